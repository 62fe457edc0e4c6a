"""Resistance to patterns that no gradient sees, in place of the artificial stress."""
import os

from cases import plate, taylor
from frame import HERE, module

asph = module(os.path.join(HERE, "knob_asph.py"))
TITLE = "hourglass resistance"
XI = (0, 0.005, 0.01, 0.02, 0.05, 0.1)
STRESS = "artificial stress 0.3 instead"


def by(before, **more):
    rows = {"xi %g" % xi: dict(more, options=before + "artstress 0 4 hourglass %g" % xi) for xi in XI}
    rows[STRESS] = dict(more, options=before + "artstress 0.3 4 balanced")
    return rows


def plates(rows):
    return by("viscosity 1 1 correction yes ", rows=rows)


SWEEPS = [
    asph.tension({size: by("plane stress ", rows=rows, speed=20)
                  for size, rows in (("quick", 8), ("full", 14), ("large", 28))}),
    taylor({size: by("viscosity 0.3 0.3 balsara yes correction yes ", rings=rings)
            for size, rings in (("quick", 3), ("full", 4), ("large", 8))}, baseline="xi 0"),
    plate({"quick": plates(6), "full": plates(10), "large": plates(20)}, baseline="xi 0"),
]
