"""What a tool of 100 000 triangles costs beside one of 100 of the same shape: at most 1.3 times per step.

A block lies on a face of a cube, which is in 108 or in 101 568 triangles. Processor time per step (loop time times the
share of a processor that LAMMPS reports), medians of interleaved runs. Instructions per step by 'perf stat' where the
machine lets us count them; with SPHTM_SLOW=1 also by valgrind, a minute more: 1.02 times."""
import os
import re
import shutil
import statistics
import subprocess
import sys

import numpy as np
from contact_scene import block, header, mesh, particles
from sphtm_scene import Checks, new_folder

DX, LIMIT, STEPS = 0.02, 1.3, 150
SCRIPT = """
pair_coeff 1 1 density 1000 elastic 1e7 0.3 {material}
fix body all sph/tm temperature 300
fix g all gravity 10 vector 0 0 -1
fix tool all contact/tri file {mesh} move 0 0 -0.5 friction 0.3 penalty 1 {heat}
thermo_style custom step f_tool[3] f_tool[12] f_tool[10]
thermo 1000
run {steps}
"""


def write(folder, name, counts, steps):
    x = block(counts, DX, (-0.5 * counts[0] * DX, -0.5 * counts[1] * DX, -0.002 * DX))
    with open(os.path.join(folder, "data.%d" % len(x)), "w") as f:
        f.write(particles(x, [(-0.6, 0.6), (-0.6, 0.6), (-1.1, 0.6)], v=np.tile([0.3, 0.2, 0.0], (len(x), 1))))
    script = "in.%s.%d.%d" % (name, len(x), steps)
    with open(os.path.join(folder, script), "w") as f:
        f.write(header(DX, data="data.%d" % len(x)) + SCRIPT.format(
            mesh=name + ".stl", steps=steps, material="heat 50 900 0.9",
            heat="heat conductance 1e4 temperature 400 effusivity 5000"))
    return script


def lmp(folder, script, before=()):
    done = subprocess.run([*before, os.environ["SPHTM_LMP"], "-nocite", "-in", script], cwd=folder, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.PIPE, stdin=subprocess.DEVNULL)
    return done.stdout, done.stderr


def loop_time(folder, script, steps):
    """Seconds of the processor per step, contacts."""
    out, err = lmp(folder, script)
    found, share = re.search(r"Loop time of (\S+) on", out), re.search(r"([\d.]+)% CPU use", out)
    if not found:
        sys.exit(out[-3000:] + err)
    last = [line.split() for line in out.splitlines() if re.match(r"^\s+%d\s" % steps, line)][-1]
    return float(found.group(1)) * float(share.group(1)) / 100 / steps, float(last[2])


def instructions(folder, script):
    """Of the whole process, and who counted; None where nobody can."""
    if shutil.which("perf"):
        found = re.search(r"^(\d+),.*instructions", lmp(folder, script, ("perf", "stat", "-x,", "-e", "instructions:u"))[1],
                          re.M)
        if found:
            return int(found.group(1)), "perf"
    if shutil.which("valgrind") and os.environ.get("SPHTM_SLOW"):
        count = ("valgrind", "--tool=cachegrind", "--cache-sim=no", "--cachegrind-out-file=/dev/null")
        found = re.search(r"I\s+refs:\s+([\d,]+)", lmp(folder, script, count)[1])
        if found:
            return int(found.group(1).replace(",", "")), "valgrind"
    return None, ""


def main():
    if not os.environ.get("SPHTM_LMP"):
        print("no SPHTM_LMP in the environment: skipped")
        sys.exit(77)
    checks = Checks()
    folder = new_folder()
    meshes = {"coarse": 3, "fine": 92}
    for name, n in meshes.items():
        mesh(folder, name + ".stl", "block --size 1 1 1 --cells %d %d %d" % (n, n, n))
    times = {name: [] for name in meshes}
    for k in range(5):
        for name in meshes:
            t, contacts = loop_time(folder, write(folder, name, (20, 20, 10), STEPS), STEPS)
            times[name].append(t)
            if k == 0:
                checks.above(name + ": contacts at the end", contacts, 100)
    median = {name: statistics.median(t) for name, t in times.items()}
    for name in meshes:
        checks.note(name + ": ms per step", " ".join("%.3f" % (1e3 * t) for t in times[name]))
    text = "101568 triangles over 108: "
    checks.below(text + "time per step", median["fine"] / median["coarse"], LIMIT)
    counted = {}
    for name in meshes:
        few, how = instructions(folder, write(folder, name, (10, 10, 5), 5))
        many, how = instructions(folder, write(folder, name, (10, 10, 5), 35)) if few else (None, "")
        counted[name] = (many - few) / 30 if few and many else None
    if all(counted.values()):
        checks.note("instructions per step", "%.4g, %.4g by %s" % (counted["coarse"], counted["fine"], how))
        checks.below(text + "instructions per step", counted["fine"] / counted["coarse"], LIMIT)
    checks.end()


main()
