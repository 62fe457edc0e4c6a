"""Heat between two bodies: perfect contact of aluminium and steel, and an interface of finite conductance."""
import numpy as np
from scipy.special import erf

from heat_rod import RUN, Layer, rod
from sphtm_scene import Checks, run

ALUMINIUM = dict(density=2700.0, k=120.0, cp=899.0)
STEEL = dict(density=7870.0, k=50.7, cp=486.0)
ZERO = 273.15
checks = Checks()


def effusivity(m):
    return np.sqrt(m["k"] * m["density"] * m["cp"])


def perfect(dim):
    """500 C aluminium, 20 C steel, interface at 284.33 C."""
    dx, n, t = 1e-5, 100, 5e-4
    text = rod([Layer(n, T=500 + ZERO, **ALUMINIUM), Layer(n, T=20 + ZERO, **STEEL)], dx,
               "pair_coeff 1 2 heat\nthermo_style custom step time dt f_body\n" + RUN.format(t), dim=dim)
    result = run(text)
    frame, t = result.dump("profile.dump")[-1], result.thermo[-1]["Time"][-1]
    x, T, kind = frame["x"], frame["c_T"], frame["type"]
    e1, e2 = effusivity(ALUMINIUM), effusivity(STEEL)
    Tc = (500 * e1 + 20 * e2) / (e1 + e2)
    checks.near("closed form", Tc, 284.33, absolute=0.005)
    left, right = T[x < 0][-1], T[x > 0][0]
    k1, k2 = ALUMINIUM["k"], STEEL["k"]
    checks.near("%dD: interface, C" % dim, (k1 * left + k2 * right) / (k1 + k2) - ZERO, Tc, relative=0.003)
    a = np.where(kind == 1, k1 / (ALUMINIUM["density"] * ALUMINIUM["cp"]), k2 / (STEEL["density"] * STEEL["cp"]))
    T0 = np.where(kind == 1, 500, 20)
    exact = Tc + (T0 - Tc) * erf(abs(x) / (2 * np.sqrt(a * t))) + ZERO
    checks.below("%dD: largest error over the jump" % dim, abs(T - exact).max() / 480, 0.004)
    heat = np.where(kind == 1, ALUMINIUM["density"] * ALUMINIUM["cp"], STEEL["density"] * STEEL["cp"]) * (T - T0 - ZERO)
    checks.below("%dD: heat lost over heat exchanged" % dim, abs(heat.sum()) / abs(heat[kind == 1]).sum(), 1e-12)


def conductance(biot, ratio, dim, bodies="heat", tolerance=0.035):
    """Two slabs between fixed temperatures in the steady state: jump and flux give the conductance back."""
    n, dx, k = 16, 1e-3, 10.0
    hc = biot * k / dx
    meets = "heat" if bodies == "heat" else "contact"
    more = """pair_coeff 1 2 %s conductance %r
region hot block INF $(-%d*v_dx) INF INF INF INF units box
region cold block $(%d*v_dx) INF INF INF INF INF units box
group hot region hot
group cold region cold
fix hot hot sph/tm/heat temperature 400
fix cold cold sph/tm/heat temperature 300
compute all all reduce sum c_T
thermo_style custom step time dt f_hot f_cold f_hot[2] f_cold[2] c_all
""" % (meets, hc, n - 3, n - 3)
    more += RUN.format("%r" % (40 * (n * dx) ** 2 / (k / 1e6) / np.pi ** 2 * (1 + 2 / (n * biot))))
    text = rod([Layer(n, 1000.0, k, 1000.0, 310, bodies), Layer(n, 1000.0, k * ratio, 1000.0, 310, bodies)], dx, more,
               dim=dim)
    result = run(text)
    frame, log = result.dump("profile.dump")[-1], result.thermo[-1]
    x, T = frame["x"] / dx, frame["c_T"]
    left, right = (x < -3) & (x > 5 - n), (x > 3) & (x < n - 5)
    p1, p2 = np.polyfit(x[left], T[left], 1), np.polyfit(x[right], T[right], 1)
    jump, flux = p1[1] - p2[1], -k * p1[0] / dx
    name = "%dD, %s, hc dp/k = %g, k ratio %g: " % (dim, bodies, biot, ratio)
    checks.near(name + "conductance", flux / jump, hc, relative=tolerance)
    area = dx if dim == 2 else dx * dx
    checks.near(name + "flux of fix heat", log["f_hot"][-1] / area, flux, relative=1e-3)
    checks.near(name + "what goes in comes out", log["f_cold"][-1], -log["f_hot"][-1], relative=2e-3)
    # heat in the particles that are not held: all of it came through the fixes
    content = 1000.0 * 1000.0 * dx ** dim * (log["c_all"][-1] - log["c_all"][0])
    checks.near(name + "heat content", content, log["f_hot[2]"][-1] + log["f_cold[2]"][-1],
                absolute=1e-9 * abs(log["f_hot[2]"][-1]))


for dim in (2, 3):
    perfect(dim)
for biot in (0.03, 0.3, 3.0):
    conductance(biot, 1, 2)
conductance(0.3, 10, 2)
conductance(0.3, 1, 3)
conductance(0.3, 1, 2, "solid")
checks.end()
