"""Two layers that conduct differently, brought together: temperatures against the closed form (REFERENCE: erf, shown in
examples/two_layer_heat/measure.py). What was chosen: layers, times and particles as in the table of the example; both layers end where no heat has come."""
import numpy as np

import case

EXAMPLE = case.example("two_layer_heat")
TITLE = "two layers, conduction"
REFERENCE = "closed form"
SCRIPT = case.script_of("two_layer_heat")
BASE = {"n": 400}
LAYERS = {1: (0.5, 5e-3), 10: (0.3, 1e-3), 100: (0.2, 1e-4), 1000: (0.2, 3e-5)}    # ratio: length of the left one (m), time (s)
# depths where temperatures are compared, in diffusion lengths of either side
DEPTHS = {"temperature, half a diffusion length left": -0.5, "half a diffusion length right": 0.5, "heat that has crossed": None}
COMPARED = dict({q: ("K above the cold side", 0.01) for q in list(DEPTHS)[:2]}, **{"heat that has crossed": ("J/m2", 0.01)})


def place(depth, ratio, t):
    return depth * np.sqrt(4 * (ratio if depth > 0 else 1) * t)


def exact_of(ratio, t):
    found = {q: float(EXAMPLE.exact(np.array(place(d, ratio, t)), ratio, t)) - EXAMPLE.COLD for q, d in DEPTHS.items() if d}
    e = np.sqrt(ratio)
    found["heat that has crossed"] = 2 * e / (1 + e) * (EXAMPLE.HOT - EXAMPLE.COLD) * np.sqrt(t / np.pi)
    return {q: (float(v), 0.0) for q, v in found.items()}


ROWS = {"ratio_%d" % r: {"variables": {"ratio": r, "left": left, "t_end": t}, "title": "conductivities 1 : %d" % r, "reference": exact_of(r, t)}
        for r, (left, t) in LAYERS.items()}
SETTINGS = {"n_200": {"n": 200}, "n_400": {}, "n_800": {"n": 800}}
SAID = {"n_200": "200 particles", "n_400": "400", "n_800": "800"}
MESH, QUICK = ("n_200", "n_400", "n_800"), "n_200"
SPACING = {"n_200": 4, "n_400": 2, "n_800": 1}


def measure(result, variables):
    frame, ratio, t = result.dump("temperature.dump")[-1], float(variables["ratio"]), result.thermo[-1]["Time"][-1]
    # the run ends with the step after t_end: sums of a step's length are taken back with the closed form of both times
    asked, order = float(variables["t_end"]), np.argsort(frame["x"])
    x, T = frame["x"][order], frame["c_T"][order]
    found = {q: float(np.interp(place(d, ratio, t), x, T)) - EXAMPLE.COLD for q, d in DEPTHS.items() if d}
    found["heat that has crossed"] = float((T[x < 0] - EXAMPLE.COLD).sum() / float(variables["n"]) * np.sqrt(asked / t))
    return dict({q: case.exact(v) for q, v in found.items()}, largest=case.exact(EXAMPLE.error(frame, ratio, t).max()))
