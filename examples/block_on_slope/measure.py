"""How fast the block of in.block_on_slope slides."""
import numpy as np

A, G, DX, RAMP = np.radians(20), 10.0, 0.01, 0.02


def acceleration(time, way):
    """Once gravity has grown, from a parabola."""
    late = time > 1.5 * RAMP
    return float(2 * np.polyfit(time[late], way[late], 2)[0])


def theory(share):
    """share: coefficient of friction over tan(angle)."""
    return float(G * np.sin(A) * max(1 - share, 0))
