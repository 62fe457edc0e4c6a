"""Pair arithmetic in double or single, the rest in double."""
from cases import heat, plate, taylor

TITLE = "pair arithmetic in double or mixed"
MIXED = "precision mixed"


def options(**more):
    return {"double": dict(more, options=""), "mixed": dict(more, options=MIXED)}


SWEEPS = [
    heat({size: {"double": {"n": 200}, "mixed": {"n": 200, "precision": "mixed"}} for size in ("quick", "full")}),
    plate({"quick": options(rows=8), "full": options(rows=10),
           "large": options(rows=20, kernel="hyperbolic 1.2")}),
    taylor({"quick": options(rings=3), "full": options(rings=4), "large": options(rings=9)}),
]
