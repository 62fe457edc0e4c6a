"""bench/validate/rigid_plastic.py, the reference of backward extrusion and of upsetting with friction, against closed forms: a block pressed evenly, a
punch over a thick bottom, a cylinder without friction and one whose friction is small (slab method)."""
import os
import sys

import numpy as np

from sphtm_scene import SOURCE, Checks

sys.path.insert(0, os.path.join(SOURCE, "bench", "validate"))
import rigid_plastic as metal                                                          # noqa: E402

checks = Checks()

# plane strain, pressed evenly: Y 2/sqrt(3) per height; with an axis: Y
for axis, closed in ((False, 2 / np.sqrt(3)), (True, np.pi)):
    block = metal.Metal(*metal.squares([(i, j) for i in range(4) for j in range(4)], 4), axis)
    x, y = block.nodes[:, 0], block.nodes[:, 1]
    held, given = np.concatenate([x == 0, (y == 0) | (y == 1)]), np.concatenate([0 * x, -1.0 * (y == 1)])
    flow, force = block.flow(held, given, 40)
    checks.near("pressed evenly, axis %d: power" % axis, block.power, closed, 1e-3)
    checks.near("force times velocity", -(flow * force).sum(), block.power, 1e-3)

coarse, fine = metal.punch(3.5, 0, 8), metal.punch(3.5, 0, 16)
checks.true("punch, thick bottom: upper bounds, falling", coarse > fine > 1, "%.4f, %.4f" % (coarse, fine))
checks.near("their limit over 2 k (1 + pi/2)", 2 * fine - coarse, 1, 0.01)
coarse, fine = metal.punch(1.75, 0.5, 8), metal.punch(1.75, 0.5, 16)
checks.near("thin bottom, from few squares, as from many", 2 * fine - coarse, 0.90, 0.02)

for mu, within in ((0, 1e-3), (0.01, 1e-3)):
    found = metal.cylinder(mu, 6, 0.01)
    checks.near("cylinder, friction %g: largest difference from the slab method" % mu, 1 + abs(found[:, 1] - 1).max(), 1, within)
checks.near("shortened by", found[-1, 0], 0.5, 1e-9)
checks.end()
