"""Friction heat of two half-spaces that slide on each other, against the closed form.

The heat mu p v is released in the first layer of each body, half and half, and the bodies touch by perfect thermal
contact, so the split by effusivity is an outcome: it is 0.5507 but for half a spacing. One body slides; the sums over
pairs across the interface then change all the time.

Then the contact law of two particle bodies computes the friction itself: its work is mu N times the way, its heat is that work,
and it is shared by effusivity."""
import numpy as np

from heat_rod import RUN, Layer, rod
from sphtm_scene import Checks, run

ALUMINIUM, STEEL = (2700.0, 120.0, 899.0), (7870.0, 50.7, 486.0)
MU, P, V, T_END = 0.3, 100e6, 1.0, 1e-3
T0 = 300.0
checks = Checks()


def effusivity(m):
    return np.sqrt(m[0] * m[1] * m[2])


def at_end(x, T):
    order = np.argsort(abs(x))[:3]
    return np.polyval(np.polyfit(x[order], T[order], 2), 0.0)


def slide(n, speed):
    dx = 1e-3 / n
    text = rod([Layer(n, *ALUMINIUM, T0), Layer(n, *STEEL, T0)], dx, """pair_coeff 1 2 heat
region touch block $(-v_dx) ${dx} INF INF INF INF units box
group touch region touch
fix friction touch sph/tm/heat source $(%r/2/v_dx)
fix slide l2 sph/tm/drive 0 %g NULL
thermo_style custom step time dt f_friction[2]
""" % (MU * P * V, speed) + RUN.format(T_END), pad=1)
    result = run(text)
    frame, log = result.dump("profile.dump")[-1], result.thermo[-1]
    t, total = log["Time"][-1], log["f_friction[2]"][-1]
    one = frame["type"] == 1
    x, rise = frame["x"], frame["c_T"] - T0
    e1, e2 = effusivity(ALUMINIUM), effusivity(STEEL)
    exact = 2 * MU * P * V * np.sqrt(t / np.pi) / (e1 + e2)
    name = "%d particles each, sliding at %g m/s: " % (n, speed)
    checks.near("closed form", 2 * 3e7 * np.sqrt(1e-3 / np.pi) / (e1 + e2), 34.540, absolute=0.001)
    checks.near(name + "heat released", total, MU * P * V * t * dx, relative=1e-9)
    heat1 = ALUMINIUM[0] * ALUMINIUM[2] * dx * dx * rise[one].sum()
    heat2 = STEEL[0] * STEEL[2] * dx * dx * rise[~one].sum()
    checks.near(name + "heat in the bodies", heat1 + heat2, total, relative=1e-9)
    allowed = min(0.03, 2 / n)
    checks.near(name + "share of the aluminium", heat1 / total, 0.5507, relative=allowed)
    checks.near(name + "rise at the aluminium's surface", at_end(x[one], rise[one]), exact, relative=allowed)
    checks.near(name + "rise at the steel's surface", at_end(x[~one], rise[~one]), exact, relative=allowed)


slide(100, 0.0)
slide(100, V)
slide(200, V)

# all of it into the aluminium alone
dx = 1e-5
text = rod([Layer(100, *ALUMINIUM, T0)], dx, """fix q all sph/tm/heat flux 3e7 facing 1 0 0
thermo_style custom step time dt f_q[2]
""" + RUN.format(T_END))
result = run(text)
frame, t = result.dump("profile.dump")[-1], result.thermo[-1]["Time"][-1]
checks.near("all into the aluminium: rise", at_end(frame["x"], frame["c_T"]) - T0, 62.7226 * np.sqrt(t / 1e-3),
            relative=0.01)

# the contact law of two bodies
CONTACT = """
units si
dimension 2
boundary p f p
atom_style atomic
newton off
variable dx equal 1e-5
variable p equal 1e7
lattice sq ${dx} origin 0.5 0.5 0
region box block 0 $(12*v_dx) $(-20*v_dx) $(24*v_dx) $(-v_dx) ${dx} units box
create_box 2 box
region low block INF INF $(-16*v_dx) 0 INF INF units box
region up block INF INF 0 $(16*v_dx) INF INF units box
create_atoms 1 region low
create_atoms 2 region up
group low type 1
group up type 2
region base block INF INF INF $(-13*v_dx) INF INF units box
region top block INF INF $(13*v_dx) INF INF INF units box
group base region base
group top region top
pair_style sph/tm hyperbolic 1.2 spacing ${dx} viscosity 1 1
pair_coeff 1 1 density 2700 elastic 2e9 0.3 heat 120 899 0
pair_coeff 2 2 density 7870 elastic 2e9 0.3 heat 50.7 486 0
pair_coeff 1 2 contact friction 0.3 damping 0.5
fix body all sph/tm temperature 300 energy yes effects artificial-heat off
variable load equal "-v_p*12*v_dx/36*(1-exp(-time/2e-6))"
fix press top addforce 0 v_load 0
variable vt equal "5*(1-exp(-time/2e-6))"
fix hold base sph/tm/drive 0 0 NULL
fix slide top sph/tm/drive v_vt NULL NULL
compute T all sph/tm/atom temperature
compute l low reduce sum c_T
compute u up reduce sum c_T
variable heat1 equal 2700*899*v_dx^2*(c_l-192*300)
variable heat2 equal 7870*486*v_dx^2*(c_u-192*300)
thermo_style custom step time dt v_heat1 v_heat2 f_slide[4] f_body[4] f_body[9]
thermo_modify format float %.15g
thermo 4000
run 12000
"""
result = run(CONTACT)
log = result.thermo[-1]
friction = log["v_heat1"] + log["v_heat2"]
checks.true("contact: friction turns heat on", "has friction" in result.output)
checks.near("contact: heat in the bodies is the book's friction heat", friction[-1], log["f_body[4]"][-1],
            relative=1e-6)
checks.near("contact: share of the aluminium", log["v_heat1"][-1] / friction[-1], 0.5507, relative=1e-4)
checks.below("contact: drift of the energy sum over the work", abs(log["f_body[9]"]).max() / log["f_slide[4]"][-1],
             0.003)
checks.near("contact: work of the slide over mu N times the way",
            (log["f_slide[4]"][-1] - log["f_slide[4]"][1]) / (0.3 * 1e7 * 12e-5 * 5 * (log["Time"][-1] - log["Time"][1])),
            1, relative=0.03)
checks.end()
