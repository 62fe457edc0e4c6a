"""A strip of perfectly plastic metal, drawn through a smooth die in plane strain. Where the reduction r is 2 sin a/(1 + 2 sin a) the slip
lines are a fan of the angle a of the die, and the force is known: (1 + a) r 2 k over the section behind the die (Hill 1950, chapter VII: the pressure of
extrusion, in drawing as a tension). The strip leaves the die as high as the die is.

What was chosen: a reduction by a third, so an angle of 14.5 degrees, which even numbers of rows pass; Y = 500 MPa, elastic constants of steel; 10 m/s, 0.5 % of the stress in
inertia; means over 3 to 5 half heights of way (a strip that has parted needs no force); the default, kept pairs, and the default without shifting. The case comes from a trial by hand in
which a strip parted in the die."""
import os
import subprocess
import sys

import case
import numpy as np

TITLE = "strip drawing without friction"
REFERENCE = "slip-line theory"
FOLDER = os.path.dirname(os.path.abspath(__file__))
SCRIPT = os.path.join(FOLDER, "in.drawing")
BASE = {"rows": 24}
HEIGHT = 3e-3
COMPARED = {"force": ("over the closed form", 0.05), "height behind the die": ("over that of the die", 0.03)}
ROWS = {name: {"variables": {"left": left}, "title": "reduced by " + title, "reference": {q: (1.0, 0.0) for q in COMPARED}}
        for name, left, title in (("third", 2 / 3, "a third"),)}
SETTINGS = {"rows_12": {"rows": 12}, "rows_18": {"rows": 18}, "rows_24": {}, "kept_12": {"rows": 12, "lists": "fix rows all adapt/neigh threshold inf"},
            "not_shifted_12": {"rows": 12, "body": "effects shifting off"}}
SAID = {"rows_12": "12 rows before the die", "rows_18": "18", "rows_24": "24", "kept_12": "12 rows, kept pairs (*threshold inf*)",
        "not_shifted_12": "12 rows, *effects shifting off*"}
MESH, QUICK = ("rows_12", "rows_18", "rows_24"), "rows_12"
SPACING = {"rows_12": 1 / 12, "rows_18": 1 / 18, "rows_24": 1 / 24}


def cost(variables):
    return 2 * float(variables["rows"]) ** 3


def prepare(folder, variables):
    subprocess.run([sys.executable, os.path.join(case.ROOT, "tools", "make_tool.py"), "block", "--size", "24", "10", "10", "-o",
                    os.path.join(folder, "die.stl")], check=True, stdout=subprocess.DEVNULL)
    rest = {k: v for k, v in variables.items() if k != "left"}
    return dict(rest, behind=round(float(variables["left"]) * float(variables["rows"])))


def measure(result, variables):
    d, t, end = result.columns("force.dat"), result.thermo[-1], result.dump("end.dump")[-1]
    spacing, left = 2 * HEIGHT / float(variables["rows"]), float(variables["left"])
    behind = (end["x"] > 2e-3) & (end["x"] < 8e-3)
    height = (np.ptp(end["y"][behind]) + spacing) / (2 * HEIGHT * left) if behind.any() else 0.0    # it has parted
    return {"force": case.exact(d[(d[:, 1] > 3 * HEIGHT) & (d[:, 1] < 5 * HEIGHT), 2].mean()), "height behind the die": case.exact(height),
            "numerical fracture": case.exact(t["f_body[15]"][-1]), "artificial share": case.exact(abs(t["f_body[7]"][-1] / t["f_body[8]"][-1]))}
