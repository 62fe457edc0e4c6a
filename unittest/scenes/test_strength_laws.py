"""The laws of strength in a whole scene: a heavy block keeps the velocities it starts with, which make one velocity
gradient. Flow stress, plastic strain and temperature in its middle are those of the law, written here once more and
integrated in time. The heat of the viscosity, which acts on the scaled mass, is left out."""
import numpy as np
from sphtm_scene import Checks, lattice_block, run

RATE, STEPS, DT = 2e4, 1500, 1e-8
E, NU, CP, CHI, SCALE = 110e9, 0.35, 500.0, 0.9, 1e4    # the mass is scaled by 1e4, and so is the heat of a mass
RHO = 4500.0
A, B, N, C, M, TREF, TMELT = 800e6, 500e6, 0.3, 0.02, 0.9, 300.0, 1900.0


def johnson_cook(eps, rate, T):
    hot = min(max((T - TREF) / (TMELT - TREF), 0.0), 1.0)
    return (A + B * eps ** N) * (1 + C * np.log(max(rate, 1.0))) * (1 - hot ** M)


def tanh_law(a, b, d, r, s):
    def flow(eps, rate, T):
        t = T / TMELT
        D, S = 1 - t ** d, t ** b
        hot = min(max((T - TREF) / (TMELT - TREF), 0.0), 1.0)
        return (A + B * eps ** N / np.exp(eps ** a)) * (1 + C * np.log(max(rate, 1.0))) * (1 - hot ** M) * (
            D + (1 - D) * np.tanh(1 / (eps + S) ** r) ** s)
    return flow


def zerilli_armstrong(c0, c1, c2, c3, c4, c5, n):
    return lambda eps, rate, T: c0 + (c1 + c2 * eps ** 0.5) * np.exp(-c3 * T + c4 * T * np.log(max(rate, 1e-4))) + \
        c5 * eps ** n


JC = "%g %g %g %g %g %g %g 1" % (A, B, N, C, M, TREF, TMELT)
CASES = [    # strength, law, temperature at the start
    ("johnson/cook " + JC, johnson_cook, 300.0),
    ("johnson/cook/tanh " + JC + " 1.6 0.4 1 6 1", tanh_law(1.6, 0.4, 1, 6, 1), 600.0),
    ("johnson/cook/tanh " + JC + " 2 5 1 2 0.3", tanh_law(2, 5, 1, 2, 0.3), 900.0),
    ("zerilli/armstrong 65e6 1033e6 0 0.00698 0.000415 266e6 0.289 1 1811",
     zerilli_armstrong(65e6, 1033e6, 0, 0.00698, 0.000415, 266e6, 0.289), 300.0),
    ("zerilli/armstrong 65e6 0 890e6 0.0028 0.000115 0 1 1 1356",
     zerilli_armstrong(65e6, 0, 890e6, 0.0028, 0.000115, 0, 1), 400.0)]

SCENE = "clear\n" + lattice_block("0 11e-3 0 11e-3", "-8e-3 19e-3 -8e-3 19e-3") + """
pair_style sph/tm cubic 1.3 spacing 1e-3
pair_coeff 1 1 density {rho} elastic {E} {nu} strength {strength} heat 0 {cp} {chi}
variable vx atom {rate}*(x-5.5e-3)
variable vy atom -{rate}*(y-5.5e-3)
velocity all set v_vx v_vy NULL
fix body all sph/tm temperature {T} dt {dt} effects artificial-heat off
compute p all sph/tm/atom pstrain vonmises temperature
dump d all custom {steps} out.{number} id x y c_p[*]
dump_modify d format float %.15g
run {steps}
"""


def integrate(law, T):
    """Equivalent stress, plastic strain and temperature of one point, whose every particle keeps its velocity."""
    G = E / (2 * (1 + NU))
    s, eps, flow = np.zeros(3), 0.0, 0.0
    for n in range(STEPS):
        t = (n + 0.5) * DT
        D = np.array([RATE / (1 + RATE * t), -RATE / (1 - RATE * t), 0.0])
        trial = s + 2 * G * DT * (D - D.mean())
        q = np.sqrt(1.5 * trial @ trial)
        s, flow = trial, q
        if q > law(eps, 0.0, T):
            lo, hi = 0.0, q / (3 * G)
            for _ in range(45):
                d = 0.5 * (lo + hi)
                lo, hi = (d, hi) if q - 3 * G * d > law(eps + d, d / DT, T) else (lo, d)
            flow = q - 3 * G * d
            s, eps = trial * flow / q, eps + d
            T += CHI * flow * d * (1 - (RATE * (t + 0.5 * DT)) ** 2) / (RHO * CP)    # over the density
    return flow, eps, T


if __name__ == "__main__":
    checks = Checks()
    result = run("".join(SCENE.format(rho=RHO * SCALE, E=E, nu=NU, strength=strength, cp=CP / SCALE, chi=CHI, rate=RATE, T=T,
                                      dt=DT, steps=STEPS, number=k) for k, (strength, _, T) in enumerate(CASES)))
    for k, (strength, law, T) in enumerate(CASES):
        frame = result.dump("out.%d" % k)[-1]
        x, y = np.array(frame["x"]), np.array(frame["y"])
        middle = np.argmin((x - 5.5e-3) ** 2 + (y - 5.5e-3) ** 2)
        have = [np.array(frame["c_p[%d]" % c])[middle] for c in (2, 1, 3)]
        name = "%s at %g K: " % (strength.split(" ")[0], T)
        for what, value, due in zip(("flow stress, MPa", "plastic strain", "temperature"), have, integrate(law, T)):
            unit = 1e6 if what.startswith("flow") else 1.0
            checks.near(name + what, value / unit, due / unit, relative=2e-3)
    checks.end()
