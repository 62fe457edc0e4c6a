"""Velocity and mass scaling of a cut: a faster tool, or heavier particles with larger steps."""
import cut
from frame import SAME, Sweep

TITLE = "velocity and mass scaling in cutting"


def by(what, factors, **more):
    return dict({"no scaling": dict(more)}, **{"%s x %g" % (what, f): dict(more, **{what: f}) for f in factors})


def sweep(what, factors):
    return Sweep(name=what, quantity="mean cutting force", reference="the cut without scaling", kind=SAME,
                 script=cut.script, prepare=cut.mesh, measure=cut.force, against="no scaling",
                 settings={"quick": by(what, factors, dx=40e-6, cut=0.4e-3),
                           "full": by(what, factors, dx=20e-6, cut=0.5e-3)})


SWEEPS = [sweep("speed", (2, 5, 10, 20)), sweep("mass", (4, 25, 100, 400))]
