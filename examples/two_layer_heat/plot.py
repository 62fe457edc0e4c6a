#!/usr/bin/python3
"""Profile of temperature.dump against the closed form: plot.py [ratio [time]] writes two_layer_heat.png"""
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from measure import exact

ratio = float(sys.argv[1]) if len(sys.argv) > 1 else 10.0
t = float(sys.argv[2]) if len(sys.argv) > 2 else 1e-3
x, T = np.loadtxt("temperature.dump", skiprows=9)[:, 1:3].T

s = np.linspace(x.min(), x.max(), 2001)

plt.rcParams.update({"font.size": 9})
figure, axes = plt.subplots(figsize=(5, 3.2))
axes.axvline(0, color="0.8", lw=1)
axes.plot(s, exact(s, ratio, t), "k-", lw=1, label="closed form")
axes.plot(x, T, "o", ms=3, mfc="none", mec="tab:red", label="%d particles" % len(x))
axes.set(xlabel="x (m)", ylabel="temperature (K)", xlim=(-0.15, 0.35),
         title="conductivity 1 | %g after %g s" % (ratio, t))
axes.legend(frameon=False, loc="lower right")
figure.tight_layout()
figure.savefig("two_layer_heat.png", dpi=150)
