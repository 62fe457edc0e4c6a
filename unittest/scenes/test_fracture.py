"""Numerical fracture: particles that lose their neighbors on one side without damage are counted and reported; what flows,
bends, is pressed flat, breaks by damage or is cut by hand is not.

tears     a bar in tension without shifting breaks: a warning with the first particle, the number at the end,
          marks on particles of both sides of the gap; on one and on two ranks; over a restart; off: nothing
fails     the same bar with a damage law that it breaks by: none
whole     the bar in tension that holds; a block spun and thrown; a block pressed to half its height
"""
import re

import numpy as np
from sphtm_scene import Checks, lattice_block, run

checks = Checks()
BAR = lattice_block("0 60e-3 0 10e-3", "-0.05 0.2 -0.03 0.04") + """
pair_style      sph/tm hyperbolic 1.2 spacing lattice {style}
pair_coeff      1 1 density 2700 elastic 70e9 0.33 {material}
region          left block INF 2.6e-3 INF INF INF INF units box
region          right block 57.4e-3 INF INF INF INF INF units box
group           left region left
group           right region right
fix             body all sph/tm {fix}
velocity        all set 0 0 0
fix             pull right sph/tm/drive {pull} 0 0
fix             hold left sph/tm/drive 0 0 0
compute         p all sph/tm/atom fracture pstrain damage failed
compute         lost all reduce sum c_p[1]
compute         failed all reduce sum c_p[4]
thermo          500
thermo_style    custom step time {torn} c_lost c_failed
"""
DUMP = "dump d all custom 1 out.dump id x y z c_p[*]\ndump_modify d sort id format float %.17g\nrun 0 post no\n"
SOFT = "strength plastic 100e6 50e6"
STAYS = "effects shifting off"


def bar(style="", material=SOFT, fix="", pull=40, steps=6000, more="", torn="f_body[15]", **a):
    return run(BAR.format(style=style, material=material, fix=fix, pull=pull, torn=torn) + more + "run %d\n" % steps + DUMP, **a)


def said(r):
    return [w for w in r.warnings() if "numerical fracture" in w]


counts = []
for ranks in 1, 2:
    r = bar(fix=STAYS, ranks=ranks)
    t, frame = r.thermo[0], r.dump("out.dump")[-1]
    counts.append((t["f_body[15]"][-1], said(r)[:1]))
    name = "tears, %d ranks: " % ranks
    checks.above(name + "particles", t["f_body[15]"][-1], 4)
    checks.true(name + "none at the start, never fewer", t["f_body[15]"][0] == 0 and np.all(np.diff(t["f_body[15]"]) >= 0))
    checks.true(name + "as many are marked", t["c_lost"][-1] == t["f_body[15]"][-1] == frame["c_p[1]"].sum())
    checks.true(name + "one warning", len(said(r)) == 1 and "damage 0, plastic strain" in said(r)[0], "%s" % r.warnings())
    end = re.search(r"numerical fracture: (\d+) of 600 particles; the first at step (\d+), time \S+: particle (\d+)", r.output)
    checks.true(name + "the closing table has it", end and float(end.group(1)) == t["f_body[15]"][-1], r.output[-600:])
    torn = frame["c_p[1]"] > 0.5
    near = torn & (frame["y"] > 0)
    checks.note(name + "first at step, places x (mm)", "%s, %s" % (end and end.group(2), np.round(1e3 * np.sort(frame["x"][near]), 1)))
checks.true("the same on 2 ranks", counts[0] == counts[1], "%s" % counts)

r = bar(fix=STAYS, more="run 4500\nwrite_restart half.restart\n", steps=1)
again = run("read_restart half.restart\ngroup left id 1\ngroup right id 1\nfix body all sph/tm\n"
            "fix pull right sph/tm/drive 40 0 0\nfix hold left sph/tm/drive 0 0 0\n"
            "thermo_style custom step f_body[15]\nrun 0\n", folder=r.folder, expect_error=True)
checks.true("restart: the number is kept", again.thermo and again.thermo[0]["f_body[15]"][0] == r.thermo[0]["f_body[15]"][-1],
            again.errors())

r = bar(fix=STAYS + " effects fracture off", torn="dt")
checks.true("off: nothing is said or marked", not said(r) and r.thermo[0]["c_lost"][-1] == 0 and
            "numerical fracture" not in r.output)
r = bar(fix="effects fracture off", expect_error=True)
checks.true("off: [15] is an error that says so", "output 15 needs the effect fracture" in r.errors(), r.errors())

r = bar()
checks.true("whole: with the default", r.thermo[0]["f_body[15]"][-1] == 0 and "numerical fracture: none" in r.output)

r = bar(material=SOFT + " damage strain 0.03")
t = r.thermo[0]
checks.above("fails: by damage", t["c_failed"][-1], 10)
checks.true("fails: the end of the log has their number", "failed by damage: %d of " % t["c_failed"][-1] in r.output)
checks.true("fails: that is no numerical fracture", t["f_body[15]"][-1] == 0, "%g of %g" % (t["f_body[15]"][-1], t["c_failed"][-1]))

r = bar(style="", pull=10)
checks.true("whole: in tension, hourglass control", r.thermo[0]["f_body[15]"][-1] == 0 and "numerical fracture: none" in r.output,
            "%g" % r.thermo[0]["f_body[15]"][-1])

BLOCK = lattice_block("-10e-3 10e-3 -10e-3 10e-3", "-0.1 0.1 -0.1 0.1") + """
pair_style      sph/tm hyperbolic 1.2 spacing lattice
pair_coeff      1 1 density 2700 elastic 70e9 0.33 strength plastic 300e6 300e6
fix             body all sph/tm
{more}
thermo          200
thermo_style    custom step time f_body[15] {most}
run             {steps}
"""
r = run(BLOCK.format(steps=3000, most="", more="variable u atom 30-2e4*y\nvariable w atom 2e4*x\nvelocity all set v_u v_w 0 units box"))
checks.true("whole: thrown and spun", r.thermo[0]["f_body[15]"].max() == 0, "%g" % r.thermo[0]["f_body[15]"].max())
r = run(BLOCK.format(steps=20000, most="c_most", more="""region low block INF INF INF -8e-3 INF INF units box
region high block INF INF 8e-3 INF INF INF units box
group low region low
group high region high
fix down high sph/tm/drive NULL -100 NULL
fix hold low sph/tm/drive NULL 0 NULL
compute p all sph/tm/atom pstrain
compute most all reduce max c_p
variable far equal 100*time
fix stop all halt 200 v_far > 9.5e-3 error continue message no"""))
checks.above("whole: pressed by", r.thermo[0]["Time"][-1] * 100, 9.5e-3)
checks.note("pressed to half its height: largest strain, torn", "%.2f %d" % (r.thermo[0]["c_most"][-1], r.thermo[0]["f_body[15]"][-1]))
checks.true("whole: pressed to half its height", r.thermo[0]["f_body[15]"][-1] == 0)
checks.end()
