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
CUT = 6.0    # length, in units of h as these are
WHERE = {"cut": (0.5, 1.0), "punch": (0.08, 0.16), "block": (0.3, 0.6)}    # of the cut: of its length
SAY = {"cut": "cut, no friction, rake 0", "punch": "smooth flat punch", "block": "block between smooth plates"}
ROWS = {scene: {"variables": {"scene": scene}, "title": SAY[scene], "reference": {q: (1.0, 0.0) for q in COMPARED}} for scene in WHERE}
SETTINGS = {"n_10": {"n": 10}, "n_20": {}, "n_40": {"n": 40}, "artstress": {"n": 10, "options": "stabilize artstress"},
            "hourglass_0": {"n": 10, "options": "hourglass 0"}, "long_10": {"n": 10, "cut": 18}, "long_20": {"cut": 18}, "long_40": {"n": 40, "cut": 18}}
SAID = {"n_10": "10 spacings over h", "n_20": "20", "n_40": "40", "artstress": "10, *stabilize artstress*", "hourglass_0": "10, *hourglass 0*",
        "long_10": "10, cut of 18 thicknesses", "long_20": "20, cut of 18 thicknesses", "long_40": "40, cut of 18 thicknesses"}
MESH, QUICK = ("n_10", "n_20", "n_40"), "n_10"
SPACING = {"n_10": 4, "n_20": 2, "n_40": 1}
H = 0.2e-3


def only(setting):
    return ["cut"] if setting.startswith("long") else list(ROWS)


def cost(variables):
    return float(variables.get("cut", 6)) / 6 * {"cut": 10.0, "punch": 8.0, "block": 1.0}[variables["scene"]] * float(variables["n"]) ** 3


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
    length = float(variables.get("cut", CUT)) if variables["scene"] == "cut" else 1.0
    lo, hi = (H * w * length for w in WHERE[variables["scene"]])
    force = d[(d[:, 1] >= lo) & (d[:, 1] <= hi), 2]
    found = {"force over the closed form": force.mean(), "artificial share": abs(t["f_body[7]"][-1] / t["f_body[8]"][-1])}
    if variables["scene"] == "cut":
        found.update(chip(result.dump("final.dump")[-1], H / float(variables["n"])))
    return {name: case.exact(value) for name, value in found.items()}


def chip(end, dx):
    """Thickness of the chip over that of the cut, between half a thickness and one and a half above the surface of the work, and its plastic strain;
    force and strain of one shear plane that makes such a chip (Merchant; the closed form is that of a thickness of 1)."""
    part = (end["y"] > 0.5 * H) & (end["y"] < 1.5 * H)
    r = part.sum() * dx**2 / H**2
    return {"thickness of the chip": r, "plastic strain of the chip": end["c_p[2]"][part].mean(),
            "force of a shear plane for this thickness": (r + 1 / r) / 2, "strain of a shear plane for this thickness": (r + 1 / r) / 3**0.5}
