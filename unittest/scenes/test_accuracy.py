"""./sphtm accuracy: one small sweep from its command line to csv, summary and pictures; what it refuses; the front;
settings that break, and a sweep whose reference is one of its settings."""
import csv
import json
import os
import subprocess
import sys

from sphtm_scene import SKIPPED, SOURCE, Checks, new_folder

FOLDER = os.path.join(SOURCE, "bench", "accuracy")
sys.path.insert(0, FOLDER)
import frame                                                                           # noqa: E402

if not os.environ.get("SPHTM_LMP"):
    sys.exit(SKIPPED)
checks, out = Checks(), new_folder()


def command(*arguments):
    return subprocess.run([sys.executable, os.path.join(FOLDER, "run.py"), *arguments],
                          env=dict(os.environ, SPHTM_OUT=out),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)


done = command("spacing", "--sweep", "heat", "--quick", "--repeats", "2")
checks.true("spacing: ends well", done.returncode == 0, done.stdout[-300:] if done.returncode else "")
with open(os.path.join(out, "summary.json")) as f:
    summary = json.load(f)
sweep = summary["knobs"]["spacing"]["sweeps"]["heat"]
points = sweep["points"]
checks.above("spacing: points", len(points), 4)
whole = all(set(p) == {"knob", "sweep", "setting", "error", "relative_time"} for p in summary["points"])
checks.true("each with knob, setting, error and time", whole and len(summary["points"]) == len(points))
checks.true("finer is better", all(a["error"] > b["error"] for a, b in zip(points, points[1:])))
checks.above("order of convergence", sweep["order"], 1.0)
base = next(p for p in points if p["setting"] == sweep["baseline"])
checks.near("time of the baseline over itself", base["relative_time"], 1.0)
checks.true("finer takes longer", points[-1]["relative_time"] > 1 > points[0]["relative_time"])
with open(os.path.join(out, "spacing.csv")) as f:
    rows = list(csv.DictReader(f))
checks.near("rows of the table of numbers", len(rows), len(points))
checks.near("error in it", float(rows[0]["error"]), points[0]["error"], relative=1e-5)
for name in ("spacing.png", "overview.png", "table.rst", "points.rst"):
    checks.true(name, os.path.getsize(os.path.join(out, name)) > 200)

# --- what it refuses
done = command("spacing", "sapcing")
checks.true("a knob that there is not is named", done.returncode != 0 and "'sapcing'" in done.stdout and "spacing" in
            done.stdout.replace("sapcing", ""), done.stdout.strip()[-200:])
done = command("spacing", "--sweep", "beam", "--quick")
checks.true("so is a sweep", done.returncode != 0 and "'beam'" in done.stdout and "plate" in done.stdout,
            done.stdout.strip())
done = command("spacing", "--repeats", "0")
checks.true("and a number of repeats", done.returncode != 0 and "--repeats 0" in done.stdout, done.stdout.strip())

# --- the front: points that no other beats in both
four = [{"error": e, "wall": w} for e, w in ((0.1, 1.0), (0.05, 2.0), (0.2, 1.5), (None, 0.1))]
frame.front(four, "wall")
checks.true("front", [p["front"] for p in four] == [True, True, False, False])

# --- a setting that lmp stops, one whose measure finds nothing, errors against a setting of the sweep
TEXT = ("units si\nregion b block 0 1 0 1 0 1\ncreate_box 1 b\nmass 1 1\ncreate_atoms 1 single 0.5 0.5 0.5\n"
        "fix 1 all nve\nrun 20000\n")
toy = frame.Sweep(name="toy", quantity="toy", reference="itself", kind="none", against="one", baseline="one",
                  script=lambda v: TEXT if v["value"] else TEXT + "none such\n",
                  settings={"quick": {"one": {"value": 2.0}, "more": {"value": 2.2}, "broken": {"value": 0}}},
                  measure=lambda r: {"value": r.variables["value"]})
one, more, broken = frame.measure(toy, "quick", 2, "wall", say=lambda text: None)
checks.true("the reference has no error", one["error"] is None and not one["front"], one["note"])
checks.near("error against it", more["error"], 0.1, relative=1e-9)
checks.true("what lmp stops has none, and says why", broken["error"] is None and "none such" in broken["note"],
            broken["note"])
checks.end()
