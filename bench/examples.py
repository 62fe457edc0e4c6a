#!/usr/bin/python3
"""Runs the examples as their READMEs say, each in a copy of its folder, and makes their reference logs and pictures anew:

    eval "$(./sphtm env)"; bench/examples.py [--jobs N] [--names LOG ...]      into out/examples/LOG, with what they print
    bench/examples.py --keep [--names LOG ...]                                 takes logs and pictures into examples/

High speed machining is ./sphtm demo; the tables of the scenes (./sphtm scenes) are theirs."""
import argparse
import concurrent.futures
import os
import re
import shlex
import shutil
import subprocess
import sys
import time

ROOT = os.path.dirname(os.path.dirname(os.path.abspath(__file__)))
OUT = os.path.join(ROOT, "out", "examples")
REFINE = "refine square epsilon 0.41667 "
TAYLOR = "./make_bar.py > spacing; python3 ../../tools/make_tool.py plane --size 1 1 --cells 2 2 -o plane.stl"

# log: folder, script, variables, before, after; the pictures are those that 'after' writes
LOGS = {
    "log.bending_beam": ("bending_beam", "in.bending_beam", {"rows": 13}, "", ""),
    "log.block_on_slope": ("block_on_slope", "in.block_on_slope", {}, "", "./measure.py; ./plot.py"),
    "log.bullet_plate": ("bullet_plate", "in.bullet_plate", {}, "", ""),
    "log.cutting_c45e": ("cutting_c45e", "in.cutting_c45e", {}, "", ""),
    "log.flat_tensile_c45e": ("flat_tensile_c45e", "in.flat_tensile_c45e", {"rows": 10, "speed": 20}, "", ""),
    "log.flat_tensile_c45e.asph": ("flat_tensile_c45e", "in.flat_tensile_c45e",
                                   {"rows": 10, "speed": 20, "adapt": "asph psi every 2 limits 0.5 3"}, "", ""),
    "log.friction_stir": ("friction_stir", "in.friction_stir", {}, "", "./plot.py"),
    "log.notched_specimen": ("notched_specimen", "in.notched_specimen", {}, "", ""),
    "log.notched_specimen.refined": ("notched_specimen", "in.notched_specimen", {"adapt": REFINE +
                                     "alpha 1.0 velocity linear when v_high above 0.1 and region circle every 20"}, "", ""),
    "log.orthogonal_cut_2d": ("orthogonal_cut_2d", "in.orthogonal_cut_2d", {}, "", "./plot.py"),
    "log.orthogonal_ti6al4v": ("orthogonal_ti6al4v", "in.orthogonal_ti6al4v", {}, "", "./measure.py; ./plot.py; ./movie.py"),
    "log.oscillating_plate": ("oscillating_plate", "in.oscillating_plate", {}, "", "./plot.py"),
    "log.peripheral_milling": ("peripheral_milling", "in.peripheral_milling", {"teeth": 1, "dx": "40e-6"}, "", ""),
    "log.rings": ("rings", "in.rings", {}, "./make_rings.py", "./plot.py"),
    "log.rotating_disk": ("rotating_disk", "in.rotating_disk", {"n": 15, "rim": 0.04, "adapt": "threshold 1e-5"}, "", ""),
    "log.taylor_bar": ("taylor_bar", "in.taylor_bar", {"dx": "$(cat spacing)"}, TAYLOR, "./measure.py; ./plot.py"),
    "log.tensile_cylinder": ("tensile_cylinder", "in.tensile_cylinder", {"faster": 4}, "", "./measure.py; ./plot.py"),
    "log.tool_heat": ("tool_heat", "in.tool_heat", {}, "", ""),
    "log.tool_heat_lumped": ("tool_heat", "in.tool_heat", {"tool": "lumped"}, "", ""),
    "log.turning": ("turning", "in.turning", {}, '"$SPHTM_LMP" -nocite -in in.orthogonal -log none', "./plot.py"),
    "log.orthogonal": ("turning", "in.orthogonal", {}, "", ""),
    "log.two_layer_heat": ("two_layer_heat", "in.two_layer_heat", {}, "", "./measure.py; ./plot.py"),
}


THINNED = {"log.rotating_disk": 10}    # every tenth row of the table alone


def run(log):
    """One example in out/examples/LOG/examples/FOLDER; how long it took, or what went wrong."""
    folder, script, variables, before, after = LOGS[log]
    top = os.path.join(OUT, log)
    shutil.rmtree(top, ignore_errors=True)
    os.makedirs(top)
    for beside in ("unittest", "tools", "bench", "materials"):
        os.symlink(os.path.join(ROOT, beside), os.path.join(top, beside))
    shutil.copytree(os.path.join(ROOT, "examples"), os.path.join(top, "examples"))
    given = " ".join("-var %s %s" % (k, v if str(v).startswith("$(") else shlex.quote(str(v))) for k, v in variables.items())
    started = time.time()
    after = re.sub(r"(^|; )\./", r"\1/usr/bin/python3 ", after)    # not all may be executed
    for what in (before, '"$SPHTM_LMP" -nocite -in %s %s -log %s' % (script, given, log), "cp %s log.lammps" % log, after):
        done = subprocess.run(what, shell=True, cwd=os.path.join(top, "examples", folder), stdin=subprocess.DEVNULL,
                              stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
        with open(os.path.join(top, "output"), "a") as f:
            f.write(done.stdout)
        if done.returncode:
            return "%s: %s" % (what, done.stdout.strip().splitlines()[-1:])
    return "ok, %.0f s" % (time.time() - started)


def clean(text, every=1):
    """A log without what belongs to one machine, and with some rows of its table."""
    row = re.compile(r"^ +\d+( +[-+.e\d]+)+$")
    counted, lines = 0, []
    for line in text.split("\n"):
        counted = counted + 1 if row.match(line) else 0
        if counted % every == 1 % every or not counted:
            lines.append(line)
    text = "\n".join(lines)
    text = re.sub(r"^Loaded \d+ plugins? from .*\n", "", text, flags=re.M)
    return text.replace(os.path.join(ROOT, ""), "").replace(ROOT, ".")


def keep(log):
    folder = LOGS[log][0]
    made = os.path.join(OUT, log, "examples", folder)
    if not os.path.exists(os.path.join(made, log)):
        return
    with open(os.path.join(made, log)) as f, open(os.path.join(ROOT, "examples", folder, log), "w") as kept:
        kept.write(clean(f.read(), THINNED.get(log, 1)))
    for name in os.listdir(made):    # pictures that the run made
        old, new = os.path.join(ROOT, "examples", folder, name), os.path.join(made, name)
        if name.endswith((".png", ".gif")) and os.stat(new).st_mtime > os.stat(os.path.join(made, log)).st_mtime:
            shutil.copy(new, old)
    print("kept", os.path.join("examples", folder, log))


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--names", nargs="+", choices=LOGS, default=list(LOGS), metavar="LOG", help=", ".join(LOGS))
    options.add_argument("--jobs", type=int, default=1)
    options.add_argument("--keep", action="store_true")
    given = options.parse_args()
    if given.keep:
        for log in given.names:
            keep(log)
        return 0
    if not os.environ.get("SPHTM_LMP"):
        sys.exit('no SPHTM_LMP in the environment: eval "$(./sphtm env)"')
    failed = 0
    with concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
        for log, said in zip(given.names, pool.map(run, given.names)):
            failed += not said.startswith("ok")
            print("%-32s %s" % (log, said), flush=True)
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
