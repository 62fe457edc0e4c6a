"""A spinning block of rubber, ten turns in plane strain, corners at 0.05 of the bulk speed of sound: angular momentum, spin and energy stay.

What was chosen: the scene of unittest/scenes/test_spinning_block.py; the defaults of the pair style."""
import case

TEST = case.module(case.os.path.join(case.ROOT, "unittest", "scenes", "test_spinning_block.py"))
TITLE = "spinning block, ten turns"
REFERENCE = "conservation"
SCRIPT = TEST.SCRIPT.replace("variable        dx equal 0.1/20", "variable        dx equal 0.1/v_n")
BASE = {"n": 20, "tip": 0.05, "style": ""}
COMPARED = {"angular momentum left": ("", 1e-4), "kinetic energy left": ("", 0.01)}
ROWS = {"block": {"variables": {}, "title": "block", "reference": {q: (1.0, 0.0) for q in COMPARED}}}
SETTINGS = {"n_10": {"n": 10}, "n_20": {}, "n_40": {"n": 40}, "artstress": {"style": "stabilize artstress"}}
SAID = {"n_10": "10 rows", "n_20": "20", "n_40": "40", "artstress": "20, *stabilize artstress*"}
MESH, QUICK = ("n_10", "n_20", "n_40"), "n_10"
SPACING = {"n_10": 4, "n_20": 2, "n_40": 1}


def cost(variables):
    return float(variables["n"]) ** 3


def measure(result, variables):
    t = result.thermo[-1]
    return {"angular momentum left": case.exact(t["v_lz"][-1] / t["v_lz"][0]), "kinetic energy left": case.exact(t["f_body[1]"][-1] / t["f_body[1]"][0]),
            "turns": case.exact(t["v_turn"][-1]), "artificial share": case.exact(t["f_body[7]"][-1] / t["f_body[1]"][0])}
