"""The bullet through the plate (F14; examples/bullet_plate), with 3 particles over the plate: it goes through,
LAMMPS's skin list and rows with a margin give the velocity of a list made anew in every step, kept rows give it within
1 %. Counter-case: at 150 m/s the plate stops it."""
import os
import re

import numpy as np

from sphtm_scene import SOURCE, Checks, run

SCRIPT = os.path.join(SOURCE, "examples", "bullet_plate", "in.bullet_plate")
SMALL = {"n": 3, "thick": 9e-3, "end": 1.5e-4, "width": 72e-3}
checks = Checks()


def residual(shifting=True, **more):
    with open(SCRIPT) as f:
        script = f.read()
    if not shifting:
        script = re.sub("(?m)^(fix +body all sph/tm.*)$", r"\1 effects shifting off", script)
        checks.true("shifting is off", "effects shifting off" in script)
    result = run(script, dict(SMALL, **more))
    return result.columns("velocity.dat")[-1, 2], result


skin, result = residual()
every, _ = residual(search="every")
checks.near("residual velocity: skin list against every step, m/s", skin, every, relative=0.01)
margin, _ = residual(adapt="threshold 0 margin 0.15")
checks.near("rows with a margin against every step", margin, every, relative=1e-12)
kept, adapted = residual(adapt="threshold 1e-5")    # these lists keep pairs, so nothing is shifted
stays, _ = residual(shifting=False, search="every")
checks.near("residual velocity: threshold 1e-5 against every step, not shifted", kept, stays, relative=0.02)
t = adapted.thermo[-1]
checks.below("threshold 1e-5: searches per particle and step", t["f_lists[2]"][-1] / t["Step"][-1], 0.8)
checks.above("it goes through at, m/s", skin, 60.0)
checks.below("and has lost speed", skin, 300.0)
t = result.thermo[-1]
checks.below("energy sum, drift over the energy of the bullet", np.abs(t["f_body[9]"] / t["f_body[9]"][0] - 1).max(),
             0.01)
slow, _ = residual(speed=150)
checks.below("counter-case, a bullet at 150 m/s: velocity, m/s", slow, 30.0)
checks.end()
