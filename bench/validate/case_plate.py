"""The oscillating plate of Gray, Monaghan and Swift 2001, in plane strain: the period of its first mode.

Reference: linear finite elements with the base inserted into a wall that holds its faces, 0.2621 s. Published SPH has 0.283 to 0.285 s
(updated Lagrangian) and 0.2745 s (total Lagrangian).

What was chosen: an amplitude of 0.001 of the speed of sound, at which the plate is linear; Wendland's C4 kernel, as the example has it; the
kernel of all other scenes, hyperbolic 1.2, is a variant."""
import numpy as np

import case

TITLE = "oscillating plate"
REFERENCE = "finite elements"
SCRIPT = case.script_of("oscillating_plate")
BASE = {"rows": 20}
COMPARED = {"period": ("s", 0.01)}
ROWS = {"gray_2001": {"variables": {}, "title": "plate", "reference": {"period": (0.2621, 0.0)}}}
SETTINGS = {"rows_6": {"rows": 6}, "rows_10": {"rows": 10}, "rows_20": {}, "rows_40": {"rows": 40}, "hyperbolic_10": {"rows": 10, "kernel": "hyperbolic 1.2"},
            "hyperbolic_20": {"kernel": "hyperbolic 1.2"}, "artstress": {"rows": 10, "end": 0.36, "options": "stabilize artstress"}}
SAID = {"rows_6": "6 rows", "rows_10": "10", "rows_20": "20", "rows_40": "40", "hyperbolic_10": "10 rows, *hyperbolic 1.2*", "hyperbolic_20": "20 rows, *hyperbolic 1.2*",
        "artstress": "10 rows, *stabilize artstress*"}
MESH, QUICK = ("rows_6", "rows_10", "rows_20", "rows_40"), "rows_6"
SPACING = {"rows_6": 1 / 6, "rows_10": 1 / 10, "rows_20": 1 / 20, "rows_40": 1 / 40}


def cost(variables):
    return float(variables["rows"]) ** 3


def measure(result, variables):
    """Time of the second return to the middle; where the run ends before it, twice that of the first."""
    tip, t = result.columns("tip.dat"), result.thermo[-1]
    time, height = tip[:, 1], tip[:, 2] - tip[0, 2]
    k = np.nonzero(height[1:] * height[:-1] < 0)[0]
    zero = time[k] + height[k] * (time[k + 1] - time[k]) / (height[k] - height[k + 1])
    return {"period": case.exact(zero[1] if len(zero) > 1 else 2 * zero[0]),
            "drift of the energy sum": case.exact(np.ptp(t["f_body[9]"]) / t["f_body[1]"][0])}
