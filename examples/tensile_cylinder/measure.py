#!/usr/bin/python3
"""The neck of in.tensile_cylinder: measure.py [folder [particles over the radius]] prints force and radius.

A section is a plane of the lattice, followed as it moves. Its area is the volume m/rho of its particles over half the
distance between the planes on either side. A circle on a lattice is some percent larger or smaller than pi R^2; areas
and forces are referred to the area of the section at the start, so the radius starts at exactly 50 mm. At the waist,
between two planes, the radius squared is that of an even parabola through four planes.
Force: mean of the two ends, averaged over a twentieth of the run; the largest of it."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "unittest", "scenes"))
from sphtm_scene import read_dump

RADIUS = 0.05


def sections(start, frame, dx):
    """Position and radius of the planes around the waist; start: the same particles before the run."""
    plane = np.floor(start["x"] / dx).astype(int)
    ks = range(-4, 4)

    def areas(f):
        x = np.array([f["x"][plane == k].mean() for k in ks])
        volume = np.array([(f["mass"] / f["c_p[1]"])[plane == k].sum() for k in ks])
        return x, volume / np.gradient(x)

    (_, before), (x, now) = areas(start), areas(frame)
    return x[1:-1], RADIUS * np.sqrt(now / before)[1:-1]


def waist(x, radius):
    s = x - 0.5 * (x[2] + x[3])
    return np.sqrt(np.polyfit(s[1:5]**2, radius[1:5]**2, 1)[1])


def measure(folder, n):
    dx = RADIUS / n
    frames = read_dump(os.path.join(folder, "neck.dump"))
    end = read_dump(os.path.join(folder, "end.dump"))[-1]
    lattice = (np.floor(frames[0]["x"] / dx) == 0).sum() / (np.pi * n * n)    # area of a section over that of the circle
    force = np.loadtxt(os.path.join(folder, "force.dat"))
    width = max(1, len(force) // 20)
    mean = np.convolve(force[:, 2], np.ones(width) / width, "valid") / lattice
    return {"radius": waist(*sections(frames[0], end, dx)), "force": mean.max(), "last force": mean[-1],
            "lattice": lattice, "strain": end["c_p[2]"].max(),
            "history": [(np.abs(f["c_p[2]"]).max(), waist(*sections(frames[0], f, dx))) for f in frames],
            "moved": force[width // 2:width // 2 + len(mean), 1], "force of moved": mean,
            "ends apart": np.abs(force[:, 3] + force[:, 4])[len(force) // 2:].max() / mean.max()}


if __name__ == "__main__":
    m = measure(sys.argv[1] if len(sys.argv) > 1 else ".", float(sys.argv[2]) if len(sys.argv) > 2 else 6)
    print("least radius %.2f mm, largest force %.3f MN, at the end %.3f MN, largest plastic strain %.3f" %
          (1e3 * m["radius"], 1e-6 * m["force"], 1e-6 * m["last force"], m["strain"]))
    print("section on the lattice over the circle %.4f, difference of the two ends' forces %.2g %%" %
          (m["lattice"], 100 * m["ends apart"]))
