"""Heat through the contact with a tool, against closed forms of the half-space.

 - a tool at fixed temperature, perfect contact: T = Tt + (T0 - Tt) erf(x/sqrt(4 a t)); a finite conductance h: surface
   at Tt + (T0 - Tt) exp(H^2) erfc(H), H = h sqrt(a t)/k; the heat through the surface with both;
 - a lumped tool: relaxation of two heat capacities, heat of both sides together kept to round-off;
 - a tool filled with SPH heat particles: interface of 500 C aluminium and 20 C steel at 284.33 C, also
   while the tool slides; friction alone: 0.5507 of the heat into the aluminium, rise of the surface 34.54 K in 1 ms at
   30 MW/m^2; heat of both bodies together is the friction work."""
import numpy as np
from contact_scene import header, mesh, particles
from scipy.special import erf, erfc, erfcx
from sphtm_scene import Checks, new_folder, run

WIDE = 4
ALUMINIUM, STEEL = (2700.0, 120.0, 899.0), (7870.0, 50.7, 486.0)


def column(n, dx, sign=1, shift=0.0):
    """WIDE columns of n particles, from y = 0 up (down with sign -1), periodic in x."""
    x, y = np.meshgrid((np.arange(WIDE) + 0.5) * dx, sign * (np.arange(n) + 0.5) * dx - shift, indexing="ij")
    return np.c_[x.ravel(), y.ravel(), 0 * x.ravel()]


STILL = """
pair_coeff 1 1 density 2700 elastic 1e4 0.3 heat 120 899 0.9
fix body all sph/tm temperature 300
fix tool all contact/tri file plane.stl rotate axis 1 0 0 angle -90 overlap allow {heat}
fix still all setforce 0 0 0
compute t all sph/tm/atom temperature
compute T all reduce ave c_t
dump d all custom {steps} T.dump id y c_t
dump_modify d format float %.15g
thermo_style custom step time dt c_T f_tool f_tool[11]
thermo_modify norm no format float %.17g
thermo 1
run {steps}
"""


def still(n, dx, heat, t_end):
    """Particles at rest that touch the tool; y, T of one column at the end, thermo."""
    folder = new_folder()
    mesh(folder, "plane.stl", "plane --size %r %r --cells 7 3 --format ascii" % (40 * dx, 40 * dx))
    box = [(0, WIDE * dx), (-dx, (n + 1) * dx), (-0.5 * dx, 0.5 * dx)]
    data = particles(column(n, dx, shift=1e-6 * dx), box)
    for steps in (10, None):    # the first run tells the time step
        steps = steps or max(10, int(round(t_end / t["Dt"][-1])))
        result = run(header(dx, 2, "p f p") + STILL.format(heat=heat, steps=steps), files={"data.scene": data},
                     folder=folder)
        t = result.thermo[-1]
    frame = result.dump("T.dump")[-1]
    return frame["y"][:n], frame["c_t"][:n], t


def fixed_temperature(checks):
    rho, k, cp = ALUMINIUM
    a = k / (rho * cp)
    errors = []
    for n in (25, 50, 100):
        dx = 1e-3 / n
        y, T, t = still(n, dx, "heat perfect temperature 400", 5e-4)
        time = t["Time"][-1]
        exact = 400 - 100 * erf(y / np.sqrt(4 * a * time))
        errors.append(abs(T - exact).max() / 100)
        heat = -(t["f_tool[11]"][1:] * t["Dt"][1:]).sum() / (WIDE * dx)
        checks.below("perfect, %d particles in 4 sqrt(a t): error over the jump" % n, errors[-1], 0.03 * 25 / n)
        checks.near("    heat out of the tool", heat, 2 * k * 100 * np.sqrt(time / (np.pi * a)), relative=0.03 * 25 / n)
        taken = rho * cp * n * dx * (t["c_T"][-1] - 300)
        checks.near("    heat in the particles", taken, heat, relative=1e-10)
    checks.note("    order of convergence", "%.2f" % -np.polyfit(np.log([25, 50, 100]), np.log(errors), 1)[0])
    n, dx = 50, 2e-5
    for biot in (0.1, 1.0, 10.0):    # h sqrt(a t)/k
        h = biot * k / np.sqrt(a * 5e-4)
        y, T, t = still(n, dx, "heat conductance %r temperature 400" % float(h), 5e-4)
        time = t["Time"][-1]
        H, s = h * np.sqrt(a * time) / k, y / np.sqrt(4 * a * time)
        # Carslaw and Jaeger, 2.7 (1); exp(2 s H + H^2) erfc(s + H) = exp(-s^2) erfcx(s + H)
        exact = 300 + 100 * (erfc(s) - np.exp(-s * s) * erfcx(s + H))
        checks.below("conductance, h sqrt(a t)/k = %g: error over the jump" % biot, abs(T - exact).max() / 100, 0.01)
        checks.near("    heat flux at the end", -t["f_tool[11]"][-1] / (WIDE * dx), h * 100 * erfcx(H), relative=0.01)


def lumped(checks):
    """Thin and far better conducting than the contact: T of both relax exponentially."""
    n, dx, h = 3, 2e-5, 1e4
    rho, _, cp = ALUMINIUM
    mine, other = rho * cp * n * dx * WIDE * dx, 3e-3
    y, T, t = still(n, dx, "heat conductance %r lumped 1e-5 300 400" % h, 4e-3)
    rate = h * WIDE * dx * (1 / mine + 1 / other)
    gap = t["f_tool"] - t["c_T"]
    due = 100 * np.exp(-rate * t["Time"])
    checks.below("lumped: difference of temperature, of 100 K", abs(gap - due).max(), 1.0)
    total = mine * (t["c_T"] - 300) + other * (t["f_tool"] - 400)
    checks.below("    heat of both sides, lost over exchanged", abs(total).max() / (other * np.ptp(t["f_tool"])), 1e-10)
    checks.above("    exchanged, K of the tool", np.ptp(t["f_tool"]), 5)


BODIES = """
pair_coeff 1 1 density {r1} elastic 2e8 0.3 heat {k1} {c1} 0
pair_coeff 2 2 density {r2} elastic 2e8 0.3 heat {k2} {c2} 0 body heat
pair_coeff 1 2 heat
group work type 1
group inside type 2
region top block INF INF {top!r} INF INF INF units box
group top region top
fix body all sph/tm temperature {T1} courant 0.4 effects artificial-heat off
fix_modify body temperature inside {T2}
fix tool all contact/tri file block.stl move 0 {down!r} 0 overlap allow particles 2 friction {mu!r} penalty 1 damping 0.5
fix hold top setforce 0 0 0
compute t all sph/tm/atom temperature
compute T1 work reduce ave c_t
compute T2 inside reduce ave c_t
thermo_style custom step time dt c_T1 c_T2 f_tool[2] f_tool[10] f_tool[11] f_tool[7]
thermo_modify norm no format float %.17g
thermo 1
run {settle}
fix_modify tool move linear {v} 0 0 ramp {ramp!r}
fix_modify body temperature work {T1}
fix_modify body temperature inside {T2}
thermo 1
run {steps}
write_dump all custom T.dump id type y c_t modify format float %.15g
"""


def bodies(n, dx, mu, v, T1, T2, t_end, overlap):
    folder = new_folder()
    long = 20 * WIDE * dx + 2.2 * abs(v) * t_end
    mesh(folder, "block.stl", "block --size %r %r %r --cells 5 1 1 --format ascii" % (long, 4 * n * dx, 40 * dx))
    x = np.r_[column(n, dx, shift=overlap), column(n, dx, -1)]
    box = [(0, WIDE * dx), (-(n + 1) * dx, (n + 1) * dx), (-0.5 * dx, 0.5 * dx)]
    dt = 0.4 * 1.2 * dx / np.sqrt(2e8 * 1.346 / 2700) / 1.6
    script = header(dx, 2, "p f p", style="artstress 0 4") + BODIES.format(
        r1=ALUMINIUM[0], k1=ALUMINIUM[1], c1=ALUMINIUM[2], r2=STEEL[0], k2=STEEL[1], c2=STEEL[2], T1=T1, T2=T2,
        top=(n - 3) * dx, down=-2 * n * dx, mu=mu, v=v, ramp=0.01 * t_end, settle=1500 if v else 10,
        steps=int(t_end / dt))
    data = particles(x, box, types=np.r_[np.ones(WIDE * n), 2 * np.ones(WIDE * n)])
    result = run(script, files={"data.scene": data}, folder=folder)
    return result.dump("T.dump")[-1], result.thermo[-1], dx * dx * n * WIDE


def at_surface(y, T):
    y, T = np.unique(np.round(y, 9)), np.array([T[np.abs(y - u) < 1e-8].mean() for u in np.unique(np.round(y, 9))])
    order = np.argsort(abs(y))[:3]
    return np.polyval(np.polyfit(y[order], T[order], 2), 0.0)


def capacity(m):
    return m[0] * m[2]


def inside(checks):
    e1, e2 = (np.sqrt(m[0] * m[1] * m[2]) for m in (ALUMINIUM, STEEL))
    n, dx, zero = 40, 2.5e-5, 273.15
    Tc = (500 * e1 + 20 * e2) / (e1 + e2)
    checks.near("interface, closed form, C", Tc, 284.33, absolute=0.005)
    for v in (0.0, 10.0):
        f, t, volume = bodies(n, dx, 0.0, v, 500 + zero, 20 + zero, 4e-4, 1e-3 * dx)
        one = f["type"] == 1
        sides = [at_surface(f["y"][m], f["c_t"][m]) - zero for m in (one, ~one)]
        checks.near("tool of particles at %g m/s: interface, aluminium, C" % v, sides[0], Tc, relative=0.03)
        checks.near("    interface, steel, C", sides[1], Tc, relative=0.03)
        lost = capacity(ALUMINIUM) * volume * (t["c_T1"] - t["c_T1"][0]) + capacity(STEEL) * volume * (t["c_T2"] - t["c_T2"][0])
        checks.below("    heat lost over exchanged", abs(lost).max() / (capacity(STEEL) * volume * np.ptp(t["c_T2"])), 1e-10)


def friction(checks):
    e1, e2 = (np.sqrt(m[0] * m[1] * m[2]) for m in (ALUMINIUM, STEEL))
    n, dx, v = 50, 2e-5, 20.0
    f, t, volume = bodies(n, dx, 0.5, v, 300.0, 300.0, 1e-3, 0.3 * dx)
    heat1 = capacity(ALUMINIUM) * volume * (t["c_T1"][-1] - t["c_T1"][0])
    heat2 = capacity(STEEL) * volume * (t["c_T2"][-1] - t["c_T2"][0])
    work = (t["f_tool[10]"][1:] * t["Dt"][1:]).sum()
    time = t["Time"][-1] - t["Time"][0]
    q = work / (WIDE * dx) / time
    checks.note("friction: mean heat, MW/m^2", "%.3f, pressure %.3f MPa" % (q / 1e6, -t["f_tool[2]"].mean() / (WIDE * dx) / 1e6))
    half = len(t["Time"]) // 2
    checks.near("    friction power over mu F v", (t["f_tool[10]"][half:] / (-0.5 * t["f_tool[2]"][half:] * v)).mean(), 1.0,
                relative=0.01)
    checks.near("    heat of both bodies over friction work", (heat1 + heat2) / work, 1.0, absolute=1e-9)
    checks.near("    fraction into the aluminium", heat1 / (heat1 + heat2), 0.5507, relative=0.03)
    one = f["type"] == 1
    due = 2 * q * np.sqrt(time / np.pi) / (e1 + e2)
    checks.near("    closed form at 30 MW/m^2, 1 ms", 2 * 3e7 * np.sqrt(1e-3 / np.pi) / (e1 + e2), 34.540, absolute=0.001)
    for name, m in (("aluminium", one), ("steel", ~one)):
        checks.near("    rise of the surface, %s, over the closed form" % name,
                    (at_surface(f["y"][m], f["c_t"][m]) - 300) / due, 1.0, relative=0.03)


if __name__ == "__main__":
    checks = Checks()
    fixed_temperature(checks)
    lumped(checks)
    inside(checks)
    friction(checks)
    checks.end()
