#!/usr/bin/python3
"""Makes orthogonal_ti6al4v.gif of a run of in.orthogonal_ti6al4v: the chip by temperature, and the forces as they come, beside the measured
ones (60 um, 30 m/min). movie.py [folder [spacing in um [length in uncut chip thicknesses]]]"""
import os
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt                                                        # noqa: E402
import numpy as np                                                                     # noqa: E402
from matplotlib.animation import FuncAnimation, PillowWriter                           # noqa: E402
from matplotlib.collections import EllipseCollection                                   # noqa: E402

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "..", "unittest", "scenes"), os.path.join(HERE, "..", "high_speed_machining")]
from measure import hull, read_stl                                                     # noqa: E402
from pictures import TOOL_FACE, TOOL_LINE, WARM                                        # noqa: E402
from sphtm_scene import read_dump                                                      # noqa: E402

CHIP, SMOOTH = 60.0, 31                                                                # um, samples of a mean
MEASURED = {"cutting force": (118.2, 20.3), "feed force": (50.3, 9.1)}                 # N/mm, two standard deviations


def main(folder=".", spacing="5", length="10"):
    dx, length = float(spacing), float(length)
    frames, force = read_dump(os.path.join(folder, "cut.dump")), np.loadtxt(os.path.join(folder, "force.dat"))
    way, start = 1e6 * force[:, 1], dx * np.ceil(round((length + 3) * CHIP / dx, 6)) + 0.1
    profile = 1e3 * np.array(hull(read_stl(os.path.join(HERE, "insert.stl"))[:, :, :2].reshape(-1, 2)))
    figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.4), constrained_layout=True)
    dots = EllipseCollection(1.15 * dx, 1.15 * dx, 0, units="xy", offsets=np.zeros((1, 2)), transOffset=left.transData, cmap=WARM, linewidths=0)
    dots.set_clim(293, 1000)
    tool, = left.fill(profile[:, 0], profile[:, 1], fc=TOOL_FACE, ec=TOOL_LINE, lw=1.2, zorder=0)
    left.add_collection(dots)
    left.set(aspect="equal", ylim=(-150, 250), xlabel="x (um)", ylabel="y (um)")
    figure.colorbar(dots, ax=left, shrink=0.8, label="temperature (K)", extend="max")
    lines = []
    for k, (name, (value, scatter)) in enumerate(MEASURED.items()):
        line, = right.plot([], [], lw=2, label=name)
        right.axhspan(value - scatter, value + scatter, color=line.get_color(), alpha=0.15, lw=0, label="measured")
        lines.append((line, np.convolve(force[:, 2 + k], np.ones(SMOOTH) / SMOOTH, "same")))
    right.set(xlabel="length of cut (um)", ylabel="force per width (N/mm)", xlim=(0, way[-1]), ylim=(0, 150))
    right.legend(frameon=False, fontsize=8, loc="lower right")
    right.spines[["top", "right"]].set_visible(False)

    def draw(frame):
        gone = np.interp(frame["step"], force[:, 0], way)
        tip = start - gone
        dots.set_offsets(1e6 * np.stack([frame["x"], frame["y"]], axis=1))
        dots.set_array(frame["c_p[1]"])
        tool.set_xy(profile + [tip, -CHIP])
        left.set_xlim(tip - 280, tip + 170)
        for line, smooth in lines:
            on = way <= gone
            line.set_data(way[on], smooth[on])

    FuncAnimation(figure, draw, frames=frames).save(os.path.join(HERE, "orthogonal_ti6al4v.gif"), PillowWriter(fps=8), dpi=75)


if __name__ == "__main__":
    main(*sys.argv[1:])
