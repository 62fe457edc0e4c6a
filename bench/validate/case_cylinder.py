"""A cylinder of perfectly plastic metal, as high as it is wide, upset to half of its height between plates with friction. Forces are over
F = Y A (1 + 2 mu R/(3 h)), with A h the volume and A = pi R^2: exact without friction, and the slab method's estimate with it. With friction a cylinder as high
as this barrels, and its side folds onto the plates, which that leaves out: there the reference is rigid_plastic.py, with 24 and 48 squares.

What was chosen: Y = 400 MPa, plates at 10 m/s each; the default and kept pairs. Means over 2 % of the height about each reduction."""
import os
import subprocess
import sys

import case
import numpy as np

TITLE = "upsetting of a cylinder with friction"
REFERENCE = "closed form; with friction finite elements"
FOLDER = os.path.dirname(os.path.abspath(__file__))
SCRIPT = os.path.join(FOLDER, "in.cylinder")
BASE = {"rows": 14}
HEIGHT, Y = 14e-3, 400e6
FORCES = {"force at %d %%" % r: r for r in (10, 20, 30, 40, 50)}
COMPARED = {q: ("over that of the slab method", 0.05) for q in FORCES}
REFERENCES = {0: [(1.0, 0.0)] * 5, 0.1: [(f, 0.003) for f in (0.989, 0.982, 0.979, 0.979, 0.985)],
              0.3: [(0.924, 0.003), (0.911, 0.004), (0.885, 0.015), (0.873, 0.015), (0.897, 0.01)]}
ROWS = {"mu_%g" % mu: {"variables": {"mu": mu}, "title": "friction %g" % mu, "reference": dict(zip(COMPARED, known))} for mu, known in REFERENCES.items()}
SETTINGS = {"rows_10": {"rows": 10}, "rows_14": {}, "rows_20": {"rows": 20}, "kept_14": {"lists": "fix rows all adapt/neigh threshold inf"},
            "artstress_14": {"options": "stabilize artstress"}}
SAID = {"rows_10": "10 rows", "rows_14": "14", "rows_20": "20", "kept_14": "14 rows, kept pairs (*threshold inf*)", "artstress_14": "14 rows, *stabilize artstress*"}
MESH, QUICK = ("rows_10", "rows_14", "rows_20"), "rows_10"
SPACING = {"rows_10": 1.4, "rows_14": 1, "rows_20": 0.7}


def cost(variables):
    return float(variables["rows"]) ** 4


def prepare(folder, variables):
    subprocess.run([sys.executable, os.path.join(case.ROOT, "tools", "make_tool.py"), "block", "--size", "42", "42", "10", "-o",
                    os.path.join(folder, "plate.stl")], check=True, stdout=subprocess.DEVNULL)
    return variables


def measure(result, variables):
    d, t = result.columns("force.dat"), result.thermo[-1]
    height, force, area = d[:, 2], d[:, 3], d[0, 4] / d[:, 2]
    force = force / (Y * area * (1 + 2 * float(variables["mu"]) * np.sqrt(area / np.pi) / (3 * height)))
    found = {q: case.exact(force[abs(1 - height / HEIGHT - 0.01 * r) < 0.01].mean()) for q, r in FORCES.items()}
    found.update({"numerical fracture": case.exact(t["f_body[15]"][-1]),
                  "artificial share": case.exact(abs(t["f_body[7]"][-1] / t["f_body[8]"][-1]))})
    return found
