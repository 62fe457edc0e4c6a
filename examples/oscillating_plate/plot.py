#!/usr/bin/python3
"""Swing of the tip and its period: plot.py [folder]; makes oscillating_plate.png"""
import os
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "unittest", "scenes"))
from sphtm_scene import read_dump

FACES = 0.2621    # s, linear finite elements, faces of the base held


def zeros(time, height):
    """Times at which the tip passes the middle."""
    k = np.nonzero(height[1:] * height[:-1] < 0)[0]
    return time[k] + height[k] * (time[k + 1] - time[k]) / (height[k] - height[k + 1])


folder = sys.argv[1] if len(sys.argv) > 1 else "."
tip = np.loadtxt(folder + "/tip.dat")
time, height = tip[:, 1], tip[:, 2] - tip[0, 2]
zero = zeros(time, height)
period = zero[1] if len(zero) > 1 else 2 * zero[0]
print("period %.4f s, finite elements %.4f s (%+.1f %%)" % (period, FACES, 100 * (period / FACES - 1)))

plt.rcParams.update({"font.size": 9})
figure, (top, low) = plt.subplots(2, 1, figsize=(6.4, 4.2), gridspec_kw={"height_ratios": [1.6, 1]})
top.plot(time, 1e3 * height, "k-", lw=1.2, label="here, period %.4f s" % period)
top.plot(time, 1e3 * height.max() * np.sin(2 * np.pi * time / FACES), "--", color="tab:orange", lw=1,
         label="finite elements, %.4f s" % FACES)
top.set(xlabel="time (s)", ylabel="height of the tip (mm)", xlim=(0, time[-1]))
top.legend(frameon=False, loc="lower left")
end = read_dump(folder + "/end.dump")[-1]
dots = low.scatter(1e3 * end["x"], 1e3 * end["y"], c=1e3 * np.hypot(end["vx"], end["vy"]), s=5, cmap="viridis",
                   linewidths=0)
low.set(xlabel="x (mm)", ylabel="y (mm)", aspect="equal", title="speed at the end (mm/s)")
figure.colorbar(dots, ax=low, shrink=0.8)
figure.tight_layout()
figure.savefig("oscillating_plate.png", dpi=150)
