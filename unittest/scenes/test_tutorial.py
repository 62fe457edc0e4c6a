"""The tutorial (doc/Tutorial.rst, examples/tutorial): every step runs as the page says, its numbers are those of the page within the
tolerance that the page names, and the pictures are drawn. The commands for the meshes give the meshes that are there. A number
that is wrong in the page is found. Numbers of steps as arguments run those alone."""
import os
import re
import shlex
import shutil
import subprocess
import sys

from sphtm_scene import SKIPPED, SOURCE, Checks, new_folder

sys.dont_write_bytecode = True
EXAMPLE = os.path.join(SOURCE, "examples", "tutorial")
sys.path.insert(0, EXAMPLE)
import measure                                                                         # noqa: E402

HOST = os.path.dirname(os.environ.get("SPHTM_LMP", ""))


def of_page(text):
    """{step: {name: (value, tolerance in %)}} of the tables of results."""
    steps = {}
    for table in re.findall(r"\* - result of step (\d)\n(.*?)(?=\n\n)", text, re.S):
        steps[int(table[0])] = {name: (float(value), float(percent)) for name, value, percent in
                                re.findall(r"   \* - (.+)\n     - ([\d.]+) \S+\n     - ([\d.]+) %", table[1])}
    return steps


def misses(found, told):
    """Numbers of a step that are not within their tolerance, or stand at one place only."""
    out = sorted(set(found) ^ set(told))
    for name in set(found) & set(told):
        value, percent = told[name]
        if abs(found[name] - value) > 0.01 * percent * value:
            out.append("%s: %.4g, in the page %.4g" % (name, found[name], value))
    return out


def call(words, folder):
    more = {"SPHTM_MATERIALS": os.path.join(SOURCE, "materials"), "PYTHONDONTWRITEBYTECODE": "1"}
    if words[-1].endswith("study.py"):
        with open(os.path.join(HOST, "source")) as f:
            more.update(PYTHONPATH=os.path.join(f.read().strip(), "python"), LD_LIBRARY_PATH=HOST)
    return subprocess.run(words, cwd=folder, env=dict(os.environ, **more), text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL)


if __name__ == "__main__":
    checks = Checks()
    if not HOST:
        print("no SPHTM_LMP in the environment: skipped")
        sys.exit(SKIPPED)
    with open(os.path.join(SOURCE, "doc", "Tutorial.rst")) as f:
        page = f.read()
    told = of_page(page)
    checks.true("the page has numbers of each step", sorted(told) == [1, 2, 3, 4, 5], str({k: len(v) for k, v in told.items()}))

    folder = new_folder()
    for name in os.listdir(EXAMPLE):
        if not name.endswith(".png") and not name.startswith(("log", "__")):
            shutil.copy(os.path.join(EXAMPLE, name), folder)
    for line in re.findall(r"^   \.\./tools/make_tool.py (.*)", page, re.M):
        name = line.split()[-1]
        call([sys.executable, os.path.join(SOURCE, "tools", "make_tool.py"), *shlex.split(line)[:-1], "new_" + name], folder)
        with open(os.path.join(folder, name), "rb") as a, open(os.path.join(folder, "new_" + name), "rb") as b:
            checks.true("the command of the page gives " + name, a.read() == b.read())

    first, wanted = None, [int(a) for a in sys.argv[1:]]
    for number, (name, step) in enumerate(measure.STEPS, 1):
        if wanted and number not in wanted:
            continue
        scripts = [s for s in os.listdir(EXAMPLE) if s.startswith("in.%d" % number)] or ["study.py"]
        words = [sys.executable, scripts[0]] if scripts[0].endswith(".py") else [os.environ["SPHTM_LMP"], "-nocite", "-in", scripts[0]]
        if scripts[0].endswith(".py") and not os.path.exists(os.path.join(HOST, "source")):
            checks.note("step %d" % number, "not run: no LAMMPS source beside lmp")
            continue
        checks.true("step %d: the page names %s" % (number, scripts[0]), scripts[0] in page)
        done = call(words, folder)
        if not checks.true("    it runs", done.returncode == 0, "" if done.returncode == 0 else done.stdout[-2000:]):
            continue
        found = step(folder)
        first = found if number == 1 else first
        for what, value in found.items():
            if what in told[number]:
                checks.near("    " + what, value, told[number][what][0], relative=0.01 * told[number][what][1])
        checks.true("    the same numbers in the page", set(found) == set(told[number]), str(set(found) ^ set(told[number]) or ""))

    if wanted:
        checks.end()
    done = call([sys.executable, "plot.py"], folder)
    missing = [p for p in re.findall(r"examples/tutorial/(\w+\.png)", page) if not os.path.exists(os.path.join(folder, p))]
    if "No module named 'matplotlib'" in done.stdout:
        checks.note("pictures", "not drawn: no matplotlib")
    elif os.path.exists(os.path.join(HOST, "source")):
        checks.true("plot.py draws all pictures of the page", done.returncode == 0 and not missing, done.stdout[-1000:] + " ".join(missing))

    # counter-cases
    wrong = of_page(page.replace("- 516 MPa", "- 536 MPa").replace("strain of 0.08", "strain of 0.09"))[1]
    checks.true("counter-case: a number and a name that are wrong", first and len(misses(first, wrong)) == 3, "; ".join(misses(first, wrong)))
    checks.true("    as it is, nothing is", first and not misses(first, told[1]))
    checks.end()
