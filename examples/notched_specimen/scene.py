#!/usr/bin/python3
"""The notched specimen, uniform and refined, against finite elements along the ligament.

./sphtm scenes notched_specimen"""
import os
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "bench"))
from study import Study                                                                # noqa: E402
from sphtm_scene import read_dump                                                      # noqa: E402

LIGAMENT = 7.4e-3                 # its width, m
# S13: edge of the square 0.5 of the spacing; the keyword takes smoothing lengths, 1.2 spacings
REFINE = "refine square epsilon 0.41667 alpha %s velocity linear when v_high above 0.1 and region circle every 20"
NARROW, WIDE = "0.5", "1.0"    # alpha
ROOT = 0.6e-3                     # nearer to the notch than this the steps of the lattice count


def finite_elements():
    return np.loadtxt(os.path.join(HERE, "ligament.csv"), delimiter=",")


def profile(result, columns):
    """Distance from the axis and von Mises stress of the particles along the ligament, over the mean axial stress
    there."""
    frame = read_dump(result.path("end.dump"))[-1]
    force = result.columns("force.dat")
    nominal = force[force[:, 1] > force[-1, 1] - 2e-6][:, 2].mean() / LIGAMENT
    near = np.abs(frame["y"]) < 10e-3 / columns
    x, s = np.abs(frame["x"][near]), frame["c_p[1]"][near] / nominal
    order = np.argsort(x)
    return x[order], s[order], nominal, frame


def errors(x, s):
    """Largest difference from finite elements over the largest value: away from the notch, and all the way to it."""
    fe = finite_elements()
    off = np.abs(s - np.interp(x, fe[:, 0], fe[:, 1])) / fe[:, 1].max()
    inner = x < fe[-1, 0] - ROOT
    return off[inner].max(), np.sqrt((off[inner]**2).mean()), off.max()


def smooth(x, s, at, width):
    """Means of a profile over windows around the given places: to compare profiles of unlike spacings."""
    return np.array([s[np.abs(x - a) < 0.5 * width].mean() for a in at])


def main():
    sizes = {"small": {"fine": 44, "coarse": 23}, "default": {"fine": 86, "coarse": 45},
             "large": {"fine": 344, "coarse": 173}}
    study = Study(__file__, sizes, __doc__)
    fine, coarse = study.size["fine"], study.size["coarse"]
    rows = {"uniform_fine": (fine, None), "uniform_coarse": (coarse, None),
            "refined": (coarse, REFINE % NARROW), "refined_wide": (coarse, REFINE % WIDE)}
    table, profiles = {}, {}
    for row, (columns, adapt) in rows.items():
        if not study.wants(row):
            continue
        result = study.run(row, {"columns": columns, "adapt": adapt}, repeats=study.options.repeats)
        x, s, nominal, frame = profiles[row] = profile(result, columns)
        inner, rms, whole = errors(x, s)
        table[row] = {"particles_start": int(result.thermo[-1]["Atoms"][0]), "particles_end": len(frame["x"]),
                      "error_inner": inner, "error_inner_rms": rms, "error_whole": whole,
                      "mean_stress_over_E_strain": nominal / (205e9 * 1e-5), "processor": result.processor,
                      "wall": result.wall}
    if "uniform_fine" in profiles:
        at = np.linspace(0.3e-3, 3.1e-3, 15)
        reference = smooth(*profiles["uniform_fine"][:2], at, 20e-3 / coarse)
        for row in set(profiles) - {"uniform_fine"}:
            off = smooth(*profiles[row][:2], at, 20e-3 / coarse) - reference
            table[row]["off_uniform_fine"] = np.abs(off / reference).max()
            table[row]["speed_up"] = table["uniform_fine"]["processor"] / table[row]["processor"]
    draw(profiles, study.path("notched_specimen.png"))
    study.end({"rows": table})


def draw(profiles, path):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    plt.rcParams.update({"font.size": 9})
    figure, (left, right) = plt.subplots(1, 2, figsize=(9, 3.6), gridspec_kw={"width_ratios": [1.3, 1]})
    fe = finite_elements()
    left.plot(1e3 * fe[:, 0], fe[:, 1], "k-", lw=1, label="finite elements")
    for mark, (row, (x, s, _, frame)) in zip("os^v", profiles.items()):
        left.plot(1e3 * x, s, mark, ms=3, label="%s, %d particles" % (row.replace("_", " "), len(frame["x"])))
    left.set(xlabel="distance from the axis (mm)", ylabel="von Mises / mean axial stress")
    left.legend(frameon=False)
    row = "refined" if "refined" in profiles else list(profiles)[-1]
    frame = profiles[row][3]
    dots = right.scatter(1e3 * frame["x"], 1e3 * frame["y"], c=frame["c_p[1]"] / profiles[row][2], s=1.5, lw=0,
                         cmap="viridis")
    right.set(aspect="equal", title=row.replace("_", " "), xlabel="x (mm)", ylabel="y (mm)")
    figure.colorbar(dots, ax=right, label="von Mises / mean axial stress")
    figure.tight_layout()
    figure.savefig(path, dpi=150)


if __name__ == "__main__":
    main()
