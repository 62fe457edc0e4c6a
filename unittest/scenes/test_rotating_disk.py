"""An elastic disk after five turns (examples/rotating_disk), with lists of LAMMPS, with rows searched once, and with a
threshold, where the swinging of the disk searches none or some of the rows: angular momentum within 0.01 %, radius within
0.1 %. Counter-case: without corrected gradients the spin is lost in the first turn."""
import os
import sys

from sphtm_scene import SOURCE, Checks, run

EXAMPLE = os.path.join(SOURCE, "examples", "rotating_disk")
sys.path.insert(0, EXAMPLE)
import scene                                                                           # noqa: E402

SCRIPT = os.path.join(EXAMPLE, "in.rotating_disk")
checks = Checks()
for row, variables in (("lists of LAMMPS", {}), ("searched once", {"adapt": "threshold inf"}),
                       ("threshold 1e-5", {"adapt": "threshold 1e-5"}),
                       ("threshold 1e-5, some searched", {"adapt": "threshold 1e-5 stretch 2e-4"})):
    m = scene.measure(run(SCRIPT, dict(variables, n=6, rim=0.04)))
    checks.above(row + ": turns", m["turns"], 5)
    checks.below(row + ": angular momentum, largest change", m["spin"], 1e-4)
    checks.below(row + ": radius, largest change", m["radius"], 1e-3)
    if "adapt" in variables:
        checks.true(row + ": searches of a particle", (m["searches"] > 20) == ("some" in row), "%.1f" % m["searches"])
loose = scene.measure(run(SCRIPT, {"n": 6, "rim": 0.04, "turns": 0.5, "options": "stabilize artstress artstress 0 4"}))
checks.above("counter-case, plain sums: angular momentum changes by", loose["spin"], 0.1)
checks.end()
