"""fix contact/tri in LAMMPS: momentum, energy and heat between tool and particles, friction on a slope,
motion, files, restart, ranks."""
import os
import subprocess
import sys

import numpy as np

from sphtm_scene import SOURCE, Checks, lattice_block, new_folder, run

STEEL = "density 7850 elastic 210e9 0.3 strength plastic 350e6 0 heat 50 480 0.9"


def make_tool(folder, *arguments, name="tool.stl"):
    subprocess.run([sys.executable, os.path.join(SOURCE, "tools", "make_tool.py"), *map(str, arguments),
                    "-o", os.path.join(folder, name)], check=True, stdout=subprocess.DEVNULL)


# a free block of 6 x 6 x 6 particles; %s: what the scene adds
BLOCK = lattice_block("0 0.006 0 0.006 0 0.006", "-0.03 0.03 -0.03 0.03 -0.03 0.03", dim=3, types=2) + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      * * {steel}
fix             body all sph/tm temperature 300 energy yes
{scene}
"""


def block(scene, **kw):
    return BLOCK.format(steel=STEEL, scene=scene) % kw


def read_vtk(path):
    """Vertices, cells and cell arrays of a file written with 'vtk' (binary, as the fix writes it)."""
    data = open(path, "rb").read()
    arrays, at = {}, 0

    def line():
        nonlocal at
        end = data.index(b"\n", at)
        text, at = data[at:end].decode(), end + 1
        return text

    def numbers(n, kind):
        nonlocal at
        out = np.frombuffer(data, kind, n, at)
        at += out.nbytes + 1
        return out
    header = [line() for _ in range(4)]
    assert header[2] == "BINARY" and header[3] == "DATASET POLYDATA", header
    nv = int(line().split()[1])
    points = numbers(3 * nv, ">f8").reshape(-1, 3)
    nt = int(line().split()[1])
    cells = numbers(4 * nt, ">i4").reshape(-1, 4)[:, 1:]
    line()
    while at < len(data):
        words = line().split()
        if words[0] == "SCALARS":
            line()
            arrays[words[1]] = numbers(nt, ">f8")
        else:
            arrays[words[1]] = numbers(3 * nt, ">f8").reshape(-1, 3)
    return points, cells, arrays


def books(c):
    """A turning, moving tool hits a free block: momentum, energy and heat are all accounted for."""
    folder = new_folder()
    make_tool(folder, "insert", "--rake", 10, "--radius", 0.5, "--height", 8, "--length", 8, "--width", 9)
    scene = block("""
fix             tool all contact/tri file tool.stl scale 1e-3 rotate axis 0 0 1 angle 20 &
                move 6.75e-3 2.1e-3 3e-3 friction 0.3 damping 0.2 heat conductance 1e5 &
                temperature 400 reference 7e-3 2e-3 3e-3 &
                vtk 180 tool.*.vtk local 180
fix_modify      tool move transrot -20 0 0 7e-3 2e-3 3e-3 0 0.1 1 -2e-3 ramp 2e-5
fix_modify      body temperature all 310
compute         p all sph/tm/atom temperature
variable        px equal mass(all)*vcm(all,x)
variable        py equal mass(all)*vcm(all,y)
variable        pz equal mass(all)*vcm(all,z)
variable        dtick equal dt
fix             rec all ave/time 1 1 1 f_tool[1] f_tool[2] f_tool[3] f_tool[10] f_tool[11] v_dtick &
                file tool.dat format " %%.17g"
thermo_style    custom step time dt v_px v_py v_pz f_tool[1] f_tool[2] f_tool[3] &
                f_tool[4] f_tool[5] f_tool[6] f_tool[10] f_tool[11] f_tool[12] f_tool[13] f_body f_body[1] f_body[4] f_body[8]
thermo_modify   format float %%.15g
thermo          180
dump            loc all local 180 tri.*.dump index f_tool[1] f_tool[2] f_tool[3] f_tool[10] f_tool[11] &
                f_tool[12] f_tool[13]
dump            1 all custom 180 all.dump id x y z vx vy vz fx fy fz c_p
dump_modify     1 format float %%.15g
run             540
""")
    one = run(scene, folder=folder)
    two = run(scene, ranks=2, files={}, folder=_copy(folder))
    t = one.thermo[-1]
    rec = one.columns("tool.dat")[1:]
    impulse = (rec[:, 1:4] * rec[:, 6:7]).sum(axis=0)
    gained = np.array([t["v_p" + k][-1] for k in "xyz"])
    scale = np.abs(rec[:, 1:4] * rec[:, 6:7]).sum()
    c.above("contacts were made", t["f_tool[12]"].max(), 5)
    c.near("momentum gained + impulse on the tool", np.linalg.norm(gained + impulse) / scale, 0, absolute=1e-12)
    work = t["f_body[8]"]
    c.near("energy book closes, over the tool's work", np.ptp(t["f_body"]) / np.ptp(work), 0, absolute=2e-3)
    frame = one.dump("all.dump")[-1]
    for k, name in ((1, "fx"), (2, "fy")):
        c.near("force on the tool is minus the sum on particles, " + name, t["f_tool[%d]" % k][-1],
               -frame[name].sum(), relative=1e-9, absolute=1e-6 * abs(t["f_tool[1]"]).max())
    # heat: friction power = tool's share + what the particles got beyond plastic heat
    c.true("friction power is positive", (rec[:, 4] >= 0).all() and rec[:, 4].max() > 0, "%g to %g" % (rec[:, 4].min(), rec[:, 4].max()))
    c.near("two ranks give the same forces", np.abs(t["f_tool[1]"] - two.thermo[-1]["f_tool[1]"]).max()
           / np.abs(t["f_tool[1]"]).max(), 0, absolute=1e-8)
    c.near("two ranks give the same torque", np.abs(t["f_tool[6]"] - two.thermo[-1]["f_tool[6]"]).max()
           / np.abs(t["f_tool[6]"]).max(), 0, absolute=1e-8)
    for result, name in ((one, "1 rank"), (two, "2 ranks")):
        k = 1 + int(np.argmax(np.abs(result.thermo[-1]["f_tool[1]"][1:])))
        _, _, a = read_vtk(result.path("tool.%d.vtk" % (180 * k)))
        force = (a["stress"] * a["area"][:, None]).sum(axis=0)
        tk = result.thermo[-1]
        c.near("VTK: stress times area adds up to the force, " + name, force[0], tk["f_tool[1]"][k], relative=1e-9)
        c.near("VTK: heat flux times area adds up, " + name, (a["heat_flux"] * a["area"]).sum(),
               tk["f_tool[11]"][k], relative=1e-9)
        c.near("VTK: contacts, " + name, a["contacts"].sum(), tk["f_tool[12]"][k])
    rows = np.loadtxt(one.path("tri.%d.dump" % (180 * k)), skiprows=9)
    c.near("dump local: forces add up", rows[:, 4].sum(), one.thermo[-1]["f_tool[1]"][k], relative=1e-5)


def _copy(folder):
    other = new_folder()
    for name in os.listdir(folder):
        if name.endswith(".stl") and name.startswith("tool.stl"):
            with open(os.path.join(folder, name), "rb") as f, open(os.path.join(other, name), "wb") as g:
                g.write(f.read())
    return other


def motion(c):
    """The reference point follows LAMMPS's formulas; variables and soft starts too."""
    folder = new_folder()
    make_tool(folder, "block", "--size", 4, 4, 4)
    p = np.array([0.011, 0.004, 0.003])     # reference point; the axis passes through q
    q, axis, period = np.array([0.01, 0.001, 0.002]), np.array([0.0, 1.0, 2.0]), 3e-6

    def turned(x, t):
        u, a = axis / np.linalg.norm(axis), 2 * np.pi * t / period
        d = x - q
        return q + d * np.cos(a) + np.cross(u, d) * np.sin(a) + u * u.dot(d) * (1 - np.cos(a))
    v, w = np.array([7.0, -3.0, 2.0]), "7 -3 2"
    ramp = 4e-6

    def s(t):
        return np.where(t < ramp, ramp * ((t / ramp)**3 - 0.5 * (t / ramp)**4), t - 0.5 * ramp)
    pq = "0.01 0.001 0.002 0 1 2 3e-6"
    cases = {"linear " + w: lambda t: p + v * t, "linear %s ramp 4e-6" % w: lambda t: p + v * s(t),
             "linear NULL -3 NULL": lambda t: p + np.array([0, -3.0, 0]) * t,
             "wiggle 1e-4 0 2e-4 5e-6": lambda t: p + np.array([1e-4, 0, 2e-4]) * np.sin(2 * np.pi * t / 5e-6),
             "rotate " + pq: lambda t: turned(p, t), "transrot %s %s" % (w, pq): lambda t: turned(p, t) + v * t,
             "variable v_d NULL NULL NULL v_u NULL": lambda t: p + np.array([20 * t, 5 * t, 0])}
    for text, formula in cases.items():
        scene = block("""
variable        d equal 20*step*1e-8
variable        u equal 5
fix             tool all contact/tri file tool.stl scale 1e-3 move 0.011 0.004 0.003
fix_modify      tool move %(text)s
thermo_style    custom step f_tool[7] f_tool[8] f_tool[9]
thermo_modify   format float %%.15g
thermo          100
run             400
""", text=text)
        scene = scene.replace("temperature 300 energy yes", "temperature 300 energy yes dt 1e-8")
        t = run(scene, folder=folder).thermo[-1]
        x = np.array([t["f_tool[%d]" % k] for k in (7, 8, 9)]).T
        due = np.array([formula(n * 1e-8) for n in t["Step"]])
        c.near("move " + text, np.abs(x - due).max() / np.abs(due - p).max(), 0, absolute=1e-9)


# a block on a rigid plane, gravity tilted; elastic and cold
SLOPE = lattice_block("0 0.006 0 0.003", "-0.02 0.03 -0.005 0.01") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 1000 elastic 1e7 0.3 strength elastic
fix             body all sph/tm
variable        gx equal sin(v_angle)
variable        gy equal -cos(v_angle)
fix             g all gravity 1000 vector ${gx} ${gy} 0
fix             floor all contact/tri file tool.stl rotate axis 1 0 0 angle -90 scale 1 1 1 move 0 0 0 &
                friction 0.3 damping 0.5 sides one
variable        x equal xcm(all,x)
variable        v equal vcm(all,x)
thermo_style    custom step time v_x v_v f_floor[1] f_floor[2] f_floor[12]
thermo_modify   format float %.15g
thermo          200
run             ${n}
"""


def slope(c):
    """Below the friction angle a block stays put, above it slides with g (sin - mu cos)."""
    folder = new_folder()
    make_tool(folder, "plane", "--size", 0.2, 0.02, "--cells", 190, 7)
    for factor in (0.9, 1.5):
        angle = np.arctan(0.3) * factor
        t = run(SLOPE, {"angle": "%.17g" % angle, "n": 4000}, folder=folder).thermo[-1]
        time, g = t["Time"][-1], 1000.0
        if factor < 1:
            slip = 0.5 * g * np.sin(angle) * time**2
            c.below("slope: creep over the free slide", abs(t["v_x"][-1] - 0.003) / slip, 0.02)
        else:
            half = len(t["Time"]) // 2      # after the first settling
            a = np.polyfit(t["Time"][half:], t["v_v"][half:], 1)[0]
            c.near("slope: acceleration", a, g * (np.sin(angle) - 0.3 * np.cos(angle)), relative=0.05)
        weight = 18 * 1e-3 * g * np.cos(angle)
        c.near("slope: mean normal force", -np.mean(t["f_floor[2]"][-8:]), weight, relative=0.25)


def restart(c):
    """A run split by a restart file goes on bit for bit, motion and temperature included."""
    folder = new_folder()
    make_tool(folder, "block", "--size", 4, 4, 4)
    tool = ("fix tool all contact/tri file tool.stl scale 1e-3 move 8.01e-3 3e-3 3e-3 friction 0.3 lumped 1e-4 480 350 "
            "heat conductance 1e5\nfix_modify tool move linear -30 0 0 ramp 1e-5")
    show = ("thermo_style custom step f_tool f_tool[1] f_tool[2] f_tool[7] f_tool[11] f_body\nthermo_modify format "
            "float %.17g\nthermo 20\n")
    scene = block("%(tool)s\n%(show)srestart 200 cut.*.rst\nrun 400\n", tool=tool, show=show)
    whole = run(scene, folder=folder)
    again = run("""read_restart cut.200.rst
newton off
pair_style sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff * * %s
fix body all sph/tm temperature 300 energy yes
%s
%srun 200
""" % (STEEL, tool, show), folder=folder)
    a, b = whole.thermo[-1], again.thermo[-1]
    c.above("restart: there is contact before the file is written", np.abs(a["f_tool[1]"][:10]).max(), 1.0)
    c.above("restart: and after it", np.abs(a["f_tool[1]"][11:]).max(), 1.0)
    for name in ("f_tool", "f_tool[1]", "f_tool[2]", "f_tool[7]", "f_tool[11]"):
        c.near("restart: " + name, np.abs(b[name][1:] - a[name][11:]).max(), 0)


def heat(c):
    """A block pressed onto a hot tool: perfect contact against the half-space formula; a lumped tool and
    the block share their heat; a conductance carries h A dT."""
    folder = new_folder()
    make_tool(folder, "block", "--size", 40, 2, 40)
    scene = lattice_block("-1e-3 1e-3 0 3e-3", "-0.005 0.005 -0.002 0.005", "1e-4") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-4
pair_coeff      1 1 density 1000 elastic 1e5 0.3 strength elastic heat 2000 500 0.9
fix             body all sph/tm temperature 300 courant 0.1
fix             still all setforce 0 0 0
fix             tool all contact/tri file tool.stl scale 1e-3 move 0 -0.9995e-3 0 overlap allow HEAT
fix             off all setforce 0 0 0
compute         T all sph/tm/atom temperature
compute         mean all reduce ave c_T
dump            1 all custom ${n} T.dump id x y c_T
thermo_style    custom step time f_tool f_tool[11] c_mean f_tool[12]
thermo_modify   format float %.15g
thermo          ${n}
run             ${n}
"""

    def pressed(how, n):
        return run(scene.replace("HEAT", how), {"n": n}, folder=folder)
    t = pressed("heat perfect temperature 400", 300)
    table, frame = t.thermo[-1], t.dump("T.dump")[-1]
    from math import erf
    a = 2000.0 / (1000 * 500)
    depth = np.unique(np.round(frame["y"] * 1e4 - 0.5)) * 1e-4 + 0.5e-4
    rows = [frame["c_T"][np.abs(frame["y"] - y) < 1e-6].mean() for y in depth]
    due = [400 - 100 * erf(y / (2 * np.sqrt(a * table["Time"][-1]))) for y in depth]
    c.near("perfect contact: temperatures", np.abs(np.array(rows) - due).max() / 100, 0, absolute=0.03)
    t = pressed("heat conductance 1e5 temperature 400", 20).thermo[-1]
    c.near("conductance: heat out of the tool, start", -t["f_tool[11]"][0], 1e5 * 2e-3 * 100, relative=0.01)
    t = pressed("heat conductance 1e6 lumped 1 20 400", 300).thermo[-1]
    total = 20 * t["f_tool"] + 1000 * 500 * 2e-3 * 3e-3 * t["c_mean"]
    c.near("lumped tool: heat of both sides", np.ptp(total) / (20 * np.ptp(t["f_tool"])), 0, absolute=2e-3)
    c.above("lumped tool: it cools", t["f_tool"][0] - t["f_tool"][-1], 0.5)


def tool_of_particles(c):
    """A tool filled with particles: friction heat arrives in them and in the work, all of it."""
    folder = new_folder()
    make_tool(folder, "block", "--size", 4.2, 4.2, 4.2)
    scene = block("""
region          tool block 0.0065 0.0105 0.001 0.005 0.001 0.005 units box
create_atoms    2 region tool
pair_coeff      2 2 density 7850 elastic 210e9 0.3 heat 50 480 0.9 body heat
pair_coeff      1 2 heat
fix             tool all contact/tri file tool.stl scale 1e-3 move 8.5e-3 3e-3 3e-3 friction 0.3 particles 2
fix_modify      tool move transrot -30 8 0 8.5e-3 3e-3 3e-3 0 0 1 -1e-3
compute         T all sph/tm/atom temperature
group           one type 1
group           two type 2
compute         T1 one reduce ave c_T
compute         T2 two reduce ave c_T
compute         x all property/atom x y
compute         xb two reduce ave c_x[1]
compute         yb two reduce ave c_x[2]
variable        n1 equal count(one)
variable        n2 equal count(two)
fix             rec all ave/time 1 1 1 f_tool[10] f_tool[11] f_body[10] f_body[3] file q.dat format " %%.17g"
thermo_style    custom step time dt f_tool[11] c_T1 c_T2 v_n1 v_n2 c_xb c_yb f_tool[7] f_tool[8] &
                f_body f_body[4] f_body[8]
thermo_modify   format float %%.15g
thermo          100
run             600
""")
    scene = scene.replace("temperature 300 energy yes", "temperature 300 energy yes effects artificial-heat off")
    two = run(scene, folder=_copy(folder), ranks=2).thermo[-1]
    t = run(scene, folder=folder)
    q, t = t.columns("q.dat")[1:], t.thermo[-1]
    capacity = 7850 * 1e-9 * 480
    heat_two = (t["c_T2"][-1] - 300) * t["v_n2"][-1] * capacity
    heat_one = (t["c_T1"][-1] - 300) * t["v_n1"][-1] * capacity
    c.near("tool of particles: heat in both", heat_one + heat_two, t["f_body[4]"][-1], relative=1e-3)
    c.near("tool of particles: rubbing heat in the tool", heat_two, (q[:, 2] * q[:, 3]).sum(), relative=0.02)
    c.near("tool of particles: they move with the tool", np.hypot(t["c_xb"][-1] - t["f_tool[7]"][-1],
           t["c_yb"][-1] - t["f_tool[8]"][-1]), 0, absolute=1e-12)
    c.near("tool of particles: heat in them on two ranks", two["c_T2"][-1] - 300, t["c_T2"][-1] - 300, relative=1e-6)
    c.near("tool of particles: energy book", np.ptp(t["f_body"]) / t["f_body[8]"].min(), 0, absolute=2e-3)


def errors(c):
    """What is wrong is said before step 0, with a remedy."""
    folder = new_folder()
    make_tool(folder, "block", "--size", 4, 4, 4)
    meshes = os.path.join(SOURCE, "unittest", "meshes")
    cases = [("file none.stl", "none.stl"), ("file %s/page.stl" % meshes, "HTML"),
             ("file %s/binary_cut.stl" % meshes, "truncated"), ("file %s/inside_out.stl" % meshes, "flip yes"),
             ("file %s/one_turned.stl" % meshes, "sides two"), ("friction 0.1", "needs a mesh"),
             ("file tool.stl friction -1", "friction must be a number >= 0, got -1"),
             ("file tool.stl rotate 0 0 1 90", "rotate axis ax ay az angle"),
             ("file tool.stl heat hot", "none, perfect or conductance"),
             ("file tool.stl vtk 100 tool.vtk", "needs a *"), ("file tool.stl strange 1", "keyword strange"),
             ("file tool.stl scale 1e-3 move 7e-3 3e-3 3e-3", "overlaps particles, by 0.001"),
             ("file tool.stl particles 1", "only conducts heat"),
             ("file tool.stl penalty", "penalty needs 1 value"),
             ("file tool.stl share 0.5 effusivity 1", "either share or effusivity")]
    for text, due in cases:
        r = run(block("fix tool all contact/tri %(text)s\nrun 0\n", text=text), folder=folder, expect_error=True)
        c.true("error: " + text.replace(meshes, ".."), r.status != 0 and due in r.output, r.errors()[:90])


if __name__ == "__main__":
    checks = Checks()
    wanted = sys.argv[1:] or ["books", "motion", "slope", "restart", "heat", "tool_of_particles", "errors"]
    for name in wanted:
        globals()[name](checks)
    checks.end()
