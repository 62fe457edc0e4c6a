"""The closed form of two layers in contact, and how far temperature.dump is from it."""
import math

import numpy as np

COLD, HOT = 300.0, 400.0
erf = np.vectorize(math.erf)


def exact(x, ratio, t):
    """Temperature; left k = rho cp = 1, right k = ratio."""
    e = np.sqrt(ratio)
    Tc = (COLD + e * HOT) / (1 + e)
    return np.where(x < 0, Tc + (COLD - Tc) * erf(-x / (2 * np.sqrt(t))),
                    Tc + (HOT - Tc) * erf(x / (2 * np.sqrt(ratio * t))))


def error(frame, ratio, t):
    """Of each particle, over the jump."""
    return abs(frame["c_T"] - exact(frame["x"], ratio, t)) / (HOT - COLD)
