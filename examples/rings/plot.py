#!/usr/bin/python3
"""The rings at six times, coloured by pressure: plot.py [folder]; makes rings.png"""
import os
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "unittest", "scenes"))
from sphtm_scene import read_dump, read_thermo

folder = sys.argv[1] if len(sys.argv) > 1 else "."
frames = read_dump(folder + "/rings.dump")[:6]
with open(folder + "/log.rings") as f:
    table = read_thermo(f.read())[-1]

plt.rcParams.update({"font.size": 8})
figure, axes = plt.subplots(2, 3, figsize=(8.4, 4.4), sharex=True, sharey=True, constrained_layout=True)
for axis, frame in zip(axes.flat, frames):
    time = frame["step"] * table["Time"][-1] / table["Step"][-1]
    dots = axis.scatter(1e3 * frame["x"], 1e3 * frame["y"], c=1e-6 * frame["c_p"], s=1.2, cmap="coolwarm", vmin=-0.8,
                        vmax=0.8, linewidths=0)
    axis.set(aspect="equal", title="%.1f ms" % (1e3 * time), xlim=(-95, 95), ylim=(-62, 62))
for axis in axes[1]:
    axis.set_xlabel("x (mm)")
for axis in axes[:, 0]:
    axis.set_ylabel("y (mm)")
figure.colorbar(dots, ax=axes, label="pressure (MPa)", shrink=0.8)
figure.savefig("rings.png", dpi=130)
