"""A can of perfectly plastic metal, extruded backward in plane strain by a punch of half its width, without friction. Where the bottom is thick the slip
lines are a fan of a right angle at each corner of the punch, and its pressure is 2 k (1 + pi/2) from the beginning (Hill 1950, chapter VII). Where it
is as thin as the can is wide the metal flows out over all of the bottom and the pressure falls with the stroke: rigid_plastic.py.

What was chosen: bottoms of 4 and 2 half widths of the punch; Y = 500 MPa, elastic constants of steel; 5 m/s; sharp corners; means over strokes of 0.04 to 0.12, 0.2 to 0.32
and 0.48 to 0.64 half widths; the default, without shifting, and kept pairs. The case comes from a trial by hand with the thin bottom, which was held against the closed
form of the thick one and seemed 5 to 16 % too weak."""
import os
import subprocess
import sys

import case

TITLE = "backward extrusion without friction"
REFERENCE = "slip-line theory; limit analysis by finite elements"
FOLDER = os.path.dirname(os.path.abspath(__file__))
SCRIPT = os.path.join(FOLDER, "in.extrusion")
BASE = {"n": 20}
HALF = 2.5e-3    # width of the punch
WHERE = {"pressure at 0.1": (0.04, 0.12), "pressure at 0.25": (0.2, 0.32), "pressure at 0.55": (0.48, 0.64)}
COMPARED = {q: ("of the half width, over 2 k (1 + pi/2)", 0.05) for q in WHERE}
ROWS = {"thick": {"variables": {"bottom": 4}, "title": "bottom of 4 half widths", "reference": {q: (1.0, 0.0) for q in COMPARED}},
        "thin": {"variables": {"bottom": 2}, "title": "bottom of 2 half widths", "reference": {"pressure at 0.1": (0.931, 0.005), "pressure at 0.25": (0.901, 0.005),
                                                                                   "pressure at 0.55": (0.827, 0.005)}}}
SETTINGS = {"n_10": {"n": 10}, "n_20": {}, "n_30": {"n": 30}, "not_shifted": {"body": "effects shifting off"},
            "kept": {"lists": "fix rows all adapt/neigh threshold inf"}}
SAID = {"n_10": "10 spacings between punch and wall", "n_20": "20", "n_30": "30", "not_shifted": "20, *effects shifting off*",
        "kept": "20, kept pairs (*threshold inf*)"}
MESH, QUICK = ("n_10", "n_20", "n_30"), "n_10"
SPACING = {"n_10": 3, "n_20": 1.5, "n_30": 1}


def cost(variables):
    return float(variables["bottom"]) * float(variables["n"]) ** 3


def prepare(folder, variables):
    for name, size in (("punch", ("5", "12", "10")), ("wall", ("4", "24", "10")), ("base", ("30", "4", "10"))):
        subprocess.run([sys.executable, os.path.join(case.ROOT, "tools", "make_tool.py"), "block", "--size", *size, "-o",
                        os.path.join(folder, name + ".stl")], check=True, stdout=subprocess.DEVNULL)
    return variables


def measure(result, variables):
    d, t = result.columns("force.dat"), result.thermo[-1]
    found = {q: case.exact(d[(d[:, 1] > lo * HALF) & (d[:, 1] < hi * HALF), 2].mean()) for q, (lo, hi) in WHERE.items()}
    found["numerical fracture"] = case.exact(t["f_body[15]"][-1])
    found["artificial share"] = case.exact(abs(t["f_body[7]"][-1] / t["f_body[8]"][-1]))
    return found
