#!/usr/bin/env python3
"""Closed triangle meshes of cutting tools and simple bodies, written as STL.

  make_tool.py insert --rake 6 --clearance 7 --radius 5e-3 --segments 6 \\
               --height 0.5 --length 0.5 --width 0.2 -o insert.stl
  make_tool.py block  --size 1 2 3 -o block.stl
  make_tool.py wedge  --size 1 1 1 -o wedge.stl
  make_tool.py plane  --size 1 1 --cells 30 30 -o plane.stl
  make_tool.py sphere --radius 0.5 --levels 4 -o ball.stl

Insert: the tool moves along -x, cuts in the x-y plane and is centered on z = 0. The lowest point of
the rounded edge lies at y = 0 and the foremost point of the rounding at x = 0, so that `move X Y 0`
puts the edge at depth -Y. The rake face leans back by the rake angle from +y, the clearance face
rises by the clearance angle from +x; a circle of the edge radius touches both. Block, wedge and
sphere are centered on the origin; the plane lies at z = 0 with normal +z and is open.

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
    # outward normals of the faces: rake face at angle pi - rake, clearance face at clear - pi/2
    first, last = clear - math.pi / 2, -math.pi - rake
    segments = max(1, a.segments) if r > 0 else 0
    arc = []
    for k in range(segments + 1):
        t = first + (last - first) * k / segments if segments else 0.0
        arc.append((r * math.cos(t), r * math.sin(t)))
    if not segments:
        arc = [(0.0, 0.0)]
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
    p.add_argument("--segments", type=int, default=8, help="chords of the edge rounding")
    p.add_argument("--height", type=float, default=1.0, help="extent in y")
    p.add_argument("--length", type=float, default=1.0, help="extent in x")
    p.add_argument("--width", type=float, default=1.0, help="extent in z")
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
