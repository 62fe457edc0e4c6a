#!/usr/bin/python3
"""Length and radius of the foot after in.taylor_bar: measure.py [folder [spacing in m]].

Radius: outermost particle of the lowest layers in each of twelve sectors, plus half a spacing; their mean, least and
largest. Length: from lowest to highest particle, plus a spacing."""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "unittest", "scenes"))
from sphtm_scene import read_dump

SECTORS = 12


def shape(frame, dx):
    """Length, and mean, least and largest radius of the foot (m)."""
    x, y, z = frame["x"], frame["y"], frame["z"]
    sector = np.floor((np.arctan2(y, x) / (2 * np.pi) + 0.5) * SECTORS).astype(int) % SECTORS
    low = z < z.min() + 2.5 * dx
    edge = np.array([np.hypot(x, y)[low & (sector == k)].max() for k in range(SECTORS)]) + dx / 2
    return np.ptp(z) + dx, edge.mean(), edge.min(), edge.max()


if __name__ == "__main__":
    folder = sys.argv[1] if len(sys.argv) > 1 else "."
    dx = float(sys.argv[2]) if len(sys.argv) > 2 else float(open(folder + "/spacing").read())
    end = read_dump(folder + "/end.dump")[-1]
    print("length %.2f mm, radius %.2f mm (%.2f to %.2f)" % tuple(1e3 * v for v in shape(end, dx)))
