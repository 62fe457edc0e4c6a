#!/usr/bin/python3
"""Force, radius and the plastic strain in the neck: plot.py [folder [particles over the radius]]"""
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from measure import END_FORCE, finite_elements, measure
from sphtm_scene import read_dump

folder = sys.argv[1] if len(sys.argv) > 1 else "."
n = float(sys.argv[2]) if len(sys.argv) > 2 else 6
m = measure(folder, n)
end = read_dump(folder + "/end.dump")[-1]

plt.rcParams.update({"font.size": 9})
figure, (left, right) = plt.subplots(1, 2, figsize=(8.4, 3.3), gridspec_kw={"width_ratios": [1, 1.25]})
elements = finite_elements()
left.plot([6.6, 7.5, 7.5, 6.6, 6.6], 1e-6 * np.take(END_FORCE, [0, 0, 1, 1, 0]), "-", color="tab:green", lw=1,
          label="known at the end")
left.plot(1e3 * elements[0], 1e-6 * elements[1], "--", color="tab:orange", lw=1.5, label="finite elements")
left.plot(1e3 * m["moved"], 1e-6 * m["force of moved"], "k-", lw=1, label="here")
left.set(xlabel="moved (mm)", ylabel="force (MN)", xlim=(0, 7.6), ylim=(0, 3.4))
left.legend(frameon=False, loc="lower right")

cut = np.abs(end["z"]) < 0.05 / n
order = np.argsort(end["c_p[2]"][cut])
dots = right.scatter(1e3 * end["x"][cut][order], 1e3 * end["y"][cut][order], c=end["c_p[2]"][cut][order], s=36,
                     cmap="inferno", vmin=0, marker="o", linewidths=0)
middle = 1e3 * 0.5 * (end["x"].min() + end["x"].max())
for sign in (-1, 1):
    right.plot([middle - 12, middle + 12], [sign * 1e3 * m["radius"]] * 2, "-", color="tab:green", lw=1.5)
right.set(xlabel="x (mm)", ylabel="y (mm)", title="plastic strain; least radius %.2f mm" % (1e3 * m["radius"]),
          aspect="equal")
figure.colorbar(dots, ax=right, shrink=0.9)
figure.tight_layout()
figure.savefig("tensile_cylinder.png", dpi=150)
