#!/usr/bin/python3
"""Both runs of in.tool_heat against the closed forms: a table, and tool_heat.png"""
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from scipy.special import erfc, erfcx

AREA, C_TOOL = 8e-5, 5.6e-5 * 486 / 8e-5                         # m^2 and J/(m^2 K), per thickness of 1 m
BODIES = {"aluminium": (2700.0, 120.0, 899.0), "steel": (7870.0, 50.7, 486.0)}
effusivity = {name: np.sqrt(np.prod(m)) for name, m in BODIES.items()}
e1, e2 = effusivity.values()


def history(tool):
    time, power, T, work, heat = np.loadtxt("history_%s.dat" % tool)[:, 1:].T
    friction = np.trapz(np.r_[0, power], np.r_[0, time])
    print("%s: heat of both bodies over friction work %.6f" % (tool, (work + heat)[-1] / friction))
    return time, T - 300, work, heat, (work + heat)[-1] / AREA / time[-1]


plt.rcParams.update({"font.size": 9})
figure, (left, right) = plt.subplots(1, 2, figsize=(8.5, 3.3))

# two half-spaces that share the friction heat by effusivity: T = 2 q sqrt(t)/(e1 + e2) ierfc(s), s = |y|/sqrt(4 a t)
time, _, work, heat, q = history("particles")
print("    fraction into the aluminium %.4f, closed form %.4f" % (work[-1] / (work + heat)[-1], e1 / (e1 + e2)))
due = 2 * q * np.sqrt(time[-1] / np.pi) / (e1 + e2)
kind, y, T = np.loadtxt("temperature_particles.dump", skiprows=9)[:, 1:4].T
for k, (name, (rho, conductivity, cp)), color in zip((1, 2), BODIES.items(), ("tab:red", "tab:blue")):
    rows, sign = np.unique(np.round(y[kind == k], 8)), 1 if k == 1 else -1
    mean = np.array([T[(kind == k) & (abs(y - r) < 1e-8)].mean() for r in rows]) - 300
    near = np.argsort(abs(rows))[:3]
    surface = np.polyval(np.polyfit(rows[near], mean[near], 2), 0.0)
    print("    rise of the surface, %s: %.3f K, closed form %.3f K" % (name, surface, due))
    left.plot(1e3 * rows, mean, "o", ms=3, mfc="none", color=color, label=name)
    s = np.linspace(0, 1e-3, 300)
    u = s / np.sqrt(4 * conductivity / (rho * cp) * time[-1])
    left.plot(1e3 * sign * s, due * (np.exp(-u * u) - np.sqrt(np.pi) * u * erfc(u)), "k-", lw=1)
left.set(xlabel="height (mm)", ylabel="rise of temperature (K)", xlim=(-1, 1), title="tool of particles, after 1 ms")
left.legend(frameon=False)

# a half-space heated through a sheet of capacity C: T = q C/e^2 (exp(x) erfc(sqrt x) - 1 + 2 sqrt(x/pi)), x = (e/C)^2 t
time, T, work, heat, q = history("lumped")
x = (e1 / C_TOOL) ** 2 * time
exact = q * C_TOOL / e1 ** 2 * (erfcx(np.sqrt(x)) - 1 + 2 * np.sqrt(x / np.pi))
print("    rise of the tool after 1 ms %.3f K, closed form %.3f K; largest difference %.3f K"
      % (T[-1], exact[-1], abs(T - exact).max()))
right.plot(1e3 * time, exact, "k-", lw=1, label="closed form")
right.plot(1e3 * time[::40], T[::40], "o", ms=3, mfc="none", color="tab:blue", label="tool")
right.set(xlabel="time (ms)", ylabel="rise of temperature (K)", title="tool with one temperature")
right.legend(frameon=False)
for ax in (left, right):
    ax.spines[["top", "right"]].set_visible(False)
figure.tight_layout()
figure.savefig("tool_heat.png", dpi=130)
