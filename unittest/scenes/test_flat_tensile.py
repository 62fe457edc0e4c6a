"""The flat specimen of C45E (S13 3.2; examples/flat_tensile_c45e), coarse: with constant h it yields, hardens, and breaks by
itself, which the material does not. ASPH puts that off. A check that the check can fail: up to strain 0.03 it is whole."""
import os
import sys

import numpy as np

from sphtm_scene import SOURCE, Checks, run

EXAMPLE = os.path.join(SOURCE, "examples", "flat_tensile_c45e")
sys.path.insert(0, EXAMPLE)
import scene                                                                           # noqa: E402

SCRIPT = os.path.join(EXAMPLE, "in.flat_tensile_c45e")
checks = Checks()
strain, stress, most = scene.curve(run(SCRIPT, {"rows": 8, "speed": 20}))
top, gone = scene.fracture(strain, stress)
checks.near("stress at strain 0.03 against the flow curve, MPa", 1e-6 * np.interp(0.03, strain, stress),
            1e-6 * scene.flow(0.03), relative=0.15)
checks.true("constant h: breaks before strain 0.2", gone is not None and gone < 0.19, "at %s" % gone)
early = strain < 0.03
checks.true("whole at strain 0.03", scene.fracture(strain[early], stress[early])[1] is None)
_, later = scene.fracture(*scene.curve(run(SCRIPT, {"rows": 8, "speed": 20, "adapt": "asph psi"}))[:2])
checks.true("ASPH: breaks later", later is None or later > gone + 0.005, "at %s" % later)
checks.end()
