#!/usr/bin/python3
"""Draws the end of in.friction_stir, run in this folder, and its force, torque and temperatures over time: friction_stir.png"""
import os
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt                                                        # noqa: E402
import numpy as np                                                                     # noqa: E402
from matplotlib.collections import EllipseCollection                                   # noqa: E402

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "high_speed_machining"))
from pictures import FLOW, TOOL_FACE, TOOL_LINE, WARM                                  # noqa: E402

DX = 0.8    # mm
SCALE = 120    # run over process
SHOULDER, ROOT, TIP, PROBE = 4.5, 2.5, 2.0, 2.4    # radii and length of the tool, mm


def frame(path):
    with open(path) as f:
        lines = f.read().splitlines()
    return dict(zip(lines[8].split()[2:], np.array([row.split() for row in lines[9:]], float).T))


def draw(ax, atoms, keep, across, up, key, cmap, low, high, label):
    xy = 1e3 * np.stack([atoms[across][keep], atoms[up][keep]], axis=1)
    c = EllipseCollection(1.05 * DX, 1.05 * DX, 0, units="xy", offsets=xy, transOffset=ax.transData, array=atoms[key][keep],
                          cmap=cmap, edgecolors=(0, 0, 0, 0.4), linewidths=0.3)
    c.set_clim(low, high)
    ax.add_collection(c)
    ax.set(aspect="equal", xlabel=across + " (mm)", ylabel=up + " (mm)")
    ax.figure.colorbar(c, ax=ax, shrink=0.85, label=label, extend="max")


def main():
    atoms = frame("end.dump")
    t = np.loadtxt("force.dat")
    time, deep, force, torque, hot, tool, power = t[:, 1:].T
    fig, axes = plt.subplots(2, 2, figsize=(14, 7.6), constrained_layout=True, gridspec_kw={"width_ratios": [1.35, 1]})
    section = np.abs(atoms["y"]) < 0.6e-3 * DX
    tip = -deep[-1]
    shape = np.array([(-SHOULDER, PROBE + 3), (-SHOULDER, PROBE), (-ROOT, PROBE), (-TIP, 0), (TIP, 0), (ROOT, PROBE),
                      (SHOULDER, PROBE), (SHOULDER, PROBE + 3)]) + [0, tip]
    for ax, key, cmap, low, high, label in ((axes[0, 0], "c_p[1]", WARM, 293, 800, "temperature (K)"),
                                            (axes[1, 0], "c_p[2]", FLOW, 0, 5, "equivalent plastic strain")):
        ax.fill(*shape.T, fc=TOOL_FACE, ec=TOOL_LINE, lw=1.2, zorder=0)
        draw(ax, atoms, section, "x", "z", key, cmap, low, high, label)
        ax.set(xlim=(-9.5, 9.5), ylim=(-6, 3.5))
    axes[0, 1].plot(time, -1e-3 * force if force.mean() < 0 else 1e-3 * force, label="axial force (kN)")
    axes[0, 1].plot(time, np.abs(torque), label="torque (N m)")
    axes[0, 1].set(xlabel="time of the process (s)", ylim=(0, None))
    axes[1, 1].plot(time, hot - 273.15, label="hottest particle")
    axes[1, 1].plot(time, tool - 273.15, label="tool")
    axes[1, 1].axhline(855 - 273.15, color="0.6", ls=":", label="melting temperature of the material")
    axes[1, 1].set(xlabel="time of the process (s)", ylabel="temperature (C)")
    for ax in axes[:, 1]:
        ax.set_xlim(0, None)
        ax.legend(frameon=False)
        ax.spines[["top", "right"]].set_visible(False)
    fig.savefig("friction_stir.png", dpi=80)
    for d in (0.3, 0.6, 1.0, 1.4, deep[-1] - 0.06):
        k = np.abs(deep - d) < 0.06
        print("depth %.2f mm, %.2f s: force %.2f kN, torque %.1f N m, hottest %.0f C, tool %.0f C, friction %.0f W" %
              (d, time[k].mean(), 1e-3 * abs(force[k].mean()), abs(torque[k].mean()), hot[k].mean() - 273.15,
               tool[k].mean() - 273.15, power[k].mean() / SCALE))


if __name__ == "__main__":
    main()
