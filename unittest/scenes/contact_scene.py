"""What the contact tests share: meshes, particles from arrays, VTK and STL files read back.

    mesh(folder, "plane.stl", "plane --size 1 1 --cells 3 3")     # tools/make_tool.py
    data = particles(x, box, v=v, types=t)                        # text of a data file
    surface = read_vtk(path)                                      # "points", "triangles", cell arrays
"""
import os
import shlex
import subprocess
import sys

import numpy as np
from sphtm_scene import SOURCE

# A stiff, light material for particles that touch nothing but tools: E/rho = 1e4, c about 100
MATERIAL = "density 1000 elastic 1e7 0.3"
HEADER = """
units si
dimension {dim}
boundary {boundary}
atom_style atomic
atom_modify map array
newton off
read_data {data}
pair_style sph/tm hyperbolic 1.2 spacing {dx!r} {style}
"""


def header(dx, dim=3, boundary=None, data="data.scene", style=""):
    return HEADER.format(dx=dx, dim=dim, boundary=boundary or ("f f f" if dim == 3 else "f f p"), data=data,
                         style=style)


def mesh(folder, name, arguments):
    """Writes a mesh with tools/make_tool.py; its path."""
    path = os.path.join(folder, name)
    done = subprocess.run([sys.executable, os.path.join(SOURCE, "tools", "make_tool.py")] + shlex.split(arguments) +
                          ["-o", path], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    if done.returncode:
        sys.exit("make_tool.py %s: %s" % (arguments, done.stdout))
    return path


def particles(x, box, v=None, types=None, ntypes=None):
    """A data file. box: three pairs. Particles are numbered from 1 in the order given."""
    x = np.asarray(x, float).reshape(-1, 3)
    types = np.ones(len(x), int) if types is None else np.asarray(types, int)
    lines = ["particles of a test", "", "%d atoms" % len(x), "%d atom types" % (ntypes or types.max()), ""]
    for (lo, hi), axis in zip(box, "xyz"):
        lines.append("%.17g %.17g %slo %shi" % (lo, hi, axis, axis))
    lines += ["", "Atoms # atomic", ""]
    lines += ["%d %d %.17g %.17g %.17g" % (i + 1, t, *p) for i, (t, p) in enumerate(zip(types, x))]
    if v is not None:
        lines += ["", "Velocities", ""]
        lines += ["%d %.17g %.17g %.17g" % (i + 1, *p) for i, p in enumerate(np.asarray(v, float).reshape(-1, 3))]
    return "\n".join(lines) + "\n"


def block(counts, dx, corner=(0.0, 0.0, 0.0)):
    """Particles of a simple cubic block whose surface, half a spacing outside the centres, begins at corner."""
    axes = [c + dx * (np.arange(n) + 0.5) for c, n in zip(corner, counts)]
    return np.stack(np.meshgrid(*axes, indexing="ij"), -1).reshape(-1, 3)


def rotation(axis, degrees):
    """Rodrigues, right-handed."""
    u = np.asarray(axis, float) / np.linalg.norm(axis)
    a = np.radians(degrees)
    k = np.array([[0, -u[2], u[1]], [u[2], 0, -u[0]], [-u[1], u[0], 0]])
    return np.eye(3) + np.sin(a) * k + (1 - np.cos(a)) * k @ k


def read_stl(path):
    """Triangles (n, 3, 3) of a binary STL file."""
    with open(path, "rb") as f:
        raw = f.read()
    n = int(np.frombuffer(raw[80:84], "<u4")[0])
    assert len(raw) == 84 + 50 * n, "size of " + path
    facets = np.frombuffer(raw[84:], np.dtype([("normal", "<f4", 3), ("corner", "<f4", (3, 3)), ("word", "<u2")]))
    return facets["corner"].astype(float)


def read_vtk(path):
    """A legacy VTK file of triangles (POLYDATA, ASCII or BINARY): dict of 'points', 'triangles', 'title' and
    the cell arrays by name. Written for these tests, apart from the code that writes and reads in C."""
    with open(path, "rb") as f:
        raw = f.read()
    at = 0

    def line():
        nonlocal at
        end = raw.index(b"\n", at)
        text, at = raw[at:end].decode("ascii"), end + 1
        return text

    assert line().startswith("# vtk DataFile Version"), path
    out = {"title": line()}
    binary = line().strip() == "BINARY"
    assert line().split() == ["DATASET", "POLYDATA"]

    def numbers(count, kind):
        nonlocal at
        if binary:
            width = np.dtype(kind).itemsize
            values = np.frombuffer(raw[at:at + width * count], ">" + kind).astype(float)
            at += width * count
            if raw[at:at + 1] == b"\n":
                at += 1
            return values
        values = []
        while len(values) < count:
            values += [float(w) for w in line().split()]
        return np.array(values)

    cells = 0
    while at < len(raw):
        words = line().split()
        if not words:
            continue
        if words[0] == "POINTS":
            assert words[2] == "double"
            out["points"] = numbers(3 * int(words[1]), "f8").reshape(-1, 3)
        elif words[0] == "POLYGONS":
            cells = int(words[1])
            polygons = numbers(int(words[2]), "i4").reshape(-1, 4).astype(int)
            assert (polygons[:, 0] == 3).all()
            out["triangles"] = polygons[:, 1:]
        elif words[0] == "CELL_DATA":
            assert int(words[1]) == cells
        elif words[0] == "SCALARS":
            assert line().split() == ["LOOKUP_TABLE", "default"]
            out[words[1]] = numbers(cells, "f8")
        elif words[0] == "VECTORS":
            out[words[1]] = numbers(3 * cells, "f8").reshape(-1, 3)
        else:
            raise AssertionError("unknown word %s in %s" % (words[0], path))
    return out


def write_stl(folder, name, triangles):
    """ASCII STL of an array (n, 3, 3)."""
    with open(os.path.join(folder, name), "w") as f:
        f.write("solid test\n")
        for t in np.asarray(triangles, float):
            n = np.cross(t[1] - t[0], t[2] - t[0])
            f.write("facet normal %.9g %.9g %.9g\nouter loop\n" % tuple(n / np.linalg.norm(n)))
            f.write("".join("vertex %.17g %.17g %.17g\n" % tuple(p) for p in t) + "endloop\nendfacet\n")
        f.write("endsolid test\n")
