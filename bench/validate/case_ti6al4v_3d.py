"""The measured cuts of Ti6Al4V of case ti6al4v in three dimensions: a work piece of the measured width of 1 mm, whose sides are free, and
the same cut with an edge inclined by 6 degrees, which was not measured: a prediction, of the passive force too.

What was chosen, before the first run: everything as in case ti6al4v, the three thicknesses at 30 m/min, cuts of 6 thicknesses as the variants
there; chip ratio and temperatures from the 0.2 mm in the middle."""
import os
import subprocess
import sys

import case

EXAMPLE = case.example("orthogonal_ti6al4v")
TITLE = "orthogonal cuts of Ti6Al4V with free sides"
REFERENCE = "measured, Ducobu et al. 2024"
SCRIPT = os.path.join(os.path.dirname(case.script_of("orthogonal_ti6al4v")), "in.ti6al4v_3d")
BASE = {"dx": 10, "run": 50, "length": 6, "width": 1, "speed": 30, "mu": 0.18, "share": 0.55}
COMPARED = {"cutting force": ("N/mm", 0.05), "feed force": ("N/mm", 0.15), "chip ratio": ("", 0.10)}
# uncut chip thickness (um): cutting, feed force (N per mm of width), chip ratio, each with two standard deviations
MEASURED = {40: ((88.4, 16.4), (46.9, 10.0), (1.36, 0.15)), 60: ((118.2, 20.3), (50.3, 9.1), (1.23, 0.09)),
            80: ((153.8, 27.3), (53.0, 12.4), (1.18, 0.08))}
ROWS = {"%d_um" % h: {"variables": {"chip": h}, "title": "%d um, 30 m/min, free sides" % h, "reference": dict(zip(COMPARED, found))}
        for h, found in MEASURED.items()}
ROWS["60_um_oblique"] = {"variables": {"chip": 60, "inclination": 6}, "title": "60 um, 30 m/min, edge inclined by 6 degrees", "reference": {}}
MESH, QUICK = ("dx_10", "dx_6.7", "dx_5"), "dx_10"
SETTINGS = {"dx_10": {}, "dx_6.7": {"dx": 6.6667}, "dx_5": {"dx": 5}}
SAID = {"dx_10": "spacing 10 um", "dx_6.7": "spacing 6.7 um", "dx_5": "spacing 5 um"}
SPACING = {"dx_10": 10, "dx_6.7": 6.6667, "dx_5": 5}
MIDDLE = 200    # um: how much of the width is looked at


def cost(variables):
    return float(variables["chip"]) ** 2 * (float(variables["chip"]) + 160) / float(variables["dx"]) ** 4


def prepare(folder, variables):
    subprocess.run([sys.executable, os.path.join(case.ROOT, "tools", "make_tool.py"), "insert", "--rake", "15", "--clearance", "2", "--radius", "20e-3",
                    "--segments", "12", "--height", "0.6", "--length", "0.5", "--width", "1.6", "-o", os.path.join(folder, "wide.stl")],
                   check=True, stdout=subprocess.DEVNULL)
    return variables


def measure(result, variables):
    found = EXAMPLE.measure(result, variables)
    forces = result.columns("force.dat")
    found["passive force"] = EXAMPLE.mean_of(forces[:, 1], forces[:, 4], forces[-1, 1])
    if "chip ratio by area" in found:
        found["chip ratio by area"] = tuple(v * float(variables["dx"]) / MIDDLE for v in found["chip ratio by area"])
    return found
