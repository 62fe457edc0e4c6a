"""A bar of elastic, perfectly plastic material is bent by a moment, and released (fix sph/tm/relax).

Plane stress, moment M on both ends, yield stress Y, height H, length l: the curvature at first yield is
k_Y = 2 Y/(E H) with the moment M_Y = Y H^2/6. Beyond it (Timoshenko, Strength of Materials II, 1956)
    M/M_Y = 3/2 (1 - (k_Y/k)^2/3),
and what is left after an elastic release is
    k_res/k_Y = k/k_Y - M/M_Y,      stress sigma(y) - M/M_Y 2 y/H Y, at the faces Y (1 - M/M_Y)."""
import numpy as np
from sphtm_scene import Checks, run

SCENE = """
units si
dimension 2
boundary f f p
atom_style atomic
newton off
atom_modify map array
lattice sq 1 origin 0.5 0.5 0
region box block -40 40 -20 20 -0.5 0.5 units box
create_box 1 box
region bar block $(-v_n*2) $(v_n*2) $(-v_n/2) $(v_n/2) INF INF units box
create_atoms 1 region bar
region left block INF $(-v_n*2+3) INF INF INF INF units box
region right block $(v_n*2-3) INF INF INF INF INF units box
group left region left
group right region right
group ends union left right
pair_style sph/tm hyperbolic 1.2 spacing 1 plane stress artstress 0 4 correction second hourglass 0.01
pair_coeff 1 1 density 1 elastic 1000 0.3 strength {flow}
fix body all sph/tm energy yes
compute s all sph/tm/atom stress/xx pstrain
variable y0 atom y
variable side atom "(x > 0) - (x < 0)"
compute y all property/atom y
fix start all store/state 0 y x
# moment M on three columns of each end: forces linear in y, each column a third
variable slow equal {ramp}
variable load equal "(time < v_slow)*0.5*(1-cos(PI*time/v_slow)) + (time >= v_slow)"
variable M equal {M}
variable inertia equal v_n*(v_n*v_n-1)/12
variable fx atom "v_load*v_M/v_inertia/3*f_start[1]*((f_start[2] > 0) - (f_start[2] < 0))"
fix moment ends addforce v_fx 0 0
fix relax all sph/tm/relax {damping}
thermo_style custom step time dt f_relax f_relax[1] f_relax[2] f_relax[3] f_relax[4] f_relax[6] &
                f_body[1] f_body[2] f_body[7] f_body[8] f_body[9]
thermo 100
run 0
run $(ceil(v_slow/dt))
variable left equal f_relax-{limit}
fix stop all halt 100 v_left < 0 error continue message no
run {most}
write_dump all custom bent.dump id x y c_s[1] c_s[2]
unfix stop
# the release
variable load equal "(time < v_end)*0.5*(1+cos(PI*(time-v_end+v_slow)/v_slow))"
variable end equal $(time)+v_slow
run $(ceil(v_slow/dt))
unfix moment
fix stop all halt 100 v_left < 0 error continue message no
run {most}
write_dump all custom free.dump id x y c_s[1] c_s[2]
"""
E, Y = 1000.0, 1.0
checks = Checks()


def bend(n, over, flow="%r" % Y, damping="", limit=1e-3, most=40000, ramp=None):
    """over: M/M_Y."""
    M = over * Y * n * n / 6
    # the slowest bending mode of the free bar: (4.73/l)^2 sqrt(E I/(rho A))
    period = 2 * np.pi / ((4.73 / (4 * n)) ** 2 * np.sqrt(E / 12) * n)
    text = SCENE.format(flow=flow, M=repr(M), damping=damping, limit=limit, most=most, ramp=repr(ramp or 2 * period))
    result = run(text, dict(n=n))
    return result, [result.dump(name)[-1] for name in ("bent.dump", "free.dump")]


def curvature(frame, start, n):
    """Of the middle line, over the middle half of the bar."""
    middle = (abs(start["x"]) < n) & (abs(start["y"]) < 1)
    return -2 * np.polyfit(frame["x"][middle], frame["y"][middle], 2)[0]


n = 12
K_Y = 2 * Y / (E * n)

# --- elastic: as stiff as a beam, and straight again
result, frames = bend(n, 0.5, "elastic")
flat = dict(x=frames[1]["x"], y=np.round(frames[1]["y"] - 0.5) + 0.5)    # where the particles were
k = [curvature(f, flat, n) / K_Y for f in frames]
checks.near("elastic: curvature", k[0], 0.5, relative=0.03)
checks.below("elastic: curvature when released", abs(k[1]), 1e-4)
softer = k[0] / 0.5

# --- beyond first yield
for over, tolerance in ((1.2, 0.03), (1.35, 0.03)):
    result, frames = bend(n, over, "plastic %r 0" % Y)
    name = "M/M_Y %g: " % over
    bent, free = [curvature(f, flat, n) / K_Y for f in frames]
    log = result.thermo
    checks.note(name + "steps: load, hold, release, hold",
                " ".join("%d" % (t["Step"][-1] - t["Step"][0]) for t in log[1:]))
    checks.note(name + "curvatures over k_Y, closed form", "%.4f %.4f, %.4f %.4f" % (
        bent, free, 1 / np.sqrt(3 - 2 * over), 1 / np.sqrt(3 - 2 * over) - over))
    checks.near(name + "moment that belongs to the curvature", 1.5 * (1 - 1 / (3 * (bent / softer) ** 2)), over,
                relative=tolerance)
    checks.near(name + "spring-back", bent - free, over * softer, relative=0.01)
    # residual stress, over the height in the middle of the bar
    middle = abs(flat["x"]) < n
    y = flat["y"][middle]
    kappa = 1 / np.sqrt(3 - 2 * over)
    exact = np.clip(2 * y / n * kappa, -1, 1) - over * 2 * y / n
    stress = frames[1]["c_s[1]"][middle] / Y
    off = np.sqrt(((stress - exact) ** 2).mean())
    checks.below(name + "residual stress, root of the mean square error over Y", off, 0.04)
    outer = abs(y) > n / 2 - 1
    checks.near(name + "residual stress of the outer rows over Y", (stress[outer] * np.sign(y[outer])).mean(),
                1 - over * (n - 1) / n, absolute=0.04)
    for phase in 2, 4:
        checks.below(name + "out of balance at the end of phase %d" % phase, log[phase]["f_relax"][-1], 1e-3)
    checks.below(name + "kinetic over elastic energy", log[4]["f_body[1]"][-1] / log[4]["f_relax[6]"][-1], 1e-6)
    work = max(abs(t["f_body[8]"]).max() for t in log)
    drift = max(abs(t["f_body[9]"]).max() for t in log)
    checks.below(name + "drift of the energy sum over the work", drift / work, 1e-5)
    checks.above(name + "energy taken by the damping over the work", log[4]["f_relax[2]"][-1] / work, 1e-3)

# --- with the damping given; without any the bar goes on swinging
result, _ = bend(n, 0.5, "elastic", "damping 2.0")
checks.below("damping given: out of balance", result.thermo[4]["f_relax"][-1], 1e-3)
checks.near("damping given: damping", result.thermo[4]["f_relax[1]"][-1], 2.0, absolute=0)
result, _ = bend(n, 0.5, "elastic", "damping 0", most=3000)
checks.above("without damping: out of balance after 3000 steps", result.thermo[4]["f_relax"][-1], 0.05)

# --- a bar that swings, damped; read from a restart file it goes on bit for bit
START = SCENE[:SCENE.index("compute s all")].format(flow="plastic %r 0" % Y) + """variable vy atom 0.3*sin(x/8)
velocity all set NULL v_vy NULL units box
"""
END = """fix relax all sph/tm/relax
run {steps}
write_dump all custom end.dump id x y vx vy modify sort id format float %.17g
print "DAMPING $(f_relax[1]:%.17g) $(f_relax[2]:%.17g)"
"""
whole = run(START + END.format(steps="200\nwrite_restart half.restart\nrun 200"), dict(n=n))
at_once = whole.dump("end.dump")[-1]
second = run("newton off\natom_modify map array\nread_restart half.restart\n"
             "pair_coeff 1 1 density 1 elastic 1000 0.3 strength plastic %r 0\nfix body all sph/tm energy yes\n" % Y +
             END.format(steps=200), folder=whole.folder)
again = second.dump("end.dump")[-1]
differences = [abs(at_once[c] - again[c]).max() for c in ("x", "y", "vx", "vy")]
checks.below("restart: difference of the motion", max(differences), 0)
said = [[line for line in r.output.splitlines() if line.startswith("DAMPING")][-1] for r in (whole, second)]
checks.true("restart: damping and energy", said[0] == said[1], " | ".join(said))
checks.above("damping found", float(said[0].split()[1]), 0.1)

for words in "damping -1", "damping", "nonsense 1":
    text = SCENE.format(flow="elastic", M=1, damping=words, limit=1, most=1, ramp=1)
    result = run(text, dict(n=4), expect_error=True)
    checks.true("refused: " + words, "sph/tm/relax" in result.errors() and words.split()[0] in result.errors(),
                result.errors()[:110])
checks.end()
