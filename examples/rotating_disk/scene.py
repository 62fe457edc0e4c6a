#!/usr/bin/python3
"""The rotating disk with every kind of list: what spin and radius are after five turns. ./sphtm scenes rotating_disk"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))
from study import Study                                                                # noqa: E402

# 1e-5_searched: a strain of 2e-4, as the swinging makes it, is enough for a search; 1e-5_plain: no corrected gradients
ROWS = {"skin": None, "every_step": "threshold 0", "once": "threshold inf", "1e-4": "threshold 1e-4",
        "1e-5": "threshold 1e-5", "1e-5_searched": "threshold 1e-5 stretch 2e-4", "1e-5_plain": "threshold 1e-5"}
PLAIN = "stabilize artstress artstress 0 4"


def measure(result):
    """Relative changes of the angular momentum and of the radius of gyration over the run, largest and last."""
    t = result.thermo[-1]
    spin, radius = t["c_sum"] / t["c_sum"][0] - 1, t["c_r"] / t["c_r"][0] - 1
    energy = t["f_body[9]"] / t["f_body[9]"][0] - 1
    searches = float(t["f_lists[2]"][-1]) if "f_lists[2]" in t else 0.0
    return {"searches": searches, "turns": t["v_angle"][-1], "spin": np.abs(spin).max(), "spin_last": spin[-1],
            "radius": np.abs(radius).max(), "radius_last": radius[-1], "energy": np.abs(energy).max()}


def main():
    sizes = {"small": {"n": 6, "rim": 0.04}, "default": {"n": 15, "rim": 0.04}, "large": {"n": 100}}
    study = Study(__file__, sizes, __doc__)
    rows, results = {}, {}
    for row, adapt in ROWS.items():
        if study.wants(row):
            variables = dict(study.size, adapt=adapt)
            if "plain" in row:
                variables["options"] = PLAIN
            results[row] = result = study.run(row, variables)
            rows[row] = dict(measure(result), processor=result.processor, wall=result.wall)
    draw(results, study)
    study.end({"rows": rows})


def draw(results, study):
    """Angular momentum and radius over the turns."""
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    figure, axes = plt.subplots(1, 2, figsize=(8, 3))
    for row, result in results.items():
        t = result.thermo[-1]
        for ax, column in zip(axes, ("c_sum", "c_r")):
            ax.plot(t["v_angle"], 100 * (t[column] / t[column][0] - 1), lw=1, label=row)
    for ax, what in zip(axes, ("angular momentum", "radius of gyration")):
        ax.set(xlabel="turns", ylabel="change of the %s (%%)" % what)
    axes[1].legend(frameon=False, fontsize=7)
    figure.tight_layout()
    figure.savefig(study.path("rotating_disk.png"), dpi=150)


if __name__ == "__main__":
    main()
