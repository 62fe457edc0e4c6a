"""Damaged restart files of fix adapt/neigh: whatever the values of refinement and of kept rows are, the answer is a
message with the file's name, not a crash; with other keywords as well."""
import os
import struct
from concurrent.futures import ThreadPoolExecutor

import restart_file
from sphtm_scene import Checks, lattice_block, new_folder, run

PAIR = """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 2700 elastic 70e9 0.33 strength plastic 300e6 1e9
"""
REFINE = "refine square epsilon 0.4 alpha 0.6 when region half level 2 every 5"
KEPT = "threshold inf"
HALF = "region half block 0 2e-3 0 2e-3 INF INF units box\n"
HEAD = lattice_block("0 8e-3 0 8e-3", "-5e-3 15e-3 -5e-3 15e-3") + PAIR + HALF
READ = "read_restart %s\n" + HALF
REST = """
fix             body all sph/tm
fix             ad all adapt/neigh %s
velocity        all set 20 0 0
thermo          5
"""
STRANGE = (float("nan"), float("inf"), -1.0, 0.5, 3e9, 1e300, -1e300, 100.0)
checks = Checks()
folder = new_folder()


def made(keywords, name):
    run(HEAD + REST % keywords + "run 12\nwrite_restart %s\n" % name, folder=folder)
    with open(os.path.join(folder, name), "rb") as f:
        return f.read()


def rows(data, keywords):
    """Where the values of particles begin, and how many they are: behind ID and place those of refinement are level, mark,
    two families."""
    found = []
    for at in range(len(data) - 72):
        n, tag, x, y, z, first, second = struct.unpack_from("<7d", data, at)
        if keywords == REFINE and n == 9.0 and first in (0.0, 1.0, 2.0) and second in (0.0, 1.0) and tag >= 1.0:
            found.append((at, 9))
        if keywords == KEPT and 1.0 <= first <= 200.0 and n == 42.0 + 12.0 * first:
            found.append((at, int(n)))
    return found


def attempt(arguments):
    name, data, keywords = arguments
    with open(os.path.join(folder, name), "wb") as f:
        f.write(data)
    own = new_folder()
    return run(READ % os.path.join(folder, name) + REST % keywords + "run 6\n", folder=own, expect_error=True,
               timeout=60)


def try_all(what, keywords, damaged, *fragments):
    """damaged: of a file each; every answer must be an error with the fragments."""
    names = ["%s.%d" % (what.replace(" ", "."), k) for k in range(len(damaged))]
    with ThreadPoolExecutor(2) as pool:
        answers = list(pool.map(attempt, zip(names, damaged, [keywords] * len(names))))
    bad = ["%d: status %d %s" % (k, a.status, a.errors()[:200]) for k, a in enumerate(answers)
           if a.status <= 0 or a.status >= 124 or not a.errors() or
           any(f.lower() not in a.errors().lower() for f in fragments + ("restart file",))]
    checks.say(not bad, what, "%d files%s" % (len(names), ", not so: %s" % bad[:4] if bad else ""))


def put(data, at, value):
    return data[:at] + struct.pack("<d", value) + data[at + 8:]


for keywords, label in (REFINE, "refinement"), (KEPT, "kept rows"):
    data = made(keywords, "good.restart")
    of_lammps = restart_file.rows(data)
    again = attempt(("again.restart", data, keywords))
    checks.say(again.status == 0 and not again.warnings(), "the file as it is, " + label, again.errors())
    places = rows(data, keywords)
    checks.above("rows of particles found, " + label, len(places), 60)
    damaged = []
    inner_of = (8, 5, 6, 7, 1) if keywords == REFINE else (11, 5, 9, 42, -1)
    lengths = [put(data, at, value) for (at, n), value in zip(rows(data, keywords), STRANGE)]
    try_all("lengths of rows, " + label, keywords, lengths, "damaged")
    for k in range(20):
        at, n = places[3 * k]
        new = put(data, at + 8 * (inner_of[k % 5] % n), STRANGE[k % 8])
        if new != data:
            damaged.append(restart_file.seal(new, of_lammps))
    try_all("values of particles, " + label, keywords, damaged, "adapt/neigh")
    at, n = places[11]
    flipped = [restart_file.seal(data[:at + 8 * k] + bytes([data[at + 8 * k] ^ 1]) + data[at + 8 * k + 1:], of_lammps)
               for k in range(6, n, n // 3 + 1)]
    try_all("a flipped bit in them, " + label, keywords, flipped, "adapt/neigh")
    block = data.index(struct.pack("<Q", 0x324d545f48505321))
    hurt = [data[:block + k] + bytes([data[block + k] ^ 64]) + data[block + k + 1:] for k in range(0, 120, 23)]
    try_all("a flipped bit in the block, " + label, keywords, hurt, "damaged")
    for other in ("asph psi", "threshold 0", REFINE.replace("level 2", "level 3"), REFINE + " asph psi",
                  "refine square epsilon 0.45 alpha 0.6 when region half level 2", "threshold 1e-5 asph psi"):
        try_all("read with %s, %s" % (other.split(" when")[0], label), other, [data], "adapt/neigh", "same")

# kept rows go into longer and shorter ones, between runs and from a file; too short ones and other kernels are refused
PULL = "\nfix again all momentum 1000 linear 1 1 1\nthermo_style custom step pe ke\n"


def ends(head, keywords, more="", **options):
    return run(head + REST % keywords + "velocity half set -20 0 0\n" + PULL + more + "run 40\n", **options)


made(KEPT, "good.restart")
file = READ % os.path.join(folder, "good.restart") + "group half region half\n"
plain = ends(file, KEPT).thermo[-1]
for rows_ in 64, 24:
    again = ends(file, KEPT + " rows %d" % rows_).thermo[-1]
    checks.say(again["PotEng"][-1] == plain["PotEng"][-1] and again["KinEng"][-1] == plain["KinEng"][-1],
               "kept rows read with rows %d" % rows_, "%r %r" % (again["KinEng"][-1], plain["KinEng"][-1]))
for what, head, keywords, fragments in (
        ("rows 16", file, KEPT + " rows 16", ("neighbors", "room for 16", "rows 32")),
        ("another ratio", file + PAIR.replace("1.2", "1.3"), KEPT, ("gradients were stored", "smoothing length")),
        ("another kernel", file + PAIR.replace("hyperbolic", "cubic"), KEPT, ("hyperbolic kernel", "cubic"))):
    error = ends(head, keywords, expect_error=True).errors()
    checks.say(all(f in error for f in fragments), "kept rows read with " + what, error)
error = ends(HEAD + "group half region half\n", KEPT, "run 5\n" + PAIR.replace("1.2", "1.3"),
             expect_error=True).errors()
checks.say("gradients were stored" in error, "another ratio between runs", error)
checks.end()
