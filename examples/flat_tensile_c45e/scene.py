#!/usr/bin/python3
"""The flat specimen with constant, density-based and adaptive smoothing length, and the path of the material: rows of
neighbors that are never searched again, without numerical fracture. ./sphtm scenes flat_tensile_c45e"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))
from study import Study                                                                # noqa: E402

ROWS = {"constant": {}, "asph": {"adapt": "asph psi every 2 limits 0.5 3"}, "density": {"adapt": "asph density"},
        "path": {"adapt": "threshold inf", "options": "plane stress artstress 0 4"}}
BROKEN = 0.5                      # fracture: the force has fallen below this part of its largest value
LEFT = 0.95                       # the path is left: the force has fallen below this part of that on the path


def curve(result):
    """Strain, engineering stress (Pa), largest plastic strain; means over a hundredth of the run."""
    c = result.columns("curve.dat")
    width = max(1, len(c) // 100)
    return [np.convolve(c[:, k], np.ones(width) / width, "valid") for k in (1, 2, 5)]


def fracture(strain, stress):
    """Strain at the largest stress, and where the stress has fallen below half of it (None: it has not)."""
    top = stress.argmax()
    gone = np.flatnonzero(stress[top:] < BROKEN * stress[top])
    return strain[top], strain[top + gone[0]] if len(gone) else None


def leaves(strain, stress, path):
    """Strain at which the stress falls below 0.95 of that on the path, a curve (None: it does not)."""
    on = (strain > 0.02) & (strain <= path[0][-1])
    off = np.flatnonzero(stress[on] < LEFT * np.interp(strain[on], path[0], path[1]))
    return strain[on][off[0]] if len(off) else None


def flow(strain):
    """Engineering stress of a bar of C45E (Jaspers 1999) that stays even: plane stress, no heat, rate 1/s."""
    return (553.1e6 + 600.8e6 * np.log1p(strain)**0.234) / (1 + strain)


def main():
    sizes = {"small": {"rows": 10, "speed": 20}, "coarse": {"rows": 14, "speed": 20},
             "default": {"rows": 25, "speed": 20}, "large": {"rows": 50, "speed": 10}}
    study = Study(__file__, sizes, __doc__)
    table, curves = {}, {}
    for row, variables in ROWS.items():
        if not study.wants(row):
            continue
        result = study.run(row, dict(study.size, **variables))
        curves[row] = strain, stress, most = curve(result)
        top, gone = fracture(strain, stress)
        table[row] = {"largest_stress": stress.max(), "strain_of_it": top, "fracture_strain": gone, "last_stress": stress[-1],
                      "largest_plastic_strain": most[-1], "processor": result.processor, "wall": result.wall}
    for row in table:
        if "path" in curves:
            path = curves["path"]
            table[row]["leaves_path"] = leaves(*curves[row][:2], path)
            table[row]["of_path_at_0.15"] = np.interp(0.15, *curves[row][:2]) / np.interp(0.15, *path[:2])
    draw(curves, study)
    study.end({"rows": table})


def draw(curves, study):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from sphtm_scene import read_dump
    plt.rcParams.update({"font.size": 9})
    figure, axes = plt.subplots(1, 2, figsize=(9, 3.6), gridspec_kw={"width_ratios": [1, 1.2]})
    titles = {"constant": "h constant", "density": "h from the density", "asph": "ASPH", "path": "never searched again"}
    for row, (strain, stress, _) in curves.items():
        axes[0].plot(strain, 1e-6 * stress, "k:" if row == "path" else "-", lw=1, label=titles[row])
    axes[0].axvline(0.15, color="0.8", lw=1, zorder=0)
    axes[0].set(xlabel="strain", ylabel="engineering stress (MPa)", ylim=(0, None))
    axes[0].legend(frameon=False)
    for k, row in enumerate(curves):
        frame = read_dump(os.path.join(study.path(row), "end.dump"))[-1]
        dots = axes[1].scatter(1e3 * frame["x"], 1e3 * frame["y"] - 30 * k, c=frame["c_p[1]"],
                               s=0.6 * (25 / int(study.size["rows"]))**2, cmap="inferno", vmin=0,
                               vmax=0.4, lw=0)
        axes[1].text(-10, -30 * k + 12, titles[row], fontsize=8)
    axes[1].set(aspect="equal", title="plastic strain", xticks=[], yticks=[])
    figure.colorbar(dots, ax=axes[1])
    figure.tight_layout()
    figure.savefig(study.path("flat_tensile_c45e.png"), dpi=150)


if __name__ == "__main__":
    main()
