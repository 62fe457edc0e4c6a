"""Keyword active of fix sph/tm: a window that moves with the tool along a long work piece.

Forces and chip as without it; particles that sleep keep their state to the last bit and wake when a tool, the window or
something that moves comes near; the energy sum stays; one and two ranks and a restarted run agree to the last bit; the
time falls with the share that is active."""
import re

import numpy as np

from contact_scene import mesh
from sphtm_scene import PLANE, Checks, new_folder, run

CUT = PLANE + """
atom_modify     map array
lattice         sq 2e-5 origin 0.5 0.5 0
region          box block -0.4e-3 6.6e-3 -0.5e-3 0.6e-3 -1e-6 1e-6 units box
create_box      1 box
region          work block 0 {length} -0.3e-3 0 INF INF units box
create_atoms    1 region work
region          base block INF INF INF -0.24e-3 INF INF units box
group           base region base
"""
STYLE = """
pair_style      sph/tm hyperbolic 1.2 spacing 2e-5
pair_coeff      1 1 materials.sphtm al6082-t6
"""
FIXES = """
variable        way equal -50*time
region          win block $(v_length-0.35e-3) $(v_length+0.25e-3) INF INF INF INF units box move v_way NULL NULL
fix             body all sph/tm temperature 293 energy yes {active}
fix             hold base setforce 0 0 0
fix             tool all contact/tri file tool.stl scale 1e-3 move $(v_length+1e-6) -8e-5 0 friction 0.3 &
                heat conductance 1e5
fix_modify      tool move linear -50 0 0
compute         fc all cutting/force tool
compute         p all sph/tm/atom active density pressure vonmises pstrain temperature
variable        moves atom c_p[1]>1.5
compute         moves all reduce ave v_moves
thermo          {every}
thermo_style    custom step time cpu c_fc[1] c_fc[2] f_body[8] f_body[9] f_body[7] c_moves
thermo_modify   format float %.15g
"""
INSERT = "insert --rake 10 --clearance 8 --radius 0 --height 0.5 --length 0.4 --width 0.2"
WINDOW = "active region win speed 2"
DUMP = "dump d all custom {n} out.dump id x y vx vy c_p[*]\ndump_modify d sort id format float %.17g\n"


def cut(active, steps, length=2.4e-3, ranks=1, more="", every=100, folder=None, start=None, tail=""):
    folder = folder or new_folder()
    mesh(folder, "tool.stl", INSERT)
    script = (start or CUT.format(length=length) + STYLE) + FIXES.format(active=active, every=every) + more
    return run("variable length index %g\n" % length + script + "run %d\n" % steps + tail, ranks=ranks, folder=folder)


def lines(result, name):
    with open(result.path(name)) as f:
        text = f.read().split("ITEM: ATOMS")[-1].splitlines()[1:]
    return sorted(text, key=lambda l: int(l.split()[0]))


def forces_and_time(checks):
    """A long bar, with the window and without: 6 mm, of which a tenth is active."""
    more = DUMP.format(n=1500)
    steps = 3000
    whole = cut("", steps, 6e-3, more=more)
    part = cut(WINDOW, steps, 6e-3, more=more)
    a, b = whole.thermo[-1], part.thermo[-1]
    late = a["Time"] > 0.5 * a["Time"][-1]
    for k, name in (("c_fc[1]", "cutting force"), ("c_fc[2]", "thrust")):
        f, g = a[k][late].mean(), np.interp(a["Time"], b["Time"], b[k])[late].mean()
        checks.near("mean %s with the window" % name, g, f, relative=0.03 if k == "c_fc[1]" else 0.12)
    x, y = whole.dump("out.dump")[-1], part.dump("out.dump")[-1]
    far = np.hypot(x["x"] - y["x"], x["y"] - y["y"]) / 2e-5
    checks.below("root mean square of the difference of places, spacings", np.sqrt((far ** 2).mean()), 0.25)
    checks.near("plastic strain, sum over particles", y["c_p[5]"].sum(), x["c_p[5]"].sum(), relative=0.05)
    share = b["c_moves"][1:].mean()
    checks.below("share of particles that move", share, 0.13)
    for name, t in (("without", a), ("with", b)):
        work = np.abs(t["f_body[8]"]).max()
        checks.below("drift of the energy sum over the work, %s" % name,
                     np.abs(t["f_body[9]"] - t["f_body[9]"][0]).max() / work, 5e-3)
    # of the second half: the first step has all particles
    mid = len(a["CPU"]) // 2
    cost = [(t["CPU"][-1] - t["CPU"][mid]) / (steps / 2) for t in (a, b)]
    checks.note("time per step without, with", "%.3g, %.3g ms; %.1f times less at %.1f %% moving; %s" %
                (1e3 * cost[0], 1e3 * cost[1], cost[0] / cost[1], 100 * share,
                 re.search(r"active: .*", part.output).group(0)))
    checks.above("times less time", cost[0] / cost[1], 2.0)


def same_bits(checks):
    """Sleeping particles keep their state; ranks and restarts do not matter."""
    more = DUMP.format(n=10) + "restart 1510 at.*.restart\n"    # they are looked at in every second of these
    one = cut(WINDOW, 3000, more=more)
    frames = one.dump("out.dump")
    slept = kept = 0
    for before, after in zip(frames[1:-1], frames[2:]):
        both = (before["c_p[1]"] == 0) & (after["c_p[1]"] == 0)
        slept += both.sum()
        kept += (both & np.all([before[k] == after[k] for k in before if k.startswith(("x", "y", "v", "c_p"))],
                               axis=0)).sum()
    checks.true("%d of %d rows of sleeping particles are the same 10 steps later" % (kept, slept),
                slept > 100000 and kept == slept)
    last = frames[-1]
    away = last["c_p[1]"] == 0
    checks.true("they are at rest", np.all(last["vx"][away] == 0) and np.all(last["vy"][away] == 0))
    checks.true("there are particles at the edge", (last["c_p[1]"] == 1).sum() > 10)
    woke = (frames[1]["c_p[1]"] == 0) & (last["c_p[1]"] == 2)
    checks.above("particles that slept and move at the end", woke.sum(), 20)
    again = (np.array([f["c_p[1]"] for f in frames[1:]]) == 2).any(axis=0) & away
    checks.above("particles that moved and sleep at the end", again.sum(), 50)
    reference = lines(one, "out.dump")    # of the last frame
    two = cut(WINDOW, 3000, more=DUMP.format(n=3000), ranks=2)
    checks.true("two ranks, same bits", lines(two, "out.dump") == reference)
    rest = cut(WINDOW, 1490, more=DUMP.format(n=3000), folder=one.folder,
               start="newton off\nread_restart at.1510.restart\n")
    checks.true("restarted, same bits", lines(rest, "out.dump") == reference)


def near(checks):
    """Without a region, by the distance from the tool."""
    whole, part = cut("", 1200), cut("active near 2.5e-4 speed 2", 1200)
    a, b = whole.thermo[-1], part.thermo[-1]
    late = a["Time"] > 0.5 * a["Time"][-1]
    f, g = a["c_fc[1]"][late].mean(), np.interp(a["Time"], b["Time"], b["c_fc[1]"])[late].mean()
    checks.near("near the tool: mean cutting force", g, f, relative=0.05)
    checks.below("near the tool: share of particles that move", b["c_moves"][-1], 0.3)


HIT = PLANE + """
lattice         sq 1e-3 origin 0.5 0.5 0
region          box block -0.05 0.05 -0.02 0.02 -5e-4 5e-4 units box
create_box      1 box
region          left block -0.023 -0.005 -0.005 0.005 INF INF units box
region          right block 0 0.018 -0.005 0.005 INF INF units box
create_atoms    1 region left
create_atoms    1 region right
group           left region left
group           right region right
region          none block -0.04 -0.038 INF INF INF INF units box
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 2700 elastic 70e9 0.33
fix             body all sph/tm energy yes {active}
velocity        left set 20 0 0 units box
compute         p all sph/tm/atom active
compute         k all reduce sum vx
compute         right right reduce ave vx
compute         least right reduce max c_p
thermo          200
thermo_style    custom step time c_k c_right c_least f_body[9] f_body[7]
run             11000
"""


def impact(checks):
    """A bar that moves wakes one that sleeps: it takes over the velocity."""
    every = 10
    free, part = run(HIT.format(active="")), run(HIT.format(active="active region none speed 0.05 every %d" % every))
    a, b = free.thermo[-1], part.thermo[-1]
    checks.true("the bar that is hit sleeps before", b["c_least"][2] == 0)
    checks.true("and moves after", b["c_least"][-1] == 2)
    checks.near("its velocity after", b["c_right"][-1], a["c_right"][-1], relative=0.01)
    checks.near("momentum", b["c_k"][-1], b["c_k"][0], relative=0.005)
    checks.below("energy sum: drift over the kinetic energy", abs(b["f_body[9]"][-1] / b["f_body[9]"][0] - 1), 5e-3)


def conduction(checks):
    """A hot block half inside of the window: heat stays in what is active, and none is lost."""
    script = PLANE + """
lattice         sq 1e-3 origin 0.5 0.5 0
region          box block -0.01 0.07 -0.01 0.02 -5e-4 5e-4 units box
create_box      1 box
region          work block 0 0.06 0 0.01 INF INF units box
create_atoms    1 region work
region          hot block 0 0.01 INF INF INF INF units box
group           hot region hot
region          win block INF 0.025 INF INF INF INF units box
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 precision {precision}
pair_coeff      1 1 density 2700 elastic 70e9 0.33 heat 200 900 0.9
fix             body all sph/tm temperature 300 active region win speed 1e-3 conduction {scheme}
fix_modify      body temperature hot 400
compute         p all sph/tm/atom active temperature
compute         all all reduce ave c_p[2]
compute         most all reduce max c_p[2]
thermo          10
thermo_style    custom step time c_all c_most
thermo_modify   format float %.15g
dump            d all custom 200 out.dump id x c_p[*]
run             400
"""
    for scheme, precision, error in ("rkl2", "double", 1e-12), ("explicit", "double", 1e-12), ("explicit", "mixed", 1e-9):
        r = run(script.format(scheme=scheme, precision=precision))
        t = r.thermo[-1]
        scheme = "%s, %s" % (scheme, precision)
        checks.near("%s: mean temperature" % scheme, t["c_all"][-1], t["c_all"][0], relative=error)
        f = r.dump("out.dump")[-1]
        asleep = f["c_p[1]"] == 0
        checks.true("%s: what sleeps has kept its temperature" % scheme,
                    asleep.sum() > 200 and np.all(f["c_p[2]"][asleep] == 300))


def main():
    checks = Checks()
    impact(checks)
    conduction(checks)
    near(checks)
    same_bits(checks)
    forces_and_time(checks)
    checks.end()


main()
