"""./sphtm validate and ./sphtm identify: what they refuse; one cut from the command line to its table, taken from its folder the
second time; errors and uncertainties of made-up answers; constants found again from forces that a closed form gives, with
intervals that hold them, and one that a force cannot tell."""
import json
import os
import subprocess
import sys

import numpy as np

from sphtm_scene import SKIPPED, SOURCE, Checks, new_folder

if not os.environ.get("SPHTM_LMP"):
    print("no SPHTM_LMP in the environment: skipped")
    sys.exit(SKIPPED)
FOLDER, TOOLS = new_folder(), os.path.join(SOURCE, "bench", "validate")
os.environ["SPHTM_OUT"] = FOLDER
sys.path.insert(0, TOOLS)
import report                                                                          # noqa: E402

checks = Checks()


def command(program, *arguments):
    return subprocess.run(["/usr/bin/python3", os.path.join(TOOLS, program + ".py"), *arguments], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True, env=dict(os.environ, SPHTM_OUT=FOLDER))


for program, arguments, word in (("run", ["ti6al4w"], "'ti6al4w'"), ("run", ["ti6al4v", "--rows", "50_um_5"], "'50_um_5'"),
                                 ("run", ["ti6al4v", "--settings", "dx_3"], "'dx_3'"),
                                 ("identify", ["ti6al4v", "--fit", "jc_q", "--rows", "40_um_30"], "'jc_q'"),
                                 ("identify", ["ti6al4v", "--fit", "jc_a", "jc_b", "--rows", "40_um_30"], "cannot give"),
                                 ("identify", ["ti6al4v", "--fit", "jc_a", "--rows", "40_um_30", "--bounds", "1.1", "2"], "bounds"),
                                 ("identify", ["ti6al4v", "--fit", "jc_a", "--rows", "40_um_30", "--jobs", "0"], "--jobs"),
                                 ("identify", ["ti6al4v", "--fit", "jc_a", "--rows", "40_um_30", "--var", "nosuch", "3"], "nosuch"),
                                 ("identify", ["taylor_bar", "--fit", "jc_a", "--rows", "40_um_30"], "there are: ti6al4v")):
    done = command(program, *arguments)
    checks.true("refused: %s %s" % (program, " ".join(arguments)), done.returncode != 0 and word in done.stdout,
                done.stdout.strip().splitlines()[-1])

done = command("run", "ti6al4v", "--rows", "40_um_30", "--settings", "dx_10")
with open(os.path.join(FOLDER, "summary.json")) as f:
    row = json.load(f)["cases"]["ti6al4v"]["rows"]["40_um_30"]
checks.true("a cut", done.returncode == 0, done.stdout.splitlines()[0])
checks.near("its cutting force, N/mm; 10 um are coarse", row["quantities"]["cutting force"]["value"], 88.4, relative=0.25)
checks.below("its energy sum, drift over the work", abs(row["all"]["dx_10"]["drift of the energy sum"][0]), 1e-4)
with open(os.path.join(FOLDER, "table.rst")) as f:
    checks.true("its table", "40 um, 30 m/min" in f.read())
answer = os.path.join(FOLDER, "ti6al4v", "40_um_30", "dx_10", "answer.json")
made = os.stat(answer).st_mtime_ns
command("run", "ti6al4v", "--rows", "40_um_30", "--settings", "dx_10")
checks.true("the second time it is there", os.stat(answer).st_mtime_ns == made)


class Case:
    __doc__, TITLE, REFERENCE = "made up", "made up", "made up"
    COMPARED, MESH, SCALING = {"force": ("N", 0.05)}, ("coarse", "fine"), ("slow", "fine")
    SETTINGS, SAID = dict.fromkeys(("coarse", "fine", "slow")), {s: s for s in ("coarse", "fine", "slow")}
    ROWS = {"one": {"title": "one", "reference": {"force": (100.0, 10.0)}}}
    FITTED = ("force",)


made = lambda value: {"quantities": {"force": (value, 0.3)}, "error": "", "seconds": 1.0, "particles": 1, "commit": "", "date": ""}
found = report.of_case(Case, {"one": {"coarse": made(92.0), "fine": made(95.0), "slow": made(94.6)}})["rows"]["one"]["quantities"]["force"]
checks.near("error at the finest spacing", found["error"], -0.05, relative=1e-9)
checks.near("uncertainty of spacing, scaling and window", found["uncertainty"], np.sqrt(3.0**2 + 0.4**2 + 0.3**2), relative=1e-9)

sizes = (4.0, 2.0, 1.0)
checks.near("order of three spacings", report.order(sizes, [3.0 + 0.5 * h**1.7 for h in sizes]), 1.7, relative=1e-6)
checks.true("no order where they do not approach a value", report.order(sizes, [3.0, 2.0, 3.0]) is None and report.order(sizes, [3.0, 2.9, 2.0]) is None)
rows = "\n".join(report.rows_table(Case, report.of_case(Case, {"one": {"coarse": made(92.0), "fine": made(95.0)}})))
checks.true("its row: value, reference, error", "95 +- 3; 100 +- 10; -5.0 %" in rows, rows.splitlines()[-4])
done = command("run", "--check")
checks.true("the tables of doc/validation.rst are of the answers in doc/validation", done.returncode == 0, done.stdout.strip().splitlines()[-1])
import page                                                                            # noqa: E402
import run as validate                                                                 # noqa: E402

for name in validate.NAMES:    # what a case must have, before a run of it
    case = validate.load(name)
    whole = set(case.SETTINGS) == set(case.SAID) and set(case.MESH) <= set(case.SETTINGS) and case.QUICK in case.SETTINGS and set(case.MESH) == set(
        case.SPACING) and all(set(r["reference"]) <= set(case.COMPARED) for r in case.ROWS.values()) and (case.__doc__ or "").count("hosen") > 0
    checks.true("case %s: settings have words, spacings sizes, references quantities, and its choices are written down" % name, whole)
    checks.true("    it has its tables on the page", all(".. table %s %s\n" % (name, k) in open(page.PAGE).read() for k in page.TABLES))
for name, row, quantity, value, within in (("slope", "share_0.7", "acceleration", 1.026, 0.01), ("impact", "bars", "contact time", 1.0, 0.06),
                                           ("layers", "ratio_10", "heat that has crossed", None, 0.02), ("plate", "gray_2001", "period", 0.2621, 0.08)):
    quick = validate.load(name)
    done = command("run", name, "--rows", row, "--settings", quick.QUICK)
    with open(os.path.join(FOLDER, "summary.json")) as f:
        found = json.load(f)["cases"][name]["rows"][row]["quantities"][quantity]
    checks.near("%s, %s: %s" % (name, row, quantity), found["value"], value or found["measured"], relative=within)

import identify                                                                        # noqa: E402

TRUE = np.array([1.3, 0.7])


class Cuts:
    """force = a (2 + x f), with a measured force that the true factors give."""
    names, noise, numerical = ("strength", "friction"), 0.01, {}
    places = {"row %d" % k: 1.0 + k for k in range(4)}

    class case:
        FITTED, ROWS = ("force",), {}

    def force(self, row, factors):
        return 10 * factors[0] * (2 + self.places[row] * factors[1] ** 2)

    def many(self, asked):
        return [{"force": (self.force(row, f), self.noise)} for row, f in asked]


cuts = Cuts()
rng = np.random.default_rng(5)
for row in cuts.places:
    cuts.case.ROWS[row] = {"reference": {"force": (cuts.force(row, TRUE) + 0.1 * rng.standard_normal(), 0.2)}}
fit = identify.Fit(cuts, list(cuts.places), 0.1)
done, half, correlation = identify.solve(fit, 2, (0.4, 2.5), 20)
for k, name in enumerate(cuts.names):
    checks.below("found again: %s, off by" % name, abs(done.x[k] - TRUE[k]), half[k])
    checks.below("its half width", half[k], 0.1)
checks.true("no doubts where it is found", not identify.doubts(fit, done, cuts.names, (0.4, 2.5)), "")
for bounds, most, wanted in (((0.85, 1.15), 20, "is at the end of its range"), ((0.85, 1.15), 20, "do not make the measured"), ((0.4, 2.5), 1, "not settled")):
    fit = identify.Fit(cuts, list(cuts.places), 0.1)
    said = "; ".join(identify.doubts(fit, identify.solve(fit, 2, bounds, most)[0], cuts.names, bounds))
    checks.true("factors from %g to %g, %d evaluations: %s" % (bounds + (most, wanted)), wanted in said, said)
jacobian = np.array([[10 * (2 + x * TRUE[1] ** 2), 20 * TRUE[0] * x * TRUE[1]] for x in cuts.places.values()]) / np.hypot(0.1, cuts.noise)
least = np.sqrt(np.diag(np.linalg.inv(jacobian.T @ jacobian)))
checks.below("half widths are not below two standard deviations of the closed form", (2 * least / half).max(), 1.02)
one = identify.Fit(cuts, ["row 0", "row 0", "row 0"], 0.1)    # one force cannot tell strength from friction
checks.above("counter-case, one row: half width", identify.solve(one, 2, (0.4, 2.5), 20)[1].max(), 100)
checks.end()
