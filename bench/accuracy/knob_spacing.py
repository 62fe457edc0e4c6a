"""Particle spacing."""
from cases import heat, plate, taylor

TITLE = "particle spacing"


def by(name, values, unit):
    return {"%d %s" % (n, unit): {name: n} for n in values}


SWEEPS = [
    heat({"quick": by("n", (50, 100, 200, 400), "particles"), "full": by("n", (50, 100, 200, 400, 800), "particles"),
          "large": by("n", (50, 100, 200, 400, 800), "particles")},
         order=lambda v: 1 / v["n"], baseline="200 particles"),
    plate({"quick": by("rows", (4, 6, 8, 10), "rows"), "full": by("rows", (4, 6, 8, 10, 14, 20), "rows"),
           "large": by("rows", (5, 10, 20, 40), "rows")},
          order=lambda v: 1 / v["rows"], baseline="10 rows"),
    taylor({"quick": by("rings", (2, 3, 4), "rings"), "full": by("rings", (2, 3, 4, 5, 6), "rings"),
            "large": by("rings", (3, 4, 6, 9, 12), "rings")},
           order=lambda v: 1 / (v["rings"] + 0.5), baseline="4 rings"),
]
