"""What a tool writes: numbered VTK files, STL files, the local array, pictures; on one and on two ranks.

The VTK files are read back with a parser of this folder's own. Triangle by triangle: sums of stress times area are the
force f_tool[1-3], of heat flux times area [11], of contacts [12]; the places are those of the moving tool; pressure is
positive where the tool is pressed, zero on sides that touch nothing. STL files have the same places in single
precision. With python3-vtk9 installed the files are read by VTK itself too."""
import glob
import os
import struct
import zlib

import numpy as np
from contact_scene import block, header, mesh, particles, read_stl, read_vtk, rotation
from sphtm_scene import Checks, new_folder, run

DX = 0.02
SCRIPT = """
pair_coeff 1 1 density 1000 elastic 1e7 0.3 heat 50 900 0.9
fix body all sph/tm temperature 300
fix tool all contact/tri file block.stl move 0.03 0 -0.2101 friction 0.3 heat conductance 1e4 temperature 450 &
    vtk 8 tool.*.vtk stl 8 tool.*.stl local 8
fix_modify tool move transrot 0.5 0 0 0.03 0 -0.2101 0 0 1 0.02
compute p all sph/tm/atom temperature vonmises
thermo_style custom step time f_tool[*]
thermo_modify norm no format float %.17g
thermo 8
dump tri all local 8 tri.*.dump index f_tool[*]
dump_modify tri format float %.15g
dump pic all image 24 pic.*.png c_p[2] type size 640 480 adiam 0.02 view 65 30 zoom 1.5 fix tool type 0 0
dump_modify pic backcolor white
dump none all image 24 none.*.png c_p[2] type size 640 480 adiam 0.02 view 65 30 zoom 1.5
dump_modify none backcolor white
run 24
"""


def png(path):
    """Pixels (rows, columns, 3) of an 8 bit RGB picture."""
    with open(path, "rb") as f:
        raw = f.read()
    assert raw[:8] == b"\x89PNG\r\n\x1a\n"
    at, data = 8, b""
    while at < len(raw):
        size, kind = struct.unpack(">I4s", raw[at:at + 8])
        chunk = raw[at + 8:at + 8 + size]
        if kind == b"IHDR":
            wide, high, depth, color = struct.unpack(">IIBB", chunk[:10])
            assert depth == 8 and color == 2
        if kind == b"IDAT":
            data += chunk
        at += 12 + size
    lines = np.frombuffer(zlib.decompress(data), np.uint8).reshape(high, 1 + 3 * wide).astype(int)
    out = np.zeros((high, wide, 3), int)
    for r in range(high):
        kind, line, above = lines[r, 0], lines[r, 1:].reshape(wide, 3), out[r - 1] if r else np.zeros((wide, 3), int)
        for c in range(wide):
            left = out[r, c - 1] if c else np.zeros(3, int)
            corner = above[c - 1] if c else np.zeros(3, int)
            if kind == 4:
                p = left + above[c] - corner
                d = np.abs(np.stack([p - left, p - above[c], p - corner]))
                guess = np.where((d[0] <= d[1]) & (d[0] <= d[2]), left, np.where(d[1] <= d[2], above[c], corner))
            else:
                guess = (0, left, above[c], (left + above[c]) // 2)[kind]
            out[r, c] = (line[c] + guess) % 256
    return out


def read_local(path):
    with open(path) as f:
        lines = f.read().splitlines()
    return np.array([[float(w) for w in line.split()] for line in lines[9:]])


def scene(ranks):
    folder = new_folder()
    mesh(folder, "block.stl", "block --size 0.3 0.3 0.3 --cells 3 4 5")
    x = block((8, 8, 4), DX, (-0.08, -0.08, -0.06))
    v = np.tile([0.0, 0.0, -1.5], (len(x), 1))
    return run(header(DX) + SCRIPT, ranks=ranks, folder=folder,
               files={"data.scene": particles(x, [(-0.4, 0.4)] * 3, v=v)})


def check_files(checks, result, ranks):
    name, t = "%d rank%s: " % (ranks, "s" * (ranks > 1)), result.thermo[-1]
    vtk = sorted(os.path.basename(p) for p in glob.glob(result.path("tool.*.vtk")))
    checks.true(name + "numbered files", set(vtk) == {"tool.%d.vtk" % k for k in (0, 8, 16, 24)} and
                len(glob.glob(result.path("tool.*.stl"))) == 4, " ".join(vtk))
    start = read_stl(result.path("block.stl")) + [0.03, 0, -0.2101]
    touched = 0
    for row, step in enumerate(t["Step"].astype(int)):
        s = read_vtk(result.path("tool.%d.vtk" % step))
        text = name + "step %d: " % step
        scale = max(abs(t["f_tool[%d]" % k]).max() for k in (1, 2, 3))
        force = (s["stress"] * s["area"][:, None]).sum(axis=0)
        due = [t["f_tool[%d]" % k][row] for k in (1, 2, 3)]
        checks.below(text + "triangle forces add up to f_tool", abs(force - due).max() / scale, 1e-13)
        checks.near(text + "heat fluxes add up", (s["heat_flux"] * s["area"]).sum(), t["f_tool[11]"][row],
                    absolute=1e-13 * abs(t["f_tool[11]"]).max())
        checks.near(text + "contacts add up", s["contacts"].sum(), t["f_tool[12]"][row])
        corners = s["points"][s["triangles"]]
        # the tool at this time: turned about its own axis, moved along x
        time = t["Time"][row]
        places = (start - [0.03, 0, -0.2101]) @ rotation((0, 0, 1), 360 * time / 0.02).T + [0.03 + 0.5 * time, 0, -0.2101]
        gap = np.linalg.norm(np.sort(corners.mean(axis=1), axis=0) - np.sort(places.mean(axis=1), axis=0), axis=1).max()
        checks.below(text + "places of the triangles", gap, 1e-12)
        n = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
        area = 0.5 * np.linalg.norm(n, axis=1)
        normal = n / (2 * area[:, None])
        checks.below("    areas", abs(area - s["area"]).max(), 1e-12)
        pressure = -(s["stress"] * normal).sum(axis=1)
        checks.below("    normal_stress_average is the pressure", abs(pressure - s["normal_stress_average"]).max(),
                     1e-9 * max(1.0, abs(pressure).max()))
        shear = np.linalg.norm(s["stress"] + pressure[:, None] * normal, axis=1)
        checks.below("    shear_stress_average", abs(shear - s["shear_stress_average"]).max(), 1e-9 * max(1.0, shear.max()))
        top = normal[:, 2] > 0.9
        checks.true("    only the top is touched", (s["contacts"][~top] == 0).all() and (s["stress"][~top] == 0).all())
        touched = max(touched, (s["contacts"] > 0).sum())
        checks.true("    temperature, patches", (s["temp"] == 450).all() and len(set(s["patch"])) == 6)
        stl = read_stl(result.path("tool.%d.stl" % step))
        checks.below("    STL has the same places", abs(stl - corners).max(), 1e-7)
        local = read_local(result.path("tri.%d.dump" % step))
        checks.below("    local array has the same places", abs(local[:, 1:10].reshape(-1, 3, 3) - corners).max(), 1e-12)
        checks.below("    local forces add up", abs(local[:, 10:13].sum(axis=0) - due).max() / scale, 1e-12)
        checks.below("    local contacts, areas and normals", abs(local[:, 14] - s["contacts"]).max() +
                     abs(local[:, 15] - area).max() + abs(local[:, 16:19] - normal).max(), 1e-9)
    checks.above(name + "triangles touched at once", touched, 8)
    return t


def by_vtk(checks, result):
    try:
        from vtkmodules.vtkIOLegacy import vtkPolyDataReader
    except ImportError:
        checks.note("python3-vtk9 is not installed", "files not read by VTK itself")
        return
    reader = vtkPolyDataReader()
    reader.SetFileName(result.path("tool.24.vtk"))
    reader.ReadAllScalarsOn()
    reader.ReadAllVectorsOn()
    reader.Update()
    data, mine = reader.GetOutput(), read_vtk(result.path("tool.24.vtk"))
    cells = data.GetCellData()
    names = {cells.GetArrayName(k) for k in range(cells.GetNumberOfArrays())}
    checks.near("VTK reads it: triangles", data.GetNumberOfPolys(), len(mine["triangles"]))
    checks.true("    arrays", {"stress", "normal_stress_average", "temp", "contacts", "vel", "area"} <= names, " ".join(sorted(names)))
    a = cells.GetArray("stress")
    checks.below("    stress", max(abs(np.array(a.GetTuple(k)) - mine["stress"][k]).max() for k in range(data.GetNumberOfPolys())), 0.0)


def pictures(checks, result):
    with_tool, without = png(result.path("pic.24.png")), png(result.path("none.24.png"))
    white = (with_tool == 255).all(axis=2).mean()
    differ = (with_tool != without).any(axis=2).mean()
    checks.true("picture: not blank", 0.05 < white < 0.95, "%.1f %% background" % (100 * white))
    checks.above("    share of the picture that the tool changes", differ, 0.05)


if __name__ == "__main__":
    checks = Checks()
    one = scene(1)
    check_files(checks, one, 1)
    by_vtk(checks, one)
    if os.path.exists(one.path("pic.24.png")):
        pictures(checks, one)
    else:
        checks.note("this LAMMPS cannot write PNG", "no pictures")
    check_files(checks, scene(2), 2)
    checks.end()
