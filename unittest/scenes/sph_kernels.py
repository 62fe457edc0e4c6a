"""Smoothing kernels and what sums over a regular lattice make of them, for sph_reference.py."""
import numpy as np


def kernel(name, q):
    """Shape W(q) without its constant and slope dW/dq, as piecewise polynomials with the cases of their papers."""
    w, s = np.zeros_like(q), np.zeros_like(q)
    if name == "hyperbolic":
        a, b = q < 1, (q >= 1) & (q < 2)
        w[a] = q[a] ** 3 - 6 * q[a] + 6
        s[a] = (3 * q[a] ** 2 - 6) * np.minimum(q[a] / 0.25, 1)    # rounded at the origin
        w[b] = (2 - q[b]) ** 3
        s[b] = -3 * (2 - q[b]) ** 2
    elif name == "cubic":
        a, b = q < 1, (q >= 1) & (q < 2)
        w[a] = 1 - 1.5 * q[a] ** 2 + 0.75 * q[a] ** 3
        s[a] = -3 * q[a] + 2.25 * q[a] ** 2
        w[b] = 0.25 * (2 - q[b]) ** 3
        s[b] = -0.75 * (2 - q[b]) ** 2
    elif name == "quintic":
        for edge, factor in ((3, 1), (2, -6), (1, 15)):
            a = q < edge
            w[a] += factor * (edge - q[a]) ** 5
            s[a] -= 5 * factor * (edge - q[a]) ** 4
    elif name == "wendland/c2":
        a = q < 2
        w[a] = (1 - q[a] / 2) ** 4 * (2 * q[a] + 1)
        s[a] = -2 * (1 - q[a] / 2) ** 3 * (2 * q[a] + 1) + 2 * (1 - q[a] / 2) ** 4
    elif name == "wendland/c4":
        a = q < 2
        p = 35 / 12 * q[a] ** 2 + 3 * q[a] + 1
        w[a] = (1 - q[a] / 2) ** 6 * p
        s[a] = -3 * (1 - q[a] / 2) ** 5 * p + (1 - q[a] / 2) ** 6 * (35 / 6 * q[a] + 3)
    return w, s


CONSTANT = {"hyperbolic": (1 / (3 * np.pi), 15 / (62 * np.pi)), "cubic": (10 / (7 * np.pi), 1 / np.pi),
            "quintic": (7 / (478 * np.pi), 1 / (120 * np.pi)), "wendland/c2": (7 / (4 * np.pi), 21 / (16 * np.pi)),
            "wendland/c4": (9 / (4 * np.pi), 495 / (256 * np.pi))}
REACH = {"quintic": 3.0}


def lattice(dim):
    """x and r of the points of a lattice of spacing 1, seen from the one in the origin, whose own r is 1e30."""
    side = np.arange(-12, 13.0)
    x, y, z = np.meshgrid(side, side, side if dim == 3 else [0.0])
    r = np.sqrt(x * x + y * y + z * z)
    r[r == 0] = 1e30
    return x, r


def lattice_sums(name, dim, h):
    """On a lattice of spacing 1: the gradient that the sums make of a unit gradient, and twice the sum of |W'| over
    the pairs across a unit of a plane between two layers."""
    x, r = lattice(dim)
    dW = CONSTANT[name][dim - 2] / h ** (dim + 1) * kernel(name, r / h)[1]
    return -np.sum(dW / r * x * x), -2 * np.sum(np.where(x > 0, dW * x, 0))


def tensile_share(name, dim, h, power):
    """The part of a tension that an artificial stress of strength 1 takes on that lattice."""
    x, r = lattice(dim)
    shape, slope = kernel(name, r / h)
    part = slope / r * x * x
    return np.sum(part * (shape / kernel(name, np.array([1 / h]))[0][0]) ** power) / np.sum(part)


def factors(name, dim, ratio):
    """1 over the gradient that the lattice makes of a unit gradient, linear between 257 values from 0.8 to 4."""
    step, out = 3.2 / 256, []
    for x in np.clip((ratio - 0.8) / step, 0, 256):
        k = min(int(x), 255)
        a, b = (1 / lattice_sums(name, dim, 0.8 + m * step)[0] for m in (k, k + 1))
        out.append(a + (x - k) * (b - a))
    return np.array(out)


def lattice_psi(name, dim, n_h):
    """Psi of the lattice without the particle itself, doc/fix_adapt_neigh.rst."""
    r = lattice(dim)[1]
    return (CONSTANT[name][dim - 2] * kernel(name, r[r < 1e30] / n_h)[0].sum()) ** (1 / dim)
