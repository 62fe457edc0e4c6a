"""Motion of tools against LAMMPS's own fix move, closed forms, and a restart in the middle.

Particles that lie on the corners of the mesh are carried by fix move with the same words; the corners of the triangles
(local array) must stay on them: linear, wiggle, rotate, transrot, also in 2d and with a negative period. variable:
displacement and velocity as formulas. Soft start: closed form of the integral. The velocity of the surface, as the
VTK file has it, is the derivative of the place. A motion that is given later starts from where the tool is. A run cut
in two by a restart file goes on bit for bit in place, temperature, forces and particles, for every kind of motion."""
import os

import numpy as np
from contact_scene import MATERIAL, block, header, mesh, particles, read_vtk
from sphtm_scene import Checks, new_folder, read_dump, run

DX, DT, STEPS = 0.1, 1e-5, 400
STIFF = MATERIAL.replace("1e7", "1e9")    # these tools are fast: they stay below ten times its speed of sound
SCRIPT = """
pair_coeff 1 1 {material} heat 0 900 0
pair_coeff 2 2 {material} heat 0 900 0 body heat
pair_coeff 1 2 none
group work type 1
group corners type 2
timestep {dt!r}
fix body work sph/tm dt {dt!r}
variable d equal 0.02*sin(2000*step*{dt!r})
variable u equal 40*cos(2000*step*{dt!r})
fix tool work contact/tri file block.stl move 0.3 0.2 0 local 50 vtk 50 tool.*.vtk reference 0.3 0.2 0
{motion}
{carry}
dump t all local 50 tri.dump index f_tool[1] f_tool[2] f_tool[3] f_tool[4] f_tool[5] f_tool[6] f_tool[7] f_tool[8] f_tool[9]
dump_modify t format float %.15g
dump c all custom 50 corners.dump id x y z
dump_modify c format float %.15g
thermo_style custom step f_tool[7] f_tool[8] f_tool[9]
thermo_modify format float %.15g
thermo 50
run {steps}
"""


def moved(motion, carry="", dim=3, steps=STEPS):
    folder = new_folder()
    mesh(folder, "block.stl", "block --size 1 1 1 --format ascii")
    z = (-0.5, 0.5) if dim == 3 else (0.0,)
    corners = [(0.3 + a, 0.2 + b, c) for a in (-0.5, 0.5) for b in (-0.5, 0.5) for c in z]
    x = np.array([(-5.0, -5, 0)] + corners)
    box = [(-6, 6), (-6, 6), (-6, 6) if dim == 3 else (-0.1, 0.1)]
    script = header(DX, dim) + SCRIPT.format(material=STIFF, dt=DT, motion=motion, carry=carry, steps=steps)
    data = particles(x, box, types=[1] + [2] * len(corners))
    return run(script, files={"data.scene": data}, folder=folder)


def tri_corners(result):
    """Corner points of the mesh at each frame of the local dump, (frames, triangles, 3, 3)."""
    frames, at = [], 0
    with open(result.path("tri.dump")) as f:
        lines = f.read().splitlines()
    while at < len(lines):
        n = int(lines[at + 3])
        rows = np.array([[float(w) for w in line.split()] for line in lines[at + 9:at + 9 + n]])
        frames.append(rows[:, 1:10].reshape(n, 3, 3))
        at += 9 + n
    return np.array(frames)


def against_fix_move(checks):
    cases = (("linear 30 -20 10", 3), ("linear NULL -20 NULL", 3), ("wiggle 0.05 0.02 -0.03 0.0011", 3),
             ("rotate 0.1 0.2 0.3 1 2 -3 0.007", 3), ("rotate 0.1 0.2 0.3 1 2 -3 -0.007", 3),
             ("transrot 30 -20 10 0.1 0.2 0.3 1 2 -3 0.007", 3), ("linear 30 -20 0", 2),
             ("rotate 0.1 0.2 0 0 0 1 0.007", 2), ("transrot 30 -20 0 0.1 0.2 0 0 0 -2 0.003", 2))
    for words, dim in cases:
        carry = words.replace("1 2 -3 -0.007", "-1 -2 3 0.007")    # fix move has no negative period
        result = moved("fix_modify tool move " + words, "fix carry corners move " + carry, dim)
        tri, worst = tri_corners(result), 0.0
        for frame, triangles in zip(read_dump(result.path("corners.dump")), tri):
            x = np.c_[frame["x"], frame["y"], frame["z"]][1:]
            p = triangles.reshape(-1, 3).copy()
            if dim == 2:
                p[:, 2] = 0.0
            gap = np.linalg.norm(p[:, None] - x[None], axis=2)
            worst = max(worst, gap.min(axis=1).max(), gap.min(axis=0).max())
        checks.true("%dd %s: the tool moves" % (dim, words), np.ptp(tri, axis=0).max() > 0.01)
        checks.below("    corners less fix move", worst, 1e-12)


def closed_forms(checks):
    a, b = 0.02 * np.sin(2000 * DT * np.arange(0, STEPS + 1, 50)), np.arange(0, STEPS + 1, 50) * DT
    start = np.array([0.3, 0.2, 0.0])
    t = moved("fix_modify tool move variable v_d NULL NULL v_u NULL NULL").thermo[-1]
    checks.below("variable: displacement", abs(t["f_tool[7]"] - start[0] - a).max(), 1e-13)
    t = moved("fix_modify tool move variable NULL NULL NULL v_u NULL NULL").thermo[-1]
    # the velocity at the end of each step, as fix move takes it: off by dt/2 times its change
    checks.below("variable: velocity alone, integrated", abs(t["f_tool[7]"] - start[0] - a).max(), 0.5 * DT * 80)
    ramp = 0.003
    u = b / ramp
    s = np.where(b < ramp, ramp * (u ** 3 - 0.5 * u ** 4), b - 0.5 * ramp)
    t = moved("fix_modify tool move linear 30 0 -7 ramp %r" % ramp).thermo[-1]
    checks.below("linear with ramp: place", abs(t["f_tool[7]"] - 0.3 - 30 * s).max() + abs(t["f_tool[9]"] + 7 * s).max(), 1e-12)
    t = moved("fix_modify tool move wiggle 0.05 0 0 0.0011 ramp %r" % ramp).thermo[-1]
    checks.below("wiggle with ramp: place", abs(t["f_tool[7]"] - 0.3 - 0.05 * np.sin(2 * np.pi * s / 0.0011)).max(), 1e-12)
    t = moved("fix_modify tool move rotate 0 0 0 0 0 1 0.007 ramp %r" % ramp).thermo[-1]
    angle = 2 * np.pi * s / 0.007
    checks.below("rotate with ramp: place", abs(t["f_tool[7]"] - 0.3 * np.cos(angle) + 0.2 * np.sin(angle)).max() +
                 abs(t["f_tool[8]"] - 0.3 * np.sin(angle) - 0.2 * np.cos(angle)).max(), 1e-12)
    two = "fix_modify tool move linear 30 0 0\nrun 100\nfix_modify tool move rotate 0.33 0.2 0 0 0 1 0.004\nrun 100\n" \
          "fix_modify tool move none"
    t = moved(two, steps=100).thermo[-1]
    checks.near("one motion after the other: x", t["f_tool[7]"][-1], 0.33, absolute=1e-12)
    tri = tri_corners(moved(two.replace("run 100", "run 100", 1), steps=100))[-1].reshape(-1, 3)
    checks.near("    turned by a quarter: corners stay on the square", abs(abs(tri[:, 0] - 0.33) - 0.5).max(), 0, absolute=1e-12)


def surface_velocity(checks):
    """VTK 'vel' against the change of the place of each triangle's middle; central difference over one step."""
    for words in ("linear 30 -20 10", "rotate 0.1 0.2 0.3 1 2 -3 0.007", "transrot 30 -20 10 0.1 0.2 0.3 1 2 -3 0.007",
                  "wiggle 0.05 0.02 -0.03 0.0011", "rotate 0.1 0.2 0.3 1 2 -3 0.007 ramp 0.002"):
        folder = new_folder()
        mesh(folder, "block.stl", "block --size 1 1 1 --format ascii")
        script = header(DX) + """
pair_coeff 1 1 %s
fix body all sph/tm dt %r
fix tool all contact/tri file block.stl move 0.3 0.2 0 vtk 1 tool.*.vtk
fix_modify tool move %s
run 52
""" % (MATERIAL, DT, words)
        result = run(script, files={"data.scene": particles([(-5, -5, 0)], [(-6, 6)] * 3)}, folder=folder)
        f = [read_vtk(result.path("tool.%d.vtk" % k)) for k in (50, 51, 52)]
        mid = [g["points"][g["triangles"]].mean(axis=1) for g in f]
        due = (mid[2] - mid[0]) / (2 * DT)
        checks.below("surface velocity, " + words, abs(f[1]["vel"] - due).max() / abs(due).max(), 2e-3)


RESTART = """
pair_coeff 1 1 density 1000 elastic 1e7 0.3 heat 50 900 0.9
{common}
fix body all sph/tm temperature 300
{tool}
{show}
restart 150 cut.*.restart
run 300
"""
AGAIN = """
read_restart cut.150.restart
{common}
fix body all sph/tm temperature 300
{tool}
{show}
run 150
"""


def restart(checks):
    tool = "fix tool all contact/tri file block.stl move 0 -0.5 0 friction 0.3 heat conductance 1e4 lumped 1 200 500 " \
           "effusivity 5000\nfix_modify tool move "
    show = "thermo_style custom step time f_tool f_tool[*] f_body[10]\nthermo_modify format float %.17g\nthermo 50\n" \
           "dump d all custom 50 NAME id x y z vx vy vz c_t\ndump_modify d format float %.17g sort id"
    common = "newton off\ncompute t all sph/tm/atom temperature\nvariable d equal 0.002*sin(2000*time)\nvariable u equal " \
             "4*cos(2000*time)"
    motions = ("linear 0 0.5 0.3", "linear 3 0.5 0 ramp 0.005", "wiggle 0.02 0.004 0 0.004", "rotate 0 -0.5 0 0 1 0 0.05",
               "transrot 1 0.4 0 0 -0.5 0 0 1 0 0.05 ramp 0.01", "variable v_d NULL NULL NULL NULL NULL",
               "variable NULL NULL NULL v_u NULL NULL")
    for ranks in (1, 2):
        for words in motions if ranks == 1 else motions[:4:3]:
            folder = new_folder()
            mesh(folder, "block.stl", "block --size 1 1 1 --cells 2 3 4")
            x = block((5, 4, 5), 0.02, (-0.05, 0.0005, -0.05))
            v = np.tile([0.0, -1.0, 0.0], (len(x), 1))
            data = particles(x, [(-0.3, 0.3), (-0.05, 0.3), (-0.3, 0.3)], v=v)
            args = dict(common=common, tool=tool + words)
            one = run(header(0.02) + RESTART.format(show=show.replace("NAME", "a.dump"), **args), ranks=ranks,
                      files={"data.scene": data}, folder=folder)
            two = run(AGAIN.format(show=show.replace("NAME", "b.dump"), **args), ranks=ranks, folder=folder)
            a, b = one.thermo[-1], two.thermo[-1]
            differ = [k for k in a if a[k][-1] != b[k][-1]]
            p, q = read_dump(os.path.join(folder, "a.dump"))[-1], read_dump(os.path.join(folder, "b.dump"))[-1]
            differ += [k for k in p if (np.asarray(p[k]) != np.asarray(q[k])).any()]
            checks.true("restart, %d rank%s, %s" % (ranks, "s" * (ranks > 1), words), not differ,
                        "differ: " + " ".join(differ) if differ else "all the same; %d contacts" % max(a["f_tool[12]"]))


if __name__ == "__main__":
    checks = Checks()
    against_fix_move(checks)
    closed_forms(checks)
    surface_velocity(checks)
    restart(checks)
    checks.end()
