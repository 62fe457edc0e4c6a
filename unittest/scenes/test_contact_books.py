"""Momentum, heat and energy of a body that meets tools: nothing is lost.

A block flies into a corner of a moving plate and a turning wedge, with damping, friction, heat and conduction on; the
tools are at 600 K, one of them lumped (its temperature rises with the heat that it takes).
 - change of momentum = - sum of f_tool dt, to round-off, in total and whatever the motion of the tools;
 - heat taken by the particles = sum of (friction power [10] - heat into the tool [11]) dt, to round-off;
 - rise of the lumped tool = sum of [11] dt over its capacity, to round-off;
 - plates that close on particles which touch both: the energy book again;
 - the same where other fixes change forces behind the tools (sph/tm/relax, sph/tm/drive, viscous, setforce) or between them;
 - the energy book: [9] of fix sph/tm constant within 1 % of the energy that was turned over, with a quarter of
   the step within 0.1 %; elastic, and plastic with Johnson and Cook.
Friction alone against a tool that does not conduct: its heat is divided by effusivity, particle by particle."""
import numpy as np
from contact_scene import block, header, mesh, particles
from sphtm_scene import Checks, new_folder, run

DX = 0.01
ELASTIC = "density 1000 elastic 1e7 0.3 heat {k} {cp} 0.9"
PLASTIC = "density 1000 elastic 1e7 0.3 strength johnson/cook 4e5 4e5 0.5 0.02 1 293 2000 1 heat {k} {cp} 0.9"
SCRIPT = """
pair_coeff 1 1 {material}
fix body all sph/tm energy yes temperature 300 effects artificial-heat off {dt}
fix plate all contact/tri file plane.stl rotate axis 1 0 0 angle -90 friction 0.4 damping 0.2 &
    heat conductance 2e4 lumped 1.0 50 600 effusivity 5000 smooth 30
fix wedge all contact/tri file wedge.stl scale 0.1 move 0.14 0.045 0 friction 0.3 damping 0.1 &
    heat perfect temperature 600
fix_modify plate move linear 0 0.5 0
fix_modify wedge move rotate 0.14 0.045 0 0 0 1 0.05
variable m equal mass(all)
compute v all reduce ave vx vy vz
compute t all sph/tm/atom temperature
compute T all reduce ave c_t
compute Tmax all reduce max c_t
thermo_style custom step time f_body[*] c_v[*] c_T c_Tmax f_plate f_plate[*] f_wedge[*] v_m
thermo_modify norm no format float %.17g
thermo 1
run {steps}
"""


def fly(material, steps, dt="", k=50.0, cp="900"):
    folder = new_folder()
    mesh(folder, "plane.stl", "plane --size 0.6 0.2 --cells 7 3")
    mesh(folder, "wedge.stl", "block --size 1 1 2 --cells 2 2 2")
    x = block((8, 6, 6), DX, (-0.02, 0.001, -0.03))
    v = np.tile([6.0, -3.0, 0.7], (len(x), 1))
    script = header(DX) + SCRIPT.format(material=material.format(k=k, cp=cp), steps=steps, dt=dt)
    data = particles(x, [(-0.5, 0.5), (-0.1, 0.5), (-0.3, 0.3)], v=v)
    return run(script, files={"data.scene": data}, folder=folder).thermo[-1]


def momentum(checks, t):
    dt = t["f_body[10]"]
    F = np.array([t["f_plate[%d]" % k] + t["f_wedge[%d]" % k] for k in (1, 2, 3)])
    P = t["v_m"] * np.array([t["c_v[%d]" % k] for k in (1, 2, 3)])
    for k in range(3):
        impulse = np.cumsum(F[k][1:] * dt[1:])
        error = abs(P[k][1:] - P[k][0] + impulse).max() / abs(P).max()
        checks.below("momentum %s + impulse on the tools, relative" % "xyz"[k], error, 1e-12)
    for name in ("plate", "wedge"):
        checks.above("    contacts with the %s, most" % name, t["f_%s[12]" % name].max(), 5)


def heat(checks, t, taken):
    dt = t["f_body[10]"][1:]
    given = sum(np.cumsum((t["f_%s[10]" % n] - t["f_%s[11]" % n])[1:] * dt) for n in ("plate", "wedge"))
    checks.below("heat of particles less friction plus heat into tools", abs(taken[1:] - given).max() / abs(taken).max(), 1e-11)
    friction = sum(np.cumsum(t["f_%s[10]" % n][1:] * dt)[-1] for n in ("plate", "wedge"))
    checks.note("    heat of the particles, friction work (J)", "%.6g, %.6g" % (taken[-1], friction))
    rise = np.cumsum(t["f_plate[11]"][1:] * dt) / 50
    checks.below("rise of the lumped tool less its heat", abs(t["f_plate"][1:] - 600 - rise).max() / abs(rise).max(), 1e-10)


def energy(checks, name, t, bound):
    turned = abs(np.array([t["f_body[%d]" % k] for k in range(1, 9)]) - t["f_body[1]"][0] * np.array([1] + 7 * [0])[:, None]).max()
    # work of the stress that is not stored stands apart
    book = t["f_body[9]"] + t["f_body[13]"]
    drift = abs(book - book[0])
    checks.below(name + ": work of the stress that is not stored, over the largest part", abs(t["f_body[13]"]).max() / turned, 0.02)
    parts = " ".join("%.4g" % t["f_body[%d]" % k][-1] for k in range(1, 9))
    checks.note(name + ": kinetic ... external at the end (J)", parts)
    if bound:
        checks.below(name + ": drift of the sum over the largest part", drift.max() / turned, bound)
    return drift[-1] / turned


CLOSING = """
pair_coeff 1 1 density 1000 elastic 1e7 0.3 heat 0 900 0.9
fix body all sph/tm energy yes temperature 300 dt {dt}
fix low all contact/tri file plane.stl rotate axis 1 0 0 angle -90 friction 0.3 damping 0.2 share 0.5 heat conductance 1e-9
fix high all contact/tri file plane.stl rotate axis 1 0 0 angle 90 move 0 {top} 0 friction 0.2 damping 0.1 share 1 &
    heat conductance 1e-9
fix_modify high move linear 0.4 -0.5 0
thermo_style custom step time f_body[*] f_low[*] f_high[*]
thermo_modify norm no format float %.17g
thermo 10
run {steps}
"""


def closing(checks):
    """Plates that close on a single layer, so that every particle touches both of them, and slide: the sum stays."""
    folder = new_folder()
    mesh(folder, "plane.stl", "plane --size 0.6 0.2 --cells 7 3")
    error = []
    for parts in (1, 4):
        x = block((6, 1, 6), DX, (-0.03, 0, -0.03))
        dt = 1e-5 / parts
        script = header(DX) + CLOSING.format(dt=dt, steps=200 * parts, top=DX)
        t = run(script, files={"data.scene": particles(x, [(-0.5, 0.5), (-0.1, 0.5), (-0.3, 0.3)])}, folder=folder).thermo[-1]
        both = min(t["f_low[12]"][-1], t["f_high[12]"][-1])
        work = abs(t["f_body[8]"]).max()
        error.append(abs(t["f_body[9]"]).max() / work)
        checks.true("closing plates: every particle touches both", both == len(x), "%g" % both)
    checks.below("closing plates: drift of the sum over the work of the tools", error[0], 2e-3)
    checks.below("    a quarter of the step", error[1], 5e-4)


BEHIND = """
pair_coeff 1 1 density 1000 elastic 1e7 0.3
region grip block INF INF 0.035 INF INF INF units box
group grip region grip
fix body all sph/tm energy yes
fix low all contact/tri file plane.stl rotate axis 1 0 0 angle -90 friction 0.3 damping 0.2
{before}
fix high all contact/tri file plane.stl rotate axis 1 0 0 angle 90 move 0 0.06 0 friction 0.2 damping 0.1
{behind}
fix_modify high move linear 0 -1 0 ramp 1e-4
thermo_style custom step time f_body[*] f_low[*] f_high[*]
thermo_modify norm no format float %.17g
thermo 10
run 400
"""


def behind(checks):
    """Fixes that change forces behind a tool, or between two: the sum stays as without them."""
    folder = new_folder()
    mesh(folder, "plane.stl", "plane --size 0.6 0.2 --cells 7 3")
    x = block((6, 6, 6), DX, (-0.03, 0, -0.03))
    for name, before, after in (("nothing", "", ""), ("sph/tm/relax", "", "fix rest all sph/tm/relax"),
                                ("viscous between the tools", "fix slow all viscous 2.0", ""), ("viscous", "", "fix slow all viscous 2.0"),
                                ("a drive", "", "fix pull grip sph/tm/drive NULL -1.0 0.2"), ("held particles", "", "fix hold grip setforce 0 0 0")):
        script = header(DX) + BEHIND.format(before=before, behind=after)
        t = run(script, files={"data.scene": particles(x, [(-0.5, 0.5), (-0.1, 0.5), (-0.3, 0.3)])}, folder=folder).thermo[-1]
        turned = max(abs(t["f_body[8]"]).max(), abs(t["f_body[2]"]).max())
        checks.above("behind the tools, %s: contacts" % name, t["f_high[12]"].max(), 30)
        checks.below("    drift of the sum over the energy turned over", abs(t["f_body[9]"] - t["f_body[9]"][0]).max() / turned,
                     4e-3 if name == "held particles" else 2e-4)


def split(checks):
    """One particle slides along a plate: heat by effusivity, or by the share given."""
    k, rho, cp = 120.0, 2700.0, 899.0
    tool = np.sqrt(50.7 * 7870 * 486)
    folder = new_folder()
    mesh(folder, "plane.stl", "plane --size 0.6 0.2 --cells 7 3")
    by_effusivity = np.sqrt(k * rho * cp) / (np.sqrt(k * rho * cp) + tool)
    for words, due in (("effusivity %r" % float(tool), by_effusivity), ("material 50.7 7870 486", by_effusivity),
                       ("share 0.25", 0.25), ("share 1", 1.0), ("share 0", 0.0), ("effusivity 0", 1.0), ("", 0.5)):
        # a conductance too small to matter switches heat on
        script = header(DX) + """
pair_coeff 1 1 density 2700 elastic 7e10 0.33 heat %r %r 0.9
fix body all sph/tm temperature 300 dt 1e-7
fix g all gravity 1e4 vector 0 0 -1
fix tool all contact/tri file plane.stl friction 0.3 heat conductance 1e-9 temperature 300 %s
compute t all sph/tm/atom temperature
compute T all reduce max c_t
thermo_style custom step c_T f_tool[10] f_tool[11]
thermo_modify format float %%.17g
thermo 1
run 2000
""" % (k, cp, words)
        data = particles([(0.01, 0, 0.5 * DX)], [(-0.5, 0.5)] * 3, v=[(10, 1, 0)])
        result = run(script, files={"data.scene": data}, folder=folder)
        t = result.thermo[-1]
        mass = rho * DX ** 3
        work = t["f_tool[10]"][1:].sum() * 1e-7
        checks.near("share of friction heat, %s" % (words or "default"), mass * cp * (t["c_T"][-1] - 300) / work, due,
                    absolute=1e-6)
        said = "half: the tool's material is not known" in result.output
        checks.true("    the log says where half of it is a guess", said == (words == ""))
        checks.near("    friction power [10] over mu W v", t["f_tool[10]"][-1] / (0.3 * mass * 1e4 * (np.sqrt(101) - 0.3 * 1e4 * 2e-4)), 1,
                    relative=1e-3)


def taken_away(checks):
    """A tool that is removed while it presses, and one that takes its place in the same overlap: the sum stays."""
    folder = new_folder()
    mesh(folder, "plane.stl", "plane --size 0.6 0.2 --cells 7 3")
    x = block((8, 6, 6), DX, (-0.02, 0.001, -0.03))
    text = header(DX) + "pair_coeff 1 1 " + ELASTIC.format(k=50, cp=900) + """
fix body all sph/tm energy yes
fix plate all contact/tri file plane.stl rotate axis 1 0 0 angle -90
fix_modify plate move linear 0 2 0
thermo_style custom step time f_body[*]
thermo_modify format float %.17g
thermo 1
run 40
fix plate all contact/tri file plane.stl rotate axis 1 0 0 angle -90 move 0 $(2*time) 0 overlap allow
run 1
unfix plate
run 100
"""
    r = run(text, files={"data.scene": particles(x, [(-0.5, 0.5), (-0.1, 0.5), (-0.3, 0.3)])}, folder=folder)
    placed, removed = ([r.thermo[k + 1]["f_body[%d]" % n][0] - r.thermo[k]["f_body[%d]" % n][-1] for n in (5, 9)] for k in (0, 1))
    spring = -removed[0]
    checks.above("removed tool: energy of its springs, of what was turned over", spring / abs(r.thermo[-1]["f_body[8]"][-1]), 0.01)
    checks.below("    jump of the sum of the energies, of that of the springs", abs(removed[1]) / spring, 1e-9)
    checks.below("tool in the place of another: the same", abs(placed[1]) / spring, 1e-9)


def main():
    checks = Checks()
    taken_away(checks)
    t = fly(ELASTIC, 1500)
    momentum(checks, t)
    heat(checks, t, t["v_m"] * 900 * (t["c_T"] - 300))
    first = energy(checks, "elastic", t, 1e-2)
    dt = 0.25 * t["f_body[10]"].min()
    fine = energy(checks, "elastic, a quarter of the step", fly(ELASTIC, 6000, "dt %r" % float(dt)), 1e-3)
    checks.above("    error of the energy falls with the step, order", np.log(first / fine) / np.log(4), 1.5)
    t = fly(PLASTIC, 1500)
    momentum(checks, t)
    energy(checks, "plastic", t, 1e-2)
    t = fly(ELASTIC, 600, cp="table/3 250 700 350 1100 900 1000")
    energy(checks, "c_p(T)", t, 1e-2)
    closing(checks)
    behind(checks)
    split(checks)
    checks.end()


main()
