"""Stiffness of the contact with a tool."""
from cases import foot, taylor
from frame import CLOSED

TITLE = "contact penalty"


def deepest(run):
    """Penetration into the rigid wall in spacings, which has none."""
    return dict(foot(run), error=run.thermo[-1]["f_wall[13]"].max())


def by(values, **more):
    return {"penalty %g" % p: dict(more, wall="penalty %g" % p) for p in values}


SWEEPS = [
    taylor({"quick": by((0.1, 0.3, 1, 3, 10), rings=3), "full": by((0.03, 0.1, 0.3, 1, 3, 10, 30), rings=4),
            "large": by((0.1, 1, 10), rings=9)}, measure=deepest, baseline="penalty 1", kind=CLOSED,
           quantity="penetration of the Taylor bar into the wall, in spacings", reference="rigid: none"),
]
