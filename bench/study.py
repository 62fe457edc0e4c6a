"""What the full scenes share (examples/*/scene.py): runs of lmp in folders of their own, times, the summary.

    study = Study(__file__, sizes={"small": {...}, "default": {...}, "large": {...}})
    run = study.run("row", {"n": 6, **study.size})       # out/scenes/<name>/row; sphtm_scene.Result, with times
    study.end({"row": {...}})                            # summary.json, and the same on the screen

Options of every scene: --size NAME; --repeats N, timed runs of each row; --rows ROW ..., some of them only; --ranks N;
--lmp "ARGUMENTS", more of lmp's, for example "-k on g 1 -sf kk"; --look, only measure and draw what earlier calls
left."""
import argparse
import json
import os
import re
import shlex
import shutil
import statistics
import sys
import time

sys.dont_write_bytecode = True
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [os.path.join(ROOT, "bench"), os.path.join(ROOT, "unittest", "scenes")]
import sphtm_scene                                                                     # noqa: E402
from provenance import provenance                                                      # noqa: E402


class Study:
    def __init__(self, script, sizes, title=""):
        self.example = os.path.dirname(os.path.abspath(script))
        self.name = os.path.basename(self.example)
        options = argparse.ArgumentParser(prog=self.name, description=title)
        options.add_argument("--size", choices=sizes, default=os.environ.get("SPHTM_SCENE_SIZE", "default"))
        options.add_argument("--repeats", type=int, default=1)
        options.add_argument("--rows", nargs="+", default=None)
        options.add_argument("--ranks", type=int, default=1)
        options.add_argument("--lmp", default="", help="more arguments of lmp")
        options.add_argument("--look", action="store_true", help="only measure and draw what is there")
        self.options = options.parse_args()
        self.size = sizes[self.options.size]
        self.out = os.path.join(os.environ.get("SPHTM_OUT", os.path.join(ROOT, "out", "scenes")), self.name)
        self.started = time.time()
        os.makedirs(self.out, exist_ok=True)

    def command(self):
        return " ".join(["./sphtm scenes", self.name] + sys.argv[1:])

    def wants(self, row):
        return not self.options.rows or row in self.options.rows

    def path(self, name):
        return os.path.join(self.out, name)

    def run(self, row, variables, repeats=1, may_stop=False, folder=None, prepare=None):
        """Runs the example's script; times are medians over the repeats. may_stop: an error of lmp is a result too.
        prepare(folder) makes files that the script reads."""
        folder, variables = self.path(folder or row), {k: v for k, v in variables.items() if v is not None}
        if not self.options.look:
            print("%s: %s" % (self.name, row), flush=True)
            shutil.rmtree(folder, ignore_errors=True)
            os.makedirs(folder)
            for name in os.listdir(self.example):
                if name.endswith((".stl", ".data")):
                    shutil.copy(os.path.join(self.example, name), folder)
            if prepare:
                prepare(folder)
        script, times = os.path.join(self.example, "in." + self.name), []
        for _ in range(0 if self.options.look else repeats):
            result = sphtm_scene.run(script, variables, ranks=self.options.ranks, folder=folder, timeout=100000,
                                     arguments=shlex.split(self.options.lmp), expect_error=may_stop)
            times.append(loop_times(result.output))
            with open(os.path.join(folder, "output"), "w") as f:
                f.write(result.output)
            with open(os.path.join(folder, "times.json"), "w") as f:
                json.dump(times, f)
        with open(os.path.join(folder, "output")) as f:
            result = sphtm_scene.Result(folder, f.read(), 0)
        with open(os.path.join(folder, "times.json")) as f:
            times = json.load(f)
        for k, name in enumerate(("wall", "processor")):
            setattr(result, name, statistics.median(t[k] for t in times))
        result.times = times
        return result

    def end(self, summary, results=None):
        """results: what of it goes to the table of README.md, name of doc/results -> its numbers (bench/results.py)."""
        summary = dict(summary, results=results or {}, **provenance(self.command()), scene=self.name, size=self.options.size, variables=self.size, ranks=self.options.ranks,
                       lmp=self.options.lmp, load_average=round(os.getloadavg()[0], 1),
                       minutes=round((time.time() - self.started) / 60, 2))
        with open(self.path("summary.json"), "w") as f:
            json.dump(summary, f, indent=1)
            f.write("\n")
        print(json.dumps(summary, indent=1))
        print("written to", self.path("summary.json"))


def loop_times(output):
    """Seconds of all run commands: by the clock, and of the processor (time of one rank, which others cannot take
    away)."""
    walls = [float(w) for w in re.findall(r"^Loop time of (\S+)", output, re.M)]
    shares = [float(s) / 100 for s in re.findall(r"([\d.]+)% CPU use", output)]
    return sum(walls), sum(w * s for w, s in zip(walls, shares))


def last_loop(output):
    """Steps of all run commands, and particles of the last."""
    loops = re.findall(r"^Loop time of \S+ on \d+ procs for (\d+) steps with (\d+) atoms", output, re.M)
    return sum(int(s) for s, _ in loops), int(loops[-1][1]) if loops else 0
