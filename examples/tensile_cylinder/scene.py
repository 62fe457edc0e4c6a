#!/usr/bin/python3
"""The tensile cylinder with every kind of list: forces, neck, largest strain, pattern, time. ./sphtm scenes tensile_cylinder"""
import os
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "..", "bench")]
from measure import measure, within                                                    # noqa: E402
from study import Study                                                                # noqa: E402

ROWS = {"skin": {}, "every_step": {"adapt": "threshold 0"}, "margin": {"adapt": "threshold 0 margin 0.15"},
        "1e-4": {"adapt": "threshold 1e-4"}, "1e-5": {"adapt": "threshold 1e-5"}, "once": {"adapt": "threshold inf"},
        "artificial_stress": {"options": "stabilize artstress correction yes"}, "neither": {"options": "hourglass 0"},
        "plain": {"options": "stabilize artstress"}}
STRAIN = (0.281, 0.286)    # F14: finite elements and SPH


def main():
    short = {"faster": 4, "grip": 0.075, "pull": 7.31e-3}
    sizes = {"small": dict(short, n=5), "default": {"n": 6, "faster": 4}, "fine": dict(short, n=8),
             "large": {"n": 16, "sample": 200}}      # 264 056 particles, 59 000 steps: for a GPU
    study = Study(__file__, sizes, __doc__)
    rows = {}
    for row, variables in ROWS.items():
        if not study.wants(row):
            continue
        result = study.run(row, dict(study.size, **variables), repeats=study.options.repeats)
        m, t = measure(result.folder, float(study.size["n"])), result.thermo[-1]
        rows[row] = {"largest_force": float(m["force"]), "end_force": float(m["last force"]), "radius": float(m["radius"]),
                     "strain": float(m["strain"]), "chessboard": float(m["chessboard"]), "within": within(m),
                     "ends_apart": float(m["ends apart"]), "processor": result.processor, "wall": result.wall}
        if "f_lists[2]" in t and t["f_lists[2]"][-1] > 0:      # threshold 0 counts no searches
            rows[row]["searched"] = float(t["f_lists[2]"][-1] / t["Step"][-1])
    best = rows.get("margin", rows.get("skin"))
    of_readme = best and {"largest_force": 1e-6 * best["largest_force"], "end_force": 1e-6 * best["end_force"],    # MN, mm
                          "radius": 1e3 * best["radius"], "strain": best["strain"]}
    study.end({"rows": rows, "strain_of_the_paper": STRAIN},
              {"tensile_cylinder.%d" % study.size["n"]: of_readme} if best and study.size["n"] in (6, 16) else None)


if __name__ == "__main__":
    main()
