#!/usr/bin/python3
"""Pictures of the steps of the tutorial whose files are in this folder: bar.png, cut.png, heat.png, mill.png, study.png"""
import csv
import os
import struct

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt                                                        # noqa: E402
import numpy as np                                                                     # noqa: E402
from matplotlib.collections import EllipseCollection, PolyCollection                   # noqa: E402

HERE = os.path.dirname(os.path.abspath(__file__))


def read_dump(path):
    """Columns of the last frame of a dump, by name."""
    with open(path) as f:
        text = f.read()
    lines = text[text.rindex("ITEM: TIMESTEP"):].splitlines()
    return dict(zip(lines[8].split()[2:], np.array([row.split() for row in lines[9:]], float).T))


def section(path):
    """Triangles of the upper end of a mesh that is extruded along z."""
    with open(path, "rb") as f:
        data = f.read()
    t = np.frombuffer(data[84:], np.dtype([("v", "<f4", (4, 3)), ("a", "<u2")]), struct.unpack("<I", data[80:84])[0])["v"][:, 1:]
    return t[(t[..., 2] == t[..., 2].max()).all(1)][..., :2].astype(float)


def tool(ax, triangles):
    ax.add_collection(PolyCollection(triangles, facecolors="#c9ced6", edgecolors="#c9ced6", linewidths=0.5, zorder=0))


def particles(ax, atoms, key, dx, low, high, label, cmap="inferno"):
    """Discs of diameter dx (mm), colored."""
    c = EllipseCollection([dx], [dx], [0], units="xy", offsets=1e3 * np.c_[atoms["x"], atoms["y"]], transOffset=ax.transData,
                          array=atoms[key], cmap=cmap)
    c.set_clim(low, high)
    ax.add_collection(c)
    ax.set(aspect="equal", xlabel="x (mm)", ylabel="y (mm)")
    ax.figure.colorbar(c, ax=ax, label=label, extend="max", shrink=0.85)


def figure(title, ratios=(1.4, 1)):
    fig, axes = plt.subplots(1, 2, figsize=(11, 3.9), constrained_layout=True, gridspec_kw={"width_ratios": ratios})
    axes[0].set_title(title, fontsize=11)
    axes[1].spines[["top", "right"]].set_visible(False)
    return fig, axes


def bar():
    fig, (left, right) = figure("the bar at a strain of 0.1")
    particles(left, read_dump("bar.dump"), "c_p[2]", 0.43, 0, 0.16, "equivalent plastic strain", "viridis")
    left.set(xlim=(-1, 28), ylim=(-2, 6))
    t = np.loadtxt("stress.dat")
    right.plot(t[:, 1], 1e-6 * t[:, 2], lw=2)
    right.set(xlabel="strain", ylabel="nominal stress (MPa)", xlim=(0, 0.1), ylim=(0, 560))
    fig.savefig("bar.png", dpi=90)


def cut():
    fig, (left, right) = figure("0.4 mm of cut")
    tool(left, section(os.path.join(HERE, "insert.stl")) + [0.801 - 0.4, -0.1])
    particles(left, read_dump("cut.dump"), "c_p[2]", 0.0135, 0, 3, "equivalent plastic strain", "viridis")
    left.set(xlim=(0, 0.82), ylim=(-0.32, 0.32))
    t = np.loadtxt("force.dat")
    for column, name in ((2, "cutting force"), (3, "thrust")):
        right.plot(1e3 * t[:, 1], 1e-3 * t[:, column], lw=1.5, label=name)
    right.set(xlabel="length of cut (mm)", ylabel="force per width (N/mm)", xlim=(0, 0.4), ylim=(0, None))
    right.legend(frameon=False)
    fig.savefig("cut.png", dpi=90)


def heat():
    fig, (left, right) = figure("temperature of work piece and tool")
    tool(left, section(os.path.join(HERE, "insert.stl")) + [0.801 - 0.4, -0.1])
    particles(left, read_dump("heat.dump"), "c_p[1]", 0.0135, 293, 700, "temperature (K)")
    left.set(xlim=(0, 0.82), ylim=(-0.32, 0.32))
    t = np.loadtxt("heat.dat")
    for column, name in ((4, "hottest particle of the work piece"), (5, "hottest particle of the tool")):
        right.plot(1e3 * t[:, 1], t[:, column], lw=1.5, label=name)
    right.set(xlabel="length of cut (mm)", ylabel="temperature (K)", xlim=(0, 0.4))
    right.legend(frameon=False)
    fig.savefig("heat.png", dpi=90)


def mill():
    t = np.loadtxt("mill.dat")
    fig, (left, right) = figure("chip of one tooth; the cutter turns clockwise, with its feed to the right")
    turned = np.radians(-32 - (58 - t[-1, 1]))
    fed = 0.16 * (58 - t[-1, 1]) / 120
    c, s = np.cos(turned), np.sin(turned)
    tool(left, section(os.path.join(HERE, "cutter.stl")) @ np.array([[c, s], [-s, c]]) + [fed, 1.0])
    particles(left, read_dump("mill.dump"), "c_p[1]", 0.0215, 293, 600, "temperature (K)")
    left.set(xlim=(-1.1, 1.4), ylim=(-0.35, 1.0))
    for column, name in ((2, "along the feed"), (3, "out of the milled surface")):
        right.plot(t[:, 1], 1e-3 * t[:, column], lw=1.5, label=name)
    right.set(xlabel="angle of the edge above the bottom (degrees)", ylabel="force on the cutter per depth (N/mm)", xlim=(58, -8))
    right.legend(frameon=False)
    fig.savefig("mill.png", dpi=90)


def study():
    with open("study.csv") as f:
        rows = list(csv.reader(f))
    t = np.array(rows[1:], float)
    fig, ax = plt.subplots(figsize=(5.5, 3.6), constrained_layout=True)
    for column, name in ((1, "cutting force"), (2, "thrust")):
        ax.plot(t[:, 0], t[:, column], "o-", label=name)
    ax.set(xlabel="coefficient of friction", ylabel="mean force per width (N/mm)", ylim=(0, None))
    ax.legend(frameon=False)
    ax.spines[["top", "right"]].set_visible(False)
    fig.savefig("study.png", dpi=90)


if __name__ == "__main__":
    for name, draw in (("bar.dump", bar), ("cut.dump", cut), ("heat.dump", heat), ("mill.dump", mill), ("study.csv", study)):
        if os.path.exists(name):
            draw()
