"""Runs one input script with many sets of variables, several at a time: a study of parameters.

  ./sphtm many in.cut --vary speed=10,20,40 chip=40,60              every combination
  ./sphtm many in.cut --table cases.csv --jobs 8                    a row each; the first line names the variables
  ./sphtm many in.cut --table cases.csv --lmp "-k on g 1 -sf kk"    on one GPU, whose time they share (MPS)

Each run has a folder of its own, FOLDER/NAME, with the files beside the script that scripts read (meshes, data, materials). A
column 'name' of the table names the runs. summary.csv has a line for each run: its variables, whether it ended, seconds, steps,
particles and the last line of its thermo output. A run that stops with an error does not stop the others; the exit status says
whether all have ended."""
import argparse
import concurrent.futures
import csv
import itertools
import os
import re
import shlex
import shutil
import subprocess
import sys
import time

sys.dont_write_bytecode = True
ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
sys.path[:0] = [os.path.join(ROOT, "bench"), os.path.join(ROOT, "unittest", "scenes")]
import sphtm_scene                                                                     # noqa: E402
from shared_gpu import shared_gpu, uses_gpu                                            # noqa: E402

READ = (".stl", ".vtk", ".data", ".sphtm", ".json", ".csv", ".txt", ".inc", ".lmp")    # files that scripts read
JOBS_ON_GPU = 12


def sets_of(options):
    """[(name, variables)] of the table and of every combination of what is varied."""
    rows = [{}]
    if options.table:
        with open(options.table, newline="") as f:
            rows = [{k.strip(): v.strip() for k, v in row.items()} for row in csv.DictReader(f, skipinitialspace=True)]
        if not rows:
            sys.exit("many: %s has no rows below its first line" % options.table)
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
    return sets


def check_variables(script, sets):
    """A variable that the script does not have would change nothing."""
    with open(script) as f:
        known = set(re.findall(r"^\s*variable\s+(\w+)\s+(?:index|string|getenv)", f.read(), re.M))
    for name in sorted({v for _, variables in sets for v in variables} - known):
        sys.exit("many: %s has no 'variable %s index'; it has: %s" % (script, name, " ".join(sorted(known)) or "none"))


def run(script, folder, variables, arguments, files):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    beside = os.path.dirname(os.path.abspath(script))
    for path in [os.path.join(beside, f) for f in os.listdir(beside) if f.endswith(READ)] + files:
        shutil.copy(path, folder)
    shutil.copy(script, os.path.join(folder, os.path.basename(script)))
    command = [os.environ["SPHTM_LMP"], "-nocite", "-in", os.path.basename(script)] + shlex.split(arguments)
    for pair in variables.items():
        command += ["-var"] + list(pair)
    began = time.time()
    with open(os.path.join(folder, "output"), "w") as f:
        status = subprocess.run(command, cwd=folder, stdin=subprocess.DEVNULL, stdout=f, stderr=subprocess.STDOUT).returncode
    with open(os.path.join(folder, "output"), errors="replace") as f:
        output = f.read()
    loops = re.findall(r"Loop time of \S+ on \d+ procs for (\d+) steps with (\d+) atoms", output)
    said = re.findall(r"^ERROR.*", output, re.M)
    ended = status == 0 and bool(loops)
    found = {"ended": "yes" if ended else "no", "seconds": "%.1f" % (time.time() - began),
             "steps": sum(int(n) for n, _ in loops), "particles": loops[-1][1] if loops else ""}
    tables = sphtm_scene.read_thermo(output)
    if ended and tables:
        found.update({k: "%.10g" % v[-1] for k, v in tables[-1].items() if len(v)})
    return found, "" if ended else (said or output.strip().split("\n"))[-1][:300]


def main():
    options = argparse.ArgumentParser(prog="./sphtm many", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("script")
    options.add_argument("--vary", nargs="+", default=[], metavar="NAME=VALUES", help="a variable and its values, with commas")
    options.add_argument("--table", metavar="FILE", help="sets of variables, a row each, with commas")
    options.add_argument("--jobs", type=int, help="runs at once; %d on a GPU, else as many as there are cores" % JOBS_ON_GPU)
    options.add_argument("--lmp", default="", help='more arguments of lmp, for example "-k on g 1 -sf kk"')
    options.add_argument("--files", nargs="+", default=[], help="more files that the script reads")
    options.add_argument("--out", default=os.environ.get("SPHTM_OUT", os.path.join(ROOT, "out", "many")), metavar="FOLDER")
    given = options.parse_args()
    if not given.vary and not given.table:
        options.error("nothing to vary: --vary or --table")
    if not os.path.isfile(given.script):
        options.error("no file %s" % given.script)
    sets = sets_of(given)
    check_variables(given.script, sets)
    jobs = min(given.jobs or (JOBS_ON_GPU if uses_gpu(given.lmp) else os.cpu_count()), len(sets))
    files, rows, began = [os.path.abspath(f) for f in given.files], {}, time.time()
    with shared_gpu(jobs, given.lmp), concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        runs = {pool.submit(run, given.script, os.path.join(given.out, name), variables, given.lmp, files): (name, variables)
                for name, variables in sets}
        for done in concurrent.futures.as_completed(runs):
            (name, variables), (found, error) = runs[done], done.result()
            rows[name] = dict({"name": name}, **dict(variables, **found))
            print("%-40s %s" % (name, error or "%s s, %s steps of %s particles" % (found["seconds"], found["steps"], found["particles"])), flush=True)
    columns = list(dict.fromkeys(k for name, _ in sets for k in rows[name]))
    with open(os.path.join(given.out, "summary.csv"), "w", newline="") as f:
        table = csv.DictWriter(f, columns, restval="")
        table.writeheader()
        table.writerows(rows[name] for name, _ in sets)
    ended = sum(row["ended"] == "yes" for row in rows.values())
    print("%d of %d runs ended, %.1f s with %d at once; written to %s" % (ended, len(sets), time.time() - began, jobs, os.path.join(given.out, "summary.csv")))
    sys.exit(0 if ended == len(sets) else 1)


if __name__ == "__main__":
    main()
