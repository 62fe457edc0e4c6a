"""Perfectly plastic flow in plane strain, for which slip-line theory has the force: an orthogonal cut without friction (Lee and Shaffer 1951,
rake 0: 2 k h, and the momentum of the chip), a smooth flat punch on a half space (Prandtl 1920, Hill 1950: (2 + pi) k), a block between
smooth plates (2 k). k = Y/sqrt(3), elastic constants of steel, no heat: nothing softens, no constant is uncertain.

What was chosen, before the first run: the defaults of the pair style; tools at 20 m/s in the cut and 4 m/s elsewhere; means over the last half of
a cut of 6 thicknesses, over 0.08 to 0.16 half widths of penetration, and over 15 to 30 % of the height."""
import os
import subprocess
import sys

import case

TITLE = "perfectly plastic flow"
REFERENCE = "slip-line theory"
FOLDER = os.path.dirname(os.path.abspath(__file__))
SCRIPT = os.path.join(FOLDER, "in.slip_line")
FILES = [os.path.join(FOLDER, "in.slip_line_" + scene) for scene in ("cut", "punch", "block")]
BASE = {"n": 20}
COMPARED = {"force over the closed form": ("", 0.05)}
WHERE = {"cut": (3.0, 6.0), "punch": (0.08, 0.16), "block": (0.3, 0.6)}    # in units of h
SAY = {"cut": "cut, no friction, rake 0", "punch": "smooth flat punch", "block": "block between smooth plates"}
ROWS = {scene: {"variables": {"scene": scene}, "title": SAY[scene], "reference": {q: (1.0, 0.0) for q in COMPARED}} for scene in WHERE}
SETTINGS = {"n_10": {"n": 10}, "n_20": {}, "n_40": {"n": 40}, "artstress": {"n": 10, "options": "stabilize artstress"},
            "hourglass_0": {"n": 10, "options": "hourglass 0"}}
SAID = {"n_10": "10 spacings over h", "n_20": "20", "n_40": "40", "artstress": "10, *stabilize artstress*", "hourglass_0": "10, *hourglass 0*"}
MESH, QUICK = ("n_10", "n_20", "n_40"), "n_10"
SPACING = {"n_10": 4, "n_20": 2, "n_40": 1}
H = 0.2e-3


def cost(variables):
    return {"cut": 10.0, "punch": 8.0, "block": 1.0}[variables["scene"]] * float(variables["n"]) ** 3


def prepare(folder, variables):
    def tool(*words):
        subprocess.run([sys.executable, os.path.join(case.ROOT, "tools", "make_tool.py")] + list(words), check=True, stdout=subprocess.DEVNULL)

    tool("insert", "--rake", "0", "--clearance", "7", "--radius", "0", "--height", "3", "--length", "2", "--width", "2", "-o",
         os.path.join(folder, "insert.stl"))
    tool("block", "--size", "0.4", "2", "2", "-o", os.path.join(folder, "punch.stl"))
    tool("block", "--size", "8", "2", "2", "-o", os.path.join(folder, "plate.stl"))
    return variables


def measure(result, variables):
    d = result.columns("force.dat")
    t = result.thermo[-1]
    lo, hi = (H * w for w in WHERE[variables["scene"]])
    found = d[(d[:, 1] >= lo) & (d[:, 1] <= hi), 2]
    return {"force over the closed form": case.exact(found.mean()), "artificial share": case.exact(abs(t["f_body[7]"][-1] / t["f_body[8]"][-1]))}
