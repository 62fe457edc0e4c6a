#!/usr/bin/python3
"""Draws the end of in.ti6al4v_3d with an inclined edge (-var inclination 6): from above, from the side the 0.2 mm in the middle, and the
chip seen along the cut: ti6al4v_3d.png. An argument is the folder of the run."""
import os
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt                                                        # noqa: E402
import numpy as np                                                                     # noqa: E402

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "..", "unittest", "scenes"), os.path.join(HERE, "..", "high_speed_machining")]
from pictures import WARM                                                              # noqa: E402
from sphtm_scene import read_dump                                                      # noqa: E402

frame = read_dump(os.path.join(sys.argv[1] if len(sys.argv) > 1 else ".", "final.dump"))[-1]
T = frame["c_p[1]"]
x, y, z = (1e6 * frame[k] for k in ("x", "y", "z"))
middle = np.abs(z) < 100
fig, axes = plt.subplots(1, 3, figsize=(15, 5), constrained_layout=True)
for ax, a, b, depth, part, names, title in (
        (axes[0], x, z, y, y > -1e9, ("x (um)", "z (um)"), "from above"),
        (axes[1], x, y, -np.abs(z), middle, ("x (um)", "y (um)"), "the middle, from the side"),
        (axes[2], z, y, -x, y > -1e9, ("z (um)", "y (um)"), "against the cutting direction")):
    order = np.argsort(depth[part])      # what is nearer covers the rest
    dots = ax.scatter(a[part][order], b[part][order], c=T[part][order], s=3, cmap=WARM, vmin=293, vmax=1000, linewidths=0)
    ax.set(aspect="equal", xlabel=names[0], ylabel=names[1], title=title)
axes[0].set_ylim(-650, 650)
axes[1].set(xlim=(np.percentile(x, 1), np.percentile(x, 99)), ylim=(-230, 250))
axes[2].set(ylim=(-230, 250))
fig.colorbar(dots, ax=axes, shrink=0.7, label="temperature (K)", extend="max")
fig.savefig(os.path.join(HERE, "ti6al4v_3d.png"), dpi=80)
