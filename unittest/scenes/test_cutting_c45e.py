"""Orthogonal cutting of C45E (S13 section 5; examples/cutting_c45e), the first 4 mm of a coarse cut: a step, then a level near
Kienzle's 2220 N/mm. Counter-case: at half the depth the force is near half."""
import os
import sys

import numpy as np

from sphtm_scene import SOURCE, Checks, run

EXAMPLE = os.path.join(SOURCE, "examples", "cutting_c45e")
sys.path.insert(0, EXAMPLE)
import scene                                                                           # noqa: E402

checks = Checks()
with open(os.path.join(EXAMPLE, "in.cutting_c45e")) as f:
    SCRIPT = f.read().replace("file insert.stl", "file " + os.path.join(EXAMPLE, "insert.stl"))


def level(**more):
    """Mean forces (N/mm) of the second half of the cut, and of its first tenth of a millimetre."""
    result = run(SCRIPT, dict({"cut": 3e-3, "length": 7e-3, "speed": 20}, **more))
    done, cutting, passive = scene.forces(result)
    late = done > 0.5 * done[-1]
    return cutting[late].mean(), passive[late].mean(), result


cutting, passive, result = level()
checks.near("cutting force against Kienzle, N/mm", cutting, scene.KIENZLE, relative=0.12)
checks.above("passive force, N/mm", passive, 0.1 * cutting)
checks.below("passive over cutting force", passive / cutting, 0.6)
frame = result.dump("end.dump")[-1]
checks.above("a chip stands above the surface, mm", 1e3 * frame["y"].max(), 1.8)
checks.below("deepest penetration of the tool, spacings", result.columns("force.dat")[:, 5].max(), 0.1)
checks.below("energy sum, drift over the work", np.abs(result.thermo[-1]["f_body[9]"]).max() / (cutting * 1e3 * 3e-3), 1e-3)
shallow, _, _ = level(depth=0.6e-3)
checks.below("counter-case, depth 0.6 mm: force over that at 1 mm", shallow / cutting, 0.85)
checks.end()
