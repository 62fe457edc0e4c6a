"""Strength of the artificial stress and viscosity of the former default, for comparison, and viscosity beside the default's hourglass
control."""
from cases import plate, rings
from frame import CLOSED

TITLE = "artificial stress and viscosity"
STRENGTHS = ((0, 0, ""), (0, 0.3, ""), (0, 1, ""), (0.1, 1, ""), (0.3, 0, ""), (0.3, 0.3, ""), (0.3, 1, ""),
             (0.3, 1, "balanced"))
VISCOSITIES = ("0 0", "0 1", "0 2", "0.3 0.3", "1 1")


def by(**more):
    """The default with a viscosity, then artificial stress, corrected, without hourglass control."""
    rows = {"default, viscosity %s" % v: dict(more, options="viscosity " + v) for v in VISCOSITIES}
    for stress, alpha, how in STRENGTHS:
        rows["stress %g%s, viscosity %g" % (stress, how and " " + how, alpha)] = dict(
            more, options="stabilize artstress artstress %g 4 %s viscosity %g %g correction yes" % (stress, how, alpha, alpha))
    return rows


SWEEPS = [
    plate({"quick": by(rows=6), "full": by(rows=10), "large": by(rows=20)}, baseline="default, viscosity 0 1",
          also=[("decay", "net energy that artificial terms take from the oscillation", "elastic: nothing", CLOSED, "lost")]),
    rings({"quick": by(), "full": by()}, baseline="default, viscosity 0 1"),
]
