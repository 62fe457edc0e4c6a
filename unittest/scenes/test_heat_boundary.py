"""Flux into a half-space, fixed temperature at its end, and materials whose k and cp depend on temperature."""
import numpy as np
from scipy.special import erfc

from heat_rod import RUN, Layer, rod
from sphtm_scene import Checks, order_of_convergence, run

checks = Checks()
K, RHO, CP, T0 = 50.0, 7800.0, 480.0, 300.0
DIFFUSIVITY, EFFUSIVITY = K / (RHO * CP), np.sqrt(K * RHO * CP)


def at_end(x, T, end):
    """Temperature at the end of the rod: parabola through the last three particles."""
    order = np.argsort(abs(x - end))[:3]
    return np.polyval(np.polyfit(x[order] - end, T[order], 2), 0.0)


# --- constant flux: surface rise 2 q sqrt(t/pi)/e, Carslaw and Jaeger 2.9
def flux(n, dim=2):
    L, q, t = 2e-3, 1e7, 10e-3
    dx = L / n
    text = rod([Layer(n, RHO, K, CP, T0)], dx, """fix q all sph/tm/heat flux %g facing -1 0 0
compute sum all reduce sum c_T
thermo_style custom step time dt f_q f_q[2] f_q[3] c_sum
""" % q + RUN.format(t), dim=dim)
    result = run(text)
    frame, log = result.dump("profile.dump")[-1], result.thermo[-1]
    t, area = log["Time"][-1], dx ** (dim - 1)
    x, T = frame["x"] + L, frame["c_T"]
    z = x / (2 * np.sqrt(DIFFUSIVITY * t))
    exact = T0 + 2 * q / EFFUSIVITY * np.sqrt(t) * (np.exp(-z * z) / np.sqrt(np.pi) - z * erfc(z))
    rise = 2 * q * np.sqrt(t / np.pi) / EFFUSIVITY
    name = "flux, %dD, %d particles: " % (dim, n)
    checks.near(name + "surface rise", at_end(x, T, 0.0) - T0, rise, relative=0.6 / n)
    checks.near(name + "area", log["f_q[3]"][-1], area, relative=1e-12)
    checks.near(name + "energy delivered", log["f_q[2]"][-1], q * area * t, relative=1e-9)
    checks.near(name + "heat in the rod", RHO * CP * dx ** dim * (log["c_sum"][-1] - log["c_sum"][0]),
                log["f_q[2]"][-1], relative=1e-10)
    return abs(T - exact).max() / rise


errors = [flux(50), flux(100), flux(200)]
checks.note("flux: errors of the profile over the rise", "%.2e %.2e %.2e" % tuple(errors))
checks.below("flux: error of the profile at 200 particles", errors[-1], 0.005)
checks.above("flux: order of convergence", order_of_convergence([4, 2, 1], errors), 0.9)
checks.below("flux, 3D: error of the profile", flux(100, 3), 0.01)


# --- fixed temperature: T0 + (Ts - T0) erfc(x/2 sqrt(a t)), x from the last layer that is held
def fixed(n, Ts="500", law=lambda t: 500.0 + 0 * t):
    L, t = 2e-3, 10e-3
    dx = L / n
    text = rod([Layer(n, RHO, K, CP, T0)], dx, """region end block INF $((3-%d)*v_dx) INF INF INF INF units box
group end region end
%s
fix hold end sph/tm/heat temperature %s
compute sum all reduce sum c_T
thermo_style custom step time dt f_hold f_hold[2] c_sum
thermo 20
""" % (n, "variable Ts equal 300+2e4*time" if Ts == "v_Ts" else "", Ts) + RUN.format(t))
    result = run(text)
    frame, log = result.dump("profile.dump")[-1], result.thermo[-1]
    t = log["Time"][-1]
    x, T = frame["x"] + L - 2.5 * dx, frame["c_T"]
    z = np.maximum(x, 0) / (2 * np.sqrt(DIFFUSIVITY * t))
    if Ts == "v_Ts":    # Carslaw and Jaeger 2.5: 4 times the second integral of erfc
        exact = T0 + 2e4 * t * ((1 + 2 * z * z) * erfc(z) - 2 * z / np.sqrt(np.pi) * np.exp(-z * z))
    else:
        exact = T0 + (500 - T0) * erfc(z)
    held = x < 0.1 * dx
    checks.below("fixed temperature %s: held" % Ts, abs(T[held] - exact[held].max()).max(), 1e-9)
    content = RHO * CP * dx * dx * (log["c_sum"][-1] - log["c_sum"][0])
    checks.near("fixed temperature %s: heat in the rod" % Ts, content, log["f_hold[2]"][-1], relative=1e-10)
    power = np.diff(log["f_hold[2]"])[-1] / np.diff(log["Time"])[-1]
    checks.near("fixed temperature %s: power" % Ts, log["f_hold"][-1], power, relative=0.02)
    return abs(T - exact)[~held].max() / (exact.max() - T0)


errors = [fixed(50), fixed(100), fixed(200)]
checks.note("fixed temperature: errors over the rise", "%.2e %.2e %.2e" % tuple(errors))
checks.below("fixed temperature: error at 200 particles", errors[-1], 0.005)
checks.below("temperature from a variable: error", fixed(100, "v_Ts"), 0.01)

# --- k(T), steady: between T1 and T2 the flux is the integral of k over T, over the length
KT = ((300.0, 20.0), (400.0, 60.0), (600.0, 30.0))
n, dx = 24, 1e-4
word = "table/3 " + " ".join("%g %g" % p for p in KT)
text = rod([Layer(n, RHO, word, 100.0, 400)], dx, """region hot block INF $((3-%d)*v_dx) INF INF INF INF units box
region cold block $(-3*v_dx) INF INF INF INF INF units box
group hot region hot
group cold region cold
fix hot hot sph/tm/heat temperature 600
fix cold cold sph/tm/heat temperature 300
thermo_style custom step time dt f_hot f_cold
""" % n + RUN.format(4 * (n * dx) ** 2 * RHO * 100.0 / 40 / np.pi))
result = run(text)
frame, log = result.dump("profile.dump")[-1], result.thermo[-1]
x, T = frame["x"] / dx + n - 2.5, frame["c_T"]
span = n - 5.0
kirchhoff = np.interp(np.linspace(300, 600, 3001), *zip(*KT))
integral = np.concatenate([[0], np.cumsum(0.5 * (kirchhoff[1:] + kirchhoff[:-1])) * 0.1])
q = integral[-1] / (span * dx)
checks.near("k(T): steady flux", log["f_hot"][-1] / dx, q, relative=0.01)
checks.near("k(T): what goes in comes out", -log["f_cold"][-1], log["f_hot"][-1], relative=1e-3)
inside = (x > 0) & (x < span)
exact = np.interp(integral[-1] * (1 - x[inside] / span), integral, np.linspace(300, 600, 3001))
checks.below("k(T): largest error over the difference", abs(T[inside] - exact).max() / 300, 0.01)

# --- k(T), cp(T): what is delivered is the change of the enthalpy
CPT = ((300.0, 450.0), (500.0, 900.0), (700.0, 500.0))
word_cp = "table/3 " + " ".join("%g %g" % p for p in CPT)


def enthalpy(T):
    s = np.linspace(0, 2000, 200001)
    c = np.interp(s, *zip(*CPT))
    return np.interp(T, s, np.concatenate([[0], np.cumsum(0.5 * (c[1:] + c[:-1])) * 0.01]))


n, dx = 60, 2e-5
for body in ("heat", "solid"):
    text = rod([Layer(n, RHO, word, word_cp, 350, body)], dx, """variable q equal 6e7*(1+sin(time*300))
fix q all sph/tm/heat flux v_q facing -1 0 0
compute sum all reduce sum c_T
thermo_style custom step time dt f_q[2] f_body[4] f_body[9]
""" + RUN.format(4e-2), body="fix body all sph/tm energy yes dt/max 4e-5")
    result = run(text)
    frame, log = result.dump("profile.dump")[-1], result.thermo[-1]
    T = frame["c_T"]
    delivered = log["f_q[2]"][-1]
    checks.above("cp(T), %s: warmed over all segments, K" % body, T.max(), 720)
    checks.near("cp(T), %s: enthalpy" % body, RHO * dx * dx * (enthalpy(T) - enthalpy(350.0)).sum(), delivered,
                relative=2e-5)
    checks.below("cp(T), %s: the fix's book over the heat" % body, abs(log["f_body[4]"][-1]) / delivered, 1e-12)
    checks.below("cp(T), %s: drift of the energy sum over the heat" % body,
                 abs(log["f_body[9]"] - log["f_body[9]"][0]).max() / delivered, 1e-9)
checks.end()
