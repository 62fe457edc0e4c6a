#!/usr/bin/python3
"""The neck of in.tensile_cylinder: measure.py [folder [particles over the radius]] prints force, radius and pattern.

Radius: planes of the lattice are followed as they move. In each, the particles within half a spacing of the surface
tell by how much that has come in: mean of their distance from the axis over that at the start, times 50 mm. At the
waist, between two planes, the radius squared is that of an even parabola through four planes. On necks of known shape
(neck()) this is within 0.05 mm at 10 mm spacing; a section's volume over the mean distance of its neighbors is 0.12 mm
too large there, as the planes lie closer together towards both sides of the waist than at it.
Force: mean of the two ends, averaged over a twentieth of the run; its largest, and that at the end. A circle on a
lattice is some percent larger or smaller than pi R^2: forces are referred to the area of the section at the start.
Chessboard: what a particle has moved along the axis less the mean of its four neighbors in the plane; of that, the same
again. Smooth fields leave little of it (0.006 spacings here), fields of a chessboard that move apart by d leave d."""
import os
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(HERE, "..", "..", "unittest", "scenes"))
from sphtm_scene import read_dump

RADIUS = 0.05
END_FORCE, LEAST_RADIUS = (2.82e6, 2.91e6), (45.6e-3, 46.2e-3)    # at the end of the pull, as published
LARGEST = 0.02                                                   # largest force: that of finite_elements.csv, within 2 %


def surface(start, frame, dx):
    """Position and radius of the surface at the four planes around the waist; start: the particles before the run."""
    plane = np.floor(start["x"] / dx).astype(int)
    far = np.hypot(start["y"], start["z"])
    ratio = np.hypot(frame["y"], frame["z"]) / far
    outer = (far > RADIUS - 0.5 * dx) & (far <= RADIUS)
    return np.array([(frame["x"][k].mean(), RADIUS * ratio[k].mean())
                     for k in (outer & (plane == n) for n in range(-2, 2))]).T


def waist(x, radius):
    s = x - 0.5 * (x[1] + x[2])
    return np.sqrt(np.polyfit(s**2, radius**2, 1)[1])


def chessboard(start, frame, dx):
    """By how much neighbors of a plane have moved apart along the axis like the fields of a chessboard, in spacings."""
    def less_neighbors(value):
        less = {}
        for i, j, k in value:
            near = [(i, j - 1, k), (i, j + 1, k), (i, j, k - 1), (i, j, k + 1)]
            if all(place in value for place in near):
                less[i, j, k] = value[i, j, k] - np.mean([value[place] for place in near])
        return less

    places = zip(*(np.floor(start[c] / dx).astype(int) for c in "xyz"))
    moved = {place: d for place, d, x in zip(places, (frame["x"] - start["x"]) / dx, start["x"]) if abs(x) < 0.03}
    return 0.5 * np.abs(list(less_neighbors(less_neighbors(moved)).values())).max()


def finite_elements():
    """Columns of finite_elements.csv: displacement of the ends, force, least radius, largest plastic strain."""
    return np.loadtxt(os.path.join(HERE, "finite_elements.csv"), delimiter=",").T


def within(m):
    """Which of the known values are met."""
    return {"end_force": bool(END_FORCE[0] <= m["last force"] <= END_FORCE[1]),
            "largest_force": bool(abs(m["force"] / finite_elements()[1].max() - 1) <= LARGEST),
            "radius": bool(LEAST_RADIUS[0] <= m["radius"] <= LEAST_RADIUS[1])}


def neck(n, stretch):
    """Particles of a bar before and after its sections were drawn apart by stretch(x), at constant volume."""
    dx = RADIUS / n
    c = dx * (np.arange(-2 * n, 2 * n) + 0.5)
    x, y, z = (a.ravel() for a in np.meshgrid(c, c, c))
    x, y, z = (a[np.hypot(y, z) < RADIUS] for a in (x, y, z))
    fine = np.linspace(0, 2 * RADIUS, 4001)
    moved = np.concatenate([[0], np.cumsum(0.5 * (stretch(fine[1:]) + stretch(fine[:-1])) * np.diff(fine))])
    thin = stretch(x)**-0.5
    return {"x": x, "y": y, "z": z}, {"x": np.sign(x) * np.interp(np.abs(x), fine, moved), "y": y * thin, "z": z * thin}


def measure(folder, n):
    dx = RADIUS / n
    frames = read_dump(os.path.join(folder, "neck.dump"))
    end = read_dump(os.path.join(folder, "end.dump"))[-1]
    # area of a section over that of the circle
    lattice = (np.floor(frames[0]["x"] / dx) == 0).sum() / (np.pi * n * n)
    force = np.loadtxt(os.path.join(folder, "force.dat"))
    width = max(1, len(force) // 20)
    mean = np.convolve(force[:, 2], np.ones(width) / width, "valid") / lattice
    return {"radius": waist(*surface(frames[0], end, dx)), "force": mean.max(), "last force": mean[-1],
            "lattice": lattice, "strain": end["c_p[2]"].max(), "chessboard": chessboard(frames[0], end, dx),
            "history": [(np.abs(f["c_p[2]"]).max(), waist(*surface(frames[0], f, dx))) for f in frames],
            "moved": force[width // 2:width // 2 + len(mean), 1], "force of moved": mean,
            "ends apart": np.abs(force[:, 3] + force[:, 4])[len(force) // 2:].max() / mean.max()}


if __name__ == "__main__":
    m = measure(sys.argv[1] if len(sys.argv) > 1 else ".", float(sys.argv[2]) if len(sys.argv) > 2 else 6)
    print("least radius %.2f mm, largest force %.3f MN, at the end %.3f MN, largest plastic strain %.3f" %
          (1e3 * m["radius"], 1e-6 * m["force"], 1e-6 * m["last force"], m["strain"]))
    print("section on the lattice over the circle %.4f, difference of the two ends' forces %.2g %%" %
          (m["lattice"], 100 * m["ends apart"]))
    print("neighbors apart like the fields of a chessboard: %.4f spacings; within its bounds:" % m["chessboard"], within(m))
