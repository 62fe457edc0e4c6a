"""./sphtm many: one script with many sets of variables, several runs at a time; what it refuses, a run that fails, one that is
stopped by hand, and what is not of a study."""
import csv
import os
import signal
import subprocess
import sys
import time

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


def command(*words):
    return [sys.executable, os.path.join(SOURCE, "bench", "many.py"), script, "--out", out, *words]


def many(*words):
    done = subprocess.run(command(*words), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    return done.returncode, done.stdout


def summary():
    with open(os.path.join(out, "summary.csv"), newline="") as f:
        return list(csv.DictReader(f))


def table_of(text, encoding="utf-8"):
    with open(table, "w", encoding=encoding) as f:
        f.write(text)


status, said = many("--vary", "v=10,20", "steps=20,30", "--jobs", "2")
rows = summary()
checks.true("every combination ends", status == 0 and len(rows) == 4 and all(r["ended"] == "yes" for r in rows), said)
checks.true("in the order of the table", [r["name"] for r in rows] == ["v_10_steps_20", "v_10_steps_30", "v_20_steps_20", "v_20_steps_30"],
            str(rows))
checks.true("the last line of each", all(abs(float(r["v_v2"]) - float(r["v"])) < 1e-6 and r["Step"] == r["steps"] for r in rows), str(rows))

checks.true("a name that is taken says whose it is", all(r["steps of the run"] == r["steps"] for r in rows), str(rows[0]))

table = os.path.join(folder, "cases.csv")
table_of("name, v, steps\nslow, 5, 20\nwrong, fast, 20\n", encoding="utf-8-sig")    # as Excel writes it
status, said = many("--table", table)
rows = summary()
checks.true("a run that fails is told, the other ends", status == 1 and [r["ended"] for r in rows] == ["yes", "no"] and
            [r["name"] for r in rows] == ["slow", "wrong"] and "fast" in said and "fast" in rows[1]["error"], said)
for words, wanted in ((("--vary", "speed=1,2"), "speed"), (("--vary", "v"), "--vary"), ((), "nothing to vary"),
                      (("--vary", "v=1", "--jobs", "0"), "--jobs"), (("--vary", "v=1", "--files", "not.there"), "not.there"),
                      (("--table", "not.there"), "not.there")):
    status, said = many(*words)
    checks.true("refused: " + (" ".join(words) or "nothing"), status != 0 and wanted in said and "Traceback" not in said, said)
for text, wanted in (("name,v\nsame,1\nsame,2\n", "same"), ("name,v,steps\na,1\n", "row 1"), ("name,v\na,1\nb,\n", "row 2"),
                     ("name,v\na,1,2\n", "3 values"), ("name,v\n..,1\n", "another folder"), ("v,v\n1,2\n", "twice")):
    table_of(text)
    status, said = many("--table", table)
    checks.true("refused: table %r" % text, status != 0 and wanted in said and "Traceback" not in said, said)

# a folder that no study has made stays as it is
mine = os.path.join(out, "mine")
os.makedirs(mine)
open(os.path.join(mine, "measured"), "w").close()
table_of("name,v\nmine,1\n")
status, said = many("--table", table)
checks.true("what is not of a study stays", status != 0 and mine in said and os.listdir(mine) == ["measured"], said)

# thermo output that ends before the run does
with open(script, "w") as f:
    f.write(SCRIPT.replace("run ${steps}", "variable t equal step\nfix stop all halt 1 v_t >= 15 error continue\nthermo 10\nrun ${steps}"))
status, said = many("--vary", "v=10")
checks.true("a last line before the end is told", status == 0 and "of step 10, it ended at step 15" in said, said)

# stopped by hand: no other run begins, and what has ended is kept
with open(script, "w") as f:
    f.write(SCRIPT)
table_of("name,v,steps\nfirst,1,20\nlong,1,100000000\nlast,1,20\n")
process = subprocess.Popen(command("--table", table, "--jobs", "1"), stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
while not os.path.isfile(os.path.join(out, "long", "output")) and process.poll() is None:
    time.sleep(0.1)
time.sleep(1.0)
process.send_signal(signal.SIGINT)
said = process.communicate(timeout=60)[0]
rows = {r["name"]: r for r in summary()}
checks.true("Ctrl-C stops", process.returncode == 1 and "--resume" in said and "Traceback" not in said, said)
checks.true("what has ended is in the summary, the others have not begun", rows["first"]["ended"] == "yes" and
            "last" not in rows and not os.path.isdir(os.path.join(out, "last")), str(rows))
before = os.stat(os.path.join(out, "first", "output")).st_mtime_ns
table_of("name,v,steps\nfirst,1,20\nlong,1,30\nlast,1,20\n")
status, said = many("--table", table, "--resume")
rows = summary()
checks.true("--resume runs the others alone", status == 0 and [r["ended"] for r in rows] == 3 * ["yes"] and
            os.stat(os.path.join(out, "first", "output")).st_mtime_ns == before, said)
table_of("name,v,steps\nfirst,2,20\n")
status, said = many("--table", table, "--resume")
checks.true("--resume with another value runs again", status == 0 and abs(float(summary()[0]["v_v2"]) - 2) < 1e-6, said)

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
