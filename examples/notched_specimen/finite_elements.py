#!/usr/bin/python3
"""Von Mises stress of the notched specimen by finite elements: finite_elements.py [folder for the files of the runs]

Needs CalculiX (Debian package calculix-ccx) and numpy; installs nothing. Linear elastic, plane strain, a quarter of the
specimen with symmetry, the end clamped and moved along the axis. Quadratic quadrilaterals in a mesh of its own: rays
from the notch to the outer border, graded towards the notch. Three meshes, each twice as fine as the last; the profile
along the ligament of the finest goes to ligament.csv, over the mean axial stress of the ligament."""
import os
import subprocess
import sys

import numpy as np

HALF, LENGTH = 5.0e-3, 6.7e-3                  # half the width and half the length (m)
RADIUS, OFFSET = 1.5e-3, 0.2e-3                # of the notch; its centre lies so far outside of the edge
E, NU, STRAIN = 205e9, 0.29, 1e-4              # C45E; displacement of the end over LENGTH


def mesh(n):
    """Corner and mid-side nodes on a grid of (2 rays + 1) x (2 rings + 1) points; rays and rings of quadrilaterals."""
    rays, rings, first = 3 * n, 4 * n, np.arccos(OFFSET / RADIUS)    # angle from -x to where the notch meets the edge
    # the outer border: from the centre of the specimen up its axis, then along the end to the edge
    share = round(rays * LENGTH / (LENGTH + HALF))                   # the corner is on a ray
    t = np.linspace(0, 1, 2 * rays + 1)
    k = 2 * share
    up, along = np.linspace(0, LENGTH, k + 1), np.linspace(0, HALF, 2 * rays - k + 1)
    outer = np.concatenate([np.stack([np.zeros(k + 1), up], 1),
                            np.stack([along[1:], np.full(2 * rays - k, LENGTH)], 1)])
    angle = t * first
    inner = np.stack([HALF + OFFSET - RADIUS * np.cos(angle), RADIUS * np.sin(angle)], 1)
    s = np.linspace(0, 1, 2 * rings + 1)
    grade = (np.exp(2.5 * s) - 1) / (np.exp(2.5) - 1)                # the elements grow twelvefold
    grade[1::2] = 0.5 * (grade[:-1:2] + grade[2::2])                 # nodes at the middle of the sides
    points = inner[:, None] + grade[None, :, None] * (outer - inner)[:, None]
    return points, rays, rings


def solve(n, folder):
    points, rays, rings = mesh(n)
    number = -np.ones(points.shape[:2], int)
    used = [(a, b) for a in range(2 * rays + 1) for b in range(2 * rings + 1) if not (a % 2 and b % 2)]
    for k, ab in enumerate(used):
        number[ab] = k + 1
    name = os.path.join(folder, "notch%d" % n)
    with open(name + ".inp", "w") as f:
        f.write("*node, nset=all\n")
        f.writelines("%d, %.12g, %.12g, 0\n" % (number[ab], *points[ab]) for ab in used)
        f.write("*element, type=CPE8, elset=body\n")
        for e, (a, b) in enumerate((2 * i, 2 * j) for i in range(rays) for j in range(rings)):
            corner = [(a, b), (a, b + 2), (a + 2, b + 2), (a + 2, b)]
            middle = [(a, b + 1), (a + 1, b + 2), (a + 2, b + 1), (a + 1, b)]
            p = [points[c] for c in corner]
            turn = sum(p[k - 1][0] * p[k][1] - p[k][0] * p[k - 1][1] for k in range(4))
            if turn < 0:
                corner, middle = corner[::-1], [middle[2], middle[1], middle[0], middle[3]]
            f.write("%d, %s\n" % (e + 1, ", ".join(str(number[c]) for c in corner + middle)))
        f.write("*material, name=steel\n*elastic\n%g, %g\n*solid section, elset=body, material=steel\n1\n" % (E, NU))
        f.write("*step\n*static\n*boundary\n")
        for ab in used:
            x, y = points[ab]
            if abs(y - LENGTH) < 1e-9:
                f.write("%d, 1, 1\n%d, 2, 2, %.12g\n" % (number[ab], number[ab], STRAIN * LENGTH))
            else:
                if abs(y) < 1e-9:
                    f.write("%d, 2, 2\n" % number[ab])
                if abs(x) < 1e-9:
                    f.write("%d, 1, 1\n" % number[ab])
        f.write("*node file, nset=all\nU, RF\n*el file\nS\n*end step\n")
    subprocess.run(["ccx", "-i", "notch%d" % n], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    stress, force = read(name + ".frd")
    ligament = [(0, b) for b in range(2 * rings + 1)]
    x = np.array([points[ab][0] for ab in ligament])
    s = np.array([stress[number[ab]] for ab in ligament])
    pull = sum(force[number[ab]] for ab in used if abs(points[ab][1] - LENGTH) < 1e-9)
    order = np.argsort(x)
    return x[order], s[order], pull, len(used)


def read(path):
    """Stresses of the nodes and the reaction along the axis from CalculiX's result file (the plane is z = 0)."""
    stress, force, block = {}, {}, None
    with open(path) as f:
        for line in f:
            if line.startswith(" -4"):
                block = line.split()[1]
            elif line.startswith(" -3"):
                block = None
            elif line.startswith(" -1") and block in ("STRESS", "FORC"):
                values = [float(line[13 + 12 * k:25 + 12 * k]) for k in range((len(line.rstrip()) - 13) // 12)]
                (stress if block == "STRESS" else force)[int(line[3:13])] = values
    return stress, {k: v[1] for k, v in force.items()}


def mises(s):
    xx, yy, zz, xy, yz, zx = s.T
    return np.sqrt(0.5 * ((xx - yy)**2 + (yy - zz)**2 + (zz - xx)**2) + 3 * (xy**2 + yz**2 + zx**2))


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else "."
    os.makedirs(folder, exist_ok=True)
    x = np.linspace(0, HALF + OFFSET - RADIUS, 75)
    profiles = []
    for n in 4, 8, 16:
        position, s, pull, nodes = solve(n, folder)
        nominal = (np.diff(position) * (s[1:, 1] + s[:-1, 1]) / 2).sum() / position[-1]
        profiles.append(np.interp(x, position, mises(s) / nominal))
        root = s[-1, 1] / nominal
        print("%6d nodes: mean stress of the ligament %.6g MPa (from the reaction %.6g), at the root: axial %.4f, von "
              "Mises %.4f times that" % (nodes, nominal * 1e-6, 1e-6 * pull / position[-1], root, profiles[-1][-1]))
        axial = np.interp(x, position, s[:, 1] / nominal)
    change = [np.abs(a - b).max() for a, b in zip(profiles, profiles[1:])]
    print("largest change of the profile from mesh to mesh:", " ".join("%.2g" % c for c in change))
    with open(os.path.join(folder, "ligament.csv"), "w") as f:
        f.write("# Von Mises and axial stress along the ligament over the mean axial stress there; finite_elements.py\n"
                "# (CalculiX, plane strain, elastic, nu 0.29). Mean axial stress over E times mean strain: %.6f\n"
                "# Largest change of the von Mises profile when the elements were halved, twice: %.2g, %.2g\n"
                "# distance from the axis (m), von Mises, axial\n" % (nominal / (E * STRAIN), *change))
        f.writelines("%.6e, %.6f, %.6f\n" % row for row in zip(x, profiles[-1], axial))


if __name__ == "__main__":
    main()
