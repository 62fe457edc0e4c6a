"""High speed machining of AL 6082-T6 (Fraser et al. 2015): what heat changes.

F15 prints neither geometry nor forces, but their deviation from an experiment (Villumsen and Fauerholdt 2008): +12.5 % without heat and
-3.9 % with heat, so the ratio 0.854, and 376 C as the mean of the maximum interface temperature.

What was chosen: geometry and constants of examples/high_speed_machining, with where each is from; means from 1 to 4 mm of cut, and up to
1.75 mm, F15's figure; the defaults of the pair style. Variants are the spread of what F15 leaves open: friction, conduction scaled along with the
velocity, and the stand-in for its material (yield and hardening 10 % up and down)."""
import os

import case

EXAMPLE = case.example("high_speed_machining")
TITLE = "high speed machining of AL 6082-T6"
REFERENCE = "Fraser et al. 2015"
SCRIPT = case.script_of("high_speed_machining")
FILES = [os.path.join(os.path.dirname(SCRIPT), "insert.stl")]
BASE = {"dp": 2e-4, "cut": 4e-3}
COMPARED = {"force with heat over without, 1 to 4 mm": ("", 0.05), "the same to 1.75 mm": ("", 0.05), "interface temperature": ("C", 0.1),
            "force with heat": ("N", 0.05), "force without": ("N", 0.05)}
ROWS = {"f15": {"variables": {}, "title": "F15", "reference": {
    "force with heat over without, 1 to 4 mm": (0.854, 0.0), "the same to 1.75 mm": (0.854, 0.0), "interface temperature": (376.0, 0.0)}}}
CARD = "materials.sphtm al6082-t6 set jc_c 0"
SETTINGS = {"dp_0.2": {}, "dp_0.1": {"dp": 1e-4}, "dp_0.05": {"dp": 5e-5, "cut": 1.75e-3},
            "friction_0.1": {"mu": 0.1}, "friction_0.3": {"mu": 0.3}, "conduction": {"body": "time/scale 5"},
            "stronger": {"material": CARD + " set jc_a 470.8e6 set jc_b 359.7e6"}, "weaker": {"material": CARD + " set jc_a 385.2e6 set jc_b 294.3e6"},
            "artstress": {"options": "stabilize artstress balsara yes"}}
SAID = {"dp_0.2": "0.2 mm", "dp_0.1": "0.1 mm", "dp_0.05": "0.05 mm", "friction_0.1": "0.2 mm, friction 0.1", "friction_0.3": "0.2 mm, friction 0.3",
        "conduction": "0.2 mm, conduction scaled along (*time/scale 5*)", "stronger": "0.2 mm, A and B 10 % up", "weaker": "0.2 mm, A and B 10 % down",
        "artstress": "0.2 mm, *stabilize artstress balsara yes*"}
MESH, QUICK = ("dp_0.2", "dp_0.1", "dp_0.05"), "dp_0.2"
SPACING = {"dp_0.2": 4, "dp_0.1": 2, "dp_0.05": 1}


def cost(variables):
    return float(variables["cut"]) * float(variables["dp"]) ** -4


def make(run, variables):
    return [run(dict(variables, heat=heat), below=name) for heat, name in (("yes", "heat"), ("no", "no_heat"))]


def measure(results, variables):
    heat, none = (EXAMPLE.Run(r.folder, float(variables["dp"])) for r in results)
    cut, hot = heat.interface()
    found = {"the same to 1.75 mm": heat.mean("fx", 0.0, 1.75)[0] / none.mean("fx", 0.0, 1.75)[0], "interface temperature": hot.mean()}
    if float(variables["cut"]) > 3.9e-3:
        with_heat, without = heat.mean("fx", 1.0)[0], none.mean("fx", 1.0)[0]
        found.update({"force with heat over without, 1 to 4 mm": with_heat / without, "force with heat": with_heat, "force without": without,
                      "tangential force, heat less no heat": heat.mean("fy", 1.0)[0] - none.mean("fy", 1.0)[0]})
    for name, r in (("with heat", heat), ("without", none)):
        found["artificial share " + name] = -r.h["artificial"][-1] / r.h["external"][-1]
    return {k: case.exact(v) for k, v in found.items()}
