"""The strip of case_tension, pulled to 2.4 times its length with pairs that are kept. By Considere's construction a strip of
this metal that is drawn evenly begins to neck at 2.67 times its length; between its clamps it does so at about 2.3."""
import numpy as np

from case_tension import CASE as ONE
from frame import Case


def judge(r):
    """1 minus the least width of the gauge over its mean; 1 where the strip came apart."""
    e, dx = r.end, r.settings["dx"]
    part = 2 * dx * r.t["v_long"][-1]
    lo, hi = e["x"].min() + 6 * dx, e["x"].max() - 6 * dx
    inside = [e["y"][(e["x"] > a) & (e["x"] <= a + part)] for a in np.arange(lo, hi - part, part)]
    widths = [np.ptp(y) if len(y) > 1 else 0.0 for y in inside]
    return 1 - min(widths) / np.mean(widths)


CASE = Case(
    title="tension to 140 %, total-Lagrangian pairs",
    criterion="1 - least width over the mean one, in the gauge", counter="pairs that are searched", setup=ONE.setup,
    model=ONE.model.replace("adapt/neigh asph psi every 2 limits 0.5 3", "adapt/neigh {pairs}"),
    steps="steps", settings=dict(ONE.settings, steps=13900, pairs="threshold inf rows 200"),
    bad={"pairs": "threshold 0"}, judge=judge, limit=0.3)
