#!/usr/bin/python3
"""Bullet through a plate: time, residual velocity and searched fraction with every kind of list. ./sphtm scenes bullet_plate"""
import os
import statistics
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))
from study import Study                                                                # noqa: E402

ROWS = {"every step": {"adapt": "threshold 0"}, "every step, lists of LAMMPS": {"search": "every"},
        "search once": {"adapt": "threshold inf"}, "1e-4": {"adapt": "threshold 1e-4"}, "1e-5": {"adapt": "threshold 1e-5"},
        "1e-6": {"adapt": "threshold 1e-6"}, "skin list": {}}


def measure(result):
    """Velocity of the bullet and of its tail, means over the last tenth; searched fraction, mean over the run."""
    v = result.columns("velocity.dat")
    last = v[v[:, 1] > 0.9 * v[-1, 1]]
    m = {"residual": last[:, 2].mean(), "residual_tail": last[:, 3].mean()}
    t = result.thermo[-1]
    m["momentum_drift"] = None
    m["energy_drift"] = np.abs(t["f_body[9]"] / t["f_body[9]"][0] - 1).max()
    m["particles"] = int(t["Atoms"][0])
    return m


def main():
    sizes = {"small": {"n": 3, "end": 2e-4}, "default": {"n": 5}, "large": {"n": 16}}
    study = Study(__file__, sizes, __doc__)
    table, results = {}, {}
    for repeat in range(study.options.repeats):         # round by round, so that a busy spell hits all rows alike
        for row, variables in ROWS.items():
            if study.wants(row):
                result = study.run(row.replace(" ", "_").replace(",", ""), dict(study.size, **variables), may_stop=True)
                results.setdefault(row, []).append(result)
    for row, all_of_it in results.items():
        if not all_of_it[-1].thermo:
            table[row] = {"stopped": all_of_it[-1].errors()}
            continue
        table[row] = dict(measure(all_of_it[-1]), processor=statistics.median(r.processor for r in all_of_it),
                          wall=statistics.median(r.wall for r in all_of_it))
    clock = "wall" if study.options.lmp else "processor"     # of the processor on a shared machine
    for reference in "every step", "skin list":
        if "processor" in table.get(reference, {}):
            for row in table.values():
                if "processor" in row:
                    row["speed_up_over_" + reference.replace(" ", "_")] = table[reference][clock] / row[clock]
                    row["residual_off_" + reference.replace(" ", "_")] = row["residual"] / table[reference]["residual"] - 1
    study.end({"rows": table})


if __name__ == "__main__":
    main()
