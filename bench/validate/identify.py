"""Finds constants of the material or of the friction from measured forces: least squares (SciPy's trust-region reflective
method with bounds), the cuts of all rows and of all slopes at once, then a check on rows that were held out. Called by
./sphtm identify [options].

  ./sphtm identify ti6al4v --fit jc_a friction --rows 40_um_10 60_um_10 80_um_10 --predict 60_um_5 60_um_30 --jobs 8

Each parameter is a factor on what the case has: a constant of the material card by its name in 'pair_coeff ... set', or
'friction' on the friction coefficient of every row. A residual is computed less measured force over its standard deviation: of the measured force, of the
mean over the window, and of the numerics at that spacing as ./sphtm validate found it (NUMERICAL in the case's file). Slopes are differences over --step, wide enough for the noise of a mean force. Intervals are of 95 %, from the slopes at the end
and Student's t; where the fit is worse than the scatter explains, they are widened by the root of chi square over the degrees
of freedom."""
import argparse
import atexit
import concurrent.futures
import contextlib
import json
import os
import re
import shutil
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import run as validate                                                                 # noqa: E402
from provenance import provenance                                                      # noqa: E402
from shared_gpu import shared_gpu                                                      # noqa: E402

import numpy as np                                                                     # noqa: E402

OUT = os.environ.get("SPHTM_OUT", os.path.join(validate.ROOT, "out", "identify"))


class Cuts:
    """Computed forces of rows for sets of factors, each run once and kept in out/identify/CASE."""

    def __init__(self, case, name, names, setting, more, jobs, lmp):
        self.case, self.name, self.names, self.setting, self.more, self.lmp = case, name, names, setting, more, lmp
        self.numerical = case.NUMERICAL[setting]
        self.pool, self.runs = concurrent.futures.ThreadPoolExecutor(jobs), 0

    def variables(self, row, factors):
        found = dict(validate.variables_of(self.case, row, self.setting), **self.more)
        card, constants = self.case.CARD, self.case.CONSTANTS
        for name, factor in zip(self.names, factors):
            if name == "friction":
                found["mu"] = "%.6g" % (found["mu"] * factor)
            else:
                card += " set %s %.8g" % (name, constants[name] * factor)
        return dict(found, material=card)

    def one(self, row, factors):
        variables = self.variables(row, factors)
        folder = os.path.join(OUT, self.name, validate.mark_of(self.case, variables))
        answer = validate.make_in(folder, self.case, variables, self.lmp)
        if answer["error"]:
            shutil.rmtree(folder)    # what was wrong can be mended
            sys.exit("identify: %s with %s: %s" % (row, " ".join("%s %.4g" % p for p in zip(self.names, factors)), answer["error"]))
        self.runs += 1
        return {q: answer["quantities"][q] for q in self.case.FITTED}

    def many(self, asked):
        """Of a list of (row, factors), all at once."""
        return [f.result() for f in [self.pool.submit(self.one, row, tuple(factors)) for row, factors in asked]]


class Fit:
    def __init__(self, cuts, rows, step):
        self.cuts, self.rows, self.step, self.history = cuts, rows, step, []

    def residuals(self, answers):
        found = []
        for row, answer in zip(self.rows, answers):
            for quantity, (value, noise) in answer.items():
                measured, scatter = self.cuts.case.ROWS[row]["reference"][quantity]
                numerical = self.cuts.numerical.get(quantity, 0.0) * measured
                found.append((value - measured) / np.sqrt((0.5 * scatter) ** 2 + noise**2 + numerical**2))
        return np.array(found)

    def at(self, factors):
        r = self.residuals(self.cuts.many([(row, factors) for row in self.rows]))
        self.history.append([list(map(float, factors)), float(r @ r)])
        print("  %s: chi square %.2f of %d forces" % (" ".join("%s %.4f" % p for p in zip(self.cuts.names, factors)), r @ r, len(r)), flush=True)
        return r

    def slopes(self, factors):
        """Central differences, all cuts at once."""
        sides = [np.array(factors) + s * self.step * np.eye(len(factors))[k] for k in range(len(factors)) for s in (-1, 1)]
        answers = self.cuts.many([(row, side) for side in sides for row in self.rows])
        r = [self.residuals(answers[k * len(self.rows):(k + 1) * len(self.rows)]) for k in range(len(sides))]
        return np.array([(r[2 * k + 1] - r[2 * k]) / (2 * self.step) for k in range(len(factors))]).T


def intervals(jacobian, residual):
    """Half widths of 95 % for each factor, and the correlation of the factors."""
    from scipy.stats import t
    freedom = len(residual) - jacobian.shape[1]
    try:
        inverse = np.linalg.inv(jacobian.T @ jacobian)
    except np.linalg.LinAlgError:
        inverse = np.zeros((jacobian.shape[1],) * 2)
    if not (np.diag(inverse) > 0).all():    # the forces cannot tell them apart, to the last digits of their squares
        return np.full(jacobian.shape[1], np.inf), np.eye(jacobian.shape[1])
    widen = max(1.0, residual @ residual / freedom) if freedom > 0 else 1.0
    sigma = np.sqrt(np.diag(inverse))
    return t.ppf(0.975, max(1, freedom)) * sigma * np.sqrt(widen), inverse / np.outer(sigma, sigma)


def solve(fit, count, bounds, evaluations):
    """The least squares of count factors that begin at 1: SciPy's answer, half widths of 95 %, correlation."""
    from scipy.optimize import least_squares
    low, high = bounds[0] + fit.step, bounds[1] - fit.step
    print("factors from %.3g to %.3g: within the bounds by the step of the slopes" % (low, high), flush=True)
    done = least_squares(fit.at, np.ones(count), jac=fit.slopes, bounds=(low, high), max_nfev=evaluations,
                         xtol=0.01, ftol=0.02, x_scale=1.0)
    return (done,) + intervals(done.jac, done.fun)


def doubts(fit, done, names, bounds):
    """Why what was found may not be it, in words."""
    said, forces = [], len(done.fun)
    if not done.success or done.status == 0:
        said.append("the fit has not settled in %d evaluations: more with --evaluations" % len(fit.history))
    low, high = bounds[0] + fit.step, bounds[1] - fit.step
    for name, factor, active in zip(names, done.x, done.active_mask):
        if active or min(factor - low, high - factor) < 0.02 * (high - low):
            said.append("%s is at the end of its range, %.3g: wider --bounds" % (name, low if factor < 0.5 * (low + high) else high))
    freedom, square = forces - len(names), float(done.fun @ done.fun)
    if square > forces and freedom > 0:
        from scipy.stats import chi2
        chance = chi2.sf(square, freedom)
        if chance < 0.01:
            said.append("chi square is %.1f with %d degrees of freedom (by chance with a probability of %.1g): these constants do not "
                        "make the measured forces" % (square, freedom, chance))
    return said


def compare(cuts, rows, start, best):
    """Of rows: measured, with the constants of the start, with those found."""
    answers = cuts.many([(row, factors) for factors in (start, best) for row in rows])
    table = []
    for k, row in enumerate(rows):
        for quantity in cuts.case.FITTED:
            measured, scatter = cuts.case.ROWS[row]["reference"][quantity]
            table.append({"row": row, "quantity": quantity, "measured": measured, "scatter": scatter,
                          "start": answers[k][quantity][0], "fitted": answers[len(rows) + k][quantity][0]})
    return table


def show(title, table):
    print(title)
    for a in table:
        print("  %-12s %-14s measured %6.1f +- %-5.1f start %6.1f (%+.0f %%)  fitted %6.1f (%+.0f %%)" % (
            a["row"], a["quantity"], a["measured"], a["scatter"], a["start"], 100 * (a["start"] / a["measured"] - 1), a["fitted"],
            100 * (a["fitted"] / a["measured"] - 1)))


def is_of_forces(name):
    """Whether a case says what identify wants: CARD, CONSTANTS, FITTED, NUMERICAL."""
    with open(os.path.join(os.path.dirname(os.path.abspath(__file__)), "case_%s.py" % name)) as f:
        text = f.read()
    return all(re.search(r"^%s\b" % word, text, re.M) for word in ("CARD", "CONSTANTS", "FITTED", "NUMERICAL"))


def variables_known(case):
    text = case.SCRIPT
    if "\n" not in text:
        with open(text) as f:
            text = f.read()
    return set(re.findall(r"^\s*variable\s+(\w+)\s+(?:index|string|getenv)", text, re.M))


def main():
    options = argparse.ArgumentParser(prog="./sphtm identify", description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("case", metavar="CASE", help="of %s, or one of your own: doc/Howto_studies" % ", ".join(n for n in validate.NAMES if is_of_forces(n)))
    options.add_argument("--fit", nargs="+", required=True, metavar="CONSTANT", help="constants of the card, or friction")
    options.add_argument("--rows", nargs="+", required=True, metavar="ROW", help="rows that are fitted")
    options.add_argument("--predict", nargs="*", default=[], metavar="ROW", help="rows that are held out")
    options.add_argument("--setting", default=None, help="of the case; its quick one without")
    options.add_argument("--var", nargs=2, action="append", default=[], metavar=("NAME", "VALUE"), help="more variables of the script")
    options.add_argument("--bounds", nargs=2, type=float, default=(0.4, 2.5), help="of the factors (default 0.4 2.5)")
    options.add_argument("--step", type=float, default=0.15, help="of the slopes (default 0.15)")
    options.add_argument("--evaluations", type=int, default=8, help="at most so many points without those of slopes (default 8)")
    options.add_argument("--jobs", type=int, default=1, help="cuts at once")
    options.add_argument("--lmp", default="", help='more arguments of lmp, for example "-k on g 1 -sf kk"')
    given = options.parse_args()
    if given.case not in validate.NAMES or not is_of_forces(given.case):
        options.error("no case '%s' with constants to find; there are: %s" % (
            given.case, ", ".join(n for n in validate.NAMES if is_of_forces(n))))
    for name, value in (("--jobs", given.jobs), ("--evaluations", given.evaluations)):
        if value < 1:
            options.error("%s must be at least 1, not %d" % (name, value))
    case = validate.load(given.case)
    for wrong in [r for r in given.rows + given.predict if r not in case.ROWS]:
        options.error("case '%s' has no row '%s'; there are: %s" % (given.case, wrong, ", ".join(case.ROWS)))
    for wrong in [n for n in given.fit if n not in case.CONSTANTS and n != "friction"]:
        options.error("no constant '%s'; there are: %s, friction" % (wrong, ", ".join(case.CONSTANTS)))
    if "friction" in given.fit and not all("mu" in dict(case.BASE, **case.ROWS[r]["variables"]) for r in given.rows + given.predict):
        options.error("case '%s' has no coefficient of friction 'mu' to find" % given.case)
    known = variables_known(case)
    for wrong in [name for name, _ in given.var if name not in known]:
        options.error("the script of case '%s' has no 'variable %s index'; it has: %s" % (given.case, wrong, " ".join(sorted(known))))
    setting = given.setting or case.QUICK
    if setting not in case.NUMERICAL:
        options.error("no setting '%s'; there are: %s" % (setting, ", ".join(case.NUMERICAL)))
    if len(given.rows) * len(case.FITTED) <= len(given.fit):
        options.error("%d forces cannot give %d constants and their scatter" % (len(given.rows) * len(case.FITTED), len(given.fit)))
    low, high = given.bounds
    if not 0 < low < 1 < high or not 0 < given.step < min(1 - low, high - 1):
        options.error("bounds must lie about 1 and be above 0, and leave room for the step")
    service = contextlib.ExitStack()
    service.enter_context(shared_gpu(given.jobs, given.lmp))
    atexit.register(service.close)
    cuts = Cuts(case, given.case, given.fit, setting, dict(given.var), given.jobs, given.lmp)
    fit, start = Fit(cuts, given.rows, given.step), np.ones(len(given.fit))
    done, half, correlation = solve(fit, len(given.fit), given.bounds, given.evaluations)
    tables = {"fitted": compare(cuts, given.rows, start, done.x), "held_out": compare(cuts, given.predict, start, done.x)}
    constants = {n: {"factor": float(f), "half_width": float(h), "value": case.CONSTANTS.get(n, 1.0) * float(f)}
                 for n, f, h in zip(given.fit, done.x, half)}
    doubted = doubts(fit, done, given.fit, given.bounds)
    for why in doubted:
        print("NOT FOUND: " + why)
    print("best, with intervals of 95 %:" if doubted else "found, with intervals of 95 %:")
    for name, c in constants.items():
        print("  %-10s %.4g, factor %.3f +- %.3f" % (name, c["value"], c["factor"], c["half_width"]))
    show("rows of the fit:", tables["fitted"])
    show("held out:", tables["held_out"])
    summary = dict(provenance("./sphtm identify " + " ".join(sys.argv[1:])), constants=constants, correlation=correlation.tolist(),
                   chi_square=float(done.fun @ done.fun), doubts=doubted, stopped=done.message, history=fit.history, cuts=cuts.runs, **tables)
    with open(os.path.join(OUT, "summary.json"), "w") as f:
        json.dump(summary, f, indent=1)
        f.write("\n")
    print("written to", os.path.join(OUT, "summary.json"))
    sys.exit(1 if doubted else 0)


if __name__ == "__main__":
    main()
