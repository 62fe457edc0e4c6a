#!/usr/bin/python3
"""Two rings of particles on concentric circles 1 mm apart, as a data file: make_rings.py [file].

On a square lattice the surface of a ring is a staircase, from whose steps cracks start."""
import sys

import numpy as np

SPACING, INNER, OUTER, CENTRE = 1e-3, 0.03, 0.04, 0.041


def make_rings(path):
    points = []
    for kind, x in ((1, -CENTRE), (2, CENTRE)):
        for k in range(int(round((OUTER - INNER) / SPACING))):
            r = INNER + (k + 0.5) * SPACING
            n = int(round(2 * np.pi * r / SPACING))
            angle = 2 * np.pi * (np.arange(n) + 0.5 * (k % 2)) / n
            points += [(kind, x + r * np.cos(a) * (1 if kind == 2 else -1), r * np.sin(a)) for a in angle]
    with open(path, "w") as f:
        f.write("two rings\n\n%d atoms\n2 atom types\n" % len(points))
        f.write("-0.14 0.14 xlo xhi\n-0.1 0.1 ylo yhi\n-0.0005 0.0005 zlo zhi\n")
        f.write("\nAtoms # atomic\n\n")
        f.writelines("%d %d %.9g %.9g 0\n" % ((i + 1,) + p) for i, p in enumerate(points))


if __name__ == "__main__":
    make_rings(sys.argv[1] if len(sys.argv) > 1 else "rings.data")
