"""Runs one input script with many sets of variables, several at a time: a study of parameters.

  ./sphtm many in.cut --vary speed=10,20,40 chip=40,60              every combination
  ./sphtm many in.cut --table cases.csv --jobs 8                    a row each; the first line names the variables
  ./sphtm many in.cut --table cases.csv --lmp "-k on g 1 -sf kk"    on one GPU, whose time they share (MPS)

Each run has a folder of its own, FOLDER/NAME, with the files beside the script that scripts read (meshes, data, materials). A
column 'name' of the table names the runs. summary.csv has a line for each run: its variables, whether it ended, its error,
seconds, steps, particles and the last line of its thermo output. A run that stops with an error does not stop the others; the
exit status says whether all have ended. Ctrl-C stops all; --resume then takes what has ended and runs the others."""
import argparse
import concurrent.futures
import csv
import hashlib
import itertools
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import threading
import time

sys.dont_write_bytecode = True
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [os.path.join(ROOT, "bench"), os.path.join(ROOT, "unittest", "scenes")]
import sphtm_scene                                                                     # noqa: E402
from shared_gpu import shared_gpu, uses_gpu                                            # noqa: E402

READ = (".stl", ".vtk", ".data", ".sphtm", ".json", ".csv", ".txt", ".inc", ".lmp")    # files that scripts read
JOBS_ON_GPU = 12


MARK = ".sphtm-many"    # in the folder of each run: what it was made with, and what came out
NUMBERS = "ended", "error", "seconds", "steps", "particles"


def rows_of(path):
    """[variables] of a table."""
    try:
        with open(path, newline="", encoding="utf-8-sig") as f:    # Excel writes a mark of the encoding first
            rows = [row for row in csv.reader(f, skipinitialspace=True) if any(v.strip() for v in row)]
    except (OSError, UnicodeDecodeError) as error:
        sys.exit("many: --table %s cannot be read: %s" % (path, error))
    if len(rows) < 2:
        sys.exit("many: %s has no rows below its first line" % path)
    names = [n.strip() for n in rows[0]]
    if "" in names or len(set(names)) < len(names):
        sys.exit("many: the first line of %s has a name twice or an empty one: %s" % (path, ", ".join(names)))
    for number, row in enumerate(rows[1:], 1):
        if len(row) != len(names) or not all(v.strip() for v in row):
            sys.exit("many: row %d of %s has %s; its first line names %d: %s" % (
                number, path, "an empty value" if len(row) == len(names) else "%d values" % len(row), len(names), ", ".join(names)))
    return [dict(zip(names, (v.strip() for v in row))) for row in rows[1:]]


def sets_of(options):
    """[(name, variables)] of the table and of every combination of what is varied."""
    rows = rows_of(options.table) if options.table else [{}]
    varied = []
    for word in options.vary:
        name, sign, values = word.partition("=")
        if not sign or not name or not all(values.split(",")):
            sys.exit("many: --vary wants NAME=VALUE,VALUE,..., not '%s'" % word)
        varied.append([(name, v) for v in values.split(",")])
    sets = []
    for row, more in itertools.product(rows, itertools.product(*varied)):
        variables = dict(row, **dict(more))
        name = variables.pop("name", "")
        name = "_".join([name] * bool(name) + ["%s_%s" % v for v in (more if name else variables.items())]) or "run"
        sets.append((re.sub(r"[^A-Za-z0-9._+-]", "_", name), variables))
    for name in {n for n, _ in sets}:
        if sum(n == name for n, _ in sets) > 1:
            sys.exit("many: two runs would be named %s; give the table a column 'name'" % name)
        if not name.strip("."):
            sys.exit("many: a run cannot be named '%s', which is another folder" % name)
    return sets


def check_variables(script, sets):
    """A variable that the script does not have would change nothing."""
    with open(script) as f:
        known = set(re.findall(r"^\s*variable\s+(\w+)\s+(?:index|string|getenv)", f.read(), re.M))
    for name in sorted({v for _, variables in sets for v in variables} - known):
        sys.exit("many: %s has no 'variable %s index'; it has: %s" % (script, name, " ".join(sorted(known)) or "none"))


def check_folders(out, sets):
    """What an earlier study has not made stays: runs begin with an empty folder."""
    for name, _ in sets:
        folder = os.path.join(out, name)
        if os.path.lexists(folder) and not os.path.isfile(os.path.join(folder, MARK)) and not (os.path.isdir(folder) and not os.listdir(folder)):
            sys.exit("many: %s is there and not of an earlier study; name another --out, or the run otherwise" % folder)


class Runs:
    """Runs of one script; those that go on end with stop()."""

    def __init__(self, script, table, out, arguments, files):
        beside = os.path.dirname(os.path.abspath(script))
        self.script, self.out, self.arguments = script, out, arguments
        self.files = [os.path.join(beside, f) for f in sorted(os.listdir(beside)) if f.endswith(READ)] + files
        self.files = [f for f in self.files if not table or not os.path.samefile(f, table)]
        self.here, self.lock, self.stopped = set(), threading.Lock(), False

    def mark(self, variables):
        text = hashlib.sha256(json.dumps([variables, self.arguments]).encode())
        for path in [self.script] + self.files:
            with open(path, "rb") as f:
                text.update(f.read())
        return text.hexdigest()

    def kept(self, name, variables):
        """What a run that was made with the same and has ended has found, or None."""
        try:
            with open(os.path.join(self.out, name, MARK)) as f:
                kept = json.load(f)
            return kept["found"] if kept["mark"] == self.mark(variables) and kept["found"]["ended"] == "yes" else None
        except (OSError, ValueError, KeyError):
            return None

    def one(self, name, variables):
        folder = os.path.join(self.out, name)
        mark = self.mark(variables)
        shutil.rmtree(folder, ignore_errors=True)
        os.makedirs(folder)
        with open(os.path.join(folder, MARK), "w") as f:
            f.write("{}")
        for path in self.files + [self.script]:
            shutil.copy(path, folder)
        command = [os.environ["SPHTM_LMP"], "-nocite", "-in", os.path.basename(self.script)] + shlex.split(self.arguments)
        for pair in variables.items():
            command += ["-var"] + list(pair)
        began = time.time()
        status = self.call(command, folder)
        with open(os.path.join(folder, "output"), errors="replace") as f:
            found = result_of(f.read(), status)
        found["seconds"] = "%.1f" % (time.time() - began)
        with open(os.path.join(folder, MARK), "w") as f:
            json.dump({"mark": mark, "found": found}, f)
        return found

    def call(self, command, folder):
        with open(os.path.join(folder, "output"), "w") as f:
            with self.lock:
                if self.stopped:
                    return "stopped"
                process = subprocess.Popen(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=f, stderr=subprocess.STDOUT)
                self.here.add(process)
            status = process.wait()
            self.here.discard(process)
        return "stopped" if self.stopped else status

    def stop(self):
        with self.lock:
            self.stopped = True
            for process in self.here:
                process.terminate()


def result_of(output, status):
    """What a run has found: NUMBERS, the last line of its thermo output under 'thermo', and under 'behind' how it lags."""
    loops = re.findall(r"Loop time of \S+ on \d+ procs for (\d+) steps with (\d+) atoms", output)
    said = re.findall(r"^ERROR.*", output, re.M) or output.strip().split("\n")
    ended = status == 0 and bool(loops)
    found = {"ended": "yes" if ended else "no", "error": "" if ended else "stopped" if status == "stopped" else said[-1][:300],
             "steps": sum(int(n) for n, _ in loops), "particles": loops[-1][1] if loops else "", "thermo": {}, "behind": ""}
    tables = sphtm_scene.read_thermo(output)
    if ended and tables:
        last = {k: v for k, v in tables[-1].items() if len(v)}
        found["thermo"] = {k: "%.10g" % v[-1] for k, v in last.items()}
        if "Step" in last and last["Step"][-1] != last["Step"][0] + int(loops[-1][0]):
            found["behind"] = "its last line of thermo output is of step %d, it ended at step %d" % (
                last["Step"][-1], last["Step"][0] + int(loops[-1][0]))
    return found


def row_of(name, variables, found):
    """A line of the summary; what has a name that is taken says whose it is."""
    row = dict({"name": name}, **variables)
    for key in NUMBERS:
        row[key + " of the run" if key in row else key] = found[key]
    for key, value in found["thermo"].items():
        row[key + " of thermo" if key in row else key] = value
    return row


def write_summary(path, sets, found):
    rows = [row_of(name, variables, found[name]) for name, variables in sets if name in found]
    with open(path, "w", newline="") as f:
        table = csv.DictWriter(f, list(dict.fromkeys(k for row in rows for k in row)), restval="")
        table.writeheader()
        table.writerows(rows)


def tell(name, found):
    what = found["error"] or "%s s, %s steps of %s particles" % (found["seconds"], found["steps"], found["particles"])
    print("%-40s %s" % (name, "; ".join([what] + [found["behind"]] * bool(found["behind"]))), flush=True)


def main():
    options = argparse.ArgumentParser(prog="./sphtm many", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("script")
    options.add_argument("--vary", nargs="+", default=[], metavar="NAME=VALUES", help="a variable and its values, with commas")
    options.add_argument("--table", metavar="FILE", help="sets of variables, a row each, with commas")
    options.add_argument("--jobs", type=int, help="runs at once; %d on a GPU, else as many as there are cores" % JOBS_ON_GPU)
    options.add_argument("--lmp", default="", help='more arguments of lmp, for example "-k on g 1 -sf kk"')
    options.add_argument("--files", nargs="+", default=[], help="more files that the script reads")
    options.add_argument("--out", default=os.environ.get("SPHTM_OUT", os.path.join(ROOT, "out", "many")), metavar="FOLDER")
    options.add_argument("--resume", action="store_true", help="run only what has not ended with the same script, files and variables")
    given = options.parse_args()
    if not given.vary and not given.table:
        options.error("nothing to vary: --vary or --table")
    for path in [given.script] + given.files:
        if not os.path.isfile(path):
            options.error("no file %s" % path)
    if given.jobs is not None and given.jobs < 1:
        options.error("--jobs must be at least 1, not %d" % given.jobs)
    sets = sets_of(given)
    check_variables(given.script, sets)
    check_folders(given.out, sets)
    jobs = min(given.jobs or (JOBS_ON_GPU if uses_gpu(given.lmp) else os.cpu_count()), len(sets))
    runs, began = Runs(given.script, given.table, given.out, given.lmp, [os.path.abspath(f) for f in given.files]), time.time()
    found = {name: runs.kept(name, variables) for name, variables in sets} if given.resume else {}
    found = {name: kept for name, kept in found.items() if kept}
    with shared_gpu(jobs, given.lmp), concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        try:
            waiting = {pool.submit(runs.one, name, variables): name for name, variables in sets if name not in found}
            for done in concurrent.futures.as_completed(waiting):
                found[waiting[done]] = done.result()
                tell(waiting[done], done.result())
        except KeyboardInterrupt:
            runs.stop()
            pool.shutdown(cancel_futures=True)
    path = os.path.join(given.out, "summary.csv")
    os.makedirs(given.out, exist_ok=True)
    write_summary(path, sets, found)
    ended = sum(f["ended"] == "yes" for f in found.values())
    print("%d of %d runs ended, %.1f s with %d at once; written to %s" % (ended, len(sets), time.time() - began, jobs, path))
    behind = sum(bool(f["behind"]) for f in found.values())
    if behind:
        print("%d of them have thermo output from before their end alone, as where fix halt ends a run: a smaller 'thermo' brings it closer" % behind)
    if runs.stopped:
        print("stopped; --resume runs what has not ended")
    sys.exit(0 if ended == len(sets) else 1)


if __name__ == "__main__":
    main()
