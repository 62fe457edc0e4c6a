"""dump sph/tm/vtp: the files are read back with a parser of this folder's own and hold what dump custom writes in the same steps.

Points, vectors, names, integers, single precision, thresholds, variables and files without particles; the list (.pvd) has the
simulation times, tools included, and stays valid and complete over several runs, a restart, and a run that is killed. Two
ranks write the same bytes as one where particles are sorted. Wrong input is refused before the first step. With python3-vtk9
installed the files are read by VTK itself too."""
import os
import re
import shlex
import shutil
import signal
import subprocess
import time
import xml.etree.ElementTree as xml

import numpy as np
from contact_scene import block, header, mesh, particles
from sphtm_scene import Checks, lattice_block, new_folder, run

DX = 0.02
SCENE = """
pair_coeff 1 1 density 1000 elastic 1e7 0.3 heat 50 900 0.9
fix body all sph/tm temperature 300
fix tool all contact/tri file block.stl move 0.03 0 -0.2101 friction 0.3 heat conductance 1e4 temperature 450 &
    vtk 8 tool.*.vtp
fix_modify tool move transrot 0.5 0 0 0.03 0 -0.2101 0 0 1 0.02
compute p all sph/tm/atom temperature stress/zz vonmises
variable height atom z+0.1
"""
THERMO = """
thermo_style custom step time dt
thermo_modify norm no format float %.17g
thermo 8
"""
DUMPS = """
dump text all custom 8 all.*.dump id type x y z vx vy vz ix iy iz c_p[*] v_height
dump_modify text sort id format float %.17g
dump all all sph/tm/vtp 8 all.*.vtp id type x y z vx vy vz ix iy iz c_p[*] v_height
dump_modify all sort id colname v_height "h<1>"
dump single all sph/tm/vtp 8 single_*.vtp id xu yu zu vx vz c_p[1]
dump_modify single precision single sort id tools no
dump hot all sph/tm/vtp 8 hot-*.vtp x y z id
dump_modify hot thresh z < -0.05 tools no pad 4
dump empty all sph/tm/vtp 8 empty.*.vtp x y z c_p[1]
dump_modify empty thresh z > 10 tools no
"""
NUMPY = {"Int32": "<i4", "Int64": "<i8", "Float32": "<f4", "Float64": "<f8"}


def read_vtp(path):
    """A dict: 'points', 'cells' (place, connectivity, offsets), 'time', 'types', and the arrays by name."""
    with open(path, "rb") as f:
        raw = f.read()
    begin = raw.index(b"<AppendedData")
    data = raw.index(b"_", begin) + 1
    end = raw.rindex(b"</AppendedData>")
    assert raw[end:].split() == [b"</AppendedData>", b"</VTKFile>"], path
    root = xml.fromstring(raw[:begin] + b"</VTKFile>")
    assert root.attrib == {"type": "PolyData", "version": "1.0", "byte_order": "LittleEndian", "header_type": "UInt64"}, path
    piece = root.find("PolyData/Piece")
    out = {"types": {}, "time": float(root.find("PolyData/FieldData/DataArray").text), "count": {
        k[8:]: int(v) for k, v in piece.attrib.items()}}
    size = 0

    def values(array):
        nonlocal size
        kind, at = NUMPY[array.get("type")], data + int(array.get("offset"))
        assert int(array.get("offset")) == size and array.get("format") == "appended", path
        bytes_ = int(np.frombuffer(raw[at:at + 8], "<u8")[0])
        size += 8 + bytes_
        found = np.frombuffer(raw[at + 8:at + 8 + bytes_], kind)
        wide = int(array.get("NumberOfComponents"))
        return found.reshape(-1, wide) if wide > 1 else found

    # in the order of the data
    for array in sorted(piece.iter("DataArray"), key=lambda a: int(a.get("offset"))):
        name = array.get("Name")
        out[name] = values(array)
        out["types"][name] = array.get("type")
    assert data + size <= end and raw[data + size:end].split() == [], path
    for place in "PointData", "CellData", "Points", "Verts", "Polys":
        out["in " + place] = [a.get("Name") for a in piece.iterfind(place + "/DataArray")]
    return out


def read_pvd(path):
    """(time, part, file) in the order of the list."""
    root = xml.parse(path).getroot()
    assert root.get("type") == "Collection", path
    return [(float(d.get("timestep")), int(d.get("part")), d.get("file")) for d in root.iter("DataSet")]


def scene(ranks, more, folder=None, head=None):
    folder = folder or new_folder()
    mesh(folder, "block.stl", "block --size 0.3 0.3 0.3 --cells 3 4 5")
    x = block((8, 8, 4), DX, (-0.08, -0.08, -0.06))
    v = np.tile([0.0, 0.0, -1.5], (len(x), 1))
    return run((head or header(DX)) + SCENE + more, ranks=ranks, folder=folder,
               files={"data.scene": particles(x, [(-0.4, 0.4)] * 3, v=v)})


def check_values(checks, ranks):
    result = scene(ranks, THERMO + DUMPS + "run 24\n")
    text, name = result.thermo[-1], "%d rank%s: " % (ranks, "s" * (ranks > 1))
    steps = (0, 8, 16, 24)
    for row, step in enumerate(steps):
        say = name + "step %d: " % step
        due, got = result.dump("all.%d.dump" % step)[0], read_vtp(result.path("all.%d.vtp" % step))
        n = len(due["id"])
        column = {"id": "id", "type": "type", "temperature": "c_p[1]", "stress/zz": "c_p[2]", "vonmises": "c_p[3]", "h<1>": "v_height"}
        same = all((got[mine] == due[theirs]).all() for mine, theirs in column.items())
        same &= all((got[v] == np.stack([due[c] for c in of.split()], 1)).all() for v, of in
                    (("Points", "x y z"), ("velocity", "vx vy vz"), ("image", "ix iy iz")))
        checks.true(say + "as in dump custom, to the last bit", same and n == 256)
        checks.true("    arrays", sorted(got["in PointData"]) == sorted([*column, "velocity", "image"]) and
                    got["in Points"] == ["Points"] and not got["in CellData"], " ".join(got["in PointData"]))
        checks.true("    kinds of numbers", got["types"]["id"] == got["types"]["image"] == "Int32" and
                    got["types"]["Points"] == got["types"]["vonmises"] == "Float64")
        checks.true("    a vertex per particle", got["count"]["Points"] == got["count"]["Verts"] == n and
                    (got["connectivity"] == np.arange(n)).all() and (got["offsets"] == np.arange(n) + 1).all())
        checks.near("    time", got["time"], text["Time"][row], relative=1e-15)
        one = read_vtp(result.path("single_%d.vtp" % step))
        scale = abs(due["c_p[1]"]).max()
        checks.below("    single precision", abs(one["temperature"] - due["c_p[1]"]).max() / scale, 6e-8)
        checks.true("    unwrapped points, incomplete vectors", one["types"]["Points"] == "Float32" and
                    abs(one["Points"][:, 2] - due["z"]).max() < 1e-8 and "vx" in one and "vz" in one and "velocity" not in one)
        hot = read_vtp(result.path("hot-%04d.vtp" % step))
        keep = due["z"] < -0.05
        checks.true("    threshold", sorted(hot["id"]) == sorted(due["id"][keep]) and len(hot["Points"]) == keep.sum(),
                    "%d particles" % keep.sum())
        none = read_vtp(result.path("empty.%d.vtp" % step))
        checks.true("    no particles", none["count"]["Points"] == 0 and none["temperature"].size == 0)
        tool, own = (read_vtp(result.path(f % step)) for f in ("all_tool_%d.vtp", "tool.%d.vtp"))
        corners = own["connectivity"].reshape(-1, 3)
        checks.true("    the tool as its fix writes it", (tool["Points"] == own["Points"]).all() and
                    (tool["connectivity"] == own["connectivity"]).all() and tool["count"]["Polys"] == len(corners) == len(own["stress"])
                    and (own["offsets"] == 3 * np.arange(1, len(corners) + 1)).all() and (own["temp"] == 450).all())
        moved = 0.5 * text["Time"][row] + 0.03
        turn = 2 * np.pi / 0.02
        of_points = np.stack([0.5 - turn * tool["Points"][:, 1], turn * (tool["Points"][:, 0] - moved), 0 * corners.max() *
                              np.ones(len(tool["Points"]))], 1)
        checks.below("    its velocity, temperature", abs(tool["velocity"] - of_points).max() / turn +
                     abs(tool["temperature"] - 450).max(), 1e-12)
    for pvd, files in (("all.pvd", ("all.%d.vtp", "all_tool_%d.vtp")), ("single.pvd", ("single_%d.vtp",)), ("tool.pvd", ("tool.%d.vtp",)),
                       ("hot.pvd", ("hot-%04d.vtp",))):
        want = [(t, part, f % step) for t, step in zip(text["Time"], steps) for part, f in enumerate(files)]
        got = read_pvd(result.path(pvd))
        checks.true(name + pvd, [e[1:] for e in got] == [e[1:] for e in want] and
                    np.allclose([e[0] for e in got], [e[0] for e in want], rtol=1e-15, atol=0), "%d files" % len(got))
    checks.true(name + "the time step changed", len(set(text["Dt"])) > 1)
    return result


def same_on_two_ranks(checks, one, two):
    """Particles are sorted; positions of the ranks agree to the last bit."""
    files = [f for f in os.listdir(one.folder) if re.match(r"(all|single).*\.vtp$|.*\.pvd$", f)]
    differ = []
    for f in files:
        with open(one.path(f), "rb") as a, open(two.path(f), "rb") as b:
            if a.read() != b.read():
                differ.append(f)
    checks.true("two ranks write what one does", len(files) > 10 and not differ, "%d files; differ: %s" % (len(files), " ".join(differ)))


DUMP = "dump a all sph/tm/vtp 4 a.*.vtp id x y z c_p[1]\n"


def several_runs(checks):
    folder = new_folder()
    result = scene(1, THERMO + DUMP + "run 8\nrun 8\nrestart 10 state\nrun 14\nwrite_dump all sph/tm/vtp now.*.vtp x y z\n", folder)
    steps = [int(re.search(r"\.(\d+)\.vtp", f).group(1)) for _, part, f in read_pvd(result.path("a.pvd")) if part == 0]
    checks.true("list over three runs", steps == list(range(0, 31, 4)), str(steps))
    checks.true("write_dump", [e[2] for e in read_pvd(result.path("now.pvd"))] == ["now.30.vtp", "now_tool_30.vtp"])
    before = read_pvd(result.path("a.pvd"))
    head = "atom_modify map array\nnewton off\nread_restart state.20\n" \
        "pair_style sph/tm hyperbolic 1.2 spacing %r\n" % DX
    for append in "yes", "no":
        again = os.path.join(new_folder(), "again")
        shutil.copytree(folder, again)
        done = run("units si\n" + head + SCENE + THERMO +
                   DUMP.replace(" 4 ", " 5 ") + "dump_modify a append %s\nrun 10\n" % append, folder=again)
        got = read_pvd(done.path("a.pvd"))
        steps = [int(re.search(r"\.(\d+)\.vtp", f).group(1)) for _, part, f in got if part == 0]
        want = list(range(0, 20, 4)) * (append == "yes") + [20, 25, 30]
        checks.true("restart, append %s: steps" % append, steps == want, str(steps))
        old = [e for e in before if e[0] < done.thermo[-1]["Time"][0] * (1 - 1e-12)]
        checks.true("    times go on", sorted(t for t, _, _ in got) == [t for t, _, _ in got] and
                    (append == "no" or [e for e in got if e[0] < done.thermo[-1]["Time"][0] * (1 - 1e-12)] == old))
        mine = [int(re.search(r"\.(\d+)\.vtp", f).group(1)) for _, _, f in read_pvd(done.path("tool.pvd"))]
        checks.true("    list of the tool goes on", mine == [0, 8, 16, 24], str(mine))


def keep_few(checks):
    result = scene(1, DUMP + "dump_modify a maxfiles 2\nrun 20\n")
    left = sorted(f for f in os.listdir(result.folder) if re.match(r"a[._].*vtp$", f))
    checks.true("maxfiles 2", left == sorted(f for _, _, f in read_pvd(result.path("a.pvd"))) ==
                ["a.16.vtp", "a.20.vtp", "a_tool_16.vtp", "a_tool_20.vtp"], " ".join(left))


def killed(checks):
    """At a moment of no one's choice, five times."""
    for _ in range(5):
        folder = new_folder()
        mesh(folder, "block.stl", "block --size 0.3 0.3 0.3 --cells 3 4 5")
        x = block((8, 8, 4), DX, (-0.08, -0.08, -0.06))
        with open(os.path.join(folder, "data.scene"), "w") as f:
            f.write(particles(x, [(-0.4, 0.4)] * 3))
        with open(os.path.join(folder, "in.scene"), "w") as f:
            f.write(header(DX) + SCENE + DUMP.replace(" 4 ", " 1 ") + "run 1000000\n")
        job = subprocess.Popen(shlex.split(os.environ["SPHTM_LMP"]) + ["-nocite", "-in", "in.scene"], cwd=folder,
                               stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
        pvd, begun = os.path.join(folder, "a.pvd"), time.time()
        while time.time() - begun < 60 and not (os.path.exists(pvd) and os.path.getsize(pvd) > 3000):
            time.sleep(0.01)
        job.send_signal(signal.SIGKILL)
        job.wait()
        entries = read_pvd(pvd)
        whole = all(read_vtp(os.path.join(folder, f))["count"]["Points"] > 0 for _, _, f in entries)
        checks.true("killed: every file of the list is whole", whole and len(entries) > 20, "%d files" % len(entries))


def in_the_plane(checks):
    result = run(lattice_block("0 4e-3 0 3e-3", "-5e-3 9e-3 -5e-3 9e-3") + """
pair_style sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff 1 1 density 2700 elastic 70e9 0.33
fix body all sph/tm
velocity all set 3 4 0 units box
compute p all sph/tm/atom pressure
compute q all sph/tm/atom pressure
dump a all sph/tm/vtp 1 out.*.left.vtp id x y vx vy c_p c_q
dump b all sph/tm/vtp 1 *.vtp x y
run 1
""")
    got = read_vtp(result.path("out.1.left.vtp"))
    checks.true("2d: two components are enough", (got["Points"][:, 2] == 0).all() and (got["velocity"][:, 2] == 0).all() and
                abs(got["velocity"] - [3, 4, 0]).max() < 1e-9 and len(got["Points"]) == 12)
    checks.true("    a name twice: both keep that of the command", "c_p" in got and "c_q" in got)
    checks.true("    names of lists", os.path.exists(result.path("out.left.pvd")) and
                [e[2] for e in read_pvd(result.path("b.pvd"))] == ["0.vtp", "1.vtp"])


def refused(checks):
    head = lattice_block("0 4e-3 0 3e-3 0 3e-3", "-5e-3 9e-3 -5e-3 9e-3 -5e-3 9e-3", dim=3) + """
pair_style sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff 1 1 density 2700 elastic 70e9 0.33
fix body all sph/tm
compute p all sph/tm/atom pressure h
"""
    D, G = "dump a all sph/tm/vtp 1 ", "a.*.vtp id x y z\n"
    with_list = new_folder()
    with open(os.path.join(with_list, "a.pvd"), "w") as f:
        f.write('<VTKFile type="Collection">\n<Collection>\n<DataSet timestep="0" file="other.vtu"/>\n</Collection>\n</VTKFile>\n')
    for name, lines, words, folder in (
            ("no star", D + "a.vtp x y z\n", ("sph/tm/vtp a", "a.vtp", "*"), None),
            ("two stars", D + "a.*.*.vtp x y z\n", ("sph/tm/vtp a", "a.*.*.vtp", "more than one *"), None),
            ("star in the folder", D + "a.*/b.vtp x y z\n", ("sph/tm/vtp a", "a.*/b.vtp", "folder"), None),
            ("one file per rank", D + "a.%.*.vtp x y z\n", ("sph/tm/vtp a", "a.%.*.vtp", "first rank"), None),
            ("legacy VTK", D + "a.*.vtk x y z\n", ("sph/tm/vtp a", "a.*.vtk", ".vtp"), None),
            ("no attributes", D + "a.*.vtp\n", ("No dump sph/tm/vtp arguments",), None),
            ("no points", D + "a.*.vtp id c_p[1]\n", ("sph/tm/vtp a", "x y z"), None),
            ("two of three", D + "a.*.vtp x y\n", ("sph/tm/vtp a", "x y z"), None),
            ("scaled", D + "a.*.vtp xs ys zs\n", ("sph/tm/vtp a", "x y z"), None),
            ("text", D + "a.*.vtp x y z element\n", ("sph/tm/vtp a", "element"), None),
            ("unknown attribute", D + "a.*.vtp x y z c_nothing[1]\n", ("dump sph/tm/vtp compute ID: nothing",), None),
            ("column that is not there", D + "a.*.vtp x y z c_p[3]\n", ("sph/tm/vtp compute p", "out-of-range"), None),
            ("column twice", D + "a.*.vtp x y z c_p[1] c_p[1]\n", ("sph/tm/vtp a", "c_p[1]", "colname"), None),
            ("name twice", D + "a.*.vtp id type x y z\ndump_modify a colname id type\n", ("sph/tm/vtp a", "type", "colname"), None),
            ("precision", D + G + "dump_modify a precision half\n", ("Dump_modify a precision", "half", "single"), None),
            ("precision alone", D + G + "dump_modify a precision\n", ("Dump_modify a precision",), None),
            ("tools", D + G + "dump_modify a tools maybe\n", ("Dump_modify a tools", "maybe"), None),
            ("format", D + G + "dump_modify a format float %.3g\n", ("Dump_modify a format", "precision"), None),
            ("no header", D + G + "dump_modify a header no\n", ("sph/tm/vtp a", "header"), None),
            ("buffer", D + G + "dump_modify a buffer yes\n", ("buffer",), None),
            ("one list for two", D + G + "dump b all sph/tm/vtp 1 a_*.vtp x y z\n", ("sph/tm/vtp a", "dump b", "a.pvd"), None),
            ("folder that is not there", D + "nowhere/a.*.vtp x y z\n", ("sph/tm/vtp a", "nowhere/a.pvd", "No such"), None),
            ("list of someone else", D + G + "dump_modify a append yes\n", ("sph/tm/vtp a", "a.pvd", "move it away"), with_list)):
        ran = run(head + lines + "thermo 1\nrun 1\n", folder=folder, expect_error=True)
        error = ran.errors()
        checks.true("refused: " + name, ran.status != 0 and all(w in error for w in words) and not ran.thermo,
                    error.splitlines()[0][:150] if error else "no error")


def by_vtk(checks, result):
    try:
        from vtkmodules.vtkIOXML import vtkXMLPolyDataReader
    except ImportError:
        checks.note("python3-vtk9 is not installed", "files not read by VTK itself")
        return
    for name, of in (("all.24.vtp", "Point"), ("all_tool_24.vtp", "Point"), ("tool.24.vtp", "Cell"), ("empty.24.vtp", "Point")):
        reader = vtkXMLPolyDataReader()
        reader.SetFileName(result.path(name))
        reader.Update()
        data, mine = reader.GetOutput(), read_vtp(result.path(name))
        checks.true("VTK reads %s: points and cells" % name, data.GetNumberOfPoints() == len(mine["Points"]) and
                    data.GetNumberOfCells() == len(mine["offsets"]), "%d, %d" % (data.GetNumberOfPoints(), data.GetNumberOfCells()))
        if not len(mine["Points"]):
            continue
        got = np.array([data.GetPoint(k) for k in range(data.GetNumberOfPoints())])
        checks.true("    places, time", (got == mine["Points"]).all() and
                    data.GetFieldData().GetArray("TimeValue").GetValue(0) == mine["time"])
        arrays = getattr(data, "Get%sData" % of)()
        names = {arrays.GetArrayName(k) for k in range(arrays.GetNumberOfArrays())}
        same = all((np.array([arrays.GetArray(n).GetTuple(k) for k in range(len(mine[n]))]).reshape(mine[n].shape) == mine[n]).all()
                   for n in mine["in %sData" % of])
        checks.true("    arrays", same and names == set(mine["in %sData" % of]), " ".join(sorted(names)))


if __name__ == "__main__":
    checks = Checks()
    one = check_values(checks, 1)
    two = check_values(checks, 2)
    same_on_two_ranks(checks, one, two)
    by_vtk(checks, one)
    several_runs(checks)
    keep_few(checks)
    killed(checks)
    in_the_plane(checks)
    refused(checks)
    checks.end()
