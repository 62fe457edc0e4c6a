"""A clamped plate swings in its first mode (Gray, Monaghan, Swift 2001; thin plate 0.2540 s, linear finite
elements 0.2621 s with the faces of the base held and 0.2550 s with a rigid base; published SPH 0.283 to 0.285 s, total
Lagrangian SPH 0.2745 s; to be met: below 0.2745 s, if possible 0.255 to 0.262 s). Ten particles over the thickness,
half a period, which the first zero of the tip's height ends.

With ten particles the plate is as much too soft as its outermost layers, where a one-sided gradient of a bending field
is of first order only: the period is held to finite elements within 3 %, the gap to the target is printed. From six particles
to ten the error falls with order 1.9. Counter-case: with artificial stress and plain sums the period is 18 % too long."""
import os

import numpy as np
from sphtm_scene import SOURCE, Checks, run

SCRIPT = os.path.join(SOURCE, "examples", "oscillating_plate", "in.oscillating_plate")
FACES, PUBLISHED, TARGET = 0.2621, 0.2745, (0.255, 0.262)


def period(time, height):
    """Twice the time of the first return to the middle."""
    k = np.nonzero((height[1:] <= 0) & (height[:-1] > 0))[0][0]
    return 2 * (time[k] + height[k] * (time[k + 1] - time[k]) / (height[k] - height[k + 1]))


def swing(**options):
    result = run(SCRIPT, options)
    tip = result.columns("tip.dat")
    return period(tip[:, 1], tip[:, 2] - tip[0, 2]), result.thermo[-1]


def main():
    checks = Checks()
    found, table = swing(end=0.14)
    checks.near("period with the default stabilization, s", found, FACES, relative=0.03)
    coarse, _ = swing(rows=6, end=0.15)
    checks.above("order of its error, six to ten particles", np.log((coarse - FACES) / (found - FACES)) / np.log(10 / 6), 1.7)
    checks.below("shorter than published SPH, s", found, PUBLISHED)
    checks.note("target, s", "%.3f to %.3f: %s" % (TARGET + ("inside" if TARGET[0] <= found <= TARGET[1] else
                                                             "%+.4f beyond" % (found - TARGET[1]),)))
    force = np.max(np.abs(table["f_hold[2]"]))
    checks.below("sum of all pair forces over that on the clamp",
                 max(np.max(np.abs(table[c])) for c in ("v_fx", "v_fy")) / force, 1e-11)
    checks.below("energy sum, drift over kinetic energy", np.ptp(table["f_body[9]"]) / table["f_body[1]"][0], 1e-4)
    checks.below("work of the artificial terms over kinetic energy", table["f_body[7]"][-1] / table["f_body[1]"][0], 0.005)
    plain, table = swing(end=0.16, kernel="hyperbolic 1.2", options="artstress 0.3 4")
    checks.note("period with artificial stress, s", "%.4f: %+.1f %%" % (plain, 100 * (plain / FACES - 1)))
    checks.above("counter-case, artificial stress: longer than the default's by", plain / found - 1, 0.1)
    checks.below("energy sum, drift over kinetic energy", np.ptp(table["f_body[9]"]) / table["f_body[1]"][0], 1e-3)
    checks.end()


if __name__ == "__main__":
    main()
