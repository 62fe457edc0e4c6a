"""The time step of conduction explicit: the automatic one damps noise of the temperature, 1.5 times the limit does not.

The limit is 4/3 of the automatic step (tm_heat_time_step). A constant step above it is refused before the first step,
so the runs that shall go wrong start with a material that conducts ten times less and change it under way."""
import numpy as np

from sphtm_scene import Checks, run

SCENE = """
units si
dimension {dim}
boundary p p p
atom_style atomic
newton off
variable dx equal 1e-4
lattice {lattice} ${{dx}} origin 0.5 0.5 {origin}
region box block 0 $({n}*v_dx) 0 $({n}*v_dx) {z} units box
create_box 2 box
create_atoms 1 box
region half block INF $({n}*0.5*v_dx) INF INF INF INF units box
group half region half
set group half type {left}
pair_style sph/tm {style} spacing ${{dx}}
pair_coeff 1 1 density 7800 body heat heat {k} 500 0
pair_coeff 2 2 density {density} body heat heat {k2} 500 0
fix body all sph/tm temperature 300 dt {dt} conduction explicit
variable noise atom "random(0,1,4711) > 0.5"
group hot variable noise
fix_modify body temperature hot 301
compute T all sph/tm/atom temperature
compute lo all reduce min c_T
compute hi all reduce max c_T
compute mean all reduce ave c_T
variable spread equal c_hi-c_lo
thermo_style custom step time dt v_spread c_mean
thermo_modify format float %.12g
thermo 20
run {steps}{change}
"""
CHANGE = """ pre no every 20 "set group all type 2\""""
checks = Checks()


def scene(dim=2, style="hyperbolic 1.2", k="50", k2=None, density=7800, left=1, dt="auto", steps=0, change="",
          fails=False):
    n = 16 if dim == 2 else 8
    z = "$(-v_dx) ${dx}" if dim == 2 else "0 $(%d*v_dx)" % n
    return run(SCENE.format(dim=dim, n=n, z=z, lattice="sq" if dim == 2 else "sc", origin=0 if dim == 2 else 0.5,
                            style=style, k=k, k2=k2 or k, density=density, left=left, dt=dt, steps=steps,
                            change=change),
               expect_error=fails)


for dim, style in ((2, "hyperbolic 1.2"), (3, "hyperbolic 1.2"), (2, "wendland/c4 2.0"), (3, "quintic 1.2"),
                   (2, "cubic 1.0")):
    name = "%dD, %s: " % (dim, style)
    auto = scene(dim, style, steps=200)
    log = auto.thermo[0]
    dt = log["Dt"][0]
    checks.note(name + "automatic step",
                "%.4g rho cp h^2/k" % (dt * 50 / (7800 * 500 * (float(style.split()[1]) * 1e-4) ** 2)))
    checks.below(name + "noise left, automatic step", log["v_spread"][-1], 0.3)
    checks.below(name + "noise grows, automatic step", np.diff(log["v_spread"]).max(), 0)
    limit = 4 / 3 * dt
    refused = scene(dim, style, dt=repr(1.01 * limit), fails=True)
    checks.true(name + "1.01 of the limit is refused", "is not stable" in refused.errors(), refused.errors()[:100])

    # the limit itself: after 20 steps all particles conduct ten times better
    for share in (0.97, 1.03, 1.5):
        result = scene(dim, style, "5", "50", dt=repr(share * limit), steps=1000, change=CHANGE, fails=share > 1)
        if share < 1:
            checks.below(name + "0.97 of the limit: noise left", result.thermo[-1]["v_spread"][-1], 0.5)
        else:
            checks.true(name + "%g of the limit stops, and says why" % share,
                        "stops at step 2" in result.errors() and "heat conduction allows" in result.errors(),
                        result.errors()[:160])
    result = scene(dim, style, "5", "50", steps=400, change=CHANGE)
    checks.below(name + "automatic step, k grows tenfold: noise left", result.thermo[-1]["v_spread"][-1], 0.3)
    checks.near(name + "automatic step, k grows tenfold: step", result.thermo[-1]["Dt"][-1], dt, relative=1e-6)

# a poor conductor of little heat among better ones counts their harmonic mean
for left in (1, 2):
    log = scene(k="1", k2="1000", density=7800000, left=left, steps=300).thermo[0]
    checks.below("two materials: noise grows, automatic step", np.diff(log["v_spread"]).max(), 1e-9)
checks.end()
