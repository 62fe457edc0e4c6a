#!/usr/bin/python3
"""Force per tooth of in.peripheral_milling over the angle, beside the mechanistic model whose coefficients are those of
in.orthogonal (h = 0.04, 0.08, 0.14 mm), all run in this folder: a table, and peripheral_milling.png"""
import glob
import os
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt                                                        # noqa: E402
import numpy as np                                                                     # noqa: E402

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "tutorial"))
from plot import particles, read_dump, section, tool                                   # noqa: E402

RADIUS, SPEED, FEED, DEPTH, START = 1e-3, 50.0, 0.16e-3, 0.5e-3, 70.0    # of in.peripheral_milling; START: degrees
THICK = 0.04e-3, 0.08e-3, 0.14e-3
ENTRY = np.degrees(np.arccos(1 - DEPTH / RADIUS))
PERIOD = np.pi * RADIUS / SPEED
BINS = np.arange(0.0, ENTRY + 1, 4.0)


def orthogonal():
    """Chip thickness, mean cutting force and thrust (N/m) of each orthogonal cut, from 0.4 to 1.2 mm."""
    rows = []
    for h in THICK:
        t = np.loadtxt("orthogonal_%ge-3.dat" % (1e3 * h))
        use = t[:, 1] > 0.4e-3
        rows.append([h, t[use, 2].mean(), t[use, 3].mean()])
    return np.array(rows)


def teeth(path):
    """For each tooth: angle of its edge above the bottom (degrees), tangential and radial force (N/m)."""
    t = np.loadtxt(path)
    turned = np.degrees(SPEED / RADIUS * t[:, 1])
    out = []
    for k in range(int(np.ceil(t[-1, 1] / PERIOD))):
        phi = START + 180 * k - turned
        use = (phi > -40) & (phi < ENTRY + 8)
        if use.sum() < 10:
            continue
        p = np.radians(phi[use])
        fx, fy = t[use, 2], t[use, 3]
        out.append((phi[use], fx * np.cos(p) + fy * np.sin(p), fy * np.cos(p) - fx * np.sin(p)))
    return out


def binned(tooth, column):
    """Means in BINS of angle."""
    which = np.digitize(tooth[0], BINS)
    return np.array([tooth[column][which == k].mean() for k in range(1, len(BINS))])


def draw(all_teeth, model, cuts):
    fig, axes = plt.subplots(1, 3, figsize=(15, 4.4), constrained_layout=True, gridspec_kw={"width_ratios": [1.25, 1, 0.8]})
    frame = sorted(glob.glob("mill.*.dump"), key=lambda p: int(p.split(".")[-2]))
    step = lambda p: int(p.split(".")[-2])
    clock = np.loadtxt("force.dat")
    angle = lambda p: START + 180 - np.degrees(SPEED / RADIUS * np.interp(step(p), clock[:, 0], clock[:, 1]))
    chosen = min(frame, key=lambda p: abs(angle(p) - 25))    # of the second tooth
    time = np.interp(step(chosen), clock[:, 0], clock[:, 1])
    turn = np.radians(-20) - SPEED / RADIUS * time
    c, s = np.cos(turn), np.sin(turn)
    tool(axes[0], section(os.path.join(HERE, "cutter.stl")) @ np.array([[c, s], [-s, c]]) + [1e3 * FEED * time / PERIOD, 1.0])
    particles(axes[0], read_dump(chosen), "c_p[1]", 0.0215, 293, 600, "temperature (K)")
    axes[0].set(xlim=(-1.0, 1.9), ylim=(-0.45, 1.3), title="second tooth, %.0f degrees above the bottom" % angle(chosen))
    for k, tooth in enumerate(all_teeth):
        for column, color in ((1, "C0"), (2, "C1")):
            axes[1].plot(tooth[0], 1e-3 * tooth[column], color=color, lw=1, alpha=0.4 + 0.35 * k)
    phi = np.linspace(0, ENTRY, 60)
    for column, color, name in ((0, "C0", "tangential"), (1, "C1", "radial")):
        axes[1].plot(phi, 1e-3 * model(phi)[column], color=color, lw=2.5, ls="--", label=name + ", model")
    axes[1].set(xlabel="angle of the edge above the bottom (degrees)", ylabel="force per depth (N/mm)", xlim=(ENTRY + 8, -5))
    axes[1].legend(frameon=False, title="two teeth, and the model")
    h = np.array([0, 0.16])
    for column, color, name in ((1, "C0", "cutting force"), (2, "C1", "thrust")):
        axes[2].plot(1e3 * cuts[:, 0], 1e-3 * cuts[:, column], "o", color=color, label=name)
        axes[2].plot(h, 1e-3 * np.polyval(np.polyfit(cuts[:, 0], cuts[:, column], 1), 1e-3 * h), color=color)
    axes[2].set(xlabel="chip thickness (mm)", ylabel="force per width (N/mm)", title="orthogonal cuts", xlim=(0, 0.16), ylim=(0, None))
    axes[2].legend(frameon=False)
    for ax in axes[1:]:
        ax.spines[["top", "right"]].set_visible(False)
    fig.savefig("peripheral_milling.png", dpi=90)


def main():
    cuts = orthogonal()
    fits = [np.polyfit(cuts[:, 0], cuts[:, k], 1) for k in (1, 2)]
    for h, cutting, thrust in cuts:
        print("orthogonal, h = %.2f mm: cutting force %.1f, thrust %.1f N/mm" % (1e3 * h, 1e-3 * cutting, 1e-3 * thrust))
    print("tangential: %.0f N/mm^2 h + %.1f N/mm; radial: %.0f N/mm^2 h + %.1f N/mm" %
          (1e-6 * fits[0][0], 1e-3 * fits[0][1], 1e-6 * fits[1][0], 1e-3 * fits[1][1]))
    model = lambda phi: [np.polyval(f, FEED * np.sin(np.radians(phi))) for f in fits]
    middle = 0.5 * (BINS[1:] + BINS[:-1])
    expected = model(middle)
    all_teeth = teeth("force.dat")
    print("model: mean tangential %.1f, radial %.1f N/mm" % tuple(1e-3 * e.mean() for e in expected))
    for k, tooth in enumerate(all_teeth, 1):
        found = [binned(tooth, c) for c in (1, 2)]
        print("tooth %d: mean tangential %.1f, radial %.1f N/mm; over the model %.3f, %.3f; root mean square of the difference "
              "%.1f, %.1f N/mm; largest tangential %.1f N/mm at %.0f degrees" %
              (k, *(1e-3 * f.mean() for f in found), *(f.mean() / e.mean() for f, e in zip(found, expected)),
               *(1e-3 * np.sqrt(((f - e)**2).mean()) for f, e in zip(found, expected)), 1e-3 * found[0].max(),
               middle[np.argmax(found[0])]))
    draw(all_teeth, model, cuts)


if __name__ == "__main__":
    main()
