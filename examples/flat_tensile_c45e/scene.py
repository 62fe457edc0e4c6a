#!/usr/bin/python3
"""The flat specimen with constant, density-based and adaptive smoothing length: with the default stabilization ("resisted"),
with balanced artificial stress, and bare; and the path of the material: rows of neighbors that are never searched again,
without numerical fracture. ./sphtm scenes flat_tensile_c45e"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))
from study import Study                                                                # noqa: E402

LENGTHS = {"constant": {}, "density": {"adapt": "asph density"}, "asph": {"adapt": "asph psi every 2 limits 0.5 3"}}
RESISTED = "plane stress"
BALANCED, BARE = RESISTED + " artstress 0.3 4 balanced", RESISTED + " hourglass 0"
PATH = {"adapt": "threshold inf", "options": RESISTED}


def rows_of(ending, **more):
    return {row + ending: dict(variables, **more) for row, variables in LENGTHS.items()}


# the bare ones break before strain 0.1
ROWS = dict(rows_of("", options=BARE, strain=0.1), **rows_of("_resisted", options=RESISTED), path=PATH)
# not at the larger sizes, unless they are named
MORE = dict(rows_of("_balanced", options=BALANCED),
            **rows_of("_far", options=RESISTED, strain=0.4), path_far=dict(PATH, strain=0.4))
TITLES = {"constant": "h constant", "density": "h from the density", "asph_resisted": "ASPH, hourglass",
          "constant_resisted": "h constant, hourglass", "path": "never searched again"}
STYLES = {"density": "--", "constant_resisted": "--", "path": "k:"}
BROKEN = 0.5                      # fracture: the force has fallen below this part of its largest value
LEFT = 0.95                       # the path is left: the force has fallen below this part of that on the path


def curve(result):
    """Strain, engineering stress (Pa), largest plastic strain; means over a strain of 0.002."""
    c = result.columns("curve.dat")
    width = max(1, int(round(len(c) * 0.002 / c[-1, 1])))
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


def flow(strain, speed=20.0):
    """Engineering stress (Pa) of a bar of C45E (Jaspers 1999) that stays even, its end pulled at speed (m/s): Johnson-Cook at
    the rate of the gauge, heated by its plastic work (card c45e), without elastic strain."""
    even, T = np.linspace(0, np.log1p(np.max(strain)), 2001), 0.0
    stress = (553.1e6 + 600.8e6 * even**0.234) * (1 + 0.0134 * np.log(speed / 0.05))
    for k in range(len(even)):
        stress[k] *= 1 - T / (1733 - 293.15)
        T += 0.9 * stress[k] * even[1] / (7870 * 486)
    return np.interp(np.log1p(strain), even, stress) / (1 + np.asarray(strain))


def main():
    sizes = {"small": {"rows": 10, "speed": 20}, "coarse": {"rows": 14, "speed": 20},
             "default": {"rows": 25, "speed": 20}, "large": {"rows": 50, "speed": 10}}
    study = Study(__file__, sizes, __doc__)
    table, curves, rows = {}, {}, dict(ROWS)
    if study.options.rows or study.options.size in ("small", "coarse"):
        rows.update(MORE)
    for row, variables in rows.items():
        if not study.wants(row):
            continue
        result = study.run(row, dict(study.size, **variables))
        curves[row] = strain, stress, most = curve(result)
        top, gone = fracture(strain, stress)
        table[row] = {"largest_stress": stress.max(), "strain_of_it": top, "fracture_strain": gone,
                      "last_stress": stress[-1], "largest_plastic_strain": most[-1], "processor": result.processor,
                      "wall": result.wall}
    for row in table:
        path = curves.get("path_far" if row.endswith("_far") else "path")
        if path:
            table[row]["leaves_path"] = leaves(*curves[row][:2], path)
            table[row]["of_path"] = {at: round(np.interp(at, *curves[row][:2]) / np.interp(at, *path[:2]), 4)
                                     for at in (0.1, 0.15, 0.198, 0.22, 0.25) if at <= curves[row][0][-1]}
    draw({row: c for row, c in curves.items() if row in TITLES}, curves, study)
    results = None
    if "asph_resisted" in curves and curves["asph_resisted"][0][-1] > 0.15:
        over = np.interp(0.15, *curves["asph_resisted"][:2]) / flow(0.15, study.size["speed"])
        results = {"flat_tensile_c45e.%d" % study.size["rows"]: {"asph_resisted": float(over)}}
    study.end({"rows": table}, results)


def draw(curves, every, study):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    from sphtm_scene import read_dump
    plt.rcParams.update({"font.size": 9})
    figure, axes = plt.subplots(1, 2, figsize=(9, 4.2), gridspec_kw={"width_ratios": [1, 1.2]})
    for row in curves:
        further = "path_far" if row == "path" else row.replace("_resisted", "_far")
        strain, stress, _ = every.get(further, every[row])
        axes[0].plot(strain, 1e-6 * stress, STYLES.get(row, "-"), lw=1, label=TITLES[row])
    axes[0].axvline(0.15, color="0.8", lw=1, zorder=0)
    axes[0].set(xlabel="strain", ylabel="engineering stress (MPa)", ylim=(0, 1250))
    axes[0].legend(frameon=False, loc="upper right", ncol=2, fontsize=8)
    for k, row in enumerate(curves):
        frame = read_dump(os.path.join(study.path(row), "end.dump"))[-1]
        dots = axes[1].scatter(1e3 * frame["x"], 1e3 * frame["y"] - 28 * k, c=frame["c_p[1]"],
                               s=0.6 * (25 / int(study.size["rows"]))**2, cmap="inferno", vmin=0,
                               vmax=0.4, lw=0)
        axes[1].text(-10, -28 * k + 12.5, "%s, strain %.2f" % (TITLES[row], curves[row][0][-1]),
                     fontsize=8)
    axes[1].set(aspect="equal", title="plastic strain", xticks=[], yticks=[])
    figure.colorbar(dots, ax=axes[1])
    figure.tight_layout()
    figure.savefig(study.path("flat_tensile_c45e.png"), dpi=150)


if __name__ == "__main__":
    main()
