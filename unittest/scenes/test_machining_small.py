"""High speed machining, a narrow, short slice of examples/high_speed_machining: the chip forms and holds together, the
signs of the forces, the effect of heat, the energy book, and 1 and 2 ranks agree. The work piece is half as long and
high as the example's, held in the same way, and cut over 1 mm; so the forces are those of a start, not of a steady
cut."""
import os
import sys

import numpy as np

from sphtm_scene import SOURCE, Checks, run

EXAMPLE = os.path.join(SOURCE, "examples", "high_speed_machining")
sys.path.insert(0, EXAMPLE)
import measure as M                                                                    # noqa: E402

DP, DEPTH, WIDTH, CUT = 0.2e-3, 1.0e-3, 0.8e-3, 1.0e-3


SMALLER = (("insert.stl", os.path.join(EXAMPLE, "insert.stl")),
           ("work block -1e-3 7e-3 -3e-3", "work block 3e-3 7e-3 -1.6e-3"),
           ("base block INF INF INF -2.2e-3", "base block INF INF INF -0.8e-3"),
           ("end block INF -0.2e-3", "end block INF 3.8e-3"),
           ("edge block INF INF INF 4e-3", "edge block INF INF INF 3e-3"))
COUNT = 20 * 13 * 4


def cut(heat, ranks=1, length=CUT):
    with open(os.path.join(EXAMPLE, "in.high_speed_machining")) as f:
        script = f.read()
    for old, new in SMALLER:
        assert old in script, old
        script = script.replace(old, new)
    result = run(script, {"heat": heat, "width": WIDTH, "cut": length}, ranks=ranks)
    h = dict(zip(M.COLUMNS, result.columns("history.dat").T))
    frame = result.dump("final.dump")[-1]
    return h, {k: v[frame["type"] == 1] if isinstance(v, np.ndarray) and len(v) == len(frame["id"]) else v
               for k, v in frame.items()}, result


def between(checks, name, value, low, high):
    checks.say(low <= value <= high, name, "%.6g, allowed %g to %g" % (value, low, high))


def steady(h, name):
    return h[name][h["cut"] > 0.6e-3].mean()


def chip(checks, label, h, f):
    """A chip on the rake face, in one piece, outside the tool."""
    x0 = 7e-3 - h["cut"][-1]
    x, y = f["x"] - x0, f["y"]
    between(checks, label + ": chip above the surface (mm)", 1e3 * (y.max() - DEPTH), 0.3, 1.0)
    risen = y > DEPTH + 0.5 * DP
    # a rigid chip 1.9 times as thick as the cut, sheared along one plane, has a quarter of itself above the old surface
    swept = h["cut"][-1] * DEPTH * WIDTH / DP ** 3
    checks.above(label + ": volume above the old surface over that cut", risen.sum() / swept, 0.25)
    ahead = x * M.TOOL.rake_normal[0] + y * M.TOOL.rake_normal[1]
    above = y > 0.5 * DP
    # the layer between center and tool is a sixth of a spacing at its thinnest (tm_contact_layer.h), half of one where nothing flows
    checks.true(label + ": no particle behind the rake face", ahead[above].min() > 0.1 * DP, "%.3f spacings" % (ahead[above].min() / DP))
    checks.true(label + ": the deepest penetration is below 0.1 dp", h["penetration"].max() < 0.1)
    sizes = M.clusters(f["x"], f["y"], f["z"], M.BOND_DP * DP)
    checks.true(label + ": one piece, %d particles" % sizes[0], len(sizes) == 1 and sizes[0] == COUNT)
    checks.true(label + ": the chip rises", f["vy"][risen].mean() > 10.0)


def forces(checks, label, h):
    """On the tool: against its motion along -x, so along +x."""
    area = DEPTH * WIDTH
    between(checks, label + ": cutting force over chip section (N/mm^2)", steady(h, "fx") / area * 1e-6, 550, 950)
    checks.true(label + ": pushes against the motion at all times", h["fx"][h["cut"] > 0.1e-3].min() > 0.0)
    checks.true(label + ": thrust is small at 17.5 degrees rake", abs(steady(h, "fy")) < 0.2 * steady(h, "fx"))
    checks.true(label + ": no force along the edge", abs(steady(h, "fz")) < 0.02 * steady(h, "fx"))
    checks.true(label + ": friction dissipates", h["friction_power"].min() >= 0.0)
    # the work of the force over the way of the tool is the external work of the book
    way = np.diff(h["cut"], prepend=h["cut"][0])
    checks.near(label + ": force times way = external work", (h["fx"] * way).sum(), -h["external"][-1], relative=0.02)
    checks.true(label + ": energy book closes, %.1e" % abs(h["energy_sum"][-1] / h["external"][-1]),
                abs(h["energy_sum"] - h["energy_sum"][0]).max() < 1e-3 * abs(h["external"][-1]))


checks = Checks()
hot, hot_frame, _ = cut("yes")
cold, cold_frame, _ = cut("no")
two, _, _ = cut("yes", ranks=2, length=0.1e-3)

for label, h, f in (("heat", hot, hot_frame), ("no heat", cold, cold_frame)):
    chip(checks, label, h, f)
    forces(checks, label, h)

between(checks, "heat lowers the cutting force: ratio", steady(hot, "fx") / steady(cold, "fx"), 0.8, 0.92)
between(checks, "hottest particle (K)", hot["T_max"][-1], 450.0, 855.0)
checks.true("without heat the temperature stays", cold["T_max"].max() == 293.0 == cold["T_max"].min())
checks.true("friction heats the tool", steady(hot, "tool_heat") > 0.0)
checks.true("without heat it does not", abs(cold["tool_heat"]).max() == 0.0)

n = len(two["fx"])
checks.above("1 and 2 ranks: samples compared", n, 8)
largest = {k: abs(two[k]).max() for k in M.COLUMNS}
largest.update((k, largest["fx"]) for k in ("fy", "fz"))                            # fz is nought by symmetry
largest.update((k, largest["external"]) for k in M.COLUMNS[M.COLUMNS.index("kinetic"):])
for k in ("fx", "fy", "fz", "T_max", "tool_heat", "heat", "plastic", "energy_sum"):
    checks.below("    %s, difference" % k, abs(hot[k][:n] - two[k]).max() / largest[k], 1e-8)
checks.end()
