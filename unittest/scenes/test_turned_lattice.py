"""Metal in tension whose particles lie on a lattice that is turned against the pull, as one gets who cuts a part from a lattice: a strip
follows its flow curve to a strain of 0.25 with any angle, and a ring that is thrown outward stays whole (bench/stability/turned_strip.py).
Steps of the faces carry nothing, so the force is up to a tenth below that of the whole section: kept pairs, which cannot come apart,
give by how much. Counter-case: without hourglass control the strip parts."""
import os
import sys

from sphtm_scene import SOURCE, Checks

sys.path.insert(0, os.path.join(SOURCE, "bench", "stability"))
from turned_strip import AT, KEPT, ring, strip                                          # noqa: E402

ROWS = 8
checks = Checks()
for angle, within in ((0.0, 0.02), (2.9, 0.05), (14.0, 0.06), (26.6, 0.08)):
    kept = strip(angle, ROWS, KEPT)[0]
    forces, artificial, torn = strip(angle, ROWS)
    name = "%g degrees: " % angle
    for at, force, other in zip(AT, forces, kept):
        checks.near(name + "force at %g, that of kept pairs" % at, force, other, absolute=within)
    checks.below(name + "share of artificial terms", artificial, 0.02)
    checks.below(name + "numerical fracture", torn, 0)
kept = ring(4, KEPT)[0]
mean, most, artificial, torn = ring(4)
checks.near("ring: mean plastic strain, that of kept pairs", mean, kept, relative=0.05)
checks.below("ring: largest plastic strain, over the mean", most / mean, 4)
checks.below("ring: share of artificial terms", artificial, 0.06)
checks.end()
