"""Bulk viscosity in shocks, and linear viscosity of pairs instead: what is behind a shock, and what it does to metal that flows."""
import os
import sys

from cases import taylor
from frame import CLOSED, ROOT, Sweep

sys.path.insert(0, os.path.join(ROOT, "bench", "validate"))
import case_plate_impact as impact                                                        # noqa: E402

TITLE = "bulk viscosity in shocks"
OPTIONS = {"0": "shock 0", "0.3": "shock 0.3", "0.5": "shock 0.5", "1": "shock 1", "0, viscosity 1 1": "shock 0 viscosity 1 1"}


def behind(run):
    found = impact.measure(run, {"speed": 400})
    errors = {q: found[q][0] / k - 1 for q, k in zip(impact.COMPARED, impact.behind("aluminum", 400))}
    return {"error": max(abs(e) for e in errors.values()), "mises": errors["von Mises stress"], "strain": errors["plastic strain"],
            "artificial": found["artificial share"][0]}


SWEEPS = [
    Sweep(name="impact", quantity="von Mises stress and plastic strain behind a shock of 400 m/s in aluminum, the larger error",
          reference="jump conditions", kind=CLOSED, script=lambda variables: impact.SCRIPT, measure=behind, baseline="0.5",
          settings={size: {label: {"options": words, "dx": dx} for label, words in OPTIONS.items()}
                    for size, dx in (("quick", 1e-4), ("full", 5e-5), ("large", 2.5e-5))}),
    taylor({size: {label: {"options": words, "rings": rings} for label, words in OPTIONS.items()}
            for size, rings in (("quick", 3), ("full", 4), ("large", 8))}, baseline="0"),
]
