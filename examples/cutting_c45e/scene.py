#!/usr/bin/python3
"""Orthogonal cutting of C45E, coarse, refined at the tool, and fine. ./sphtm scenes cutting_c45e"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))
from study import Study                                                                # noqa: E402

KIENZLE = 2220.0 * 1.0 ** (1 - 0.14)      # N per mm of width at 1 mm: kc1.1 = 2220 N/mm2, mc = 0.14; see README.md
# S13: edge of the square 0.5 of the spacing; the keyword takes smoothing lengths, 1.2 spacings
REFINE = "refine square epsilon 0.41667 alpha 0.5 velocity linear when region tip every 50"


def forces(result):
    """Length of cut (mm), cutting and passive force (N per mm of width), smoothed over a quarter of a millimetre."""
    f = result.columns("force.dat")
    done, width = 1e3 * f[:, 2], max(1, int(0.25 / np.median(np.diff(1e3 * f[:, 2]))))
    mean = [np.convolve(1e-3 * f[:, k], np.ones(width) / width, "same") for k in (3, 4)]
    return done, mean[0], mean[1]


def measure(result):
    """Means over the second half of the cut; the overshoot before it over the steady level."""
    done, cutting, passive = forces(result)
    late = (done > 0.5 * done[-1]) & (done < done[-1] - 0.2)
    start = done < 0.5 * done[-1]
    thirds = [part.mean() for part in np.array_split(cutting[late], 3)]
    c = result.columns("force.dat")
    return {"cutting": cutting[late].mean(), "passive": passive[late].mean(), "thirds": thirds,
            "swing": cutting[late].std() / cutting[late].mean(),
            "first_peak": cutting[start].max() / cutting[late].mean(), "over_kienzle": cutting[late].mean() / KIENZLE,
            "deepest": c[:, 5].max(), "particles_end": int(result.thermo[-1]["Atoms"][-1]),
            "processor": result.processor, "wall": result.wall}


def main():
    sizes = {"small": {"cut": 3e-3, "length": 8e-3}, "default": {}, "large": {"speed": 5}}
    study = Study(__file__, sizes, __doc__)
    rows = {"coarse": {}, "refined": {"adapt": REFINE}, "adaptive": {"adapt": "asph psi " + REFINE},
            "fine": {"dx": 0.15e-3}}
    table, results = {}, {}
    for row, variables in rows.items():
        if study.wants(row):
            results[row] = study.run(row, dict(study.size, **variables), may_stop=True)
            if results[row].errors():
                table[row] = {"stopped": results.pop(row).errors()}
                continue
            table[row] = measure(results[row])
    draw(results, study)
    results = {row: table[row] for row in ("refined", "fine") if "cutting" in table.get(row, {})}
    if len(results) == 2:
        fine, refined = results["fine"], results["refined"]
        results["refined_over_fine"] = {"cutting": refined["cutting"] / fine["cutting"],
                                        "passive": refined["passive"] / fine["passive"],
                                        "time": refined["processor"] / fine["processor"]}
    study.end({"rows": table, "kienzle": KIENZLE}, {"cutting_c45e": results} if len(results) == 3 else None)


def draw(results, study):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from sphtm_scene import read_dump
    plt.rcParams.update({"font.size": 9})
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.4), gridspec_kw={"width_ratios": [1.1, 1]})
    for k, (row, result) in enumerate(results.items()):
        done, cutting, passive = forces(result)
        axes[0].plot(done, cutting, "-", color="C%d" % k, lw=1, label=row)
        axes[0].plot(done, passive, "--", color="C%d" % k, lw=0.7)
    axes[0].axhline(KIENZLE, color="0.5", lw=0.8)
    axes[0].set(xlabel="length of cut (mm)", ylabel="cutting (full) and passive force (N/mm)", ylim=(0, None))
    axes[0].legend(frameon=False)
    row = "adaptive" if "adaptive" in results else list(results)[0]
    frame = read_dump(results[row].path("end.dump"))[-1]
    dots = axes[1].scatter(1e3 * frame["x"], 1e3 * frame["y"], c=frame["c_p[2]"], s=2, cmap="inferno", vmin=0, vmax=3,
                           lw=0)
    axes[1].set(aspect="equal", title="plastic strain, " + row, xlabel="x (mm)", ylabel="y (mm)")
    figure.colorbar(dots, ax=axes[1])
    figure.tight_layout()
    figure.savefig(study.path("cutting_c45e.png"), dpi=150)


if __name__ == "__main__":
    main()
