"""./sphtm stability: the hard cases that take seconds end, meet their criterion, fail it in the counter-run, and end with the same bits after
a restart; a case that fails is said to. The others, and the one that is missed (tension), are in doc/stability.rst."""
import json
import os
import subprocess
import sys

from sphtm_scene import SKIPPED, SOURCE, Checks, new_folder

FOLDER = os.path.join(SOURCE, "bench", "stability")
CASES = ("compression", "corners", "friction", "hole", "hypervelocity", "melting", "sharp_edge", "taylor_500", "trapped")

if not os.environ.get("SPHTM_LMP"):
    sys.exit(SKIPPED)
checks, out = Checks(), new_folder()


def command(*cases):
    return subprocess.run([sys.executable, os.path.join(FOLDER, "run.py"), "--cases", *cases], env=dict(os.environ, SPHTM_OUT=out),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


done = command(*CASES)
print(done.stdout)
with open(os.path.join(out, "summary.json")) as f:
    summary = json.load(f)
for name in CASES:
    c = summary["cases"][name]
    checks.true(name + ": within its limit", c["holds"], "%s, limit %s %s" % (c["value"], c["limit"], c["error"]))
    checks.true("    the counter-run is not", c["counter_fails"], "%s" % c["counter_value"])
    checks.true("    a restart half way ends with the same bits", c["restart"] == "same bits", c["restart"])
checks.true("the command says that all is well", done.returncode == 0 and not summary["wrong"], summary["wrong"])

# a case that misses its criterion
sys.path.insert(0, FOLDER)
import frame                                                                           # noqa: E402
from case_trapped import CASE                                                          # noqa: E402

CASE.limit = -1.0
answer = frame.measure(CASE, True)
checks.true("a limit that cannot be met is not", not answer["holds"], answer["value"])

# a strip in tension, 12 rows, pulled to 2.2 times its length: with shifting of drawn metal from a plastic strain of 0.2 on, as it was until
# b6b468c, it came apart at 1.39 times its length where places are moved, then at 1.92 and 2.03; since hourglass control resists more
# in tension it is whole, and without shifting it comes apart at 1.38, before at 1.35 (doc/stability.rst)
from drawn_strip import drawn                                                          # noqa: E402

for noise in 0.0, 0.02:
    checks.above("strip in tension, places moved by %g of the spacing: comes apart at" % noise, drawn("default", 12, noise), 2.0)
checks.below("    the counter-run, without shifting", drawn("shifting off", 12, 0.0), 1.4)
checks.end()
