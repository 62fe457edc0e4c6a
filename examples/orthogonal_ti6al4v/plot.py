#!/usr/bin/python3
"""Draws the end of in.orthogonal_ti6al4v, run in this folder with its own settings, and the forces beside the measured ones:
orthogonal_ti6al4v.png. An argument is the folder of another run of 60 um at 30 m/min with 5 um."""
import os
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt                                                        # noqa: E402
import numpy as np                                                                     # noqa: E402
from matplotlib.collections import EllipseCollection                                   # noqa: E402

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "..", "unittest", "scenes"), os.path.join(HERE, "..", "high_speed_machining")]
from measure import hull, read_stl                                                         # noqa: E402
from pictures import FLOW, TOOL_FACE, TOOL_LINE, WARM                                  # noqa: E402
from sphtm_scene import read_dump                                                      # noqa: E402

CHIP, DX, LENGTH = 60.0, 5.0, 10.0                                                     # um, um, uncut chip thicknesses
MEASURED = {"cutting force": (118.2, 20.3), "feed force": (50.3, 9.1)}                 # N/mm, two standard deviations

folder = sys.argv[1] if len(sys.argv) > 1 else "."
frame, force = read_dump(os.path.join(folder, "cut.dump"))[-1], np.loadtxt(os.path.join(folder, "force.dat"))
way = 1e6 * force[:, 1]
tip = DX * np.ceil((LENGTH + 3) * CHIP / DX) + 0.1 - np.interp(frame["step"], force[:, 0], way)
profile = 1e3 * np.array(hull(read_stl(os.path.join(HERE, "insert.stl"))[:, :, :2].reshape(-1, 2))) + [tip, -CHIP]

fig, axes = plt.subplots(1, 3, figsize=(15, 4.6), constrained_layout=True, gridspec_kw={"width_ratios": [1, 1, 0.9]})
for ax, key, cmap, lo, hi, label in ((axes[0], "c_p[1]", WARM, 293, 1000, "temperature (K)"),
                                     (axes[1], "c_p[2]", FLOW, 0, 2.5, "equivalent plastic strain")):
    xy = 1e6 * np.stack([frame["x"], frame["y"]], axis=1)
    dots = EllipseCollection(1.15 * DX, 1.15 * DX, 0, units="xy", offsets=xy, transOffset=ax.transData, array=frame[key], cmap=cmap,
                             linewidths=0)
    dots.set_clim(lo, hi)
    ax.fill(profile[:, 0], profile[:, 1], fc=TOOL_FACE, ec=TOOL_LINE, lw=1.2, zorder=0)
    ax.add_collection(dots)
    ax.set(aspect="equal", xlim=(tip - 320, tip + 220), ylim=(-200, 330), xlabel="x (um)", ylabel="y (um)")
    fig.colorbar(dots, ax=ax, shrink=0.8, label=label, extend="max")
for k, (name, (value, scatter)) in enumerate(MEASURED.items()):
    smooth = np.convolve(force[:, 2 + k], np.ones(31) / 31, "same")
    line, = axes[2].plot(way, force[:, 2 + k], lw=0.5, alpha=0.3)
    axes[2].plot(way[15:-15], smooth[15:-15], lw=2, color=line.get_color(),
                 label="%s, mean %.0f N/mm" % (name, force[way > 0.5 * way[-1], 2 + k].mean()))
    axes[2].axhspan(value - scatter, value + scatter, color=line.get_color(), alpha=0.15, lw=0, label="measured, two standard deviations")
axes[2].set(xlabel="length of cut (um)", ylabel="force on the tool per width (N/mm)", xlim=(0, None), ylim=(0, None))
axes[2].legend(frameon=False, fontsize=8)
axes[2].spines[["top", "right"]].set_visible(False)
fig.savefig(os.path.join(HERE, "orthogonal_ti6al4v.png"), dpi=90)
