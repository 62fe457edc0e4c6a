"""Pair arithmetic in double or single, the rest in double."""
from cases import heat, plate, taylor

TITLE = "pair arithmetic in double or mixed"
PLATE = "%sviscosity 1 1 artstress 0 4 correction yes"
BAR = "%sviscosity 0.3 0.3 balsara yes artstress 0 4 correction yes"
MIXED = "precision mixed "


def options(text, **more):
    return {"double": dict(more, options=text % ""), "mixed": dict(more, options=text % MIXED)}


SWEEPS = [
    heat({size: {"double": {"n": 200}, "mixed": {"n": 200, "precision": "mixed"}} for size in ("quick", "full")}),
    plate({"quick": options(PLATE, rows=8), "full": options(PLATE, rows=10),
           "large": options(PLATE, rows=20, kernel="hyperbolic 1.2")}),
    taylor({"quick": options(BAR, rings=3), "full": options(BAR, rings=4), "large": options(BAR, rings=9)}),
]
