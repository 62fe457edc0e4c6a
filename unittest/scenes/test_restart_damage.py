"""Restart files with one flipped bit each, at places drawn once for all, and cut ones: each is refused in words, or goes
on to the last digit as the whole file does; none crashes.

    test_restart_damage.py [flips] [cuts]
"""
import os
import random
import re
import struct
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

from sphtm_scene import SOURCE, Checks, lattice_block, new_folder, run

FLIPS, CUTS = (int(a) for a in (sys.argv[1:] + ["500", "50"][len(sys.argv) - 1:])[:2])
HEAD = lattice_block("0 0.008 0 0.006", "-0.02 0.02 -0.02 0.02", types=2, more="atom_modify     map array\n") + """
group           low id 1:8
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 7830 elastic 200e9 0.29 strength johnson/cook 792e6 510e6 0.26 0.014 1.03 298 1793 1 &
                heat 38 477 0.9
pair_coeff      2 2 density 7830 elastic 200e9 0.29 heat 38 477 0.9
pair_coeff      1 2 contact friction 0.1
"""
FIXES = """
fix             body all sph/tm temperature 300 energy yes
fix             hold low setforce 0 0 0
fix             tool all contact/tri file tool.stl move 0 0.0069 0 friction 0.3 overlap allow
fix             hot low sph/tm/heat source 1e3
fix             lists all adapt/neigh threshold 1e-4
compute         p all sph/tm/atom density temperature pstrain vonmises
compute         m all reduce max c_p[*]
thermo_style    custom step time dt ke f_body[9] f_tool[2] f_hot[2] c_m[*]
thermo_modify   format float %.17g
thermo          10
"""
GO_ON = "read_restart NAME\n" + FIXES + "run 30\n" + \
    "write_dump all custom NAME.dump id type x y vx vy fx fy c_p[*] modify sort id format float %.17g\n"

checks = Checks()
folder = new_folder()
subprocess.run([sys.executable, os.path.join(SOURCE, "tools", "make_tool.py"), "block", "--size", "0.03", "0.002", "0.02",
                "-o", os.path.join(folder, "tool.stl")], check=True, stdout=subprocess.DEVNULL)
run(HEAD + FIXES + "fix_modify      tool move linear 0 -50 0\nrun 200\nwrite_restart good.restart\n", folder=folder)
with open(os.path.join(folder, "good.restart"), "rb") as f:
    good = f.read()


def attempt(name, data):
    """What came of it: refused, the same, or what is wrong."""
    path = os.path.join(folder, name)
    with open(path, "wb") as f:
        f.write(data)
    script = os.path.join(folder, "in." + name)
    with open(script, "w") as f:
        f.write(GO_ON.replace("NAME", name))
    try:
        done = subprocess.run([os.environ["SPHTM_LMP"], "-nocite", "-log", "none", "-in", script], cwd=folder,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, timeout=120,
                              env=dict(os.environ, OMP_NUM_THREADS="1"))
        text, status = done.stdout.decode(errors="replace"), done.returncode
    except subprocess.TimeoutExpired:
        return "it hangs", ""
    error = " ".join(re.findall(r"^ERROR.*", text, re.M))
    dump = path + ".dump"
    end = ""
    if os.path.exists(dump):
        with open(dump) as f:
            end = f.read()
        os.remove(dump)
    thermo = re.findall(r"^ +\d+ .*", text, re.M)
    os.remove(path)
    os.remove(script)
    if status < 0 or status > 128:
        return "it crashes with status %d" % status, text[-300:]
    if status:
        return ("refused" if error else "it ends with %d without an error" % status), error or text[-300:]
    return end + "\n".join(thermo), text


whole, text = attempt("whole", good)
checks.true("the whole file goes on", whole.count("\n") > 50, text[-300:] if whole.count("\n") <= 50 else "")
draw = random.Random(1)
damaged = [(draw.randrange(len(good)), 1 << draw.randrange(8)) for k in range(FLIPS)]
cuts = [draw.randrange(1, len(good)) for k in range(CUTS)]


def flipped(case):
    at, bit = case
    data = bytearray(good)
    data[at] ^= bit
    return attempt("flip.%d.%d" % case, bytes(data))


def cut(length):
    return attempt("cut.%d" % length, good[:length])


count = {"refused": 0, "named": 0, "the same": 0}
unnamed = {}    # errors of LAMMPS's own reader, which comes first
with ThreadPoolExecutor(2) as pool:
    results = list(zip(["bit %d of byte %d flipped" % (b, a) for a, b in damaged], pool.map(flipped, damaged)))
    results += zip(["cut after %d bytes" % n for n in cuts], pool.map(cut, cuts))
for name, (outcome, text) in results:
    if outcome == "refused":
        count["refused"] += 1
        if re.search(r"(flip|cut)\.\d", text):
            count["named"] += 1
        else:
            unnamed.setdefault(re.sub(r"\d+", "N", text.split("(src")[0])[:100], []).append(name)
    elif outcome == whole:
        count["the same"] += 1
    else:
        checks.true(name + " of %d" % len(good), False, (outcome if len(outcome) < 60 else "it goes on with other numbers") +
                    " <- " + " ".join(text.split())[-200:])
for text, names in unnamed.items():
    checks.note("%d without the name of the file" % len(names), text)
checks.true("%d flips, %d cuts" % (FLIPS, CUTS), sum(count[k] for k in ("refused", "the same")) == FLIPS + CUTS,
            "%(refused)d refused, %(named)d of them with the name of the file, %(the same)d harmless" % count)
checks.end()
