"""A block on a slope of 20 degrees: it stays below the friction angle, and slides with g (sin a - mu cos a) above it.

What was chosen: the example's block; the defaults of the pair style, and as a variant the options that the example takes, since an elastic
block without damping of its own flutters as it slides."""
import os

import case

EXAMPLE = case.example("block_on_slope")
TITLE = "block on a slope"
REFERENCE = "closed form"
SCRIPT = case.script_of("block_on_slope")
FILES = [os.path.join(os.path.dirname(SCRIPT), "slope.stl")]
BASE = {"options": ""}
COMPARED = {"acceleration": ("m/s2", 0.03)}
ROWS = {"share_%g" % s: {"variables": {"share": "%g" % s}, "title": "friction %g tan a" % s, "reference": {"acceleration": (EXAMPLE.theory(s), 0.0)}}
        for s in (0.0, 0.7, 0.98)}
ROWS["share_1.02"] = {"variables": {"share": 1.02}, "title": "friction 1.02 tan a: it stays", "reference": {}}
SETTINGS = {"base": {}, "artstress": {"options": "stabilize artstress"}}
SAID = {"base": "default", "artstress": "*stabilize artstress*, as the example has it"}
MESH, QUICK, SPACING = ("base",), "base", {"base": 1}


def measure(result, variables):
    time, way = result.columns("way_%g.dat" % float(variables["share"]))[:, 1:3].T
    return {"acceleration": case.exact(EXAMPLE.acceleration(time, way))}
