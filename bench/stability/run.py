"""Hard cases, each with a quantitative criterion, a counter-run that shows that the criterion can fail, and a restart
in the middle. Prints a table and writes summary.json and table.rst. Called by ./sphtm stability [options]."""
import argparse
import json
import os
import sys

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import frame    # noqa: E402

OUT = os.environ.get("SPHTM_OUT", os.path.join(frame.ROOT, "out", "stability"))
NAMES = sorted(f[5:-3] for f in os.listdir(frame.HERE) if f.startswith("case_") and f.endswith(".py"))


def number(x, missing="stopped"):
    return missing if x is None else "%.3g" % x


def main():
    options = argparse.ArgumentParser(description=__doc__.split(".")[0])
    options.add_argument("--cases", nargs="+", choices=NAMES, default=NAMES, metavar="CASE")
    options.add_argument("--quick", action="store_true", help="shorter runs where a case has them")
    options = options.parse_args()
    os.makedirs(OUT, exist_ok=True)
    path = os.path.join(OUT, "summary.json")
    cases = {}
    if os.path.exists(path):    # cases of earlier calls stay
        with open(path) as f:
            cases = {k: v for k, v in json.load(f)["cases"].items() if k in NAMES}
    for name in options.cases:
        module = frame.load(name)
        own = getattr(module, "measure", None)    # of a case that runs by itself
        answer = own(options.quick) if own else frame.measure(module.CASE, options.quick)
        cases[name] = answer
        print("%-5s %-18s %9s <= %-9s counter-run %9s %s  restart %s  %d steps %.0f s %s" % (
            "ok" if answer["holds"] else "FAIL", name, number(answer["value"]), number(answer["limit"]),
            number(answer["counter_value"]), "fails" if answer["counter_fails"] else "HOLDS", answer["restart"],
            answer["steps"], answer["seconds"], answer["error"]), flush=True)
        wrong = [n for n in sorted(cases) if not cases[n]["holds"] or not cases[n]["counter_fails"] or
                 cases[n]["restart"] == "differs"]
        with open(path, "w") as f:
            json.dump({"cases": {n: cases[n] for n in sorted(cases)}, "wrong": wrong}, f, indent=1)
            f.write("\n")
        table(cases)
    sys.exit(1 if any(n in wrong for n in options.cases) else 0)


def table(cases):
    head = ("case", "criterion", "value", "allowed", "counter-run", "its value", "restart")
    with open(os.path.join(OUT, "table.rst"), "w") as f:
        f.write(".. list-table::\n   :header-rows: 1\n\n")
        for row in [head] + [(a["title"], a["criterion"], number(a["value"]) + ("" if a["holds"] else " (fails)"),
                              number(a["limit"]), a["counter_run"], number(a["counter_value"]), a["restart"])
                             for _, a in sorted(cases.items())]:
            f.write("   * - %s\n" % row[0] + "".join("     - %s\n" % v for v in row[1:]))


if __name__ == "__main__":
    main()
