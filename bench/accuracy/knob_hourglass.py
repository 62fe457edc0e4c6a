"""Stiffness of the hourglass control: that of the default, which follows the flow (auto), constant ones, none, and artificial stress instead."""
import os

from cases import plate, taylor
from frame import HERE, module

asph = module(os.path.join(HERE, "knob_asph.py"))
TITLE = "hourglass resistance"
XI = (0, 0.005, 0.01, 0.02, 0.05, 0.1)
STRESS = "artificial stress 0.3 instead"


def by(before, **more):
    rows = {"auto": dict(more, options=before)}
    rows.update({"xi %g" % xi: dict(more, options=before + "hourglass %g" % xi) for xi in XI})
    rows[STRESS] = dict(more, options=before + "artstress 0.3 4 balanced")
    return rows


SWEEPS = [
    asph.tension({size: by("plane stress ", rows=rows, speed=20)
                  for size, rows in (("quick", 8), ("full", 14), ("large", 28))}),
    taylor({size: by("", rings=rings)
            for size, rings in (("quick", 3), ("full", 4), ("large", 8))}, baseline="auto"),
    plate({size: by("", rows=rows) for size, rows in (("quick", 6), ("full", 10), ("large", 20))}, baseline="auto"),
]
