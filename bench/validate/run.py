"""Against experiments: each case runs rows of a published experiment, with several spacings, time scalings and variants, and
prints what comes out beside what was measured, with the scatter of both. Called by ./sphtm validate [options].

Every run has a folder of its own, out/validate/CASE/ROW/SETTING, and is taken from there where it was made with the same script
and variables: a set can be made in pieces, on several machines (copy the folders), and looked at with --look."""
import argparse
import concurrent.futures
import hashlib
import importlib.util
import json
import os
import re
import shlex
import shutil
import sys
import time

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path[:0] = [HERE, os.path.join(ROOT, "bench"), os.path.join(ROOT, "unittest", "scenes")]
import page                                                                            # noqa: E402
import report                                                                          # noqa: E402
import sphtm_scene                                                                     # noqa: E402
from provenance import provenance                                                      # noqa: E402
from shared_gpu import shared_gpu                                                      # noqa: E402
from study import last_loop, loop_times                                                # noqa: E402

OUT = os.environ.get("SPHTM_OUT", os.path.join(ROOT, "out", "validate"))
NAMES = sorted(f[5:-3] for f in os.listdir(HERE) if f.startswith("case_") and f.endswith(".py"))


# what a case may leave out: files beside the script, variables of all rows, settings from slow to the base time scaling, settings
# that are run for some rows only, what makes files and the script's variables from those of a row, cost of a run (any unit)
DEFAULTS = {"FILES": (), "BASE": {}, "SCALING": (), "only": None, "prepare": None, "cost": lambda variables: 1.0, "make": None}


def load(name):
    """A case's module, with what it leaves out."""
    spec = importlib.util.spec_from_file_location("case_" + name, os.path.join(HERE, "case_%s.py" % name))
    case = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(case)
    for key, value in DEFAULTS.items():
        if not hasattr(case, key):
            setattr(case, key, value)
    case.only = case.only or (lambda setting: list(case.ROWS))
    return case


def variables_of(case, row, setting):
    return dict(case.BASE, **dict(case.ROWS[row]["variables"], **case.SETTINGS[setting]))


def card_of(file, name):
    """Text of a material card, of a file where LAMMPS would find it, or ''."""
    for folder in os.environ.get("SPHTM_MATERIALS", "").split(os.pathsep) + [os.path.join(ROOT, "materials")]:
        try:
            with open(os.path.join(folder, file)) as f:
                return {card.split()[0]: card for card in re.split(r"^material ", f.read(), flags=re.M)[1:]}.get(name, "")
        except OSError:
            continue
    return ""


def mark_of(case, variables):
    """What a run was made with: the script, the material cards that it or the variables name, the variables."""
    script = case.SCRIPT
    if "\n" not in script:
        with open(script) as f:
            script = f.read()
    # what a script prints of the time it will take changes nothing
    script = re.sub(r"^variable\s+eta\s.*\n", "", script, flags=re.M)
    script = re.sub(r"^(thermo_style\b.*?) (?:v_eta|cpuremain)$", r"\1", script, flags=re.M | re.S)
    text = json.dumps({k: str(v) for k, v in sorted(variables.items())}) + script
    for file, card in sorted(set(re.findall(r"([\w./+-]+\.sphtm) (\S+)", text))):
        text += card_of(file, card.strip('",'))
    return hashlib.sha256(text.encode()).hexdigest()[:16]


def kept(folder, mark):
    """The answer of a run that was made with the same, or None."""
    try:
        with open(os.path.join(folder, "answer.json")) as f:
            answer = json.load(f)
        return answer if answer["mark"] == mark else None
    except (OSError, ValueError, KeyError):
        return None


class Scene:
    """Runs a case's script in its folder, or in one below it, where a value needs several runs."""

    def __init__(self, folder, case, lmp):
        self.folder, self.case, self.lmp = folder, case, lmp

    def __call__(self, variables, below="."):
        folder = os.path.normpath(os.path.join(self.folder, below))
        os.makedirs(folder, exist_ok=True)
        for path in self.case.FILES:
            shutil.copy(path, folder)
        if self.case.prepare:
            variables = self.case.prepare(folder, variables)
        result = sphtm_scene.run(self.case.SCRIPT, variables, folder=folder, timeout=100000, arguments=shlex.split(self.lmp), expect_error=True)
        with open(os.path.join(folder, "output"), "w") as f:
            f.write(result.output)
        return result


def make(case, name, row, setting, lmp):
    return make_in(os.path.join(OUT, name, row, setting), case, variables_of(case, row, setting), lmp)


def make_in(folder, case, variables, lmp):
    """One run: its quantities with the error of their means, its time and particles."""
    mark = mark_of(case, variables)
    answer = kept(folder, mark)
    if answer:
        return answer
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    started = time.time()
    one = Scene(folder, case, lmp)
    results = case.make(one, variables) if case.make else [one(variables)]
    loops = [last_loop(r.output) for r in results]
    answer = dict(provenance(), mark=mark, variables=variables, lmp=lmp, error="; ".join(r.errors() for r in results if r.errors()),
                  steps=max(n for n, _ in loops), particles=max(n for _, n in loops),
                  seconds=round(sum(loop_times(r.output)[0] for r in results), 1), wall=round(time.time() - started, 1))
    if not answer["error"]:
        answer["quantities"] = {k: list(v) for k, v in case.measure(results[0] if len(results) == 1 else results, variables).items()}
    with open(os.path.join(folder, "answer.json"), "w") as f:
        json.dump(answer, f, indent=1)
        f.write("\n")
    return answer


def measure_again(case, folder):
    """Reads a kept run once more, where what is read off has changed."""
    with open(os.path.join(folder, "answer.json")) as f:
        answer = json.load(f)
    if answer["error"]:
        return
    results = []
    for below in [""] + sorted(os.listdir(folder)):
        path = os.path.join(folder, below)
        if os.path.exists(os.path.join(path, "output")) and below != "output":
            with open(os.path.join(path, "output")) as f:
                results.append(sphtm_scene.Result(path, f.read(), 0))
    found = case.measure(results[0] if len(results) == 1 else results, answer["variables"])
    answer["quantities"] = {k: list(v) for k, v in found.items()}
    with open(os.path.join(folder, "answer.json"), "w") as f:
        json.dump(answer, f, indent=1)
        f.write("\n")


def answers_of(case, name, runs=True):
    """row -> setting -> answer, of the runs that are there, or else of those that the project keeps, if made with the same."""
    answers, old = {row: {} for row in case.ROWS}, page.kept(name)
    for row in case.ROWS:
        for setting in case.SETTINGS:
            mark = mark_of(case, variables_of(case, row, setting))
            answer = runs and kept(os.path.join(OUT, name, row, setting), mark) or old.get(row, {}).get(setting)
            if answer and answer["mark"] == mark:
                answers[row][setting] = answer
    return answers


def main():
    options = argparse.ArgumentParser(prog="./sphtm validate", description=__doc__.split("\n\n")[0])
    options.add_argument("names", nargs="*", metavar="CASE", help="of %s; all without" % ", ".join(NAMES))
    options.add_argument("--quick", action="store_true", help="each case's quick setting alone")
    options.add_argument("--rows", nargs="+", metavar="ROW", help="some rows of a case")
    options.add_argument("--settings", nargs="+", metavar="SETTING", help="some settings of a case")
    options.add_argument("--jobs", type=int, default=1, help="runs at once")
    options.add_argument("--lmp", default="", help='more arguments of lmp, for example "-k on g 1 -sf kk"')
    options.add_argument("--measure", action="store_true", help="run nothing, measure kept runs again")
    options.add_argument("--look", action="store_true", help="run nothing, make tables and pictures of what is there")
    options.add_argument("--keep", action="store_true", help="take the answers into doc/validation, and make the tables of doc/validation.rst anew")
    options.add_argument("--check", action="store_true", help="say whether those tables are what doc/validation gives, and no more")
    given = options.parse_args()
    for wrong in [n for n in given.names if n not in NAMES]:
        options.error("no case '%s'; there are: %s" % (wrong, ", ".join(NAMES)))
    if given.keep and not os.access(page.PAGE, os.W_OK):
        options.error("--keep writes %s and beside it, which cannot be written: use it in a source tree" % page.PAGE)
    cases = {name: load(name) for name in given.names or NAMES}
    if given.check:
        stale = page.stale(cases, {name: report.of_case(case, answers_of(case, name, runs=False)) for name, case in cases.items()})
        print("doc/validation.rst %s what doc/validation gives" % ("is not" if stale else "has"))
        sys.exit(stale)
    jobs = []
    for name, case in cases.items():
        for kind, asked, there in (("row", given.rows, case.ROWS), ("setting", given.settings, case.SETTINGS)):
            for wrong in [a for a in asked or [] if a not in there]:
                options.error("case '%s' has no %s '%s'; there are: %s" % (name, kind, wrong, ", ".join(there)))
        settings = given.settings or ([case.QUICK] if given.quick else list(case.SETTINGS))
        jobs += [(name, row, s) for s in settings for row in given.rows or case.ROWS if row in case.only(s)]
    jobs.sort(key=lambda job: -cases[job[0]].cost(variables_of(cases[job[0]], *job[1:])))
    os.makedirs(OUT, exist_ok=True)
    failed = []
    if given.measure:
        for name, row, setting in jobs:
            folder = os.path.join(OUT, name, row, setting)
            if kept(folder, mark_of(cases[name], variables_of(cases[name], row, setting))):
                measure_again(cases[name], folder)
    if not given.look and not given.keep and not given.measure:
        with shared_gpu(given.jobs, given.lmp), concurrent.futures.ThreadPoolExecutor(given.jobs) as pool:
            runs = {pool.submit(make, cases[name], name, row, setting, given.lmp): (name, row, setting) for name, row, setting in jobs}
            for run in concurrent.futures.as_completed(runs):
                answer = run.result()
                print("%-12s %-12s %-18s %s" % (runs[run] + (answer["error"] or report.line(answer),)), flush=True)
                failed += [runs[run]] if answer["error"] else []
    summary = dict(provenance(" ".join(["./sphtm validate"] + [a for a in sys.argv[1:] if a != "--look"])), cases={})
    for name, case in cases.items():
        found = answers_of(case, name)
        if given.keep:
            page.keep(name, found)
        summary["cases"][name] = report.of_case(case, found)
        if summary["cases"][name]["rows"]:
            report.draw(case, summary["cases"][name], os.path.join(OUT, name + ".png"))
        if given.keep and os.path.exists(os.path.join(OUT, name + ".png")):
            shutil.copy(os.path.join(OUT, name + ".png"), os.path.join(ROOT, "doc", "validation", name + ".png"))
    if given.keep:    # of all cases, since one table is
        everything = {name: cases.get(name) or load(name) for name in NAMES}
        page.write(everything, {name: report.of_case(case, answers_of(case, name, runs=False)) for name, case in everything.items()})
    summary["results"] = {"validate." + name: report.results(name, cases[name], summary["cases"][name]) for name in cases}
    with open(os.path.join(OUT, "summary.json"), "w") as f:
        json.dump(summary, f, indent=1)
        f.write("\n")
    with open(os.path.join(OUT, "table.rst"), "w") as f:
        f.write("\n".join(report.table(cases[name], summary["cases"][name]) for name in cases))
    print("\n".join(report.text(name, cases[name], summary["cases"][name]) for name in cases))
    commits = {a["commit"] for c in summary["cases"].values() for a in c["rows"].values()}
    if commits - {summary["commit"]}:
        print("values at the finest spacing were computed with commit %s; now it is %s" % (", ".join(sorted(commits)), summary["commit"]))
    print("written to", OUT)
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
