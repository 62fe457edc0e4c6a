"""Faults: values that are no numbers, damaged and cut restart files, a mesh that is gone, a full disk, a killed rank.
Each ends the run with an error that says what happened; none goes on with a wrong state."""
import os
import re
import shlex
import shutil
import signal
import struct
import subprocess
import sys
import time

import numpy as np
import restart_file
from sphtm_scene import SOURCE, Checks, lattice_block, new_folder, run

HEAD = lattice_block("0 0.008 0 0.006", "-0.02 0.02 -0.02 0.02", more="atom_modify     map array\n") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 balsara yes xsph 0.1 hourglass 0.02 {plane}
pair_coeff      1 1 density 7830 elastic 200e9 0.29 strength johnson/cook 792e6 510e6 0.26 0.014 1.03 298 1793 1 &
                heat 38 477 0.9 damage johnson/cook 0.5 1.0 -3.0 0.01 1.0 {eos}
velocity        all ramp vx 0 100 x 0 0.008 units box
"""
FIXES = """
fix             body all sph/tm temperature 300 energy yes
fix             tool all contact/tri file tool.stl move 0 -0.0012 0 {tool}
thermo          10
"""
checks = Checks()
folder = new_folder()


def make_mesh():
    subprocess.run([sys.executable, os.path.join(SOURCE, "tools", "make_tool.py"), "block", "--size", "0.03", "0.002",
                    "0.02", "-o", os.path.join(folder, "tool.stl")], check=True, stdout=subprocess.DEVNULL)


def ends(name, result, *words):
    text = result.errors()
    checks.true(name, result.status != 0 and all(w in text for w in words) and "Segmentation" not in result.output,
                text.splitlines()[0][:150] if text else
                "status %d, no error: %s" % (result.status, result.output[-100:]))


def go_on(data, name, **more):
    with open(os.path.join(folder, name), "wb") as f:
        f.write(data)
    return run("read_restart %s\n" % name + FIXES.format(tool="") + "run 40\n", folder=folder, expect_error=True,
               **more)


# --- a restart file whose values are damaged: every column of the state, on 48 particles
make_mesh()
COLUMNS = {"density": 1, "stress": 6, "history": 20, "plastic strain": 3, "temperature": 3, "energy": 3, "damage": 2,
           "balsara": 1, "xsph": 3, "thickness": 1, "hourglass": 6, "reference": 7, "correction": 16, "layer": 10}
for plane, eos, missing in (("", "eos shock 4570 1.49 1.9", ("thickness",)), ("plane stress", "", ("energy",))):
    run(HEAD.format(plane=plane, eos=eos) + FIXES.format(tool="") + "run 20\nwrite_restart good.restart\n",
        folder=folder)
    with open(os.path.join(folder, "good.restart"), "rb") as f:
        good = f.read()
    places = restart_file.rows(good)
    checks.true("a file is sealed as it is written" + plane, restart_file.seal(good, places) == good)
    fields = [(name, k) for name, n in COLUMNS.items() if name not in missing for k in range(n)]
    # the rows: the number of values, the ID, and then the values
    lead = struct.pack("d", len(fields) + 2)
    rows = [m.start() + 16 for m in re.finditer(re.escape(lead), good)
            if 7000 < struct.unpack_from("d", good, m.start() + 16)[0] < 8700]
    checks.true("rows of the particles are found in the file" + plane, len(rows) == 48, str(len(rows)))
    row = rows[20]
    for at, (name, k) in enumerate(fields):
        if k not in (0, COLUMNS[name] - 1):
            continue
        bad = bytearray(good)
        bad[row + 8 * at:row + 8 * at + 8] = struct.pack("d", np.nan)
        ends("NaN in %s %d %s" % (name, k + 1, plane), go_on(restart_file.seal(bad, places), "bad.restart"),
             "damaged", "not a finite number")
    checks.true("the whole file goes on" + plane, go_on(good, "again.restart").status == 0)
bad = bytearray(good)
bad[row + 6] ^= 0x10    # one bit of a density
ends("one bit of a value flipped", go_on(bad, "bad.restart"), "damaged", "checksum of the particles")
ends("one bit of a value flipped, sealed", go_on(restart_file.seal(bad, places), "bad.restart"), "damaged", "checksum")
for share in (0.05, 0.3, 0.7, 0.98):
    r = go_on(good[:int(share * len(good))], "cut.restart")
    checks.true("restart file cut at %g" % share, r.status != 0 and "ERROR" in r.output, r.errors()[:150])

# --- values that become no numbers in the run, in each field of the state that a script can reach
for what, command in (("position", "variable n atom (id==20)*exp(1000)\nset atom 20 x v_n"),
                      ("velocity", "variable n atom exp(1000)\nvelocity all set v_n NULL NULL"),
                      ("force", "variable n equal exp(1000)\nfix nan all addforce v_n 0 0")):
    r = run(HEAD.format(plane="", eos="") + FIXES.format(tool="") + "run 20\n" + command + "\nrun 20\n", folder=folder,
            expect_error=True)
    checks.true("NaN in " + what, r.status != 0 and "ERROR" in r.output, r.errors()[:150])

# --- the mesh is gone when the run is to go on
os.rename(os.path.join(folder, "tool.stl"), os.path.join(folder, "gone.stl"))
ends("mesh file gone at restart", go_on(good, "again.restart"), "tool.stl")
make_mesh()

# --- a full disk
if os.path.exists("/dev/full"):
    for what, tool, more in (("mesh output", "vtk 10 full.*.vtk", ""), ("mesh output, STL", "stl 10 full.*.stl", ""),
                             ("restart file", "", "restart 10 full.*.vtk\n")):
        for step in range(0, 41, 10):
            for end in ("vtk", "stl"):
                path = os.path.join(folder, "full.%d.%s" % (step, end))
                if not os.path.islink(path):
                    os.symlink("/dev/full", path)
        r = run(HEAD.format(plane="", eos="") + FIXES.format(tool=tool) + more + "run 40\n", folder=folder,
                expect_error=True)
        ends("full disk, " + what, r)

# --- a rank is killed: the others end, and the last restart file is whole
script = HEAD.format(plane="", eos="") + FIXES.format(tool="") + "restart 100 rank.*.restart\nrun 10000000\n"
with open(os.path.join(folder, "in.killed"), "w") as f:
    f.write(script)
command = shlex.split(os.environ.get("SPHTM_MPIRUN", "mpirun"))
command += ["-np", "2", os.environ["SPHTM_LMP"], "-nocite", "-log", "none", "-in", "in.killed"]
if shutil.which(command[0]):
    going = subprocess.Popen(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                             stdin=subprocess.DEVNULL, text=True, start_new_session=True)
    begin = time.time()
    while time.time() - begin < 60 and not os.path.exists(os.path.join(folder, "rank.200.restart")):
        time.sleep(0.1)
    children = subprocess.run(["ps", "-o", "pid=,args=", "--ppid", str(going.pid)], stdout=subprocess.PIPE,
                              text=True).stdout
    ranks = [int(line.split()[0]) for line in children.splitlines() if "in.killed" in line]
    checks.true("two ranks run", len(ranks) == 2, str(ranks))
    if ranks:
        os.kill(ranks[-1], signal.SIGKILL)
    try:
        going.communicate(timeout=60)
    except subprocess.TimeoutExpired:
        os.killpg(going.pid, signal.SIGKILL)
        going.communicate()
    checks.true("one rank killed: the run ends with an error", going.returncode not in (0, -9), str(going.returncode))
    with open(os.path.join(folder, "rank.100.restart"), "rb") as f:
        checks.true("the restart file before goes on", go_on(f.read(), "again.restart").status == 0)
checks.end()
