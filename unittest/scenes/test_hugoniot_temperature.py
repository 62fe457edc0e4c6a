"""Two plates of copper meet at 1, 2 and 3 km/s: pressure, density and temperature behind the shocks against the Hugoniot.

Mie-Grueneisen with Us = c0 + s up, Gamma rho constant; the temperature of reference is the integral of
dT = -Gamma T dv/v + ((v0 - v) dpH + pH dv)/(2 c_v) along the Hugoniot (Walsh and Christian, Phys. Rev. 97, 1544, 1955)
with constant c_v, that of c_p at 300 K."""
import numpy as np

from sphtm_scene import Checks, run

RHO, C0, S, GAMMA, CP, T0 = 8930.0, 3940.0, 1.489, 2.02, 383.0, 300.0
CV = CP / (1 + GAMMA ** 2 * CP * T0 / C0 ** 2)
DX, HALF = 1e-4, 240    # spacing, particles over the thickness of a plate

SCENE = """
units           si
dimension       2
boundary        f p p
atom_style      atomic
newton          off
lattice         sq 1e-4 origin 0.5 0.5 0
region          box block -0.04 0.04 0 8e-4 -5e-5 5e-5 units box
create_box      1 box
region          left block -24e-3 0 INF INF INF INF units box
region          right block 0 24e-3 INF INF INF INF units box
create_atoms    1 region left
create_atoms    1 region right
group           left region left
group           right region right
pair_style      sph/tm cubic 1.3 spacing 1e-4 viscosity 1 2 artstress 0 4 correction yes hourglass 0
pair_coeff      1 1 density 8930 elastic 120e9 0.34 eos shock 3940 1.489 2.02 strength none heat {k} {cp} 0.9 {more}
fix             body all sph/tm temperature 300 energy yes {fix}
velocity        left set {up} 0 0 units box
velocity        right set -{up} 0 0 units box
compute         p all sph/tm/atom temperature density pressure energy
variable        now equal time
fix             stop all halt 1 v_now > {time} error continue
thermo          20
thermo_style    custom step time f_body[1] f_body[2] f_body[4] f_body[7] f_body[9]
thermo_modify   format float %.12g
run             100000
write_dump      all custom end.dump id x y vx c_p[*] modify sort id
"""
checks = Checks()


def hugoniot(up):
    """Density, pressure and temperature behind a shock."""
    us = C0 + S * up
    v0 = 1 / RHO
    v = np.linspace(v0, v0 * (us - up) / us, 20001)
    eta = 1 - v / v0
    p = RHO * C0 ** 2 * eta / (1 - S * eta) ** 2
    dp = np.gradient(p, v)
    T = T0
    for k in range(len(v) - 1):
        a, b = ((v0 - v[j]) * dp[j] + p[j] for j in (k, k + 1))
        step, T1 = v[k + 1] - v[k], T
        for _ in range(2):
            T1 = T + step * (-GAMMA / v0 * 0.5 * (T + T1) + 0.25 * (a + b) / CV)
        T = T1
    return 1 / v[-1], p[-1], T


def plates(up, fix="", more=""):
    result = run(SCENE.format(up=up, time=0.75 * HALF * DX / (C0 + S * up), fix=fix, more=more, k=0, cp=CP))
    frame, log = result.dump("end.dump")[-1], result.thermo[-1]
    shock = (C0 + S * up - up) * log["Time"][-1]    # the front, from the plane of impact
    inside = (abs(frame["x"]) > 0.5 * shock) & (abs(frame["x"]) < 0.75 * shock)
    return {"T": frame["c_p[1]"][inside], "rho": frame["c_p[2]"][inside], "p": frame["c_p[3]"][inside],
            "e": frame["c_p[4]"][inside], "log": log}


for up in 500.0, 1000.0, 1500.0:
    r = plates(up)
    rho, p, T = hugoniot(up)
    name = "up %g m/s, %.1f GPa: " % (up, p * 1e-9)
    checks.near(name + "density", r["rho"].mean(), rho, relative=0.001)
    checks.near(name + "pressure", r["p"].mean(), p, relative=0.003)
    checks.near(name + "rise of the temperature", r["T"].mean() - T0, T - T0, relative=0.01)
    checks.near(name + "energy of the jump", r["e"].mean(), 0.5 * up ** 2, relative=0.002)
    log = r["log"]
    checks.below(name + "drift of the sum of energies over what went in", np.ptp(log["f_body[9]"]) / log["f_body[1]"][0], 0.01)
    checks.note(name + "temperature", "%.1f K, spread %.1f K; Hugoniot %.1f K" % (r["T"].mean(), r["T"].std(), T))

# --- each part alone is not enough; without both nothing heats
rho, p, T = hugoniot(1000.0)
for off in "compression-heat", "artificial-heat":
    rise = plates(1000.0, "effects %s off" % off)["T"].mean() - T0
    checks.below("up 1000 m/s without %s: rise over that of the Hugoniot" % off, rise / (T - T0), 0.75)
checks.end()
