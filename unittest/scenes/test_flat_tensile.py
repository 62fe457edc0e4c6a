"""The flat specimen of C45E (S13 3.2; examples/flat_tensile_c45e), coarse: bare, with constant h, it breaks by itself, which
the material does not: rows that are never searched again show its path. With hourglass resistance ASPH follows the path to
strain 0.15 and is whole at 0.2. Counter-cases: bare, ASPH breaks as well; and up to strain 0.03 the bare specimen is whole
and on the path, so that the checks tell the two apart."""
import os
import sys

import numpy as np

from sphtm_scene import SOURCE, Checks, run

EXAMPLE = os.path.join(SOURCE, "examples", "flat_tensile_c45e")
sys.path.insert(0, EXAMPLE)
import scene                                                                           # noqa: E402

SCRIPT = os.path.join(EXAMPLE, "in.flat_tensile_c45e")
checks = Checks()
curves = {row: scene.curve(run(SCRIPT, dict(scene.ROWS[row], rows=8, speed=20)))[:2]
          for row in ("path", "constant", "asph", "asph_resisted")}
path = curves["path"]
checks.near("path: stress at strain 0.03 against the flow curve, MPa", 1e-6 * np.interp(0.03, *path), 1e-6 * scene.flow(0.03),
            relative=0.1)
checks.true("path: whole at the end", scene.fracture(*path)[1] is None)
strain, stress = curves["constant"]
for row in ("constant", "asph"):
    gone = scene.fracture(*curves[row])[1]
    checks.true("%s, bare: breaks before strain 0.1" % row, gone is not None and gone < 0.1, "at %s" % gone)
early = strain < 0.03
checks.true("whole at strain 0.03", scene.fracture(strain[early], stress[early])[1] is None)
checks.true("on the path at strain 0.03", scene.leaves(strain[early], stress[early], path) is None)
strain, stress = curves["asph_resisted"]
checks.above("ASPH, resisted: strain at the end", strain[-1], 0.198)
checks.true("ASPH, resisted: whole there", scene.fracture(strain, stress)[1] is None)
checks.near("ASPH, resisted: stress at strain 0.15 against the path, MPa", 1e-6 * np.interp(0.15, strain, stress),
            1e-6 * np.interp(0.15, *path), relative=0.02)
bare = np.interp(0.09, *curves["constant"]) / np.interp(0.09, *path)
checks.below("counter-case: bare at strain 0.09, of the stress on the path", bare, 0.5)
checks.end()
