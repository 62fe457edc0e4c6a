"""An elastic block hits a rigid slope that is not square to the pattern of the split; while it is pressed against it,
its foot is split."""
import os

import numpy as np
from case_split_contact import CASE as FLAT, judge as judge_flat
from frame import Case

ANGLE = 35.0    # of the slope and the block (degrees)


def along_slope(x, y):
    c, s = np.cos(np.radians(ANGLE)), np.sin(np.radians(ANGLE))
    return c * x - s * y, s * x + c * y


def block(folder, _):
    """The block of the flat case, turned."""
    x, y = along_slope(*[1e-3 * (a.ravel() + 0.5) for a in np.meshgrid(np.arange(16), np.arange(10))])
    with open(os.path.join(folder, "block.data"), "w") as f:
        f.write("a block\n\n%d atoms\n1 atom types\n\n-0.04 0.04 xlo xhi\n-0.04 0.04 ylo yhi\n-0.1 0.1 zlo zhi\n\n" % x.size)
        f.write("Atoms\n\n")
        f.writelines("%d 1 %.17g %.17g 0\n" % row for row in zip(range(1, x.size + 1), x, y))


def judge(r):
    """As on the flat plate; away from the slope is up there."""
    r.end["vy"] = np.cos(np.radians(ANGLE)) * r.end["vy"] - np.sin(np.radians(ANGLE)) * r.end["vx"]
    return judge_flat(r)


HEAD, _, TAIL = FLAT.setup.partition("lattice")
SHOT = "%.17g %.17g" % along_slope(0.0, -20.0)
CASE = Case(
    title="split next to a slope", criterion=FLAT.criterion, counter=FLAT.counter,
    setup=HEAD + "read_data block.data\n" + TAIL[TAIL.index("pair_style"):].replace("set 0 -20 0", "set %s 0" % SHOT),
    model=FLAT.model.replace("move 0.008 -0.001 0", "move 0.008 -0.001 0 rotate axis 0 0 1 angle %g" % ANGLE),
    steps="steps", meshes=FLAT.meshes, prepare=block, settings=FLAT.settings, bad=FLAT.bad, judge=judge,
    limit=FLAT.limit, stops=FLAT.stops)
