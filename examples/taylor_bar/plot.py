#!/usr/bin/python3
"""The bar after the impact, coloured by plastic strain: plot.py [folder]; makes taylor_bar.png"""
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from measure import read_dump, shape

folder = sys.argv[1] if len(sys.argv) > 1 else "."
dx = float(open(folder + "/spacing").read())
end = read_dump(folder + "/end.dump")[-1]
length, radius, _, _ = shape(end, dx)
bottom = end["z"].min() - dx / 2

plt.rcParams.update({"font.size": 9})
figure, (side, foot) = plt.subplots(1, 2, figsize=(8.4, 4.6), gridspec_kw={"width_ratios": [1, 1.25]},
                                    constrained_layout=True)
r, strain = np.hypot(end["x"], end["y"]), end["c_p[1]"]
half = np.concatenate([r, -r])
side.scatter(1e3 * half, 1e3 * (np.tile(end["z"], 2) - bottom), c=np.tile(strain, 2), s=3, cmap="inferno", vmin=0,
             vmax=3, linewidths=0)
side.plot([7.36, 7.36], [-0.5, 2.5], "-", color="tab:green", lw=1.2)
side.plot([-7.36, -7.36], [-0.5, 2.5], "-", color="tab:green", lw=1.2)
side.plot([-4, 4], [21.48, 21.48], "-", color="tab:green", lw=1.2)
side.set(xlabel="radius (mm)", ylabel="height (mm)", aspect="equal", xlim=(-9, 9), ylim=(-0.5, 23),
         title="length %.2f mm, radius %.2f mm" % (1e3 * length, 1e3 * radius))
low = end["z"] - bottom < 2.5 * dx
dots = foot.scatter(1e3 * end["x"][low], 1e3 * end["y"][low], c=strain[low], s=10, cmap="inferno", vmin=0, vmax=3,
                    linewidths=0)
turn = np.linspace(0, 2 * np.pi, 200)
foot.plot(7.36 * np.cos(turn), 7.36 * np.sin(turn), "-", color="tab:green", lw=1.2, label="finite elements")
foot.set(xlabel="x (mm)", ylabel="y (mm)", aspect="equal", xlim=(-9, 9), ylim=(-9, 9), title="the foot from below")
foot.legend(frameon=False, loc="upper right")
figure.colorbar(dots, ax=foot, label="plastic strain", shrink=0.8)
figure.savefig("taylor_bar.png", dpi=130)
