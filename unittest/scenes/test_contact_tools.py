"""Several tools at once, the same tool in other files, several ranks.

 - a block in a vise of two plates: equal and opposite forces; a third tool presses it sideways; momentum of the block;
 - a plate cut into two tools with a seam between the particles' columns gives the force of the whole, each its part;
 - a tool that belongs to a group leaves other particles alone; two tools in the same place push twice;
 - the same shape as binary STL, ASCII STL, legacy VTK, subdivided, or placed by other keywords: the same forces;
 - 1, 2 and 4 ranks: particles, forces, torques, friction power, heat, temperature of a lumped tool."""
import os

import numpy as np
from contact_scene import MATERIAL, block, header, mesh, particles, read_stl
from sphtm_scene import Checks, new_folder, read_dump, run

DX = 0.02
SCRIPT = """
pair_coeff 1 1 {material}
fix body all sph/tm {state}
{tools}
{more}
thermo_style custom step {columns}
thermo_modify norm no format float %.17g
thermo {every}
dump d all custom {steps} end.dump id x y z vx vy vz
dump_modify d format float %.17g
run {steps}
"""
BOX = [(-0.4, 0.4), (-0.4, 0.4), (-0.4, 0.4)]


def go(tools, columns, steps, ranks=1, more="", material=MATERIAL, state="", meshes=(), v=(0.0, 0.0, 0.0), every=1,
       counts=(6, 6, 6), before=None):
    folder = new_folder()
    for name, words in meshes:
        mesh(folder, name, words)
    if before:
        before(folder)
    x = block(counts, DX, -0.5 * DX * np.array(counts))
    script = header(DX, style="stabilize artstress") + SCRIPT.format(material=material, state=state, tools="\n".join(tools), more=more,
                                        columns=" ".join(columns), steps=steps, every=every)
    data = particles(x, BOX, v=np.tile(v, (len(x), 1)))
    result = run(script, ranks=ranks, files={"data.scene": data}, folder=folder)
    return result.thermo[-1], read_dump(result.path("end.dump"))[-1], len(x)


PLATES = [("plate.stl", "block --size 0.3 0.3 0.1 --cells 3 3 1")]


def vise(checks):
    tools = ["fix top all contact/tri file plate.stl move 0 0 0.1101 damping 0.3",
             "fix bottom all contact/tri file plate.stl move 0 0 -0.1101 damping 0.3",
             "fix side all contact/tri file plate.stl rotate axis 0 1 0 angle 90 move -0.114 0 0 damping 0.3",
             "fix_modify top move linear 0 0 -0.2", "fix_modify bottom move linear 0 0 0.2",
             "fix_modify side move linear 0.5 0 0"]
    columns = ["f_top[*]", "f_bottom[*]", "f_side[*]", "f_body[10]", "c_v[*]"]
    t, _, n = go(tools, columns, 800, more="compute v all reduce ave vx vy vz", meshes=PLATES)
    early = t["f_side[12]"].cumsum() == 0
    scale = abs(t["f_top[3]"]).max()
    checks.above("vise: steps before the third tool touches", early.sum(), 100)
    checks.below("    forces of top and bottom until then, sum over largest", abs((t["f_top[3]"] + t["f_bottom[3]"])[early]).max() /
                 scale, 1e-10)
    checks.above("    third tool pushed back, most contacts", t["f_side[12]"].max() * (t["f_side[1]"].min() < 0), 30)
    dt, mass = t["f_body[10]"], n * 1000 * DX ** 3
    for k, axis in enumerate("xyz"):
        impulse = sum((t["f_%s[%d]" % (name, k + 1)][1:] * dt[1:]).sum() for name in ("top", "bottom", "side"))
        checks.below("    momentum %s of the block and impulse on three tools" % axis,
                     abs(mass * t["c_v[%d]" % (k + 1)][-1] + impulse) / (mass * 0.5), 1e-12)


def seam(checks):
    """The seam lies between two columns of particles; both tools reach beyond the block."""
    fly = dict(v=(0.0, 0.0, -0.5), steps=400)
    whole, end, _ = go(["fix w all contact/tri file plate.stl move 0 0 -0.0601 sides two"], ["f_w[*]"],
                       meshes=[("plate.stl", "plane --size 0.4 0.3 --cells 4 3")], **fly)
    halves = ["fix a all contact/tri file half.stl move -0.1 0 -0.0601 sides two",
              "fix b all contact/tri file half.stl move 0.1 0 -0.0601 sides two"]
    parts, end2, _ = go(halves, ["f_a[*]", "f_b[*]"], meshes=[("half.stl", "plane --size 0.2 0.3 --cells 2 3")], **fly)
    # a seam is an edge of both: particles of the columns next to it, half a spacing off, do not reach it
    scale = abs(whole["f_w[3]"]).max()
    for k in range(1, 7):    # torques about the origins, where z is the same and x differs
        both = parts["f_a[%d]" % k] + parts["f_b[%d]" % k]
        if k == 5:
            both = both - (-0.1) * parts["f_a[3]"] - 0.1 * parts["f_b[3]"]
        if k == 6:
            both = both + (-0.1) * parts["f_a[2]"] + 0.1 * parts["f_b[2]"]
        checks.below("two halves and the whole, f[%d]" % k, abs(both - whole["f_w[%d]" % k]).max() / scale, 1e-9)
    checks.below("    places at the end", max(abs(end[k] - end2[k]).max() for k in "xyz"), 1e-12)
    checks.near("    each half carries half", (parts["f_a[3]"].sum() / whole["f_w[3]"].sum()), 0.5, absolute=1e-9)


def groups(checks):
    first = "region left block INF 0 INF INF INF INF units box\ngroup left region left"
    t, end, _ = go([first, "fix p left contact/tri file plate.stl move 0 0 -0.1101"], ["f_p[*]"], meshes=PLATES,
                   v=(0.0, 0.0, -0.5), steps=75)
    checks.near("group of the left half: contacts", t["f_p[12]"].max(), 18)
    once, _, _ = go(["fix p all contact/tri file plate.stl move 0 0 -0.1101 damping 0"], ["f_p[3]"], meshes=PLATES,
                    v=(0, 0, -0.5), steps=10)
    twice, _, _ = go(["fix p all contact/tri file plate.stl move 0 0 -0.1101 damping 0",
                      "fix q all contact/tri file plate.stl move 0 0 -0.1101 damping 0"], ["f_p[3]", "f_q[3]"],
                     meshes=PLATES, v=(0, 0, -0.5), steps=10)
    hit = np.nonzero(once["f_p[3]"])[0]
    if len(hit):
        k = hit[0]
        checks.near("two tools in one place: first touch", twice["f_p[3]"][k], once["f_p[3]"][k], relative=1e-12)
    checks.below("    both feel the same", abs(twice["f_p[3]"] - twice["f_q[3]"]).max(), 0.0)


def files(checks):
    def other_files(folder):
        t = read_stl(mesh(folder, "plate.stl", "wedge --size 0.5 0.2 0.6"))
        mesh(folder, "ascii.stl", "wedge --size 0.5 0.2 0.6 --format ascii")
        mesh(folder, "fine.stl", "wedge --size 0.5 0.2 0.6 --subdivide 3 --format ascii")
        mesh(folder, "unit.stl", "wedge --size 1 1 1 --format ascii")
        points = t.reshape(-1, 3)
        with open(os.path.join(folder, "plate.vtk"), "w") as f:
            f.write("# vtk DataFile Version 3.0\nwedge\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS %d float\n" % len(points))
            f.write("".join("%.9g %.9g %.9g\n" % tuple(p) for p in points))
            f.write("CELLS %d %d\n" % (len(t), 4 * len(t)))
            f.write("".join("3 %d %d %d\n" % (3 * k, 3 * k + 1, 3 * k + 2) for k in range(len(t))))
            f.write("CELL_TYPES %d\n" % len(t) + "5\n" * len(t))
    place = "rotate axis 1 0 0 angle 90 rotate axis 0 0 1 angle 20 move 0 0.01 -0.1"
    reference = None
    for what in ("file plate.stl", "file ascii.stl", "file plate.vtk", "file fine.stl", "file unit.stl scale 0.5 0.2 0.6",
                 "file unit.stl move 1 0 0 scale 0.5 0.2 0.6 move -0.5 0 0"):
        tools = ["fix p all contact/tri %s %s friction 0.2 penalty 1" % (what, place)]
        t, end, _ = go(tools, ["f_p[*]"], meshes=(), before=other_files, v=(0.3, 0.0, -1.0), steps=540)
        values = np.array([t["f_p[%d]" % k] for k in range(1, 13) if not 7 <= k <= 9])
        if reference is None:
            reference = values
            checks.above("files: contacts", t["f_p[12]"].max(), 3)
            continue
        worst = max(abs(a - b).max() / max(abs(a).max(), 1e-9) for a, b in zip(reference, values))
        checks.below("    %s: forces, torques, power, contacts" % what, worst, 2e-5)    # single precision


def ranks(checks):
    tools = ["fix p all contact/tri file plate.stl move 0.05 0 -0.1101 friction 0.3 heat conductance 1e4 lumped 1 200 500 "
             "effusivity 5000", "fix_modify p move rotate 0.05 0 -0.1101 0 1 0 0.5",
             "fix q all contact/tri file plate.stl rotate axis 0 1 0 angle 90 move -0.1105 0 0 friction 0.1 damping 0.3"]
    columns = ["f_p", "f_p[*]", "f_q[*]", "f_body[1]", "f_body[4]", "f_body[5]", "f_body[6]", "f_body[8]", "f_body[9]"]
    runs = [go(tools, columns, 540, n, "balance 1.0 shift x 5 1.0\ncomm_modify cutoff 0.1" if n == 4 else "",
               "density 1000 elastic 1e7 0.3 heat 50 900 0.9", "energy yes temperature 300", PLATES, (-1.0, 0.3, -2.0), 20)
            for n in (1, 2, 4)]
    t1, end1, _ = runs[0]
    checks.above("ranks: contacts with both tools", min(t1["f_p[12]"].max(), t1["f_q[12]"].max()), 5)
    for n, (t, end, _) in zip((2, 4), runs[1:]):
        worst = {k: abs(t[k] - t1[k]).max() / max(abs(t1[k]).max(), 1e-300) for k in t1
                 if k != "Step" and abs(t1[k]).max() > 1e-12 * abs(t1["f_p[3]"]).max()}
        name = max(worst, key=worst.get)
        checks.below("    %d ranks: largest relative difference, %s" % (n, name), worst[name], 1e-9)
        checks.below("    places, over the spacing", max(abs(end[k] - end1[k]).max() for k in "xyz") / DX, 1e-10)


if __name__ == "__main__":
    checks = Checks()
    vise(checks)
    seam(checks)
    groups(checks)
    files(checks)
    ranks(checks)
    checks.end()
