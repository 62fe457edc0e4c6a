"""Smoothing length over the spacing."""
from cases import heat, plate

TITLE = "smoothing length over spacing"
RATIOS = (0.9, 1.0, 1.1, 1.2, 1.4, 1.7, 2.0)


def by(ratios, kernel, **more):
    return {"h %g" % r: dict(more, kernel="%s %g" % (kernel, r)) for r in ratios}


SWEEPS = [
    heat({size: by(RATIOS, "hyperbolic", n=n) for size, n in (("quick", 200), ("full", 400), ("large", 400))},
         baseline="h 1.2"),
    plate({size: by(RATIOS if size == "full" else RATIOS[1:6], "wendland/c4", rows=n)
           for size, n in (("quick", 6), ("full", 10), ("large", 20))}, baseline="h 1.2"),
]
