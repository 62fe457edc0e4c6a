#!/usr/bin/python3
"""Draws the last frame and the forces of in.orthogonal_cut_2d, run in this folder: orthogonal_cut_2d.png"""
import glob
import os
import re
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt                                                        # noqa: E402
import numpy as np                                                                     # noqa: E402
from matplotlib.collections import EllipseCollection                                   # noqa: E402

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "high_speed_machining"))
from measure import hull, read_stl                                                         # noqa: E402
from pictures import FLOW, TOOL_FACE, TOOL_LINE, WARM                                  # noqa: E402

number = lambda path: int(re.findall(r"(\d+)\.", path)[-1])
last = max(glob.glob("cut.*.dump"), key=number)
with open(last) as f:
    lines = f.read().splitlines()
names = lines[8].split()[2:]
atoms = dict(zip(names, np.array([row.split() for row in lines[9:]], float).T))
with open("log.lammps") as f:                                          # steps and times of the thermo table
    clock = np.array(re.findall(r"^ +(\d+) +(\S+) +\S+e-\d\d ", f.read(), re.M), float)
seconds = lambda step: np.interp(step, clock[:, 0], clock[:, 1])
here = os.path.dirname(os.path.abspath(__file__))
profile = hull(read_stl(os.path.join(here, "insert.stl"))[:, :, :2].reshape(-1, 2))
profile += [1.201 - 8.33e3 * seconds(number(last)), -0.1]              # mm
dx = 20e-3                                                            # spacing in mm
force = np.loadtxt("force.dat")
time = 1e6 * seconds(force[:, 0])

fig, axes = plt.subplots(1, 3, figsize=(15, 4.6), constrained_layout=True, gridspec_kw={"width_ratios": [1, 1, 0.9]})
for ax, key, cmap, hi, label in ((axes[0], "c_p[1]", WARM, 1100, "temperature (K)"),
                                 (axes[1], "c_p[2]", FLOW, 2.5, "equivalent plastic strain")):
    xy = 1e3 * np.stack([atoms["x"], atoms["y"]], axis=1)
    c = EllipseCollection(1.1 * dx, 1.1 * dx, 0, units="xy", offsets=xy, transOffset=ax.transData, array=atoms[key],
                          cmap=cmap, edgecolors=(0, 0, 0, 0.4), linewidths=0.3)
    c.set_clim(300 if key == "c_p[1]" else 0, hi)
    ax.fill(profile[:, 0], profile[:, 1], fc=TOOL_FACE, ec=TOOL_LINE, lw=1.2, zorder=0)
    ax.add_collection(c)
    ax.set(aspect="equal", xlim=(-0.12, 1.22), ylim=(-0.42, 0.78), xlabel="x (mm)", ylabel="y (mm)")
    fig.colorbar(c, ax=ax, shrink=0.8, label=label, extend="max")
for k, name in ((1, "cutting force"), (2, "thrust")):
    smooth = np.convolve(force[:, k], np.ones(15) / 15, "same")
    line, = axes[2].plot(time, 1e-3 * force[:, k], lw=0.6, alpha=0.35)
    axes[2].plot(time[7:-7], 1e-3 * smooth[7:-7], lw=2, color=line.get_color(),
                 label="%s, mean %.0f N/mm" % (name, 1e-3 * force[time > 12, k].mean()))
axes[2].set(xlabel="time (us)", ylabel="force on the tool per width (N/mm)", xlim=(0, None))
axes[2].legend(frameon=False)
axes[2].spines[["top", "right"]].set_visible(False)
fig.savefig("orthogonal_cut_2d.png", dpi=90)
