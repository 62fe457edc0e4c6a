"""An elastic cantilever of ten heights, bent and pulled by a force on its last column, at rest: stiffness as an ordinary user finds it, force
over the displacement of that column. Reference: beam theory in plane strain, with shear (Timoshenko, factor 5/6); the length runs from the face of
the held particles to the column that is loaded.

What was chosen, before the first run: fix sph/tm/relax, until what is unbalanced is 1e-4 of what is carried; a displacement of a thousandth of the
length in bending, and a hundredth of that in tension, small enough for linear theory."""
import os

import case

TITLE = "elastic cantilever"
REFERENCE = "beam theory"
SCRIPT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "in.beam")
BASE = {"rows": 8}
COMPARED = {"stiffness": ("over beam theory", 0.03)}
ROWS = {load: {"variables": {"load": load}, "title": said, "reference": {"stiffness": (1.0, 0.0)}} for load, said in
        (("bend", "bent"), ("pull", "pulled"))}
SETTINGS = {"rows_4": {"rows": 4}, "rows_8": {}, "rows_16": {"rows": 16}, "held_4": {"rows": 4, "more": 1}, "held_8": {"more": 1},
            "held_16": {"rows": 16, "more": 1}, "linear_4": {"rows": 4, "options": "correction linear"},
            "linear_8": {"options": "correction linear"}, "artstress": {"options": "stabilize artstress"}}
SAID = {"rows_4": "4 rows", "rows_8": "8", "rows_16": "16", "held_4": "4 rows, the first column of the beam held as well", "held_8": "8 rows, the same",
        "held_16": "16 rows, the same", "linear_4": "4 rows, *correction linear*", "linear_8": "8 rows, *correction linear*",
        "artstress": "8 rows, *stabilize artstress*"}
MESH, QUICK = ("rows_4", "rows_8", "rows_16"), "rows_4"
SPACING = {"rows_4": 4, "rows_8": 2, "rows_16": 1}


def cost(variables):
    return float(variables["rows"]) ** 4 * (10 if variables["load"] == "bend" else 1)


def measure(result, variables):
    t = result.thermo[-1]
    return {"stiffness": case.exact(t["v_stiffness"][-1]), "unbalanced": case.exact(t["f_rest"][-1])}
