"""Metal that is sheared far bears its shear flow stress, and a cut has the force that it has, on whatever lattice its particles lie (bench/stability/sheared_lattice.py).
A lattice along the shear finds itself again after a shear of 1; one that lies obliquely must be put in order by shifting. Counter-case: without shifting a turned one lets go."""
import os
import sys

import numpy as np

from sphtm_scene import SOURCE, Checks

sys.path.insert(0, os.path.join(SOURCE, "bench", "stability"))
from sheared_lattice import cut, sheared                                               # noqa: E402

checks = Checks()
for angle, hardening in (0.0, 0.0), (9.5, 0.0), (18.4, 0.0), (26.6, 0.0), (45.0, 0.0), (18.4, 500e6), (26.6, 500e6):
    stress, across, artificial, torn = sheared(angle, hardening=hardening)
    name = "%g degrees, hardening %g MPa: " % (angle, 1e-6 * hardening)
    print(name + "stress %s, across %s, artificial %.2f %%, torn %d" % (np.round(stress, 3).tolist(), np.round(across, 2).tolist(), 100 * artificial, torn))
    checks.below(name + "shear stress off that of the flow curve, to a shear of 3", abs(stress - 1.0).max(), 0.05)
    checks.below(name + "share of artificial terms", artificial, 0.05)
stress = sheared(18.4, shifting="off")[0]
checks.below("counter-case, without shifting: least shear stress", stress.min(), 0.9)
along, across = cut(0.0)[0], cut(20.0)[0]
print("cut of the tutorial: %.1f N/mm along the lattice, %.1f turned by 20 degrees" % (along, across))
checks.near("cut of the tutorial: force on a lattice that is turned by 20 degrees", across, along, relative=0.08)
checks.end()
