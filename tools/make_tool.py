#!/usr/bin/env python3
"""Closed triangle meshes of cutting tools and simple bodies, written as STL.

  make_tool.py insert --rake 6 --clearance 7 --radius 5e-3 --segments 6 \\
               --height 0.5 --length 0.5 --width 0.2 -o insert.stl
  make_tool.py insert --rake 6 --chamfer 0.1 20 -o chamfered.stl
  make_tool.py endmill --flutes 2 --diameter 4 --helix 30 --rake 10 --relief 10 --length 6 -o mill.stl
  make_tool.py drill  --diameter 4 --point 118 --web 0.6 --helix 28 --length 12 -o drill.stl
  make_tool.py pin    --shoulder 6 3 --probe 2.5 1.5 2 -o pin.stl
  make_tool.py block  --size 1 2 3 -o block.stl
  make_tool.py wedge  --size 1 1 1 -o wedge.stl
  make_tool.py plane  --size 1 1 --cells 30 30 -o plane.stl
  make_tool.py sphere --radius 0.5 --levels 4 -o ball.stl

Insert: the tool moves along -x, cuts in the x-y plane and is centered on z = 0. The lowest point of
the rounded edge lies at y = 0 and the foremost point of the rounding at x = 0, so that `move X Y 0`
puts the edge at depth -Y. The rake face leans back by the rake angle from +y, the clearance face
rises by the clearance angle from +x; a circle of the edge radius touches both. A chamfer of the
given width lies between edge and rake face, turned forward from the rake face by its angle; then the
rounding touches the chamfer instead of the rake face, and the foremost point of both is at x = 0.

Tools that turn stand on z = 0 with their axis on z and the shank up. End mill and drill cut turning
about -z (clockwise, seen from the shank) and have right-handed helices: `move rotate 0 0 0 0 0 -1
period`. End mill: edge 1 begins at x = diameter/2 on y = 0. The flank is a logarithmic spiral, which
has the relief angle everywhere; the end is flat. Drill: straight lips, half the web ahead of the
axis, on a cone of the point angle; the flanks behind them rise by the lip relief; the flutes begin to
turn above the point. Pin: a shoulder, concave if wished, and a conical probe for friction stir.

Block, wedge and sphere are centered on the origin; the plane lies at z = 0 with normal +z and is open.

Lengths are plain numbers: scale them in LAMMPS (`scale 1e-3`) or here (--scale). All bodies but the
plane are watertight with normals outward; the mesh is checked before it is written.
"""
import argparse
import math
import struct
import sys


# --- profiles and bodies: lists of triangles, each three (x, y, z) ----------------------------

def insert_profile(a):
    """Convex polygon of the insert, counter-clockwise, starting at the clearance side."""
    rake, clear = math.radians(a.rake), math.radians(a.clearance)
    if not -80 <= a.rake <= 80 or not 0 <= a.clearance < 90 or a.rake + a.clearance >= 89:
        sys.exit("insert: need -80 <= rake <= 80, 0 <= clearance, rake + clearance < 89 degrees")
    r = a.radius
    width, turned = a.chamfer if a.chamfer else (0.0, 0.0)
    if width < 0 or not 0 <= turned < 90 or (width > 0 and a.rake - turned < -80):
        sys.exit("insert: need a chamfer width >= 0, an angle from 0 to 90 and rake - angle >= -80 degrees")
    front = rake - math.radians(turned)    # of the face that meets the edge
    # outward normals of the faces: that face at angle pi - front, clearance face at clear - pi/2
    first, last = clear - math.pi / 2, -math.pi - front
    segments = max(1, a.segments) if r > 0 else 0
    arc = []
    for k in range(segments + 1):
        t = first + (last - first) * k / segments if segments else 0.0
        arc.append((r * math.cos(t), r * math.sin(t)))
    if not segments:
        arc = [(0.0, 0.0)]
    if width > 0:
        arc.append((arc[-1][0] + width * math.sin(front), arc[-1][1] + width * math.cos(front)))
    # the chords of the polygon reach as deep and as far forward as its own vertices do
    x0, y0 = min(p[0] for p in arc), min(p[1] for p in arc)
    arc = [(x - x0, y - y0) for x, y in arc]
    (xc, yc), (xr, yr) = arc[0], arc[-1]
    x_rake = xr + (a.height - yr) * math.tan(rake)
    y_clear = yc + (a.length - xc) * math.tan(clear)
    if a.height <= yr or a.length <= max(xc, x_rake) or a.height <= y_clear:
        sys.exit("insert: height and length leave no room for the faces; "
                 "make them larger than the edge radius and the inclined faces")
    arc.reverse()                       # rake side first: counter-clockwise seen from +z
    return arc + [(a.length, y_clear), (a.length, a.height), (x_rake, a.height)]


def extrude(polygon, width):
    """Prism over a convex polygon, centered on z = 0."""
    lo, hi, n = -0.5 * width, 0.5 * width, len(polygon)
    cx, cy = sum(p[0] for p in polygon) / n, sum(p[1] for p in polygon) / n
    tris = []
    for k in range(n):
        (xa, ya), (xb, yb) = polygon[k], polygon[(k + 1) % n]
        al, bl, ah, bh = (xa, ya, lo), (xb, yb, lo), (xa, ya, hi), (xb, yb, hi)
        tris += [(al, bl, bh), (al, bh, ah)]
        tris += [((cx, cy, hi), ah, bh), ((cx, cy, lo), bl, al)]
    return tris


def make_insert(a):
    return extrude(insert_profile(a), a.width)


def grid(nu, nv, point):
    """Triangles of a structured nu x nv patch; point(u, v) with u, v in [0, 1]."""
    tris = []
    for i in range(nu):
        for j in range(nv):
            a, b = point(i / nu, j / nv), point((i + 1) / nu, j / nv)
            c, d = point((i + 1) / nu, (j + 1) / nv), point(i / nu, (j + 1) / nv)
            tris += [(a, b, c), (a, c, d)]
    return tris


def make_plane(a):
    sx, sy = a.size
    return grid(a.cells[0], a.cells[1], lambda u, v: ((u - 0.5) * sx, (v - 0.5) * sy, 0.0))


def make_block(a):
    s, n, tris = a.size, a.cells, []
    for axis in range(3):
        b, c = (axis + 1) % 3, (axis + 2) % 3
        for side in (-0.5, 0.5):
            def point(u, v, axis=axis, b=b, c=c, side=side):
                p = [0.0, 0.0, 0.0]
                p[axis] = side * s[axis]
                p[b], p[c] = (u - 0.5) * s[b], (v - 0.5) * s[c]
                return tuple(p)
            face = grid(n[b], n[c], point)
            tris += face if side > 0 else [(t[0], t[2], t[1]) for t in face]
    return tris


def make_wedge(a):
    sx, sy, sz = a.size
    return extrude([(-0.5 * sx, -0.5 * sy), (0.5 * sx, -0.5 * sy), (0.5 * sx, 0.5 * sy)], sz)


def split(tris):
    """Each triangle into four; shared edges stay shared."""
    out = []
    for a, b, c in tris:
        # midpoints from sorted ends, so that both sides of an edge get the same bits
        mid = lambda p, q: tuple(0.5 * (u + v) for u, v in zip(*sorted((p, q))))
        ab, bc, ca = mid(a, b), mid(b, c), mid(c, a)
        out += [(a, ab, ca), (ab, b, bc), (ca, bc, c), (ab, bc, ca)]
    return out


def make_sphere(a):
    g = (1 + math.sqrt(5)) / 2
    v = [(-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
         (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1)]
    f = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4),
         (11, 10, 2), (10, 7, 6), (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8),
         (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10), (8, 6, 7), (9, 8, 1)]

    def onto(p):
        n = math.sqrt(sum(x * x for x in p))
        return tuple(a.radius * x / n for x in p)
    tris = [tuple(onto(v[i]) for i in t) for t in f]
    for _ in range(a.levels):
        tris = [tuple(onto(p) for p in t) for t in split(tris)]
    return tris


# --- tools that turn ----------------------------------------------------------------------------

def ears(polygon):
    """Triangles, as indices, of a simple polygon that runs counter-clockwise; it may be concave."""
    def area(i, j, k):
        (xa, ya), (xb, yb), (xc, yc) = polygon[i], polygon[j], polygon[k]
        return (xb - xa) * (yc - ya) - (xc - xa) * (yb - ya)
    left, tris = list(range(len(polygon))), []
    # only corners that turn inward can lie in an ear; those that cutting makes convex stay in the list, which does no harm
    inward = [j for j in left if area(j - 1, j, (j + 1) % len(left)) <= 0]
    n, tried = 0, 0
    while len(left) > 3:
        n %= len(left)
        i, j, k = left[n - 1], left[n], left[(n + 1) % len(left)]
        if area(i, j, k) > 0 and not any(min(area(i, j, m), area(j, k, m), area(k, i, m)) >= 0
                                         for m in inward if m not in (i, j, k)):
            tris.append((i, j, k))
            del left[n]
            tried = 0
        else:
            n, tried = n + 1, tried + 1
            if tried > len(left):
                sys.exit("the profile crosses itself: choose other angles, a thicker core or web, fewer flutes")
    return tris + [tuple(left)]


def turned(p, angle):
    c, s = math.cos(angle), math.sin(angle)
    return c * p[0] - s * p[1], s * p[0] + c * p[1]


def between(rings):
    """The wall between rings of equally many points, counter-clockwise, the lowest first; normals outward."""
    tris = []
    for low, high in zip(rings, rings[1:]):
        for k in range(len(low)):
            m = (k + 1) % len(low)
            tris += [(low[k], low[m], high[k]), (low[m], high[m], high[k])]
    return tris


def heights(low, high, twist_per_length):
    """Levels of a twisted body: no more than 6 degrees from one to the next."""
    n = max(1, math.ceil(abs(twist_per_length) * (high - low) / math.radians(6)))
    return [low + (high - low) * k / n for k in range(n + 1)]


def polar(r, t):
    return r * math.cos(t), r * math.sin(t)


def mill_profile(a):
    """Section of the end mill, counter-clockwise; each flute from its edge over flank and heel to the next rake face."""
    rake, relief = math.radians(a.rake), math.radians(a.relief)
    outer, core = 0.5 * a.diameter, 0.5 * a.diameter * a.core
    if a.flutes < 1 or a.diameter <= 0 or a.length <= 0 or not 0.1 <= a.core <= 0.9 or a.segments < 2:
        sys.exit("endmill: need flutes >= 1, diameter and length > 0, core 0.1 to 0.9, segments >= 2")
    if not -60 <= a.rake <= 60 or not 0 <= a.relief <= 60 or not 0 <= a.helix <= 60 or not 0.05 <= a.land <= 0.7:
        sys.exit("endmill: need rake -60 to 60, relief 0 to 60, helix 0 to 60 degrees, land 0.05 to 0.7")
    pitch = 2 * math.pi / a.flutes
    heel = a.land * pitch
    if core <= outer * abs(math.sin(rake)) or outer * math.exp(-heel * math.tan(relief)) <= core:
        sys.exit("endmill: rake face or flank does not end outside the core: a thinner core, a smaller land or angle")
    depth = outer * math.cos(rake) - math.sqrt(core**2 - (outer * math.sin(rake))**2)
    foot = math.atan2(depth * math.sin(rake), outer - depth * math.cos(rake))    # of the rake face, behind its edge
    root = heel + 0.35 * (pitch + foot - heel)
    if foot >= heel or root >= pitch + foot:
        sys.exit("endmill: no room for the rake face on the land: a larger land or a smaller rake")
    flute = [(outer * math.exp(-heel * u * math.tan(relief)), heel * u) for u in (k / a.segments for k in range(a.segments + 1))]
    low = flute[-1][0]
    flute += [(low + (core - low) * math.sin(0.5 * math.pi * u), heel + (root - heel) * u)
              for u in (k / a.segments for k in range(1, a.segments + 1))]
    flute += [(core, root + (pitch + foot - root) * k / a.segments) for k in range(1, a.segments + 1)]
    return [polar(r, t + k * pitch) for k in range(a.flutes) for r, t in flute]


def make_endmill(a):
    profile = mill_profile(a)
    twist = math.tan(math.radians(a.helix)) / (0.5 * a.diameter)
    rings = [[turned(p, twist * z) + (z,) for p in profile] for z in heights(0.0, a.length, twist)]
    caps = ears(profile)
    return between(rings) + [tuple(rings[-1][i] for i in t) for t in caps] + \
        [tuple(rings[0][i] for i in reversed(t)) for t in caps]


def drill_flute(a):
    """(radius, angle, fraction of the lip relief) of half of the section, from lip to lip."""
    outer, web, n = 0.5 * a.diameter, 0.5 * a.web, a.segments
    start, land = -math.asin(web / outer), math.radians(a.land)
    out = [(outer, start + land * k / n, k / n) for k in range(n + 1)]
    end, foot = start + land, 0.5 * math.pi    # the next lip begins at the web, a quarter turn before its corner
    if end >= foot - math.radians(5):
        sys.exit("drill: the land leaves no room for the flute: a smaller land")
    for k in range(1, n + 1):
        u = k / n
        out.append((outer + (web - outer) * math.sin(0.5 * math.pi * u), end + (foot - end) * u, 1 - u))
    return out


def make_drill(a):
    outer = 0.5 * a.diameter
    if a.diameter <= 0 or not 0 < a.web < 0.6 * a.diameter or a.segments < 2:
        sys.exit("drill: need diameter > 0, web above 0 and below 0.6 diameters, segments >= 2")
    if not 60 <= a.point <= 170 or not 0 <= a.relief <= 30 or not 0 <= a.helix <= 50 or not 20 <= a.land <= 120:
        sys.exit("drill: need point 60 to 170, relief 0 to 30, helix 0 to 50, land 20 to 120 degrees")
    slope, lift = 1 / math.tan(0.5 * math.radians(a.point)), math.tan(math.radians(a.relief)) * math.radians(a.land)
    tip = []
    for half in (0.0, math.pi):
        tip += [polar(r, t + half) + (r * (slope + lift * u),) for r, t, u in drill_flute(a)]
    top = max(p[2] for p in tip)
    if a.length <= 1.05 * top:
        sys.exit("drill: the point alone is %.6g long" % top)
    twist = math.tan(math.radians(a.helix)) / outer
    rings = [tip] + [[turned(p, twist * (z - 1.02 * top)) + (z,) for p in tip] for z in heights(1.02 * top, a.length, twist)]
    apex, end = (0.0, 0.0, 0.0), (0.0, 0.0, a.length)
    n, low, high = len(tip), rings[0], rings[-1]
    return between(rings) + [(apex, low[(k + 1) % n], low[k]) for k in range(n)] + \
        [(end, high[k], high[(k + 1) % n]) for k in range(n)]


def make_pin(a):
    (shoulder, height), (root, tip, length) = a.shoulder, a.probe
    dish = 0.5 * (shoulder - root) * math.tan(math.radians(a.concave))
    if not 0 < tip <= root < shoulder or height <= 0 or length <= 0 or not 0 <= a.concave <= 30 or a.segments < 3 or dish >= length:
        sys.exit("pin: need 0 < tip <= root < shoulder diameter, lengths > 0, concave 0 to 30 degrees, segments >= 3, and a probe "
                 "that reaches out of the hollow")
    # the rim of the shoulder is at z = length; the hollow rises from it to the root of the probe
    profile = [(0.5 * tip, 0.0), (0.5 * root, length + dish), (0.5 * shoulder, length), (0.5 * shoulder, length + height)]
    if length + dish >= length + height:
        sys.exit("pin: the hollow of the shoulder goes through it: a higher shoulder or a smaller angle")
    rings = [[polar(r, 2 * math.pi * k / a.segments) + (z,) for k in range(a.segments)] for r, z in profile]
    low, high, n = rings[0], rings[-1], a.segments
    ends = (0.0, 0.0, 0.0), (0.0, 0.0, length + height)
    return between(rings) + [(ends[0], low[(k + 1) % n], low[k]) for k in range(n)] + \
        [(ends[1], high[k], high[(k + 1) % n]) for k in range(n)]


# --- checking and writing -----------------------------------------------------------------------

def single(x):
    return struct.unpack("<f", struct.pack("<f", x))[0]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def normal(t):
    n = cross([t[1][k] - t[0][k] for k in range(3)], [t[2][k] - t[0][k] for k in range(3)])
    length = math.sqrt(sum(x * x for x in n))
    return tuple(x / length for x in n) if length > 0 else (0.0, 0.0, 0.0)


def volume(tris):
    return sum(sum(a[k] * cross(b, c)[k] for k in range(3)) for a, b, c in tris) / 6


def check(tris, closed):
    """Every edge once in each direction, no degenerate triangle, positive volume."""
    seen = set()
    for t in tris:
        if len(set(t)) < 3 or normal(t) == (0.0, 0.0, 0.0):
            sys.exit("degenerate triangle: choose other dimensions, or --format ascii where "
                     "single precision is too coarse")
        for k in range(3):
            edge = (t[k], t[(k + 1) % 3])
            if edge in seen:
                sys.exit("two facets share an edge in the same direction: this is a bug")
            seen.add(edge)
    if closed:
        if any((b, a) not in seen for a, b in seen):
            sys.exit("the mesh is not closed: this is a bug")
        if volume(tris) <= 0:
            sys.exit("the mesh is inside out: this is a bug")


def write_binary(path, name, tris):
    with open(path, "wb") as f:
        f.write(("SPH-TM " + name)[:80].ljust(80).encode("ascii") + struct.pack("<I", len(tris)))
        for t in tris:
            f.write(struct.pack("<12fH", *normal(t), *t[0], *t[1], *t[2], 0))


def write_ascii(path, name, tris):
    with open(path, "w", encoding="ascii") as f:
        f.write(f"solid {name}\n")
        for t in tris:
            f.write("  facet normal %.9g %.9g %.9g\n    outer loop\n" % normal(t))
            for p in t:
                f.write("      vertex %.17g %.17g %.17g\n" % p)
            f.write("    endloop\n  endfacet\n")
        f.write(f"endsolid {name}\n")


def turning_tools(kind):
    """The options of end mill, drill and pin."""
    def lengths(p, **defaults):
        for name, (value, text) in defaults.items():
            p.add_argument("--" + name, type=int if isinstance(value, int) else float, default=value, help=text)
    lengths(kind("endmill", make_endmill, help="end mill"), flutes=(2, "number of flutes"), diameter=(4.0, "over the edges"),
            helix=(30.0, "helix angle (degrees)"), rake=(10.0, "radial rake angle (degrees)"),
            relief=(10.0, "relief angle (degrees)"), length=(6.0, "extent in z"), core=(0.5, "core over outer diameter"),
            land=(0.4, "angle of the land over the pitch"), segments=(8, "chords of flank, heel and root each"))
    lengths(kind("drill", make_drill, help="twist drill with two flutes"), diameter=(4.0, "over the lips"),
            point=(118.0, "point angle (degrees)"), web=(0.6, "thickness of the web"), helix=(28.0, "helix angle (degrees)"),
            relief=(10.0, "lip relief angle at the corner (degrees)"), land=(75.0, "angle of each land (degrees)"),
            length=(12.0, "extent in z"), segments=(10, "chords of land and flute each"))
    p = kind("pin", make_pin, help="friction stir tool")
    p.add_argument("--shoulder", type=float, nargs=2, default=[6.0, 3.0], metavar=("DIAMETER", "HEIGHT"))
    p.add_argument("--probe", type=float, nargs=3, default=[2.5, 1.5, 2.0], metavar=("ROOT", "TIP", "LENGTH"),
                   help="diameters and length below the rim of the shoulder")
    lengths(p, concave=(0.0, "angle of the hollow of the shoulder (degrees)"), segments=(48, "chords of the circle"))


def arguments():
    top = argparse.ArgumentParser(description=__doc__,
                                  formatter_class=argparse.RawDescriptionHelpFormatter)
    kinds = top.add_subparsers(dest="kind", required=True)

    def kind(name, make, **text):
        p = kinds.add_parser(name, **text)
        p.set_defaults(make=make)
        p.add_argument("-o", "--output", required=True, help="STL file to write")
        p.add_argument("--format", choices=["binary", "ascii"], default="binary")
        p.add_argument("--subdivide", type=int, default=0, metavar="N",
                       help="split every triangle into four, N times")
        p.add_argument("--scale", type=float, default=1.0, help="factor on all lengths")
        return p
    p = kind("insert", make_insert, help="orthogonal cutting insert")
    p.add_argument("--rake", type=float, default=0.0, help="rake angle (degrees)")
    p.add_argument("--clearance", type=float, default=7.0, help="clearance angle (degrees)")
    p.add_argument("--radius", type=float, default=0.0, help="edge radius; 0: sharp")
    p.add_argument("--chamfer", type=float, nargs=2, metavar=("WIDTH", "ANGLE"),
                   help="width of the chamfer, and its angle with the rake face (degrees)")
    p.add_argument("--segments", type=int, default=8, help="chords of the edge rounding")
    p.add_argument("--height", type=float, default=1.0, help="extent in y")
    p.add_argument("--length", type=float, default=1.0, help="extent in x")
    p.add_argument("--width", type=float, default=1.0, help="extent in z")
    turning_tools(kind)
    for name, make in (("block", make_block), ("wedge", make_wedge)):
        p = kind(name, make)
        p.add_argument("--size", type=float, nargs=3, default=[1.0, 1.0, 1.0])
        if name == "block":
            p.add_argument("--cells", type=int, nargs=3, default=[1, 1, 1])
    p = kind("plane", make_plane, help="open rectangle, normal +z")
    p.add_argument("--size", type=float, nargs=2, default=[1.0, 1.0])
    p.add_argument("--cells", type=int, nargs=2, default=[1, 1])
    p = kind("sphere", make_sphere, help="subdivided icosahedron, vertices on the sphere")
    p.add_argument("--radius", type=float, default=0.5)
    p.add_argument("--levels", type=int, default=3)
    return top.parse_args()


def main():
    a = arguments()
    tris = a.make(a)
    for _ in range(a.subdivide):
        tris = split(tris)
    tris = [tuple(tuple(a.scale * x + 0.0 for x in p) for p in t) for t in tris]
    if a.format == "binary":
        tris = [tuple(tuple(single(x) for x in p) for p in t) for t in tris]
    check(tris, a.kind != "plane")
    (write_binary if a.format == "binary" else write_ascii)(a.output, a.kind, tris)
    lo = [min(p[k] for t in tris for p in t) for k in range(3)]
    hi = [max(p[k] for t in tris for p in t) for k in range(3)]
    print("%s: %d triangles, box %s to %s, volume %.6g"
          % (a.output, len(tris), " ".join("%.6g" % x for x in lo),
             " ".join("%.6g" % x for x in hi), 0.0 if a.kind == "plane" else volume(tris)))


if __name__ == "__main__":
    main()
