"""What goes wrong during a run stops it: with the particle's tag, its position, the cause, a status that is not 0 and
restart files that still read."""
import glob
import os
import re
import sys

from sphtm_scene import Checks, lattice_block, run

# with artificial stress: what drives each state off here was found with it, and nothing but messages is looked at
SCENE = """
pair_style sph/tm hyperbolic 1.2 spacing 1e-3 stabilize artstress
pair_coeff 1 1 density 2700 elastic 70e9 0.33 strength johnson/cook 428e6 327e6 1.008 0.01 1.31 293 855 1.0 &
  heat 200 900 0.9
fix body all sph/tm {fix}
group one id 30
thermo 10
restart 10 state.*.restart
run 20
{lines}
run 80
"""
SMALL, LARGE = "-5e-3 13e-3 -5e-3 13e-3", "-1 1 -1 1"
AGAIN = """
read_restart state.20.restart
fix body all sph/tm
thermo 10
compute p all sph/tm/atom density temperature
compute low all reduce min c_p[1] c_p[2]
thermo_style custom step atoms c_low[1] c_low[2]
run 20
"""


def script(box, fix="", lines="", work="0 8e-3 0 8e-3", dx="1e-3"):
    text = SCENE.format(fix=fix, lines=lines)
    if box != HEAVY:
        return lattice_block(work, box, dx, more="atom_modify     map array\n") + text
    second = "pair_coeff 2 2 density 2700000 elastic 70e12 0.33 heat 200 900 0.9\nset atom 31 type 2\nfix body"
    return lattice_block(work, LARGE, dx, types=2, more="atom_modify     map array\n") + text.replace("fix body", second, 1)


# name, box, words of fix sph/tm, lines before the second run, fragments of the message
# a heavy particle shot through light ones takes their density below zero
HEAVY = "types"
PRESSED = ("variable k equal -0.45/dt\nvariable vx atom v_k*(x-4e-3)\nvariable vy atom v_k*(y-4e-3)\n"
           "velocity all set v_vx v_vy NULL units box")
CONDUCTOR = ("pair_coeff 1 1 density 2700 elastic 70e9 0.33 strength johnson/cook 428e6 327e6 1.008 0.01 1.31 293 855 1.0 "
             "heat table/2 300 200 500 1e12 900 0.9\n")
CASES = [
    ("a force that becomes infinite", LARGE, "", "variable f equal exp(800*(step>25))\nfix push one addforce v_f 0 0",
     ["particle 30", "not a number", "Likely cause"]),
    ("a runaway particle", LARGE, "", "fix push one addforce 1e10 0 0",
     ["particle 30", "velocity", "ten times the speed of sound", "Likely cause"]),
    ("a velocity set too high", LARGE, "", "velocity one set 1e6 0 0 units box",
     ["particle 30", "velocity", "ten times the speed of sound"]),
    ("a density below zero", HEAVY, "density/max 1e9", "group heavy id 31\nvelocity heavy set 300 0 0 units box", ["particle", "density", "not positive", "Likely cause"]),
    ("a density beyond a factor of 3", LARGE, "courant 0.8", PRESSED,
     ["particle", "density is ", "times that of the material", "density/max", "neighbors within reach",
      "compressed or stretched"]),
    ("plastic strain of more than 1 in a step", LARGE, "density/max 1e9",
     "variable vx atom 6e4*(y>4e-3)-6e4*(y<4e-3)\nvelocity all set v_vx NULL NULL units box",
     ["particle", "plastic strain grew by", "in one step", "lower courant"]),
    ("heat without end", LARGE, "", "fix glow one sph/tm/heat source 1e18",
     ["particle 30", "is above the 8550 of temperature/max", "heat source or flux"]),
    ("a temperature above the given largest", LARGE, "temperature/max 400", "fix glow one sph/tm/heat source 1e17",
     ["particle 30", "is above the 400 of temperature/max"]),
    ("a particle that leaves the box", SMALL, "", "group last id 32\nvelocity last set 8000 0 0 units box",
     ["particle 32", "leaves the box", "x upper boundary", "velocity", "lost ignore"]),
    ("heat taken out without end", LARGE, "", "fix sink one sph/tm/heat source -1e20",
     ["particle 30", "temperature", "not positive", "heat sink"]),
    # a step that falls: heat conduction of a table, which a hot particle makes fast; a constant one is refused for it
    ("a step that falls to nothing", LARGE, "conduction explicit", CONDUCTOR + "fix_modify body temperature one 600",
     ["the time step has fallen to", "of what it was", "limited by heat conduction at particle 30"]),
    ("a constant step that conduction outgrows", LARGE, "dt 2e-8 conduction explicit",
     CONDUCTOR + "fix_modify body temperature one 600",
     ["Fix sph/tm dt 2e-08 is not stable: heat conduction allows"]),
]


def stopped(checks, name, box, words, lines, fragments, ranks=1):
    result = run(script(box, words, lines), expect_error=True, timeout=120, ranks=ranks)
    errors = result.errors()
    missing = [f for f in fragments if f not in errors]
    checks.true(name + ": says what and where", result.status > 0 and not missing and "Loop time" in result.output,
                "status %d, not said: %s <- %s" % (result.status, ", ".join(missing), errors[:300])
                if missing or result.status < 1 else "")
    at = "not stable" in errors or re.search(r"at (-?[\d.e+-]+) (-?[\d.e+-]+) (-?[\d.e+-]+)", errors)
    checks.true(name + ": position", at is True or at and abs(float(at.group(1))) < 1 and abs(float(at.group(2))) < 1,
                errors[:300] if not at else "")
    steps = [int(re.search(r"state\.(\d+)\.", f).group(1))
             for f in glob.glob(os.path.join(result.folder, "state.*.restart"))]
    again = run(AGAIN, folder=result.folder, expect_error=True)
    last = again.thermo[-1] if again.status == 0 and again.thermo else {}
    good = last and last["Step"][-1] == 40 and last["Atoms"][-1] == 64
    checks.true(name + ": an earlier restart file goes on", 20 in steps and good, "" if good else again.output[-300:])


checks = Checks()
wanted = sys.argv[1:]
for case in CASES:
    if not wanted or any(w in case[0] for w in wanted):
        stopped(checks, *case)
if not wanted:
    stopped(checks, "on two ranks, a runaway particle", *CASES[1][1:], ranks=2)

    # who asks for it may lose particles; all others go on
    result = run(script(SMALL, "lost ignore", next(c[3] for c in CASES if "leaves the box" in c[0]) +
                        "\nthermo_modify lost ignore"))
    checks.near("lost ignore: one particle is gone", result.thermo[-1]["Atoms"][-1] if "Atoms" in result.thermo[-1] else
                float(re.findall(r"with (\d+) atoms", result.output)[-1]), 63)

    # a neighbour list that LAMMPS's defaults do not hold
    result = run(script(LARGE, work="0 3e-3 0 3e-3", dx="0.05e-3"), expect_error=True)
    checks.true("a neighbour list that overflows", result.status > 0 and "neigh_modify one" in result.errors(),
                result.errors()[:200])
    few = script(LARGE).replace("thermo 10", "thermo 10\nneigh_modify one 5 page 100", 1)
    result = run(few, expect_error=True)
    checks.true("room for too few neighbours", result.status == 0 and "neigh_modify one" in result.output,
                result.errors()[:200])
checks.end()
