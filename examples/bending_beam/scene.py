#!/usr/bin/python3
"""The bent beam: elastic profile, then refined where it is stretched. ./sphtm scenes bending_beam"""
import os
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [os.path.join(HERE, "..", "..", "bench"), os.path.join(HERE, "..", "..", "bench", "stability")]
from frame import pieces                                                               # noqa: E402
from study import Study                                                                # noqa: E402
from sphtm_scene import read_dump                                                      # noqa: E402

L, W = 0.05, 12.5e-3
# S13: edge of the square 0.5 of the spacing; the keyword takes smoothing lengths, 1.2 spacings
REFINE = "refine square epsilon 0.41667 alpha 0.6 velocity linear when f_strain[1] above 0.04 every 200"
BARE = "viscosity 1 1 hourglass 0 correction no"
RESISTED = "artstress 0.3 4 balanced hourglass 0.02"
DEFAULT = "stabilize hourglass"    # of the pair style
ELASTIC, ELASTIC_RESISTED = {"options": "hourglass 0", "sag": 0}, {"options": DEFAULT, "sag": 0}


def bent(options, **more):
    return dict({"ramp": 100e-6, "options": options}, **more)


ROWS = {"elastic": ELASTIC, "elastic_resisted": ELASTIC_RESISTED,
        "unrefined_bare": bent(BARE), "refined_bare": bent(BARE, adapt=REFINE),
        "unrefined": bent(RESISTED), "refined": bent(RESISTED, adapt=REFINE),
        "unrefined_default": bent(DEFAULT), "refined_default": bent(DEFAULT, adapt=REFINE)}


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


def places(frame):
    return {int(k): (x, y) for k, x, y in zip(frame["id"], frame["x"], frame["y"])}


def strains(frame, first, rows):
    """Logarithmic strain along the beam of each particle of an unrefined frame, from its two neighbors in the row."""
    start, now, found = places(first), places(frame), {}
    for k, (x, y) in start.items():
        ends = k - 1, k + 1
        if all(e in start and abs(start[e][1] - y) < 0.5 * W / rows for e in ends):
            length = [np.hypot(*np.subtract(p[ends[1]], p[ends[0]])) for p in (start, now)]
            found[k] = np.log(length[1] / length[0])
    return found


def split_particles(frame, first):
    """IDs of the particles of the free length that have been split: a parent's goes to one of its children."""
    start, whole = places(first), 0.9 * first["mass"].max()
    return [int(k) for k, m in zip(frame["id"], frame["mass"]) if m < whole and 0 < start.get(int(k), (-1, 0))[0] < L]


def state_of(frame, first, rows, strain):
    """Of a frame: particles; how many of the lattice have been split, how many of those are shorter than at the start in
    the unrefined beam (strain), how many lay in the lower half, the middle row apart; in the upper half near the clamp,
    two rows off the surface, the neighbors of the least and of the 3 % with the fewest."""
    dx, start = W / rows, places(first)
    split = split_particles(frame, first)
    kept = np.array([int(k) in start for k in frame["id"]])
    x, y = np.array([start[int(k)] for k in frame["id"][kept]]).T
    near = frame["c_p[5]"][kept][(y > 0) & (y < W / 2 - 1.9 * dx) & (x > 0) & (x < L / 2)]
    return {"particles": len(frame["id"]), "split": len(split),
            "split_shortened": sum(bool(strain.get(k, 0.0) < 0) for k in split),
            "split_in_lower_half": sum(bool(start[k][1] < -0.5 * dx) for k in split),
            "neighbors_least": int(near.min()), "neighbors_fewest": float(np.percentile(near, 3))}


def breaks(result, rows):
    """How far down the end is in the last frame in which the beam is whole, and in the first in which it is not: in pieces
    that are farther apart than the kernel of the lattice reaches."""
    whole = 0.0
    for frame in read_dump(result.path("beam.dump")):
        tip = tip_at(result, frame)
        if len(pieces(np.c_[frame["x"], frame["y"]], 2.4 * W / rows)) > 1:
            return whole, tip
        whole = tip
    return whole, None


def opening(frame, first, rows):
    """Largest distance between neighbors in a row of the stretched half near the clamp, less what their plastic strain makes of
    it (plane strain: exp(sqrt(3)/2 eps)), in spacings. A parent's ID goes to one of its children."""
    start, now, worst = places(first), places(frame), 0.0
    strain = {int(k): e for k, e in zip(frame["id"], frame["c_p[1]"])}
    for k, (x, y) in start.items():
        pair = k, k + 1
        if y > 0 and 0 < x < L / 2 and all(e in start and e in now for e in pair) and abs(start[k + 1][1] - y) < 0.5 * W / rows:
            length = [np.hypot(*np.subtract(p[k + 1], p[k])) for p in (start, now)]
            worst = max(worst, length[1] / length[0] - np.exp(np.sqrt(0.75) * max(strain[e] for e in pair)))
    return float(worst)


def opens(result, first, rows, wide=1.0):
    """How far down the end is where first a gap is wider than a spacing (None: nowhere), and the widest gap at 30 mm, and of all."""
    found = [(tip_at(result, frame), opening(frame, first, rows)) for frame in read_dump(result.path("beam.dump"))]
    return {"opens_at": next((tip for tip, gap in found if gap > wide), None), "widest_gap": max(gap for _, gap in found),
            "gap_at_30_mm": max([gap for tip, gap in found if tip > -0.031], default=None)}


def tip_at(result, frame):
    h = result.columns("history.dat")
    return float(np.interp(frame["step"], h[:, 0], h[:, 4]))


def at_sag(result, sag):
    """The first frame with the end so far down, or the last one, and where the end is then."""
    for frame in read_dump(result.path("beam.dump")):
        if tip_at(result, frame) < -sag:
            break
    return frame, tip_at(result, frame)


def like(result, tip):
    """The frame in which the end is nearest to tip."""
    return min(read_dump(result.path("beam.dump")), key=lambda frame: abs(tip_at(result, frame) - tip))


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
        if row.startswith("elastic"):
            error, slope = profile_error(*elastic_profile(result, rows))
            table[row] = {"profile_error": error, "profile_slope": slope, "processor": result.processor}
            continue
        first = read_dump(result.path("elastic.dump"))[-1]
        h, table[row] = result.columns("history.dat"), {}
        table[row]["whole_until"], table[row]["in_pieces_at"] = breaks(result, rows)
        if row == "unrefined_bare":
            frame, tip = at_sag(result, -(table[row]["in_pieces_at"] or -1.0))
            frames["bare, %.0f mm down" % (-1e3 * tip)] = frame
        table[row].update(opens(result, first, rows))
        if row == "unrefined":
            straight, lattice = result, first
        for name, sag in (("25_mm", 0.025), ("end", 1.0)) if row in ("unrefined", "refined") else ():
            frame, tip = at_sag(result, sag)
            strain = strains(like(straight, tip), lattice, rows)
            table[row][name] = dict(state_of(frame, first, rows, strain), tip=tip)
            frames["%s, %.0f mm down" % (row, -1e3 * tip)] = frame
        table[row].update(largest_plastic_strain=h[-1, 5], steps=int(h[-1, 0]), processor=result.processor,
                          wall=result.wall)
    if frames:
        draw(frames, study)
    straight = {row: 100 * table[row]["profile_error"] for row in ("elastic", "elastic_resisted") if "profile_error" in table.get(row, {})}
    study.end({"rows": table}, {"bending_beam": straight} if len(straight) == 2 else None)    # %


def draw(frames, study):
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    plt.rcParams.update({"font.size": 9})
    figure, axes = plt.subplots(1, len(frames), figsize=(2.3 * len(frames), 4), squeeze=False, sharey=True)
    for ax, (row, frame) in zip(axes[0], frames.items()):
        dots = ax.scatter(1e3 * frame["x"], 1e3 * frame["y"], c=frame["c_p[1]"], s=0.8, cmap="viridis", vmin=0, vmax=0.6, lw=0)
        ax.set(aspect="equal", title=row.replace(", ", "\n"), xlabel="x (mm)", xlim=(-6, 50), ylim=(-58, 12))
    figure.colorbar(dots, ax=axes[0].tolist(), label="plastic strain", shrink=0.8)
    figure.savefig(study.path("bending_beam.png"), dpi=150, bbox_inches="tight")


if __name__ == "__main__":
    main()
