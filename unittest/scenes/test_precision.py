"""Pair arithmetic in single (precision mixed): what it leaves the same, and how far it is from double.

Far from the origin and in fast flight differences of neighbors must not lose digits, a stressed body must stay at rest,
momentum and energy must hold, and neither ranks nor restarts may show."""
import numpy as np

from sphtm_scene import Checks, lattice_block, run

WORK = " ".join(3 * ["$(v_far) $(v_far+0.01)"])
BOX = " ".join(3 * ["$(v_far-0.03) $(v_far+0.05)"])
SCENE = lattice_block(WORK, BOX, dim=3, more="""\
atom_modify     map array
variable        far index 0
variable        fly index 0
variable        amplitude index 50
""") + """
pair_style      sph/tm {kernel} {precision} spacing 1e-3 {more}
pair_coeff      1 1 density 2700 elastic 70e9 0.33 strength johnson/cook 324e6 114e6 0.42 0.002 1.34 293 855 1.0 &
                heat 167 896 0.9
fix             body all sph/tm temperature 293 dt 4e-8 energy yes
variable        u atom v_fly+v_amplitude*sin(300*(x-v_far))*cos(200*(y-v_far))
velocity        all set v_u 0 0
compute         p all sph/tm/atom temperature pressure
variable        px equal mass(all)*(vcm(all,x)-v_fly)
variable        py equal mass(all)*vcm(all,y)
thermo_style    custom step time v_px v_py f_body[1] f_body[9]
thermo_modify   format float %.15g
thermo          20
"""
STEPS = """
run             {steps}
write_dump      all custom end.dump id x y z vx vy vz c_p[*] modify sort id format float %.17g
"""
checks = Checks()


def scene(precision="", kernel="hyperbolic 1.2", more="", steps=200, ranks=1, **variables):
    text = SCENE.format(precision=precision and "precision " + precision, kernel=kernel, more=more)
    result = run(text + STEPS.format(steps=steps), variables, ranks=ranks)
    return result, result.dump("end.dump")[-1]


def differ(a, b, columns):
    """Largest difference over the largest value."""
    return max(np.abs(a[c] - b[c]).max() for c in columns) / max(np.abs(b[c]).max() for c in columns)


V, STATE = ("vx", "vy", "vz"), ("x", "y", "z", "vx", "vy", "vz", "c_p[1]", "c_p[2]")

# --- the keyword
_, plain = scene()
_, double = scene("double")
checks.true("double is the default, bit for bit", all((plain[c] == double[c]).all() for c in STATE))
result, mixed = scene("mixed")
checks.true("mixed is another arithmetic", not (mixed["vx"] == double["vx"]).all())
# 2^-24 of the stress in each of 200 steps, magnified by some ten by the motion
checks.below("velocities, mixed against double", differ(mixed, double, V), 2e-5)
checks.below("pressure, mixed against double", differ(mixed, double, ["c_p[2]"]), 2e-5)
table = result.thermo[-1]
size = 1000 * 2700e-9 * np.abs(double["vx"]).mean()
drift = max(np.ptp(table["v_px"]), np.ptp(table["v_py"]))
checks.below("momentum, change over that of the particles", drift / size, 1e-6)
checks.below("energy sum, drift over kinetic energy", np.ptp(table["f_body[9]"]) / table["f_body[1]"][0], 0.01)
for kernel, more in (("cubic 1.3", "form f14"), ("wendland/c2 1.5", "correction yes xsph 0.3 balsara yes hourglass 0.02"),
                     ("quintic 1.0", "artstress 0 1")):
    (_, a), (_, b) = (scene(p, kernel, more, steps=60) for p in ("mixed", "double"))
    checks.below("%s %s: velocities" % (kernel, more), differ(a, b, V), 2e-5)

# --- ranks and restarts
_, two = scene("mixed", ranks=2)
checks.true("two ranks, the same bits", all((two[c] == mixed[c]).all() for c in STATE))
first = run(SCENE.format(precision="precision mixed", kernel="hyperbolic 1.2", more="")
            + "run 100\nwrite_restart half.restart\n")
again = run("read_restart half.restart\nfix body all sph/tm temperature 293 dt 4e-8 energy yes\n"
            "compute p all sph/tm/atom temperature pressure\n" + STEPS.format(steps=100), folder=first.folder)
end = again.dump("end.dump")[-1]
checks.true("a restart keeps mixed and its bits", all((end[c] == mixed[c]).all() for c in STATE))

# --- far from the origin, and in flight
_, away = scene("mixed", far=100)          # 1e5 spacings: positions in single would be off by 0.006 spacings
_, away_double = scene("double", far=100)
checks.below("1e5 spacings from the origin: velocities", differ(away, away_double, V), 2e-5)
for fly in (0, 400):    # waves of 0.1 m/s in a body at rest, and at 400 m/s, where single resolves 3e-5 m/s
    (_, a), (_, b) = (scene(p, fly=fly, amplitude=0.1, steps=100) for p in ("mixed", "double"))
    checks.below("waves of 0.1 m/s at %d m/s: error of the velocity, m/s" % fly,
                 max(np.abs(a[c] - b[c]).max() for c in V), 1e-6 if fly == 0 else 1e-4)

# --- a stressed body at rest: a column that stands on its foot, under 1e5 times its weight at g
REST = lattice_block("-0.005 0.005 0 0.02", "-0.03 0.03 -0.01 0.05") + """
region          foot block INF INF INF 0.003 INF INF units box
group           foot region foot
pair_style      sph/tm hyperbolic 1.2 precision {precision} spacing 1e-3
pair_coeff      1 1 density 7850 elastic 200e9 0.29 strength elastic
fix             body all sph/tm
fix             weight all gravity 1e6 vector 0 -1 0
fix             damping all viscous 5000
fix             hold foot setforce 0 0 0
compute         p all sph/tm/atom vonmises
compute         s all reduce max c_p
variable        top equal bound(all,ymax)
thermo_style    custom step time f_body[1] ke c_s v_top
thermo_modify   norm no format float %.15g
thermo          100
run             3000
"""
rest = {p: run(REST.format(precision=p)).thermo[-1] for p in ("double", "mixed")}
speed = {p: np.sqrt(2 * t["KinEng"][-1] / (200 * 7850e-6)) for p, t in rest.items()}
checks.note("column at rest: largest stress, Pa; mean speed, m/s", "%.3g; double %.2e, mixed %.2e" %
            (rest["mixed"]["c_s"][-1], speed["double"], speed["mixed"]))
# each step may round forces to 2^-24 of sigma/(rho dp): the speed that this gives in one oscillation of a particle
noise = 2.0 ** -24 * rest["mixed"]["c_s"][-1] / (7850 * 5000)
checks.below("speed in mixed over that of rounded forces", speed["mixed"] / (noise + speed["double"]), 10)
checks.near("height, mixed against double", rest["mixed"]["v_top"][-1], rest["double"]["v_top"][-1], relative=1e-7)

# --- what is refused
wrong = run(SCENE.format(precision="precision mixed", kernel="hyperbolic 1.2", more="") + "run 0\n", {"far": 1e6},
            expect_error=True)
checks.true("a box too far from the origin", "precision mixed: the box reaches" in wrong.errors(), wrong.errors())
checks.end()
