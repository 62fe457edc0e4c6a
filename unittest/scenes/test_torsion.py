"""A drive that turns (fix sph/tm/drive ... rotate): torsion of a round bar against its plastic limit, of a square one against
Saint-Venant; torque against angular momentum; a ring about an axis that moves, in 2D; restart, ranks, messages.

    test_torsion.py round 8 10 12 16     torque of round bars with so many particles over the diameter, over the limit; no checks
    test_torsion.py rings 4 5 6 8        the same of bars that are made of so many rings (examples/taylor_bar/make_bar.py)"""
import os
import sys

import numpy as np
from sphtm_scene import SOURCE, Checks, new_folder, run

sys.path.insert(0, os.path.join(SOURCE, "examples", "taylor_bar"))
from make_bar import make_bar                                                          # noqa: E402

TAU = 300e6 / np.sqrt(3.0)
SHEAR = 200e9 / 2.6
HEAD = """
units           si
dimension       3
boundary        f f f
atom_style      atomic
newton          off
atom_modify     map array
"""
LATTICE = HEAD + """
variable        dx equal 8e-3/${n}
variable        grip equal 4*v_dx
lattice         sc ${dx} origin 0.5 0.5 0.5
region          box block -9e-3 9e-3 -9e-3 9e-3 -5e-3 17e-3 units box
create_box      1 box
region          bar ${section} $(-v_grip) $(12e-3+v_grip) units box
create_atoms    1 region bar
variable        length equal 12e-3
"""
RINGS = HEAD + """
read_data       bar.data
change_box      all z final -10e-3 25e-3
displace_atoms  all move 0 0 ${down}
"""
PARTS = """
region          low block INF INF INF INF INF 0 units box
region          high block INF INF INF INF ${length} INF units box
group           low region low
group           high region high
group           rest subtract all low high
pair_style      sph/tm hyperbolic 1.2 spacing ${dx}
pair_coeff      1 1 density 7850 elastic 200e9 0.3 ${strength}
"""
BAR = LATTICE + PARTS
TWIST = """
fix             body all sph/tm energy yes
variable        w equal ${rate}*((time<3e-5)*time/3e-5+(time>=3e-5))
fix             hold low sph/tm/drive 0 0 0 rotate 0 0 0 0 0 1 0
fix             twist high sph/tm/drive 0 0 ${axial} rotate 0 0 0 0 0 2 v_w
variable        lz equal angmom(rest,z)
thermo          ${every}
thermo_style    custom step time dt f_twist[5] f_twist[6] f_twist[4] f_twist[3] f_hold[5] f_body[8] f_body[9] v_lz v_w
thermo_modify   format float %.16g
variable        left equal ${most}-f_twist[6]
fix             stop all halt ${every} v_left <= 0 error continue message no
write_dump      all custom start.dump id x y z modify sort id format float %.16g
run             1000000
write_dump      all custom end.dump id x y z vx vy vz modify sort id format float %.16g
"""
ROUND, SQUARE = "cylinder z 0 0 4e-3", "block -4e-3 4e-3 -4e-3 4e-3"
LIMIT = 2.0 / 3.0 * np.pi * 4e-3**3 * TAU
checks = Checks()


def angle_between(before, after):
    turn = np.arctan2(after["y"], after["x"]) - np.arctan2(before["y"], before["x"])
    return np.mod(turn + np.pi, 2 * np.pi) - np.pi


FLOWS = {"strength": "strength plastic 300e6 0", "rate": 8000, "every": 20, "most": 0.5}


def flowing(n, axial):
    """A round bar that flows: run, torque in each line of its thermo output, their mean from 0.3 on."""
    return torque_of(run(BAR + TWIST, dict(FLOWS, n=n, section=ROUND, axial=axial)))


def of_rings(n):
    """The same of n rings: where layers begin and end follows from the radius, so grips have 4 of them."""
    folder = new_folder()
    spacing = make_bar(n, 4e-3, 12e-3 + 8 * 4e-3 / n, 7850, os.path.join(folder, "bar.data"))
    with open(os.path.join(folder, "bar.data")) as f:
        lines = f.read().split("Atoms", 1)[1].split("\n")[2:]
    z = np.unique(np.round([float(w.split()[-1]) for w in lines if len(w.split()) >= 5], 9))
    low, high = 0.5 * (z[3] + z[4]), 0.5 * (z[-4] + z[-5])
    return torque_of(run(RINGS + PARTS + TWIST, dict(FLOWS, dx=spacing, down=-low, length=high - low, axial="0"), folder=folder))


def torque_of(r):
    t = r.thermo[-1]
    torque = -0.5 * (t["f_twist[5]"] - t["f_hold[5]"])
    return r, torque, torque[t["f_twist[6]"] > 0.3].mean()


if sys.argv[1:2] == ["round"]:
    for n in map(int, sys.argv[2:]):
        print("%d over the diameter: torque over 2/3 pi R^3 tau %.3f" % (n, flowing(n, "0")[2] / LIMIT))
    sys.exit(0)
if sys.argv[1:2] == ["rings"]:
    for n in map(int, sys.argv[2:]):
        print("%d rings: torque over 2/3 pi R^3 tau %.3f" % (n, of_rings(n)[2] / LIMIT))
    sys.exit(0)

# metal that flows: torque of the whole section at its shear flow stress; bars of rings come up to it from below
coarse, fine = (of_rings(n)[2] / LIMIT for n in (4, 6))
print("round bars of 4 and 6 rings: torque over the limit %.3f, %.3f" % (coarse, fine))
checks.near("round bar of 6 rings: plastic torque", fine, 1.0, relative=0.03)
checks.true("  nearer than with 4 rings", 0.94 < coarse < fine < 1.0, "%.3f %.3f" % (coarse, fine))
for axial, n in ("0", 8), ("NULL", 8):
    r, torque, mean = flowing(n, axial)
    t, name = r.thermo[-1], "round bar, axis %s: " % ("held" if axial == "0" else "free")
    print(name + "torque %.2f N m, limit %.2f" % (mean, LIMIT))
    checks.near(name + "plastic torque", mean, LIMIT, relative=0.02)
    checks.below(name + "drift of the energy sum over the work", abs(t["f_body[9]"]).max() / t["f_twist[4]"][-1], 1e-6)
    work = np.sum(np.diff(t["f_twist[6]"]) * -0.5 * (t["f_twist[5]"][1:] + t["f_twist[5]"][:-1]))
    checks.near(name + "work in the balance", -t["f_body[8]"][-1], t["f_twist[4]"][-1], relative=1e-9)
    a, b = r.dump("start.dump")[-1], r.dump("end.dump")[-1]
    grip = a["z"] > 12e-3
    spin = 0.5 * 7850 * (8e-3 / n)**3 * np.sum((a["x"]**2 + a["y"]**2)[grip]) * t["v_w"][-1]**2
    checks.near(name + "work, integral of the torque over the angle and energy of the grip", t["f_twist[4]"][-1], work + spin, relative=0.005)
    checks.below(name + "change of a radius of the grip over it", abs(np.hypot(b["x"], b["y"]) / np.hypot(a["x"], a["y"]) - 1)[grip].max(), 1e-7)
    checks.below(name + "angle of the grip less that told", abs(angle_between(a, b)[grip] - t["f_twist[6]"][-1]).max(), 1e-7)
    speed = np.stack([-b["y"], b["x"]]) * t["v_w"][-1]
    checks.below(name + "velocity of the grip less that of the turn", abs(np.stack([b["vx"], b["vy"]]) - speed)[:, grip].max() / 32.0, 1e-12)
    held = abs(b["z"] - a["z"])[grip].max()
    checks.true(name + "it moves along the axis where that is free", held == 0.0 if axial == "0" else held > 0.0, "%g" % held)

# torque and angular momentum of what is between the grips, step by step
r = run(BAR + TWIST, {"n": 6, "section": ROUND, "strength": "strength plastic 300e6 0", "rate": 8000, "axial": "0", "every": 1, "most": 0.3})
t = r.thermo[-1]
taken = -np.cumsum((t["f_twist[5]"] + t["f_hold[5]"])[1:] * t["Dt"][1:])
checks.near("angular momentum between the grips, from their torques", t["v_lz"][-1] - t["v_lz"][0], taken[-1], absolute=0.01 * abs(taken).max())

# elastic: square section, 0.1406 G a^4 over the length between the outermost driven centers
due = 0.1406 * SHEAR * 8e-3**4
for n, soft in (8, 0.14), (12, 0.09):
    t = run(BAR + TWIST, {"n": n, "section": SQUARE, "strength": "", "rate": 100, "axial": "0", "every": 20, "most": 0.003}).thermo[-1]
    late = t["f_twist[6]"] > 0.0015
    stiff = np.polyfit(t["f_twist[6]"][late], 0.5 * (t["f_hold[5]"] - t["f_twist[5]"])[late], 1)[0] * (12e-3 + 8e-3 / n) / due
    print("square bar of %d rows: torsional stiffness %.3f of Saint-Venant's" % (n, stiff))
    checks.near("square bar, %d rows: torsional stiffness" % n, stiff, 1.0, relative=soft)

# 2D: a free disk whose hub turns about an axis that moves; it follows as a whole, across a periodic face too
DISK = """
units           si
dimension       2
boundary        p f p
atom_style      atomic
newton          off
atom_modify     map array
lattice         sq 1e-3 origin 0.5 0.5 0
region          box block -20e-3 20e-3 -20e-3 20e-3 -5e-4 5e-4 units box
create_box      1 box
region          disk sphere 15e-3 0 0 8e-3 units box
create_atoms    1 region disk
region          hub sphere 15e-3 0 0 3e-3 units box
group           hub region hub
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 2700 elastic 70e9 0.33
"""
SPIN = """
fix             body all sph/tm energy yes
variable        w equal 5000*((time<1e-4)*time/1e-4+(time>=1e-4))
variable        v equal 20*((time<1e-4)*time/1e-4+(time>=1e-4))
fix             turn hub sph/tm/drive v_v 0 0 rotate 15e-3 0 0 0 0 1 v_w
thermo          50
thermo_style    custom step time f_turn[5] f_turn[6] f_turn[4] f_body[9]
thermo_modify   format float %.16g
"""
END = "write_dump all custom {} id xu yu vx vy modify sort id format float %.16g\n"
HALF = "variable left equal 3e-4-time\nfix stop all halt 50 v_left <= 0 error continue message no\nrun 100000\n"
WHOLE = "variable left equal 6e-4-time\nfix stop all halt 50 v_left <= 0 error continue message no\nrun 100000\n"
START = END.format("start.dump") + "run 0\n"
first = run(DISK + SPIN + START + HALF + "write_restart half\n" + WHOLE + END.format("whole.dump"))
a, b, t = first.dump("start.dump")[-1], first.dump("whole.dump")[-1], first.thermo[-1]
time = t["Time"][-1]
turned, way = 5000 * (time - 5e-5), 20 * (time - 5e-5)
hub = np.hypot(a["xu"] - 15e-3, a["yu"]) < 3e-3
checks.near("disk: angle", t["f_turn[6]"][-1], turned, relative=1e-5)
arm = np.exp(1j * turned) * (a["xu"] - 15e-3 + 1j * a["yu"])
off = abs(b["xu"] + 1j * b["yu"] - (15e-3 + way) - arm)
checks.below("disk: places of the hub, in spacings", off[hub].max() / 1e-3, 1e-3)
checks.below("disk: places of the rest, in spacings", off.max() / 1e-3, 0.1)
checks.true("disk: it crossed the face of the box", (b["xu"] > 20e-3 + 5e-3).any())
checks.below("disk: drift of the energy sum over the work", abs(t["f_body[9]"][-1]) / t["f_turn[4]"].max(), 1e-6)
AGAIN = "\nread_restart half\n" + SPIN + WHOLE
second = run(AGAIN + END.format("again.dump"), folder=first.folder)
c = second.dump("again.dump")[-1]
for k in "xu", "yu", "vx", "vy":
    checks.true("restart bit for bit: " + k, np.array_equal(b[k], c[k]), "%g" % abs(b[k] - c[k]).max())
checks.near("restart: angle", second.thermo[-1]["f_turn[6]"][-1], t["f_turn[6]"][-1], relative=0)
two = run(AGAIN + END.format("two.dump"), folder=first.folder, ranks=2)
d = two.dump("two.dump")[-1]
checks.below("two ranks: places, in spacings", abs(b["xu"] - d["xu"]).max() / 1e-3, 1e-8)
checks.near("two ranks: torque", two.thermo[-1]["f_turn[5]"][-1], t["f_turn[5]"][-1], absolute=1e-8 * abs(t["f_turn[5]"]).max())
other = run(AGAIN.replace("rotate 15e-3 0 0 0 0 1 v_w", ""), folder=first.folder, expect_error=True)
checks.true("restart with a drive that does not turn", "does not turn" not in other.errors() and "it turns (rotate)" in other.errors(), other.errors()[:140])

for words, expected in (
        ("0 0 0 rotate 0 0 0 0 0 1", "rotate must read"), ("0 0 0 rotate 0 0 0 0 0 0 5", "has no direction"),
        ("0 0 0 turn 0 0 0 0 0 1 5", "unknown keyword turn"), ("0 0 0 rotate 0 0 0 1 0 0 5", "in 2d the axis is z"),
        ("NULL 0 0 rotate 0 0 0 0 0 1 5", "vx is NULL, but rotate"), ("0 0 0 rotate a 0 0 0 0 1 5", "Expected floating point"),
        ("0 0 0 rotate 0 0 0 0 0 1 fast", "rotate omega must be a number or v_name, got fast")):
    result = run(DISK + "fix body all sph/tm\nfix d hub sph/tm/drive " + words + "\nrun 0\n", expect_error=True)
    checks.true("message for '%s'" % words, expected in result.errors(), result.errors()[:140])
checks.end()
