#!/usr/bin/python3
"""The bent beam: elastic profile, then refined where it is stretched. ./sphtm scenes bending_beam"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))
from study import Study                                                                # noqa: E402
from sphtm_scene import read_dump                                                      # noqa: E402

L, W = 0.05, 12.5e-3
# S13: edge of the square 0.5 of the spacing; the keyword takes smoothing lengths, 1.2 spacings
REFINE = "refine square epsilon 0.41667 alpha 0.6 velocity linear when v_strain above 0.04 every 200"
ELASTIC = {"options": "viscosity 0.5 0.5 correction yes artstress 0 4", "sag": 0}
ROWS = {"elastic": ELASTIC, "unrefined": {"ramp": 100e-6}, "refined": {"ramp": 100e-6, "adapt": REFINE}}


def elastic_profile(result, rows, at=0.5):
    """Stress along the beam over the height at a part of the free length, and what the moment of the force there asks for."""
    dx, frame = W / rows, read_dump(result.path("elastic.dump"))[-1]
    h = result.columns("history.dat")
    force = h[(h[:, 1] > frame_time(result) - 50e-6) & (h[:, 1] <= frame_time(result))][:, 2].mean()
    near = np.abs(frame["x"] - at * L) < 1.01 * dx
    y, s = frame["y"][near], frame["c_p[2]"][near]
    moment = force * (L + 3 * dx - at * L)
    return y, s, 12 * moment / W**3 * (y - frame["y"][near].mean()), 6 * moment / W**2


def frame_time(result):
    t = result.thermo[1]
    return t["Time"][-1]


def profile_error(y, s, wanted, top):
    """Largest difference from the linear profile over the stress of the surface; slope of the best line over the wanted."""
    best = np.polyfit(wanted, s, 1)
    return np.abs(s - wanted).max() / top, best[0]


def halves(frame, first, rows):
    """What became of the particles of the lattice, by the half they started in: of those on the free length, how many have
    been split; in the upper half near the clamp, two rows off the surface, the neighbors of the least and of the 3 %
    with the fewest. The ID of a parent goes to one of its children."""
    dx, start = W / rows, {int(k): (x, y) for k, x, y in zip(first["id"], first["x"], first["y"])}
    kept = np.array([int(k) in start for k in frame["id"]])
    x, y = np.array([start[int(k)] for k in frame["id"][kept]]).T
    split, near = frame["mass"][kept] < 0.9 * first["mass"].max(), frame["c_p[5]"][kept]
    free, inside = (x > 0) & (x < L), (y > 0) & (y < W / 2 - 1.9 * dx) & (x > 0) & (x < L / 2)
    return {"particles": len(frame["id"]), "split_stretched_half": int((split & free & (y > 0)).sum()),
            "split_compressed_half": int((split & free & (y < 0)).sum()), "neighbors_least": int(near[inside].min()),
            "neighbors_fewest": float(np.percentile(near[inside], 3))}


def at_sag(result, sag):
    """The first frame with the end so far down, and where the end is then."""
    h = result.columns("history.dat")
    for frame in read_dump(result.path("beam.dump")):
        tip = np.interp(frame["step"], h[:, 0], h[:, 4])
        if tip < -sag:
            return frame, tip
    return frame, tip


def main():
    sizes = {"small": {"rows": 13}, "default": {"rows": 25}, "large": {"rows": 50}}
    study = Study(__file__, sizes, __doc__)
    rows, table, frames = study.size["rows"], {}, {}
    for row, variables in ROWS.items():
        if not study.wants(row):
            continue
        result = study.run(row, dict(study.size, **variables), may_stop=True)
        if not os.path.exists(result.path("end.dump")):
            table[row] = {"stopped": result.errors()}
            continue
        if row == "elastic":
            error, slope = profile_error(*elastic_profile(result, rows))
            table[row] = {"profile_error": error, "profile_slope": slope, "processor": result.processor}
            continue
        first = read_dump(result.path("elastic.dump"))[-1]
        h, table[row] = result.columns("history.dat"), {}
        for name, sag in (("25_mm", 0.025), ("end", 1.0)):
            frame, tip = at_sag(result, sag)
            table[row][name] = dict(halves(frame, first, rows), tip=tip)
            frames["%s, %.0f mm down" % (row, -1e3 * tip)] = frame
        table[row].update(largest_plastic_strain=h[-1, 5], steps=int(h[-1, 0]), processor=result.processor, wall=result.wall)
    draw(frames, study)
    study.end({"rows": table})


def draw(frames, study):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    plt.rcParams.update({"font.size": 9})
    figure, axes = plt.subplots(1, max(1, len(frames)), figsize=(2.6 * max(1, len(frames)), 4), squeeze=False, sharey=True)
    for ax, (row, frame) in zip(axes[0], frames.items()):
        dots = ax.scatter(1e3 * frame["x"], 1e3 * frame["y"], c=frame["c_p[1]"], s=0.8, cmap="viridis", vmin=0, vmax=0.6, lw=0)
        ax.set(aspect="equal", title=row.replace(", ", "\n"), xlabel="x (mm)", xlim=(-6, 50), ylim=(-58, 12))
    figure.colorbar(dots, ax=axes[0].tolist(), label="plastic strain", shrink=0.8)
    figure.savefig(study.path("bending_beam.png"), dpi=150, bbox_inches="tight")


if __name__ == "__main__":
    main()
