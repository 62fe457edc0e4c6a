"""The meshes of tools/make_tool.py: closed, every edge once in each direction, normals outward (a positive volume), and the
volume, extents and angles of closed forms. Bodies that turn, and the chamfered insert, by their angles; combinations that cannot
be are refused, and a mesh with a facet turned round is found. The log of fix contact/tri says closed for each."""
import math
import os
import struct
import subprocess
import sys

import numpy as np
from sphtm_scene import SOURCE, Checks, lattice_block, new_folder, run

TOOL = os.path.join(SOURCE, "tools", "make_tool.py")
folder = new_folder()
checks = Checks()


def make(arguments, name="tool.stl", refused=False):
    """The triangles, or what make_tool.py says when it refuses."""
    path = os.path.join(folder, name)
    done = subprocess.run([sys.executable, TOOL, *arguments.split(), "-o", path], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)
    if refused:
        return done.stdout if done.returncode else ""
    if done.returncode:
        sys.exit("%s: %s" % (arguments, done.stdout))
    with open(path, "rb") as f:
        data = f.read()
    count = struct.unpack("<I", data[80:84])[0]
    return np.frombuffer(data[84:], np.dtype([("v", "<f4", (4, 3)), ("a", "<u2")]), count)["v"][:, 1:].astype(float)


def volume(t):
    return np.einsum("ij,ij->", t[:, 0], np.cross(t[:, 1], t[:, 2])) / 6


def open_edges(t):
    """Directed edges that do not have exactly one partner the other way."""
    edges = {}
    for a, b, c in t:
        for p, q in ((a, b), (b, c), (c, a)):
            key = tuple(p), tuple(q)
            edges[key] = edges.get(key, 0) + 1
    return sum(n != 1 or edges.get((q, p), 0) != 1 for (p, q), n in edges.items())


def body(name, arguments, lo, hi, expected, relative=1e-6):
    t = make(arguments)
    checks.true(name + ": closed", open_edges(t) == 0, "%d triangles" % len(t))
    checks.near("    volume", volume(t), expected, relative=relative)
    checks.below("    extents", np.abs(np.r_[t.min((0, 1)) - lo, t.max((0, 1)) - hi]).max(), 1e-5)
    return t


def section(t, z):
    """Points at this height, each once."""
    p = t.reshape(-1, 3)
    return np.unique(np.round(p[np.abs(p[:, 2] - z) < 1e-6][:, :2], 6), axis=0)


def area_of_mill(flutes, outer, core, rake, relief, land):
    """Area of the section between its closed curves: sectors under spiral, heel and root, and the triangle at the rake face."""
    pitch, b = 2 * math.pi / flutes, math.tan(math.radians(relief))
    heel = land * pitch
    depth = outer * math.cos(math.radians(rake)) - math.sqrt(core**2 - (outer * math.sin(math.radians(rake)))**2)
    foot = math.atan2(depth * math.sin(math.radians(rake)), outer - depth * math.cos(math.radians(rake)))
    root = heel + 0.35 * (pitch + foot - heel)
    low = outer * math.exp(-heel * b)
    spiral = outer**2 / (4 * b) * (1 - math.exp(-2 * heel * b))
    u = (np.arange(20000) + 0.5) / 20000
    back = 0.5 * (root - heel) * np.mean((low + (core - low) * np.sin(0.5 * math.pi * u))**2)
    gullet = 0.5 * core**2 * (pitch + foot - root)
    rake_face = -0.5 * outer * core * math.sin(foot)    # from its foot forward to the edge, at a smaller angle
    return flutes * (spiral + back + gullet + rake_face)


def mills():
    area = area_of_mill(2, 2.0, 1.0, 10, 10, 0.4)
    straight = make("endmill --helix 0 --segments 40")
    checks.true("end mill, straight: closed", open_edges(straight) == 0, "%d triangles" % len(straight))
    checks.near("    volume", volume(straight), 6 * area, relative=2e-3)
    checks.near("    diameter", 2 * np.hypot(straight[..., 0], straight[..., 1]).max(), 4, relative=1e-6)
    t = make("endmill --helix 30 --segments 20")
    checks.true("end mill, helix 30: closed", open_edges(t) == 0, "%d triangles" % len(t))
    checks.near("    volume", volume(t), 6 * area, relative=5e-3)
    checks.near("    length", t[..., 2].max() - t[..., 2].min(), 6, relative=1e-6)
    ends = [section(t, z) for z in (0.0, 6.0)]
    edge = [p[np.hypot(*p.T) > 2 - 1e-4] for p in ends]
    checks.true("    two edges at each end", [len(e) for e in edge] == [2, 2], str([len(e) for e in edge]))
    turn = 6 * math.tan(math.radians(30)) / 2    # right-handed: the angle grows with z
    expected = 2 * np.array([math.cos(turn), math.sin(turn)])
    checks.below("    edge turned by the helix, right-handed", np.hypot(*(edge[1] - expected).T).min(), 1e-4)
    # the rake face goes back from the edge, against the cutting direction -y; the flank falls by the relief angle
    points = section(make("endmill --helix 0 --rake 15 --relief 8 --segments 100"), 0.0)
    d = points - [2, 0]
    near = d[(np.hypot(*d.T) > 1e-6)]
    flank = near[(near[:, 1] > 0) & (near[:, 0] > -0.05) & (np.hypot(*near.T) < 0.05)]
    flank = flank[np.argmin(np.hypot(*flank.T))]
    checks.near("    relief angle", math.degrees(math.atan2(-flank[0], flank[1])), 8, absolute=0.5)
    depth = 2 * math.cos(math.radians(15)) - math.sqrt(1 - (2 * math.sin(math.radians(15)))**2)
    foot = depth * np.array([-math.cos(math.radians(15)), math.sin(math.radians(15))])
    checks.below("    foot of the rake face", np.hypot(*(near - foot).T).min(), 1e-5)
    for flutes in 1, 3, 4, 6:
        t = make("endmill --flutes %d --rake -5 --core 0.7 --land 0.3" % flutes)
        checks.true("    %d flutes" % flutes, open_edges(t) == 0 and volume(t) > 0, "%d triangles" % len(t))


def drills():
    t = make("drill --diameter 4 --point 118 --web 0.6 --length 12")
    checks.true("drill: closed", open_edges(t) == 0, "%d triangles" % len(t))
    checks.near("    diameter", 2 * np.hypot(t[..., 0], t[..., 1]).max(), 4, relative=1e-6)
    checks.below("    extent in z", abs(t[..., 2].min()) + abs(t[..., 2].max() - 12), 1e-5)
    # corners of the lips: on the cone, half a web ahead of the axis
    slope = 1 / math.tan(math.radians(59))
    corner = np.array([math.sqrt(4 - 0.09), -0.3, 2 * slope])
    p = np.unique(np.round(t.reshape(-1, 3), 6), axis=0)
    checks.below("    corner of lip 1", np.linalg.norm(p - corner, axis=1).min(), 1e-5)
    checks.below("    corner of lip 2", np.linalg.norm(p - corner * [-1, -1, 1], axis=1).min(), 1e-5)
    checks.below("    foot of lip 1 at the web", np.linalg.norm(p - [0, -0.3, 0.3 * slope], axis=1).min(), 1e-5)
    at_corner = p[np.abs(np.hypot(p[:, 0], p[:, 1]) - 2) < 1e-5]
    checks.near("    lowest points of the rim are the lips", at_corner[:, 2].min(), 2 * slope, relative=1e-5)
    far = p[np.abs(p[:, 2]) < 1e-6]
    checks.true("    its point is on the axis", len(far) == 1 and np.abs(far).max() < 1e-6, str(far))
    # above the point every section has the same area, of which the volume grows with the length
    longer = make("drill --diameter 4 --point 118 --web 0.6 --length 20")
    straight = [volume(make("drill --helix 0 --length %d" % n)) for n in (12, 20)]
    checks.near("    volume of 8 more", volume(longer) - volume(t), straight[1] - straight[0], relative=0.015)    # levels of 6 degrees
    core = section(make("drill --helix 0 --web 0.8"), 12.0)
    checks.near("    web", 2 * np.hypot(*core.T)[np.hypot(*core.T) > 1e-3].min(), 0.8, relative=1e-5)
    checks.true("    point of 90 degrees, web 1: closed", open_edges(make("drill --point 90 --web 1 --relief 6")) == 0)


def pins():
    n = 48
    polygon = 0.5 * n * math.sin(2 * math.pi / n)    # area of the polygon of radius 1
    probe = polygon * 2 / 3 * (1.25**2 + 1.25 * 0.75 + 0.75**2)
    t = body("pin", "pin --shoulder 6 3 --probe 2.5 1.5 2", [-3, -3, 0], [3, 3, 5], probe + polygon * 9 * 3)
    checks.true("    in 3D round an axis", abs(t[..., 0].sum()) < 1e-3)
    dish = (3 - 1.25) * math.tan(math.radians(8))
    probe = polygon * (2 + dish) / 3 * (1.25**2 + 1.25 * 0.75 + 0.75**2)
    hollow = polygon * dish / 3 * (9 + 3 * 1.25 + 1.25**2)    # over the probe too, which fills its part
    body("pin with a hollow of 8 degrees", "pin --shoulder 6 3 --probe 2.5 1.5 2 --concave 8", [-3, -3, 0], [3, 3, 5],
         probe + polygon * 9 * 3 - hollow)


def inserts():
    t = body("insert, rake 0", "insert --rake 0 --clearance 0 --radius 0 --height 1 --length 2 --width 3", [0, 0, -1.5],
             [2, 1, 1.5], 6)
    width, angle = 0.2, 30
    cut = 0.5 * width**2 * math.sin(math.radians(angle)) * math.cos(math.radians(angle))
    # turned forward by 30 degrees the chamfer leans over the edge; its upper corner is the foremost point
    forward = width * math.sin(math.radians(angle))
    t = body("insert with a chamfer", "insert --rake 0 --clearance 0 --radius 0 --height 1 --length 2 --width 3 --chamfer 0.2 30",
             [0, 0, -1.5], [2, 1, 1.5], 3 * (2 - cut))
    corner = section(t, 1.5)
    checks.below("    corner of chamfer and rake face",
                 np.hypot(*(corner - [0, width * math.cos(math.radians(angle))]).T).min(), 1e-6)
    checks.below("    edge", np.hypot(*(corner - [forward, 0]).T).min(), 1e-6)
    t = make("insert --rake 10 --clearance 7 --radius 0.02 --segments 40 --chamfer 0.1 25")
    checks.true("insert with rounding and chamfer: closed", open_edges(t) == 0 and volume(t) > 0)
    checks.below("    foremost and lowest point at 0", abs(t[..., 0].min()) + abs(t[..., 1].min()), 1e-9)
    p = section(t, 0.5)
    near = p[(p[:, 0] < 0.4) & (np.hypot(*(p - p.mean(0)).T) > 1e-3)]    # not the middle of the fan
    above, corner, below = near[np.argsort(-near[:, 1])][:3]    # top, corner of the two faces, end of the rounding
    for name, a, b, rake in ("above the chamfer", corner, above, 10), ("of the chamfer", below, corner, 10 - 25):
        checks.near("    rake " + name, math.degrees(math.atan2(*(b - a))), rake, absolute=0.01)
    checks.near("    width of the chamfer", np.hypot(*(corner - below)), 0.1, relative=1e-4)


def wrong_words():
    for arguments in ("endmill --core 0.1 --rake 20", "endmill --land 0.7 --relief 30", "endmill --flutes 0", "endmill --helix 80",
                      "drill --web 3", "drill --length 0.5", "drill --point 20", "drill --land 110", "pin --probe 7 1 2",
                      "pin --probe 2 3 2", "pin --concave 60", "insert --chamfer 0.1 100", "insert --chamfer 5 20"):
        said = make(arguments, refused=True)
        checks.true("refused: " + arguments, said and "Traceback" not in said and "bug" not in said, said.strip())
    t = make("endmill")
    t[7] = t[7][::-1]
    checks.true("counter-case: a facet turned round", open_edges(t) > 0, "%d edges" % open_edges(t))


def in_lammps():
    """The tools as fix contact/tri reads them: one of them on each of four sides of a block."""
    scene = lattice_block("0 4e-3 0 4e-3 0 4e-3", "-0.02 0.03 -0.02 0.03 -0.03 0.03", dim=3) + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 2700 elastic 70e9 0.33
fix             body all sph/tm
"""
    for k, kind in enumerate(("endmill", "drill", "pin --concave 8", "insert --chamfer 0.1 20")):
        make(kind, "tool%d.stl" % k)
        scene += "fix t%d all contact/tri file tool%d.stl scale 1e-3 move 2e-3 2e-3 6e-3\n" % (k, k)
    said = run(scene + "run 2\n", folder=folder).output
    for k in range(4):
        line = [w for w in said.splitlines() if w.startswith("contact/tri t%d: tool%d.stl" % (k, k))]
        checks.true("fix contact/tri reads tool %d" % k, line and "closed, volume" in line[0], line[0] if line else "")


if __name__ == "__main__":
    mills()
    drills()
    pins()
    inserts()
    wrong_words()
    in_lammps()
    checks.end()
