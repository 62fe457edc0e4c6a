"""A square bar of Weldox 460E is drawn until it breaks: engineering stress and strain against finite elements, and what
breaks it. With the default and with pairs that are kept (total-Lagrangian) a neck forms and fails by damage; the halves of kept
pairs go on. SPHTM_FASTER: pull so many
times faster than the finite elements (4).

Bar 20 x 2.4 x 2.4 mm, both ends pulled with 1 - exp(-t) m/s, t in ms; Johnson and Cook's hardening and damage without
rate and temperature. Finite elements: 571.6 MPa at a strain of 0.0987, half of it at 0.192."""
import os
import sys

from sphtm_scene import SOURCE, Checks, run

sys.path.insert(0, os.path.join(SOURCE, "bench", "validate"))
from weldox_bar import HALF, LARGEST, SCRIPT, STRAIN, Drawn                                # noqa: E402

FASTER = float(os.environ.get("SPHTM_FASTER", "4"))


def drawn(rows, until, **variables):
    """rows: particles over the side."""
    d = Drawn(run(SCRIPT, dict(variables, rows=rows, until=until, faster="%g" % FASTER), timeout=3000))
    print("%d particles, %s: largest stress %.1f MPa at %.4f, half of it at %s; first failure at %s; largest damage %.3f, "
          "plastic strain %.2f, failed %d, numerical fracture %d; at the end %.2f of the largest stress"
          % (rows, "kept" if variables else "default", d.largest, d.at, d.half, d.first, d.damage, d.pstrain, d.failed, d.torn, d.last))
    print("    stress off by " + ", ".join("%+.1f %% at %g" % (100 * d.off[e], e) for e in STRAIN))
    return d


checks = Checks()


def same(name, d, last, within):
    checks.near(name + "largest stress", d.largest, LARGEST, relative=0.002)
    checks.near(name + "its strain", d.at, 0.0987, absolute=0.01)
    for e in STRAIN[1:last]:
        checks.below(name + "stress at a strain of %g" % e, abs(d.off[e]), within)


# with the default lists shifting moves rows into each other: a neck forms and fails by damage, as with kept pairs
d = drawn(6, 0.25)
same("6 particles: ", d, 7, 0.003)
checks.below("6 particles: stress at a strain of 0.15", abs(d.off[0.15]), 0.015)
checks.near("6 particles: half of it", d.half or 1.0, HALF, relative=0.06)
checks.near("6 particles: strain of the first failure", d.first or 1.0, HALF, relative=0.08)
checks.above("6 particles: a neck, local strain", d.pstrain, 0.9)
checks.above("6 particles: particles that have failed by damage", d.failed, 1)
checks.true("6 particles: which is no numerical fracture", d.torn == 0 and "numerical fracture: none" in d.result.output, "%g" % d.torn)

d = drawn(8, 0.25, adapt="threshold inf")    # with 4 and 6: case_weldox.py
name = "kept, 8 particles: "
same(name, d, 7, 0.003)
checks.below(name + "stress at a strain of 0.15", abs(d.off[0.15]), 0.03)
checks.near(name + "half of it", d.half or 1.0, HALF, relative=0.05)
checks.near(name + "strain of the first failure", d.first or 1.0, HALF, relative=0.05)
checks.above(name + "a neck, local strain", d.pstrain, 0.9)
checks.above(name + "failed by damage, over a cross section", d.failed / 64, 1.0)
checks.true(name + "which is no numerical fracture", d.torn == 0 and "numerical fracture: none" in d.result.output, "%g" % d.torn)
checks.below(name + "broken, and goes on: stress at the end over the largest", abs(d.last), 0.2)
checks.below(name + "drift of the energy sum over the work", abs(d.t["f_body[9]"][-1] - d.t["f_body[9]"][0]) / abs(d.t["f_body[8]"]).max(), 0.001)
checks.end()
