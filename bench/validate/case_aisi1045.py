"""Orthogonal cuts of AISI 1045: forces and the temperature of the rake face.

Measured for the Assessment of Machining Models (Ivester et al. 2000, NIST): tubes of 1.6 mm wall, K68 carbide, 200 m/min, rake -7 and +5
degrees, uncut thickness 0.15 and 0.3 mm. The numbers are second-hand: file validation.csv beside Xia and Gillespie 2019 (J. Mater. Process. Technol.,
doi 10.1016/j.jmatprotec.2019.116389), which prints no unit of the temperature (read as C, as its programs are), no scatter and no method, and
whose other four rows have a speed that does not fit their own strain rates and are left out. So this compares forces as far as the unknown
friction and edge allow, and brackets the temperature.

What was chosen, before the first run: card c45e (Jaspers 1999); friction 0.5, at most the shear flow stress; edge radius 20 um; heat of friction into
the chip alone and no heat into the tool, which has long been hot where such cuts are measured: an upper bound; the variant has a tool that stays at
293 K in perfect contact: a lower one. Cuts of 10 uncut thicknesses at 50 m/s with time scaled, means over the last half; 300 um below the cut."""
import math
import os
import subprocess
import sys

import case

EXAMPLE = case.example("orthogonal_ti6al4v")
TITLE = "orthogonal cuts of AISI 1045"
REFERENCE = "measured, Ivester et al. 2000, second-hand"
WIDTH = 1.6     # mm
with open(case.script_of("orthogonal_ti6al4v")) as f:
    SCRIPT = "variable below index 300\nvariable lead index 0\n" + f.read().replace("$(v_L+1e-7)", "$(v_L+1e-7+1e-6*v_lead)").replace("0.16e-3", "1e-6*v_below").replace("0.14e-3", "1e-6*(v_below-40)").replace(
        "$(-v_h-0.3e-3)", "$(-v_h-1e-6*v_below-0.14e-3)")
BASE = {"dx": 10, "run": 50, "length": 10, "speed": 200, "mu": 0.5, "share": 1, "material": "materials.sphtm c45e", "contact": "heat none friction/shear 1"}
COMPARED = {"cutting force": ("N/mm", 0.1), "feed force": ("N/mm", 0.15), "rake face, mean temperature": ("K", 0.1)}
# uncut thickness (um), rake (degrees): cutting, feed force (N), temperature (C)
MEASURED = {(150, -7): (610, 450, 1130), (150, 5): (585, 385, 1240), (300, -7): (1150, 600, 1120), (300, 5): (920, 450, 1240)}
ROWS = {"%d_um_rake_%d" % key: {"variables": {"chip": key[0], "rake": key[1]}, "title": "%d um, rake %d" % key, "reference": dict(
    zip(COMPARED, ((m[0] / WIDTH, 0.0), (m[1] / WIDTH, 0.0), (m[2] + 273.0, 0.0))))} for key, m in MEASURED.items()}
SETTINGS = {"dx_20": {"dx": 20}, "dx_15": {"dx": 15}, "dx_10": {}, "cold_tool": {"dx": 15, "contact": "heat perfect temperature 293 friction/shear 1"},
            "friction_0.3": {"dx": 15, "mu": 0.3}}
SAID = {"dx_20": "20 um", "dx_15": "15 um", "dx_10": "10 um", "cold_tool": "15 um, tool that stays at 293 K, perfect contact",
        "friction_0.3": "15 um, friction 0.3"}
MESH, QUICK = ("dx_20", "dx_15", "dx_10"), "dx_20"
SPACING = {"dx_20": 20, "dx_15": 15, "dx_10": 10}


def cost(variables):
    return float(variables["chip"]) ** 2 * (float(variables["chip"]) + 300) / float(variables["dx"]) ** 3


def prepare(folder, variables):
    subprocess.run([sys.executable, os.path.join(case.ROOT, "tools", "make_tool.py"), "insert", "--rake", str(variables["rake"]), "--clearance", "6", "--radius",
                    "0.02", "--segments", "8", "--height", "3", "--length", "3", "--width", "1", "-o", os.path.join(folder, "insert.stl")],
                   check=True, stdout=subprocess.DEVNULL)
    return dict({k: v for k, v in variables.items() if k != "rake"}, lead=lead(variables))


def lead(variables):
    """A rake face that leans forward starts clear of the work piece: by how much the edge lies behind, um."""
    return round(max(0.0, -math.tan(math.radians(float(variables["rake"])))) * 1.2 * float(variables["chip"]), 3)


def measure(result, variables):
    return EXAMPLE.measure(result, dict(variables, lead=lead(variables)), float(variables["rake"]))
