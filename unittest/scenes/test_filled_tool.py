"""A tool that is filled with particles: friction heat goes into them with lists of fix adapt/neigh as with LAMMPS's, to the last bit; a filling
that is not in the tool's group is an error, since it would stay behind."""
import os

import numpy as np

from sphtm_scene import SOURCE, Checks, run

checks = Checks()
EXAMPLE = os.path.join(SOURCE, "examples", "tool_heat")
with open(os.path.join(EXAMPLE, "in.tool_heat")) as f:
    script = f.read().replace("file tool.stl", "file " + os.path.join(EXAMPLE, "tool.stl"))
body = next(line for line in script.split("\n") if line.startswith("fix             body"))
variables = {"n": 6, "t_end": 1e-6}
found = {}
for name, line in (("LAMMPS's list", ""), ("searched lists", "fix lists all adapt/neigh threshold 0 margin 0.15")):
    r = run(script.replace(body, body + "\n" + line), variables)
    d = r.dump("temperature_particles.dump")[-1]
    order = np.argsort(d["id"])
    found[name] = {c: d[c][order] for c in ("id", "y", "c_T")}
    tool = d["type"] == 2
    checks.above("%s: hottest particle of the tool, K" % name, d["c_T"][tool].max(), 300.1)
a, b = found.values()
checks.true("the same bits with both", all(np.array_equal(a[c], b[c]) for c in a), "largest difference %g K" % np.abs(a["c_T"] - b["c_T"]).max())

tool = next(line for line in script.split("\n") if line.startswith("fix             tool"))
r = run(script.replace(tool, tool.replace("tool all", "tool work")), variables, expect_error=True)
checks.true("a filling that is not in the group is refused", 0 < r.status < 128 and "particles 2: " in r.errors() and "not in its group work" in r.errors()
            and "type 2" in r.errors(), r.errors()[:300])
checks.end()
