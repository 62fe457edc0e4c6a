"""The notched specimen of Spreng 2013 within its elastic range, plane strain, against finite elements (CalculiX; the halving of its
elements changes the profile by 0.001).

What was chosen: the default of the pair style; the profile of von Mises stress along the ligament over the mean axial stress there,
read at the axis, at 2 mm, and 0.6 mm from the root of the notch (3.1 mm) as means over 0.3 mm; the stiffness as mean axial stress over E
times the mean strain."""
import numpy as np

import case

SCENE = case.example("notched_specimen", "scene")
FINITE = SCENE.finite_elements()
WIDTH, PLACES = 0.3e-3, {"at the axis": 0.15e-3, "at 2 mm": 2.0e-3, "0.6 mm from the root": 3.1e-3}
with open(case.os.path.join(case.ROOT, "examples", "notched_specimen", "ligament.csv")) as f:
    STIFFNESS = float(f.read().split("mean strain: ")[1].split()[0])


def mean_at(x, s, place):
    """Over a window around a place; the finite elements are averaged over it too."""
    return float(s[np.abs(x - place) < 0.5 * WIDTH].mean())


FINE = np.linspace(0, FINITE[-1, 0], 4000)
TITLE = "notched specimen, elastic"
REFERENCE = "finite elements"
SCRIPT = case.script_of("notched_specimen")
BASE = {"columns": 90}
COMPARED = dict({"von Mises stress " + p: ("over the mean", 0.02) for p in PLACES}, **{"stiffness": ("", 0.02)})
ROWS = {"s13": {"variables": {}, "title": "specimen", "reference": dict(
    {"von Mises stress " + p: (mean_at(FINE, np.interp(FINE, FINITE[:, 0], FINITE[:, 1]), at), 0.0) for p, at in PLACES.items()},
    stiffness=(STIFFNESS, 0.0))}}
SETTINGS = {"columns_45": {"columns": 45}, "columns_90": {}, "columns_180": {"columns": 180},
            "kept": {"adapt": "threshold inf"}, "artstress": {"options": "stabilize artstress"}}
SAID = {"columns_45": "45 particles over the width", "columns_90": "90", "columns_180": "180", "kept": "90, pairs that are kept",
        "artstress": "90, *stabilize artstress*"}
MESH, QUICK = ("columns_45", "columns_90", "columns_180"), "columns_45"
SPACING = {"columns_45": 4, "columns_90": 2, "columns_180": 1}


def cost(variables):
    return float(variables["columns"]) ** 3


def measure(result, variables):
    x, s, nominal, _ = SCENE.profile(result, float(variables["columns"]))
    found = {"von Mises stress " + p: case.exact(mean_at(x, s, at)) for p, at in PLACES.items()}
    return dict(found, stiffness=case.exact(nominal / (205e9 * 1e-5)))
