"""Friction heat of steel that slides on aluminum, shared by two half-spaces: closed form.

What was chosen: the example, with spacings of 40, 20 and 10 um over 1 mm of either body (at 1 ms heat has gone 0.2 to 0.4 mm); surface
temperatures by a parabola through three rows."""
import os

import case

EXAMPLE = case.example("tool_heat")
TITLE = "sliding friction, heat"
REFERENCE = "closed form"
SCRIPT = case.script_of("tool_heat")
FILES = [os.path.join(os.path.dirname(SCRIPT), "tool.stl")]
BASE = {"dx": 2e-5, "n": 50}
COMPARED = {"part of the heat in the aluminum": ("", 0.02), "rise of its surface": ("over the closed form", 0.02),
            "rise of the steel's surface": ("over the closed form", 0.02)}
SHARE = EXAMPLE.effusivity["aluminium"] / sum(EXAMPLE.effusivity.values())
ROWS = {"sliding": {"variables": {}, "title": "steel on aluminum", "reference": {
    q: (v, 0.0) for q, v in zip(COMPARED, (SHARE, 1.0, 1.0))}}}
SETTINGS = {"dx_40": {"dx": 4e-5, "n": 25}, "dx_20": {}, "dx_10": {"dx": 1e-5, "n": 100}, "artstress": {"options": "stabilize artstress"}}
SAID = {"dx_40": "40 um", "dx_20": "20 um", "dx_10": "10 um", "artstress": "20 um, *stabilize artstress*"}
MESH, QUICK = ("dx_40", "dx_20", "dx_10"), "dx_40"
SPACING = {"dx_40": 4, "dx_20": 2, "dx_10": 1}


def cost(variables):
    return float(variables["dx"]) ** -2


def measure(result, variables):
    time, _, work, heat, whole, q = EXAMPLE.history("particles", result.folder, 4 * float(variables["dx"]))
    due, rows = EXAMPLE.due(q, time[-1]), EXAMPLE.rows(result.folder)
    return {"part of the heat in the aluminum": case.exact(work[-1] / (work + heat)[-1]),
            "rise of its surface": case.exact(rows["aluminium"][2] / due), "rise of the steel's surface": case.exact(rows["steel"][2] / due),
            "heat over the work of friction": case.exact(whole)}
