#!/usr/bin/python3
"""A round bar of particles on rings, as a data file: make_bar.py [rings radius length density [file]] (SI).

Ring k has 6k particles, layers are turned by half a particle, so that the surface is round and every particle has the
same volume; the cross section of a cubic lattice is a polygon with corners, from which the rim of a mushroom tears.
Prints the spacing, the cube root of that volume."""
import sys

import numpy as np


def make_bar(rings, radius, length, density, path):
    """Writes the data file, its axis along z from 0 to length; returns the spacing."""
    area = np.pi * radius**2 / (1 + 3 * rings * (rings + 1))
    layers = int(round(length / np.sqrt(area)))
    height, step, points = length / layers, radius / (rings + 0.5), []
    for layer in range(layers):
        z = (layer + 0.5) * height
        points.append((0, 0, z))
        for k in range(1, rings + 1):
            # the golden ratio keeps particles of neighboring rings from lining up
            turn = 2 * np.pi * ((np.arange(6 * k) + 0.5 * (layer % 2)) / (6 * k) + 0.618034 * k)
            points += [(k * step * np.cos(t), k * step * np.sin(t), z) for t in turn]
    w = 4 * radius
    with open(path, "w") as f:
        f.write("round bar, %d rings\n\n%d atoms\n1 atom types\n" % (rings, len(points)))
        f.write("%g %g xlo xhi\n%g %g ylo yhi\n%g %g zlo zhi\n" % (-w, w, -w, w, -0.1 * length, 1.1 * length))
        f.write("\nMasses\n\n1 %.12g\n\nAtoms # atomic\n\n" % (density * area * height))
        f.writelines("%d 1 %.9g %.9g %.9g\n" % ((i + 1,) + p) for i, p in enumerate(points))
    return (area * height) ** (1 / 3)


if __name__ == "__main__":
    values = [float(w) for w in sys.argv[1:5]] or [5, 3.2e-3, 32.4e-3, 8930]
    print("%.9g" % make_bar(int(values[0]), *values[1:], sys.argv[5] if len(sys.argv) > 5 else "bar.data"))
