"""What the runs of in.tool_heat are compared by: how much of the friction heat goes where, and how hot the surfaces get."""
import os

import numpy as np

AREA = 8e-5                                                      # m^2, per thickness of 1 m
BODIES = {"aluminium": (2700.0, 120.0, 899.0), "steel": (7870.0, 50.7, 486.0)}
effusivity = {name: np.sqrt(np.prod(m)) for name, m in BODIES.items()}


def history(tool, folder=".", area=AREA):
    """Time, rise of the tool, heat of work and tool, their sum over the work of friction, heat flux."""
    time, power, T, work, heat = np.loadtxt(os.path.join(folder, "history_%s.dat" % tool))[:, 1:].T
    t, p = np.r_[0, time], np.r_[0, power]
    friction = (np.diff(t) * (p[1:] + p[:-1]) / 2).sum()
    return time, T - 300, work, heat, (work + heat)[-1] / friction, (work + heat)[-1] / area / time[-1]


def due(q, t):
    """Rise of the surface of two half-spaces that share a constant heat flux by effusivity."""
    return 2 * q * np.sqrt(t / np.pi) / sum(effusivity.values())


def rows(folder="."):
    """Name -> heights of the rows of particles, their mean rise, the rise at the surface."""
    kind, y, T = np.loadtxt(os.path.join(folder, "temperature_particles.dump"), skiprows=9)[:, 1:4].T
    found = {}
    for k, name in zip((1, 2), BODIES):
        height = np.unique(np.round(y[kind == k], 8))
        mean = np.array([T[(kind == k) & (abs(y - r) < 1e-8)].mean() for r in height]) - 300
        near = np.argsort(abs(height))[:3]
        found[name] = height, mean, float(np.polyval(np.polyfit(height[near], mean[near], 2), 0.0))
    return found
