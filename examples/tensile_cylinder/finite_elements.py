#!/usr/bin/python3
"""The tensile cylinder by finite elements: finite_elements.py [folder for the files of the runs]

Needs CalculiX (Debian package calculix-ccx) and numpy; installs nothing. Half of the bar, axisymmetric, quadratic
quadrilaterals with reduced integration (CAX8R), elastic and perfectly plastic, large strains, static; the end keeps its
radius free and moves by half of 7.5 mm. Three meshes, each twice as fine as the last; force and radius of the finest
against displacement go to finite_elements.csv."""
import os
import re
import subprocess
import sys

import numpy as np

NECK, GRIP, FLANK, END = 0.05, 0.075, 0.025, 0.25    # radii; the cone begins here; half the length (m)
PULL, SECTOR = 7.5e-3, 180                           # CalculiX gives the force on a sector of 2 degrees


def radius(z):
    return np.clip(NECK + z - FLANK, NECK, GRIP)


def mesh(n):
    """Heights of the nodes and their shares of the radius: corners at even, middles of sides at odd places."""
    z = [0.0]
    for low, high in (0, FLANK), (FLANK, GRIP - NECK + FLANK), (GRIP - NECK + FLANK, END):
        k = max(1, round((high - low) * n / NECK))
        z += list(low + (high - low) * np.arange(1, k + 1) / k)
    z = np.interp(np.arange(2 * len(z) - 1) / 2, np.arange(len(z)), z)
    return z, np.linspace(0, 1, 2 * n + 1)


def solve(n, folder):
    z, share = mesh(n)
    last, side = len(z) - 1, len(share) - 1
    used = [(i, j) for j in range(last + 1) for i in range(side + 1) if not (i % 2 and j % 2)]
    number = {place: k + 1 for k, place in enumerate(used)}
    name = "cylinder%d" % n
    with open(os.path.join(folder, name + ".inp"), "w") as f:
        f.write("*node, nset=all\n")
        f.writelines("%d, %.12g, %.12g, 0\n" % (number[i, j], share[i] * radius(z[j]), z[j]) for i, j in used)
        f.write("*element, type=CAX8R, elset=body\n")
        ring = (0, 0), (2, 0), (2, 2), (0, 2), (1, 0), (2, 1), (1, 2), (0, 1)
        for e, (i, j) in enumerate((i, j) for j in range(0, last, 2) for i in range(0, side, 2)):
            f.write("%d, %s\n" % (e + 1, ", ".join(str(number[i + a, j + b]) for a, b in ring)))
        for name_of_set, j in ("waist", 0), ("end", last):
            f.write("*nset, nset=%s\n%s\n" % (name_of_set, ",\n".join(str(number[i, j]) for i in range(side + 1))))
        f.write("*nset, nset=rim\n%d\n" % number[side, 0])
        f.write("*material, name=steel\n*elastic\n210e9, 0.3\n*plastic\n350e6, 0\n")
        f.write("*solid section, elset=body, material=steel\n*boundary\nwaist, 2, 2\n")
        f.write("*step, nlgeom, inc=2000\n*static\n0.01, 1, 1e-6, 0.02\n*boundary\nend, 2, 2, %.9g\n" % (PULL / 2))
        f.write("*node print, nset=end, totals=only\nRF\n*node print, nset=rim\nU\n*el print, elset=body\nPEEQ\n*end step\n")
    subprocess.run(["ccx", "-i", name], cwd=folder, check=True, stdout=subprocess.DEVNULL)
    return read(os.path.join(folder, name + ".dat"))


def read(path):
    """Of each increment: displacement of the ends (m), force (N), least radius (m), largest plastic strain."""
    with open(path) as f:
        blocks = re.findall(r"^ (total force|displacements|equivalent plastic strain).*time +(\S+)\n\n((?:.*\S.*\n)+)",
                            f.read(), re.M)
    rows = {}
    for kind, time, text in blocks:
        values = [[float(w) for w in line.split()] for line in text.splitlines()]
        row = rows.setdefault(float(time), [PULL * float(time), 0, 0, 0])
        if kind == "total force":
            row[1] = SECTOR * values[0][1]
        elif kind == "displacements":
            row[2] = NECK + values[0][1]
        else:
            row[3] = max(v[-1] for v in values)
    return np.array([[0, 0, NECK, 0]] + [rows[t] for t in sorted(rows)])


def main():
    folder = sys.argv[1] if len(sys.argv) > 1 else "."
    os.makedirs(folder, exist_ok=True)
    found = []
    for n in 5, 10, 20:
        table = solve(n, folder)
        top = table[:, 1].argmax()
        found.append((n, 1e-6 * table[top, 1], 1e3 * table[top, 0], 1e-6 * table[-1, 1], 1e3 * table[-1, 2], table[-1, 3]))
        print("%2d elements over the radius: largest force %.3f MN after %.2f mm, at the end %.3f MN, least radius %.2f mm, "
              "largest plastic strain %.3f" % found[-1])
    with open(os.path.join(folder, "finite_elements.csv"), "w") as f:
        f.write("# Tensile cylinder, finite_elements.py (CalculiX, axisymmetric), %d elements over the radius of the neck\n"
                "# elements, largest force (MN), at the end: "
                % found[-1][0] + "; ".join("%d, %.3f, %.3f" % (n, force, end) for n, force, _, end, _, _ in found) +
                "\n# moved (m), force (N), least radius (m), largest plastic strain\n")
        f.writelines("%.6e, %.6e, %.6e, %.5f\n" % tuple(row) for row in table)


if __name__ == "__main__":
    main()
