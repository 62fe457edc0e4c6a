"""Strength of the artificial stress and of the artificial viscosity."""
from cases import plate, rings
from frame import CLOSED

TITLE = "artificial stress and viscosity"
STRENGTHS = ((0, 0, ""), (0, 0.3, ""), (0, 1, ""), (0.1, 1, ""), (0.3, 0, ""), (0.3, 0.3, ""), (0.3, 1, ""),
             (0.3, 1, "balanced"))


def label(stress, alpha, how=""):
    return "stress %g%s, viscosity %g" % (stress, how and " " + how, alpha)


def plates(rows):
    return {label(s, a, how): {"rows": rows,
                               "options": "viscosity %g %g artstress %g 4 %s correction yes" % (a, a, s, how)}
            for s, a, how in STRENGTHS}


def all_rings():
    return {label(s, a, how): {"eps": s, "options": "%s viscosity %g %g" % (how, a, a)} for s, a, how in STRENGTHS}


SWEEPS = [
    plate({"quick": plates(6), "full": plates(10), "large": plates(20)}, baseline=label(0, 1),
          also=[("decay", "net energy that artificial terms take from the swing", "elastic: nothing", CLOSED, "lost")]),
    rings({"quick": all_rings(), "full": all_rings()}, baseline=label(0.3, 1)),
]
