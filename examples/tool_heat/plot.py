#!/usr/bin/python3
"""Both runs of in.tool_heat against the closed forms: a table, and tool_heat.png"""
import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from scipy.special import erfc, erfcx

from measure import AREA, BODIES, due, effusivity, history, rows

C_TOOL = 5.6e-5 * 486 / AREA                                     # J/(m^2 K)
e1, e2 = effusivity.values()

plt.rcParams.update({"font.size": 9})
figure, (left, right) = plt.subplots(1, 2, figsize=(8.5, 3.3))

# two half-spaces that share the friction heat by effusivity: T = 2 q sqrt(t)/(e1 + e2) ierfc(s), s = |y|/sqrt(4 a t)
time, _, work, heat, whole, q = history("particles")
print("particles: heat of both bodies over friction work %.6f" % whole)
print("    fraction into the aluminium %.4f, closed form %.4f" % (work[-1] / (work + heat)[-1], e1 / (e1 + e2)))
rise = due(q, time[-1])
for (name, (height, mean, surface)), sign, color in zip(rows().items(), (1, -1), ("tab:red", "tab:blue")):
    rho, conductivity, cp = BODIES[name]
    print("    rise of the surface, %s: %.3f K, closed form %.3f K" % (name, surface, rise))
    left.plot(1e3 * height, mean, "o", ms=3, mfc="none", color=color, label=name)
    s = np.linspace(0, 1e-3, 300)
    u = s / np.sqrt(4 * conductivity / (rho * cp) * time[-1])
    left.plot(1e3 * sign * s, rise * (np.exp(-u * u) - np.sqrt(np.pi) * u * erfc(u)), "k-", lw=1)
left.set(xlabel="height (mm)", ylabel="rise of temperature (K)", xlim=(-1, 1), title="tool of particles, after 1 ms")
left.legend(frameon=False)

# a half-space heated through a sheet of capacity C: T = q C/e^2 (exp(x) erfc(sqrt x) - 1 + 2 sqrt(x/pi)), x = (e/C)^2 t
time, T, work, heat, whole, q = history("lumped")
print("lumped: heat of both bodies over friction work %.6f" % whole)
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
