"""Particle shifting once more, from the equations of doc/pair_sph_tm.rst: by how much a particle is moved in a step in which it flows."""
import numpy as np


def along_stretch(L, dim):
    """P: what passes what lies along the stretch of a velocity gradient, and nothing of what lies across; 0 where spin is faster."""
    D = 0.5 * (L + L.T) - np.trace(L) / 3 * np.eye(3)
    W = 0.5 * (L - L.T)
    strain = np.sum(D * D)
    if strain <= np.sum(W * W):
        return np.zeros((3, 3))
    E = np.sqrt((1.5 if dim == 3 else 2.0) / strain) * D
    return (np.eye(3) + E) @ (0.5 * np.eye(3) + E) / 3 if dim == 3 else 0.5 * (np.eye(3) + E)


def shift(g, L, dim, h, eps, d_eps, flow, p, way):
    """g: gradient of the concentration, L: velocity gradient, eps: plastic strain before the step, flow: flow stress, way: of sound in the step."""
    one = np.eye(3)
    D = 0.5 * (L + L.T) - np.trace(L) / 3 * one
    W = 0.5 * (L - L.T)
    strain, spin = np.sum(D * D), np.sum(W * W)
    if d_eps <= 0 or strain <= 0:
        return np.zeros(3)
    pure = max(0.0, 1 - spin / strain)**3
    E = np.sqrt((1.5 if dim == 3 else 2.0) / strain) * D if pure > 0 else -one
    A = 0.5 * (one + E)
    P = (one + E) @ (0.5 * one + E) / 3 if dim == 3 else A
    s = min(max(-3 * p / flow, 0.0), 1.0) if flow > 0 else 0.0
    drawn = s * pure**9
    begins, whole = 0.2 - 0.1 * drawn, 0.4 - 0.2 * drawn
    if eps <= begins:
        return np.zeros(3)
    inside = max(0.0, 1 - h * np.linalg.norm(g) / 0.4)
    skin = max(0.0, 1 - h * np.linalg.norm(P @ g) / 0.4 - inside)
    r = 100 * pure * h * (inside * A + 0.3 * drawn * skin * P) @ g
    size = np.linalg.norm(r)
    beneath = max(0.0, 1 - h * np.linalg.norm(g) / 0.3)
    moves = 40 * ((1 - s) * (1 - pure))**3 * beneath * h * g + ((1 - s) / (1 + size / 2) + s / (1 + size / 22)) * r
    dx = -h * d_eps * min((eps - begins) / (whole - begins), 1.0) * moves
    return dx * min(1.0, 0.05 * way / max(np.linalg.norm(dx), 1e-300))
