"""The flat specimen of C45E (S13 3.2; examples/flat_tensile_c45e), coarse: with constant h it yields, hardens, and breaks by
itself, which the material does not: rows that are never searched again show its path. ASPH follows it to strain 0.15 and
does not break there. A check that the check can fail: up to strain 0.03 the specimen with constant h is whole and on the path."""
import os
import sys

import numpy as np

from sphtm_scene import SOURCE, Checks, run

EXAMPLE = os.path.join(SOURCE, "examples", "flat_tensile_c45e")
sys.path.insert(0, EXAMPLE)
import scene                                                                           # noqa: E402

SCRIPT = os.path.join(EXAMPLE, "in.flat_tensile_c45e")
checks = Checks()
curves = {row: scene.curve(run(SCRIPT, dict(scene.ROWS[row], rows=8, speed=20)))[:2] for row in ("path", "constant", "asph")}
checks.near("path: stress at strain 0.03 against the flow curve, MPa", 1e-6 * np.interp(0.03, *curves["path"]),
            1e-6 * scene.flow(0.03), relative=0.1)
checks.true("path: whole at the end", scene.fracture(*curves["path"])[1] is None)
strain, stress = curves["constant"]
_, gone = scene.fracture(strain, stress)
checks.true("constant h: breaks before strain 0.2", gone is not None and gone < 0.198, "at %s" % gone)
early = strain < 0.03
checks.true("whole at strain 0.03", scene.fracture(strain[early], stress[early])[1] is None)
checks.true("on the path at strain 0.03", scene.leaves(strain[early], stress[early], curves["path"]) is None)
_, later = scene.fracture(*curves["asph"])
checks.true("ASPH: breaks later, or not", later is None or later > gone + 0.005, "at %s" % later)
checks.near("ASPH: stress at strain 0.15 against the path, MPa", 1e-6 * np.interp(0.15, *curves["asph"]),
            1e-6 * np.interp(0.15, *curves["path"]), relative=1 - scene.LEFT)
checks.end()
