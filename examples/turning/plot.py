#!/usr/bin/python3
"""Draws the end of in.turning, run in this folder, and its forces over the turn beside those of in.orthogonal: turning.png"""
import os
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt                                                        # noqa: E402
import numpy as np                                                                     # noqa: E402
from matplotlib.collections import PolyCollection                                      # noqa: E402

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "high_speed_machining"))
from measure import read_stl                                                           # noqa: E402
from pictures import WARM                                                              # noqa: E402

FEED, DEPTH, INNER, DX = 0.32, 0.56, 1.84, 0.08    # mm, of in.turning


def frame(path):
    with open(path) as f:
        lines = f.read().splitlines()
    return dict(zip(lines[8].split()[2:], np.array([row.split() for row in lines[9:]], float).T))


def tool(turned):
    """Triangles of the insert after so many turns, mm."""
    t = read_stl(os.path.join(HERE, "insert.stl")).reshape(-1, 3, 3) + [0.1, -FEED * (1 + turned), INNER + 0.5 * DX + 0.52]
    c, s = np.cos(2 * np.pi * turned), np.sin(2 * np.pi * turned)
    return np.stack([c * t[..., 0] - s * t[..., 2], t[..., 1], s * t[..., 0] + c * t[..., 2]], axis=-1)


def solid(ax, atoms, turned, color, view):
    """From back to front; returns the last dots."""
    view = np.array(view) / np.linalg.norm(view)
    right = np.cross([0.0, 1.0, 0.0], view)
    right /= np.linalg.norm(right)
    up = np.cross(view, right)
    p = 1e3 * np.stack([atoms[k] for k in "xyz"], axis=1)
    order = np.argsort(p @ view)
    colors = color(atoms)[order]
    scale = {"cmap": WARM, "vmin": 293, "vmax": 700} if colors.ndim == 1 else {}
    dots = ax.scatter((p @ right)[order], (p @ up)[order], c=colors, s=3.2, linewidths=0, **scale)
    t = tool(turned)
    n = np.cross(t[:, 1] - t[:, 0], t[:, 2] - t[:, 0])
    seen = n @ view > 0
    ax.add_collection(PolyCollection(np.stack([t[seen] @ right, t[seen] @ up], axis=-1), facecolors="#9aa1a9", alpha=0.75,
                                     edgecolors="#4a4f55", linewidths=0.4))
    ax.set(aspect="equal", xticks=[], yticks=[])
    ax.axis("off")
    return dots


def main():
    atoms = frame("end.dump")
    t = np.loadtxt("force.dat")
    turned, cutting, along, outward = t[:, 1:].T
    with open("log.lammps") as f:
        end = float([l for l in f if l.startswith("turned ")][-1].split()[1])
    eye = 2 * np.pi * (end - 0.06)
    view = [-np.sin(eye), 0.9, np.cos(eye)]
    fig, axes = plt.subplots(1, 3, figsize=(16, 5.2), constrained_layout=True, gridspec_kw={"width_ratios": [1, 1, 1]})
    dots = solid(axes[0], atoms, end, lambda a: a["c_p[1]"], view)
    fig.colorbar(dots, ax=axes[0], shrink=0.7, label="temperature (K)", extend="max")
    kind = np.array([[0.80, 0.83, 0.87], [0.25, 0.45, 0.70], [0.93, 0.55, 0.20]])
    solid(axes[1], atoms, end, lambda a: kind[a["c_p[3]"].astype(int)], view)
    axes[1].set_title("orange: active, blue: at the edge, gray: asleep", fontsize=11)
    straight = np.loadtxt("orthogonal.dat")
    late = straight[:, 1] > 1.5e-3
    model = straight[late][:, 2:].mean(axis=0) * 1e-3 * DEPTH
    steady = turned > 0.12
    for f, name, color in ((cutting, "cutting force", "C0"), (along, "feed force", "C1"), (outward, "passive force", "C2")):
        smooth = np.convolve(f, np.ones(9) / 9, "same")
        axes[2].plot(turned[4:-4], smooth[4:-4], color=color, label="%s, mean %.0f N" % (name, f[steady].mean()))
    for value, color in zip(model, ("C0", "C1")):
        axes[2].axhline(value, color=color, ls="--", lw=1)
    axes[2].set(xlabel="turns", ylabel="force on the tool (N)", xlim=(0, None), title="dashed: straight cut in plane strain")
    axes[2].legend(frameon=False)
    axes[2].spines[["top", "right"]].set_visible(False)
    fig.savefig("turning.png", dpi=80)
    print("straight cut: cutting force %.1f, thrust %.1f N/mm, times %.2f mm: %.1f, %.1f N" %
          (*(1e-3 * straight[late][:, 2:].mean(axis=0)), DEPTH, *model))
    print("turning, from 0.12 turns on: cutting %.1f, feed %.1f, passive %.1f N; over the straight cut %.3f, %.3f" %
          (cutting[steady].mean(), along[steady].mean(), outward[steady].mean(), cutting[steady].mean() / model[0],
           along[steady].mean() / model[1]))
    print("hottest %.0f K; share that is active %.3f, at the edge %.3f" %
          (atoms["c_p[1]"].max(), (atoms["c_p[3]"] == 2).mean(), (atoms["c_p[3]"] == 1).mean()))


if __name__ == "__main__":
    main()
