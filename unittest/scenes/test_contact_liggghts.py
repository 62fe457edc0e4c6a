"""The same meshes and the same touch in LIGGGHTS (Debian's package liggghts) and here. Skipped where it is missing.

Reading: STL files, ASCII and binary, with scale, move and rotate in several orders: number of triangles, their places
(LIGGGHTS writes six digits), areas, and how many neighbors each has across its edges. Force: a sphere of radius 0.1,
overlap 1e-3, on faces, edges and corners of a wedge. LIGGGHTS has Hertz's law, 41.797283 N, and a linear spring is made
as strong here: force and torque vectors, so normal, contact point and its lever, must agree; torque = r x F."""
import glob
import os
import shutil
import subprocess
import sys

import numpy as np
from contact_scene import header, mesh, particles, read_vtk
from sphtm_scene import Checks, new_folder, run

LIGGGHTS = """
atom_style      granular
atom_modify     map array sort 0 0
boundary        f f f
newton          off
communicate     single vel yes
units           si
region          reg block -6 6 -6 6 -6 6 units box
create_box      1 reg
neighbor        0.05 bin
neigh_modify    delay 0
fix             m1 all property/global youngsModulus peratomtype 5.e6
fix             m2 all property/global poissonsRatio peratomtype 0.45
fix             m3 all property/global coefficientRestitution peratomtypepair 1 0.9
fix             m4 all property/global coefficientFriction peratomtypepair 1 0.05
pair_style      gran model hertz tangential history
pair_coeff      * *
timestep        1.0e-9
create_atoms    1 single {x} units box
set             group all diameter 0.2 density 2500
fix             tool all mesh/surface/stress file {mesh} type 1 verbose yes {place} curvature 1e-5 stress on
fix             wall all wall/gran model hertz tangential history mesh n_meshes 1 meshes tool
fix             integr all nve/sphere
dump            dvtk all mesh/vtk 10 tool_*.vtk area nneighs tool
thermo_style    custom step f_tool[1] f_tool[2] f_tool[3] f_tool[4] f_tool[5] f_tool[6]
thermo          10
thermo_modify   lost ignore norm no format float %.12g
run             10
"""
OURS = """
pair_coeff 1 1 density 2500 elastic 5e6 0.45
fix body all sph/tm
fix tool all contact/tri file {mesh} {place} penalty {penalty!r} damping 0 overlap allow vtk 10 ours.*.vtk reference 0 0 0
thermo_style custom step f_tool[*]
thermo_modify norm no format float %.12g
run 0
"""
RADIUS, OVERLAP = 0.1, 1e-3
HERTZ = 4 / 3 * 5e6 / (2 * (1 - 0.45 ** 2)) * np.sqrt(RADIUS) * OVERLAP ** 1.5


def words(x):
    return "%.15g %.15g %.15g" % tuple(x)


def by_liggghts(folder, name, place, x):
    """Rows of f_tool[1-6]; corners, areas and numbers of neighbors of the triangles."""
    for old in glob.glob(os.path.join(folder, "tool_*.vtk")):
        os.remove(old)
    with open(os.path.join(folder, "in.liggghts"), "w") as f:
        f.write(LIGGGHTS.format(mesh=name, place=place, x=words(x)))
    with open(os.path.join(folder, "screen"), "w") as screen:    # -screen none would crash it
        subprocess.run(["liggghts", "-in", "in.liggghts"], cwd=folder, stdout=screen, stderr=subprocess.STDOUT,
                       stdin=subprocess.DEVNULL, timeout=120)
    with open(os.path.join(folder, "screen")) as f:
        text = f.read()
    row = [line.split() for line in text.splitlines() if line.split()[:1] == ["10"] and len(line.split()) == 7]
    if not row:
        sys.exit("liggghts:\n" + text[-3000:])
    with open(os.path.join(folder, "tool_10.vtk")) as f:
        tokens = f.read().split()
    n3 = int(tokens[tokens.index("POINTS") + 1])
    at = tokens.index("POINTS") + 3
    corners = np.array(tokens[at:at + 3 * n3], float).reshape(-1, 3, 3)    # three vertices of their own per facet
    n = n3 // 3
    at = tokens.index("area") + 4
    area = np.array(tokens[at:at + n], float)
    at = tokens.index("nneighs") + 4
    neighbors = np.array(tokens[at:at + n], int)
    return np.array(row[-1][1:], float), corners, area, neighbors


def by_us(folder, name, place, x):
    dp = 2 * RADIUS
    penalty = HERTZ / OVERLAP / (5e6 * dp)
    result = run(header(dp) + OURS.format(mesh=name, place=place, penalty=float(penalty)), folder=folder,
                 files={"data.scene": particles([x], [(-6, 6)] * 3)})
    t = result.thermo[-1]
    s = read_vtk(os.path.join(folder, "ours.0.vtk"))
    edges = {}
    for k, tri in enumerate(s["triangles"]):
        for a, b in ((0, 1), (1, 2), (2, 0)):
            edges.setdefault(frozenset((tri[a], tri[b])), []).append(k)
    neighbors = np.zeros(len(s["triangles"]), int)
    for sharing in edges.values():
        for k in sharing:
            neighbors[k] += len(sharing) - 1
    force = np.array([t["f_tool[%d]" % k][0] for k in range(1, 7)])
    return force, s["points"][s["triangles"]], s["area"], neighbors, t


def matched(a, b):
    """For each triangle of a the one of b with the nearest middle."""
    gap = np.linalg.norm(a.mean(axis=1)[:, None] - b.mean(axis=1)[None], axis=2)
    return gap.argmin(axis=1), gap.min(axis=1).max()


def reading(checks):
    cases = (("wedge --size 2 1 1 --format ascii", ""), ("wedge --size 2 1 1", ""),
             ("block --size 2 1 1 --cells 2 3 4", "move 1 0 0 scale 2"),
             ("block --size 2 1 1 --cells 2 3 4", "scale 2 move 1 0 0"),
             ("insert --rake 10 --clearance 7 --radius 0.2 --segments 6 --height 1 --length 1 --width 0.5",
              "rotate axis 1 2 3 angle 40 move 0.1 -0.2 0.3 rotate axis 0 0 1 angle -25 scale 1.5"),
             ("plane --size 2 1 --cells 4 3", "rotate axis 1 0 0 angle -90"), ("sphere --radius 1.5 --levels 3", ""))
    for shape, place in cases:
        folder = new_folder()
        mesh(folder, "tool.stl", shape)
        far = (-5.5, -5.5, -5.5)
        theirs, ours = by_liggghts(folder, "tool.stl", place, far), by_us(folder, "tool.stl", place, far)
        name = "%s %s" % (shape.split(" --")[0], place)
        checks.near(name + ": triangles", len(ours[1]), len(theirs[1]))
        size = np.ptp(ours[1].reshape(-1, 3), axis=0).max()
        match, gap = matched(ours[1], theirs[1])
        checks.true("    one to one", sorted(match) == list(range(len(match))))
        checks.below("    places, over the size (six digits)", gap / size, 2e-6)
        checks.below("    areas, relative", abs(ours[2] / theirs[2][match] - 1).max(), 1e-7)
        checks.true("    neighbors of each", (ours[3] == theirs[3][match]).all(),
                    "%d in all" % ours[3].sum())


def touches():
    """Name, contact point, outward direction; wedge with corners (-1,-.5), (1,-.5), (1,.5), z from -.5 to .5."""
    slope = np.array([-1.0, 2.0, 0.0]) / np.sqrt(5)
    unit = np.eye(3)
    yield "face x", (1, 0.1, 0.3), unit[0]
    yield "face x on the edge of two of its triangles", (1, 0.0, 0.0), unit[0]
    yield "bottom face", (0.3, -0.5, -0.2), -unit[1]
    yield "sloped face", (0.1, 0.05, 0.2), slope
    yield "end face", (0.5, -0.3, 0.5), unit[2]
    yield "edge of 90 degrees", (1, -0.5, 0.2), np.array([1, -1, 0]) / np.sqrt(2)
    yield "edge of 63 degrees", (1, 0.5, -0.1), np.array([0.8, 0.6, 0])
    yield "edge of 27 degrees", (-1, -0.5, 0.1), np.array([-1, 0.1, 0]) / np.sqrt(1.01)
    yield "corner", (1, 0.5, 0.5), np.array([0.5, 0.6, 0.4]) / np.linalg.norm([0.5, 0.6, 0.4])
    yield "sharp corner", (-1, -0.5, -0.5), np.array([-1, -0.1, -0.3]) / np.linalg.norm([-1, -0.1, -0.3])


def pressing(checks):
    checks.near("Hertz", HERTZ, 41.797283, absolute=1e-6)
    folder = new_folder()
    mesh(folder, "tool.stl", "wedge --size 2 1 1 --format ascii")
    for name, r, n in touches():
        r = np.array(r, float)
        x = r + (RADIUS - OVERLAP) * n
        theirs, ours = by_liggghts(folder, "tool.stl", "", x), by_us(folder, "tool.stl", "", x)
        due = np.r_[-HERTZ * n, np.cross(r, -HERTZ * n)]
        checks.below("sphere on %s: ours against r x F, over F" % name, abs(ours[0] - due).max() / HERTZ, 1e-9)
        checks.below("    LIGGGHTS against ours: force", abs(theirs[0] - ours[0])[:3].max() / HERTZ, 1e-6)
        checks.below("    LIGGGHTS against ours: torque", abs(theirs[0] - ours[0])[3:].max() / HERTZ, 1e-6)
        checks.near("    depth over spacing", ours[4]["f_tool[13]"][0], OVERLAP / (2 * RADIUS), relative=1e-9)


if __name__ == "__main__":
    if not shutil.which("liggghts"):
        print("liggghts is not installed (Debian: apt-get install liggghts): skipped")
        sys.exit(77)
    checks = Checks()
    reading(checks)
    pressing(checks)
    checks.end()
