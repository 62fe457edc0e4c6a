"""./sphtm many: one script with many sets of variables, several runs at a time; what it refuses, and a run that fails."""
import csv
import os
import subprocess
import sys

from sphtm_scene import SOURCE, Checks, lattice_block, new_folder

SCRIPT = "variable v index 10\nvariable steps index 20\n" + lattice_block("0 8e-3 0 8e-3", "-1 1 -1 1") + """
pair_style sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff 1 1 density 2700 elastic 70e9 0.33
velocity all set ${v} 0 0 units box
variable v2 equal vcm(all,x)
fix body all sph/tm
thermo_style custom step v_v2
run ${steps}
"""
checks = Checks()
folder = new_folder()
script, out = os.path.join(folder, "in.flight"), os.path.join(folder, "out")
with open(script, "w") as f:
    f.write(SCRIPT)


def many(*words):
    done = subprocess.run([sys.executable, os.path.join(SOURCE, "bench", "many.py"), script, "--out", out, *words],
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def summary():
    with open(os.path.join(out, "summary.csv"), newline="") as f:
        return list(csv.DictReader(f))


status, said = many("--vary", "v=10,20", "steps=20,30", "--jobs", "2")
rows = summary()
checks.true("every combination ends", status == 0 and len(rows) == 4 and all(r["ended"] == "yes" for r in rows), said)
checks.true("in the order of the table", [r["name"] for r in rows] == ["v_10_steps_20", "v_10_steps_30", "v_20_steps_20", "v_20_steps_30"],
            str(rows))
checks.true("the last line of each", all(abs(float(r["v_v2"]) - float(r["v"])) < 1e-6 and r["Step"] == r["steps"] for r in rows), str(rows))

table = os.path.join(folder, "cases.csv")
with open(table, "w") as f:
    f.write("name, v, steps\nslow, 5, 20\nwrong, fast, 20\n")
status, said = many("--table", table)
rows = summary()
checks.true("a run that fails is told, the other ends", status == 1 and [r["ended"] for r in rows] == ["yes", "no"] and
            [r["name"] for r in rows] == ["slow", "wrong"] and "fast" in said, said)
for words, wanted in ((("--vary", "speed=1,2"), "speed"), (("--vary", "v"), "--vary"), ((), "nothing to vary")):
    status, said = many(*words)
    checks.true("refused: " + (" ".join(words) or "nothing"), status != 0 and wanted in said, said)
with open(table, "w") as f:
    f.write("name,v\nsame,1\nsame,2\n")
status, said = many("--table", table)
checks.true("two runs of one name are refused", status != 0 and "same" in said, said)

# a service that shares a GPU, here one that does nothing, takes the choice of GPUs, and its clients count those it has
with open(os.path.join(folder, "nvidia-cuda-mps-control"), "w") as f:
    f.write("#!/bin/sh\ncat > /dev/null < /dev/null\n")
os.chmod(f.name, 0o755)
os.environ["PATH"] = folder + os.pathsep + os.environ["PATH"]
os.environ.pop("CUDA_MPS_PIPE_DIRECTORY", None)
sys.path.insert(0, os.path.join(SOURCE, "bench"))
from shared_gpu import shared_gpu                                                      # noqa: E402
for chosen, inside in (("1", "0"), ("2,3", "0,1"), ("GPU-aa9a33b3", "GPU-aa9a33b3"), (None, None)):
    os.environ.pop("CUDA_VISIBLE_DEVICES", None)
    if chosen:
        os.environ["CUDA_VISIBLE_DEVICES"] = chosen
    with shared_gpu(2, "-k on g 1 -sf kk") as service:
        there = os.environ.get("CUDA_VISIBLE_DEVICES")
    checks.true("CUDA_VISIBLE_DEVICES=%s: runs that share see %s" % (chosen, inside),
                service and there == inside and os.environ.get("CUDA_VISIBLE_DEVICES") == chosen, str(there))
checks.end()
