"""Orthogonal cutting of C45E (S13 section 5; examples/cutting_c45e), refined at the edge of the tool: the first 1.5 mm
of a small work piece. All particles about the edge are children, mass and energy stay, the force is nearer to that of
fine particles: below the one of the coarse run (by 16 % in the full scene), and of the size of Kienzle's law."""
import os
import sys

import numpy as np

from sphtm_scene import SOURCE, Checks, run

EXAMPLE = os.path.join(SOURCE, "examples", "cutting_c45e")
sys.path.insert(0, EXAMPLE)
import scene                                                                           # noqa: E402

with open(os.path.join(EXAMPLE, "in.cutting_c45e")) as f:
    SCRIPT = f.read().replace("file insert.stl", "file " + os.path.join(EXAMPLE, "insert.stl"))
CUT, DX, SPEED, START, TOP = 1.5e-3, 0.3e-3, 20.0, 5.12e-3, 1e-3
SIZE = {"cut": CUT, "length": 5.1e-3, "below": 2e-3, "speed": SPEED}


def cut(**more):
    """Mean forces (N/mm) of the second half of the cut."""
    result = run(SCRIPT, dict(SIZE, **more))
    done, cutting, passive = scene.forces(result)
    late = (done > 0.5 * done[-1]) & (done < done[-1] - 0.13)    # the rest is smoothed with zeros
    return cutting[late].mean(), passive[late].mean(), result


checks = Checks()
coarse, coarse_passive, first = cut()
cutting, passive, result = cut(adapt=scene.REFINE)
frame, thermo = result.dump("end.dump")[-1], result.thermo[-1]
x, y, mass = frame["x"], frame["y"], frame["mass"]
start, whole = int(first.thermo[0]["Atoms"][0]), first.dump("end.dump")[-1]["mass"]
child = mass < 0.5 * whole.max()
checks.near("mass", mass.sum(), whole.sum(), relative=1e-6)
checks.near("every child has a quarter of it", mass[child].max() / whole.max(), 0.25, relative=1e-6)
checks.near("particles: four for each that was split", child.sum() / 4, start - (~child).sum())
# criteria are looked at every 50 steps: the tool has gone on by as much
edge = START - SPEED * thermo["Time"][-1]
gone = 51 * SPEED * thermo["Dt"][0]
inside = (np.abs(x - edge) < 1.5e-3 - gone) & (y > -1e-3) & (y < 2e-3)
checks.above("particles about the edge", inside.sum(), 100)
checks.true("all of them are children", child[inside].all(), "%d of %d" % (child[inside].sum(), inside.sum()))
# fine particles are 13 % below it, and the force swings by 10 %
checks.near("cutting force against Kienzle, N/mm", cutting, scene.KIENZLE, relative=0.25)
checks.below("cutting force over that of the coarse run", cutting / coarse, 1.0)
checks.below("passive force over that of the coarse run", passive / coarse_passive, 1.0)
checks.above("passive over cutting force", passive / cutting, 0.1)
checks.above("a chip stands above the surface, spacings", (y.max() - TOP) / DX, 1.0)
checks.below("deepest penetration of the tool, spacings", result.columns("force.dat")[:, 5].max(), 0.1)
checks.below("energy sum, drift over the work", np.abs(thermo["f_body[9]"]).max() / (cutting * 1e3 * CUT), 1e-3)
checks.end()
