"""Corpora of malformed scripts, test_bad_input_*.py: each script must stop before step 0 (or warn), and say what is
wrong, where, and what to write instead.

Each case is a name, the lines that take the place of lines of a good script, and the fragments that the message must
hold. A line is known by its label; an empty text removes it. 'wrong' cases must fail before the first step, 'warned'
cases must run to the end with the fragments in a WARNING, 'fine' cases must run without one.

    test_bad_input_X.py [word...]    only cases whose name holds one of the words; -v shows every message
"""
import os
import re
import subprocess
import sys
from collections import namedtuple
from concurrent.futures import ThreadPoolExecutor

from sphtm_scene import Checks, Result, new_folder, run

BASE = {
    "units": "units si",
    "dimension": "dimension 2",
    "boundary": "boundary f f p",
    "atom_style": "atom_style atomic",
    "newton": "newton off",
    "lattice": "lattice sq 1e-3 origin 0.5 0.5 0",
    "box": "region box block -5e-3 15e-3 -5e-3 15e-3 -0.5e-3 0.5e-3 units box",
    "create_box": "create_box 1 box",
    "work": "region work block 0 8e-3 0 8e-3 INF INF units box",
    "atoms": "create_atoms 1 region work",
    "pair_style": "pair_style sph/tm hyperbolic 1.2 spacing 1e-3",
    "pair_coeff": "pair_coeff 1 1 density 2700 elastic 70e9 0.33 strength plastic 300e6 1e9",
    "fix": "fix body all sph/tm",
    "more": "",
    "compute": "compute p all sph/tm/atom pstrain",
    "thermo": "thermo 5",
    "run": "run 5",
}
GOOD = "density 2700 elastic 70e9 0.33"
JC = GOOD + " strength johnson/cook 428e6 327e6 1.008 0.01 1.31 293 855 1.0"
HEAT = " heat 200 900 0.9"
TWO = {"create_box": "create_box 2 box"}
THREE_D = {"dimension": "dimension 3", "boundary": "boundary f f f", "lattice": "lattice sc 1e-3 origin 0.5 0.5 0.5",
           "box": "region box block -5e-3 15e-3 -5e-3 15e-3 -5e-3 15e-3 units box",
           "work": "region work block 0 5e-3 0 5e-3 0 5e-3 units box"}
CARD = """material one
  density 2700
  elastic 70e9 0.33
  strength johnson/cook 428e6 327e6 1.008 0.01 1.31 293 855 1.0
  heat 200 900 0.9
end
"""
# environment: a function that gives more variables of the environment; first: the lines of a script that is run before
Case = namedtuple("Case", "kind name lines fragments files environment first")
CASES = []


def case(kind, name, lines, *fragments, files=None, environment=None, first=None):
    CASES.append(Case(kind, name, lines, fragments, files or {}, environment, first))


def wrong(name, lines, *fragments, **more):
    case("wrong", name, lines, *fragments, **more)


def warned(name, lines, *fragments, **more):
    case("warned", name, lines, *fragments, **more)


def fine(name, lines, **more):
    case("fine", name, lines, **more)


def style(text):
    return {"pair_style": "pair_style sph/tm " + text}


def coeff(text):
    return {"pair_coeff": "pair_coeff 1 1 " + text}


def fix(text):
    return {"fix": "fix body all sph/tm " + text}


def script(lines):
    unknown = set(lines) - set(BASE)
    assert not unknown, unknown
    return "\n".join({**BASE, **lines}.values()) + "\n"


def attempt(c):
    folder = new_folder()
    if c.first:
        run(script(c.first), folder=folder, files=c.files)
        with open(os.path.join(folder, "state.restart"), "rb") as f:
            whole = f.read()
        with open(os.path.join(folder, "short.restart"), "wb") as f:
            f.write(whole[:len(whole) * 2 // 3])
    try:
        return run(script(c.lines), folder=folder, files=c.files, expect_error=True, timeout=60,
                   environment=c.environment and c.environment())
    except subprocess.TimeoutExpired as late:
        return Result(folder, "%s\nERROR: still running after 60 s" % late.stdout, 124)


def judge(checks, c, result, verbose):
    errors, warnings = result.errors(), "\n".join(result.warnings())
    said = errors if c.kind == "wrong" else warnings
    if c.environment:
        said += warnings
    missing = [f for f in c.fragments if f.lower() not in said.lower()]
    started = re.search(r"^ *Step\b.*\n *0 ", result.output, re.M)
    if c.kind == "wrong":
        ok = result.status not in (0, 124) and result.status > 0 and errors and not started and not missing
    elif c.kind == "warned":
        ok = result.status == 0 and not errors and not missing
    else:
        ok = result.status == 0 and not errors and not said
    why = []
    if c.kind == "wrong" and result.status == 0:
        why.append("it ran to the end")
    if c.kind == "wrong" and started:
        why.append("it took a step")
    if c.kind != "wrong" and result.status != 0:
        why.append("it failed: " + errors)
    if missing:
        why.append("not said: " + ", ".join(missing))
    if result.status < 0 or result.status > 128:
        why.append("it crashed with status %d" % result.status)
    text = "; ".join(why)
    if why or verbose:
        text += "   <- " + " | ".join(said.splitlines())[:400]
    checks.say(ok, c.kind + ": " + c.name, text)


def run_all():
    """The end of every corpus: runs its cases and ends the test."""
    verbose = "-v" in sys.argv
    wanted = [a for a in sys.argv[1:] if a != "-v"]
    todo = [c for c in CASES if not wanted or any(w in c.name for w in wanted)]
    checks = Checks()
    run(script({}))    # ends the test with its output where even the good script fails
    with ThreadPoolExecutor(2) as pool:
        for c, result in zip(todo, pool.map(attempt, todo)):
            judge(checks, c, result, verbose)
    print(len(todo), "scripts")
    checks.end()

