"""Rows of particles with smoothing lengths of their own: threshold 0, with and without a margin, searches with the
reach of each. The same bits as LAMMPS's lists, which reach as far as the largest h wants, with refinement to two levels
and merging, with ASPH, on 1 and 2 ranks and across a periodic boundary; rows hold what is within the larger reach of
the two, counted here. Counter-case: with the reach of the largest for all there would be several times as many."""
import numpy as np
from refine_scene import DX, dump, start, styles, values
from sphtm_scene import Checks, run

SUPPORT, SPARE = 2.0, 1.02    # of the kernel; what rows reach further where particles are refined
SQUARE = "refine square epsilon 0.41666667 alpha 0.6 every 20 "
CIRCLE = ("compute xu all property/atom xu yu\n"
          "variable near atom ((c_xu[1]-%.17g-%.17g*step)^2+(c_xu[2]-%.17g)^2<%.17g)" %
          (2 * DX, 0.02 * DX, 6 * DX, (4 * DX) ** 2))
CASES = {
    "circle that moves, split and merged": dict(
        make=dict(spin=2000.0, squeeze=3e3, size=(24, 12, 8)),
        refine=SQUARE + "when v_near above 0.5 level 2 coarsen fallen",
        more=CIRCLE, steps=100),
    "ASPH, split, periodic": dict(
        make=dict(size=(24, 12, 8), squeeze=6e3, boundary="p s p", v="40 0 0", shift=12),
        refine="asph psi every 5 " + SQUARE + "when pstrain above 0.01", steps=120),
    "3D, ASPH, split": dict(
        make=dict(dim=3, size=(12, 6, 4), spin=2000.0, squeeze=6e3, grid="* * *"),
        refine="asph psi every 5 refine cube epsilon 0.41666667 alpha 0.5 every 20 when pstrain above 0.005", steps=40)}
EVERY, MARGIN = " threshold 0", " threshold 0 margin 0.15"


def body(case, lists, ranks=1):
    c = CASES[case]
    make = dict(c["make"])
    shift = make.pop("shift", 0)
    script = start(**make)
    if shift:
        script += "displace_atoms all move %.17g 0 0 units box\n" % (shift * DX)
    script += styles(c["refine"] + lists, more=c.get("more", ""))
    # the last step is not one that changes h
    return run(script + "run %d\n" % (c["steps"] + 3) + dump(1) + "run 0\n", ranks=ranks)


def same(a, b):
    return len(a["id"]) == len(b["id"]) and all(np.array_equal(a[k], b[k]) for k in a if k != "box")


def neighbors_of_half_step(frame, dt, period=None):
    """How many are within the larger reach of the two, and within that of the largest, of each particle."""
    x = np.array([frame[a] - 0.5 * dt * frame["v" + a[0]] for a in ("xu", "yu", "zu")])
    reach = SUPPORT * SPARE * values(frame, "h")
    d = x[:, :, None] - x[:, None, :]
    if period:
        d[0] -= period * np.round(d[0] / period)
    r = np.sqrt((d**2).sum(0)) + 1e3 * np.eye(len(reach))
    return (r < np.maximum(reach[:, None], reach)).sum(1), (r < reach.max()).sum(1)


def main():
    checks = Checks()
    for case, c in CASES.items():
        # each number of ranks numbers particles in its own way
        frames = {ranks: body(case, "", ranks).dump("d.dump")[-1] for ranks in (1, 2)}
        h = values(frames[1], "h")
        checks.above(case + ": largest over smallest h", h.max() / h.min(), 1.5)
        for name, lists in (("threshold 0", EVERY), ("with a margin", MARGIN)):
            for ranks in (1, 2):
                other = body(case, lists, ranks)
                checks.true("%s: %s, ranks %d, same bits" % (case, name, ranks),
                            same(frames[ranks], other.dump("d.dump")[-1]), "%d particles" % len(h))
                if lists != EVERY:
                    continue
                t = other.thermo[0]
                entries = t["f_ad[6]" if "asph" in c["refine"] else "f_ad[3]"][-1]
                period = 40 * DX if "p s p" == c["make"].get("boundary") else None
                own, largest = neighbors_of_half_step(frames[ranks], t["Dt"][-1], period)
                checks.near("%s, ranks %d: entries per particle" % (case, ranks), entries, own.mean(), relative=1e-9)
            if lists == EVERY:
                checks.below(case + ": rows, of those with the largest reach", own.mean() / largest.mean(), 0.7)
                small = values(frames[2], "h") < 1.1 * h.min()
                checks.below(case + ": the same for the smallest", own[small].mean() / largest[small].mean(), 0.7)
    refined = styles(SQUARE + "when pstrain above 0.01 threshold 1e-5")
    kept = run(start() + refined + "run 1\n", expect_error=True).errors()
    checks.true("error: refined, threshold 1e-5",
                all(w in kept for w in ("threshold 1e-05", "smoothing length", "threshold 0")), kept)
    checks.end()


if __name__ == "__main__":
    main()
