#!/usr/bin/python3
"""Bullet through a plate: time, residual velocity and searched fraction with every kind of list.

./sphtm scenes bullet_plate; SPHTM_ROUND=2 in the environment: only round 2 of several that run side by side;
--look --repeats 3 takes their medians."""
import os
import statistics
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))
from study import Study                                                                # noqa: E402

ROWS = {"every step": {"adapt": "threshold 0"}, "every step, rows with a margin": {"adapt": "threshold 0 margin 0.15"},
        "every step, lists of LAMMPS": {"search": "every"},
        "search once": {"adapt": "threshold inf rows 400"}, "1e-4": {"adapt": "threshold 1e-4"},
        "1e-5": {"adapt": "threshold 1e-5"}, "1e-6": {"adapt": "threshold 1e-6"}, "skin list": {}}


def measure(result):
    """Velocity of the bullet and of its tail, means over the last tenth; searched fraction, mean over the run."""
    v = result.columns("velocity.dat")
    last = v[v[:, 1] > 0.9 * v[-1, 1]]
    m = {"residual": last[:, 2].mean(), "residual_tail": last[:, 3].mean()}
    t = result.thermo[-1]
    if "f_lists[2]" in t and t["f_lists[2]"][-1] > 0:      # threshold 0 counts no searches
        m["searched"] = float(t["f_lists[2]"][-1] / t["Step"][-1])
    m["energy_drift"] = np.abs(t["f_body[9]"] / t["f_body[9]"][0] - 1).max()
    m["particles"] = int(t["Atoms"][0])
    return m


def main():
    sizes = {"small": {"n": 3, "thick": 9e-3, "end": 1.5e-4, "width": 72e-3}, "default": {"n": 5},
             "large": {"n": 10, "sample": 20}}
    study = Study(__file__, sizes, __doc__)
    table, results = {}, {}
    for repeat in range(study.options.repeats):         # round by round, so that a busy spell hits all rows alike
        for row, variables in ROWS.items():
            name = row.replace(" ", "_").replace(",", "")
            folder = os.path.join(os.environ.get("SPHTM_ROUND", str(repeat)), name)
            done = os.path.exists(study.path(os.path.join(folder, "times.json")))
            if study.wants(row) and (done or not study.options.look):
                result = study.run(name, dict(study.size, **variables), may_stop=True, folder=folder)
                results.setdefault(row, []).append(result)
    for row, all_of_it in results.items():
        if all_of_it[-1].errors():
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
                    off = row["residual"] / table[reference]["residual"] - 1
                    row["residual_off_" + reference.replace(" ", "_")] = off
    best = table.get("skin list", {})
    study.end({"rows": table}, {"bullet_plate." + study.options.size: best} if "residual" in best else None)
    try:
        draw({row: all_of_it[-1] for row, all_of_it in results.items() if not all_of_it[-1].errors()}, study)
    except ImportError as e:
        print("no picture: %s" % e)


def draw(results, study):
    """Velocity of the bullet in all rows, and cuts through the middle at four times of the first."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from sphtm_scene import read_dump
    plt.rcParams.update({"font.size": 9})
    figure, axes = plt.subplots(1, 4, figsize=(10, 3.2), gridspec_kw={"width_ratios": [1.5, 1, 1, 1]})
    for row, result in results.items():
        v = result.columns("velocity.dat")
        axes[0].plot(1e6 * v[:, 1], v[:, 2], lw=1, label=row)
    axes[0].set(xlabel="time (us)", ylabel="velocity of the bullet (m/s)", ylim=(0, None))
    axes[0].legend(frameon=False, fontsize=7)
    frames = read_dump(list(results.values())[0].path("bullet.dump"))
    for ax, frame in zip(axes[1:], frames[1:4]):
        thin = np.abs(frame["y"]) < 2e-3
        ax.scatter(1e3 * frame["x"][thin], 1e3 * frame["z"][thin], c=frame["c_p[1]"][thin], s=2, cmap="inferno", vmin=0,
                   vmax=1, lw=0)
        ax.set(aspect="equal", xlim=(-45, 45), ylim=(-40, 80), xlabel="x (mm)")
    figure.tight_layout()
    figure.savefig(study.path("bullet_plate.png"), dpi=150)


if __name__ == "__main__":
    main()
