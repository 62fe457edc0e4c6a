"""Two layers that conduct differently, against the closed form: the scene of examples/two_layer_heat."""
import os
import sys

import numpy as np
from sphtm_scene import SOURCE, Checks, order_of_convergence, run

EXAMPLE = os.path.join(SOURCE, "examples", "two_layer_heat")
sys.path.insert(0, EXAMPLE)
from measure import COLD, HOT, error as error_of, exact                                # noqa: E402

SCRIPT = os.path.join(EXAMPLE, "in.two_layer_heat")


def solve(n, ratio, left, t, text=None):
    """x, T and the share of the jump by which they are off."""
    result = run(text or SCRIPT, dict(n=n, ratio=ratio, left=left, t_end=t))
    frame, time = result.dump("temperature.dump")[-1], result.thermo[-1]["Time"][-1]
    return frame["x"], frame["c_T"], error_of(frame, ratio, time), result


checks = Checks()

# the closed form itself, against the numbers of the reference
known = {-0.05: 0.200233, -0.01: 0.625320, 0.01: 0.773290, 0.10: 0.884799}
for x, T in known.items():
    checks.near("closed form at %g" % x, float(exact(np.array(x), 10, 1e-3)) / 100 - 3, T, absolute=1e-6)

# the left layer is as long as it must be for its end to stay cold
cases = [(1, 0.5, 5e-3, 1.9), (10, 0.3, 1e-3, 0.85), (100, 0.2, 1e-4, 1.2)]
for ratio, left, t, order in cases:
    errors = []
    for n in (100, 200, 400):
        x, T, error, result = solve(n, ratio, left, t)
        errors.append(error.max())
        if n == 200:
            checks.below("ratio %d: largest error over the jump" % ratio, error.max(), 0.01)
            mean = result.thermo[-1]["c_mean"]
            checks.below("ratio %d: heat lost" % ratio, abs(mean - mean[0]).max() / mean[0], 1e-9)
            rate = np.sqrt(ratio)
            side = slice(np.argmax(x > 0) - 1, np.argmax(x > 0) + 1)
            Tc = (T[side][0] + ratio * T[side][1]) / (1 + ratio)
            checks.near("ratio %d: interface" % ratio, (Tc - COLD) / (HOT - COLD), rate / (1 + rate), relative=0.005)
    checks.note("ratio %d: errors at 100, 200, 400" % ratio, "%.2e %.2e %.2e" % tuple(errors))
    checks.above("ratio %d: order of convergence" % ratio, order_of_convergence([4, 2, 1], errors), order)

# the same in three dimensions, with another kernel and h
with open(SCRIPT) as f:
    cube = f.read().replace("dimension       2", "dimension 3").replace("sq ${dx} origin 0.5 0.5 0",
        "sc ${dx} origin 0.5 0.5 0.5").replace("$(-v_dx) ${dx} units", "0 ${dx} units")
for style in ("hyperbolic 1.2", "cubic 1.3", "quintic 1.2", "wendland/c4 2.0"):
    x, T, error, result = solve(200, 10, 0.3, 1e-3, cube.replace("hyperbolic 1.2", style))
    checks.below("3D, %s: largest error over the jump" % style, error.max(), 0.01)

checks.end()
