"""Particle shifting once more, from the equations of doc/pair_sph_tm.rst: by how much a particle is moved in a step in which it flows."""
import numpy as np

BITS = 0xffffffff


def mix(a, b):
    """A hash of two integers: multiplications by odd constants and shifts, modulo 2^32."""
    a = (a * 2654435761 + b * 2654435769) & BITS
    for shift, factor in ((16, 2246822507), (13, 3266489909)):
        a = ((a ^ a >> shift) * factor) & BITS
    return a ^ a >> 16


def own_direction(x, edge, dim):
    """Between -1 and 1 in each direction, from the place in thousandths of the edge."""
    a = 1
    for place in np.floor(1e3 * np.asarray(x) / edge + 0.3717).astype(int):
        a = mix(mix(a, int(place) & BITS), int(place) >> 32 & BITS)
    return np.array([mix(a >> 8, k) / 2.0**31 - 1.0 if k < dim else 0.0 for k in range(3)])


def shift(g, own, L, dim, h, eps, d_eps, flow, p, way):
    """g: gradient of the concentration, own: direction, L: velocity gradient, eps: plastic strain before the step, flow: flow stress,
    way: of sound in the step."""
    D = 0.5 * (L + L.T) - np.trace(L) / 3 * np.eye(3)
    W = 0.5 * (L - L.T)
    strain, spin = np.sum(D * D), np.sum(W * W)
    pure = max(0.0, 1 - spin / strain)**3 if strain > 0 else 0.0
    along = 0.5 * (g + np.sqrt((1.5 if dim == 3 else 2.0) / strain) * D @ g) if pure > 0 else np.zeros(3)
    s = min(max(-3 * p / flow, 0.0), 1.0) if flow > 0 else 0.0
    drawn, uneven = s * pure**9, h * np.linalg.norm(g)
    begins, whole = 0.2 + drawn * (0.05 - 0.2), 0.4 + drawn * (0.15 - 0.4)
    if d_eps <= 0 or eps <= begins or uneven >= 0.4:
        return np.zeros(3)
    inside = 1 - uneven / 0.4
    r = 100 * inside * pure * h * along
    size = np.linalg.norm(r)
    moves = 6 * (1 - s) * (1 - pure) * inside * h * g + ((1 - s) / (1 + size / 2) + s / (1 + size / 22)) * r
    dx = -h * d_eps * (min((eps - begins) / (whole - begins), 1.0) * moves - 0.02 * drawn * max(0.0, 1 - uneven / 0.05) * own)
    return dx * min(1.0, 0.05 * way / max(np.linalg.norm(dx), 1e-300))
