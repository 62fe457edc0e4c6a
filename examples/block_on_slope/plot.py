#!/usr/bin/python3
"""Accelerations of way_*.dat against g (sin a - mu cos a), as a table; draws block_on_slope.png"""
import glob

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from measure import A, DX, G, RAMP, acceleration, theory as theory_of

runs = sorted(((float(f[4:-4]), np.loadtxt(f)) for f in glob.glob("way_*.dat")), key=lambda r: r[0])

plt.rcParams.update({"font.size": 9})
figure, (left, right) = plt.subplots(1, 2, figsize=(8, 3.2))
print("mu/tan a   acceleration   theory   force along, across over weight")
for share, rows in runs:
    time, way, speed, along, across = rows[:, 1:].T
    late = time > 1.5 * RAMP
    found, theory = acceleration(time, way), theory_of(share)
    print("%8g   %12.6f   %.6f   %.5f %.5f" % (share, found, theory, along[late].mean(), across[late].mean()))
    if share > 1:
        print("           creeps by %.1e spacings in %.2f s" % (np.ptp(way[late]) / DX, np.ptp(time[late])))
    line, = left.plot(time, way / DX, lw=1.5, label="$\\mu$ = %g tan a" % share)
    # the way of a point that gravity, grown over the ramp, pulls from rest
    t = np.linspace(0, time[-1], 400)
    pull = np.where(t < RAMP, t ** 3 / (6 * RAMP), RAMP ** 2 / 6 + RAMP / 2 * (t - RAMP) + (t - RAMP) ** 2 / 2)
    left.plot(t[::16], theory * pull[::16] / DX, "o", ms=3, mfc="none", color=line.get_color())
    right.plot(time, along / across, color=line.get_color(), lw=1.5)
    right.axhline(min(share, 1) * np.tan(A), color=line.get_color(), ls=":", lw=1)
left.set(xlabel="time (s)", ylabel="way (spacings)", title="lines: particles, dots: a point with friction")
left.legend(frameon=False)
right.set(xlabel="time (s)", ylabel="friction over normal force", ylim=(-0.02, 0.5), title="dotted: min($\\mu$, tan a)")
for ax in (left, right):
    ax.spines[["top", "right"]].set_visible(False)
figure.tight_layout()
figure.savefig("block_on_slope.png", dpi=130)
