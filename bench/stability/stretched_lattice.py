#!/usr/bin/python3
"""Hourglass control against the tensile instability in a lattice that is stretched: for waves of displacements of whole planes along the
stretch, the stiffness of hourglass control over the stiffness with which a constant tension drives the wave apart (momentum sum with corrected gradients).
Below 1 the wave grows; long waves are those of a neck, which grow in the metal too.

  stretched_lattice.py [--ratio 1.2] [--kernel hyperbolic] [--weight gradient | square]

Uniaxial tension: zeta (sigma_Mises + <-p>) with zeta = 12 (tm_hourglass.h) is 16 sigma. The volume stays. weight: of a pair in the force of hourglass
control, W'/r as it is, or r^2 (1 - r/2h), of the same stiffness for the longest waves at no stretch, as a comparison."""
import argparse
import os
import sys

import numpy as np

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "unittest", "scenes"))
import sph_kernels                                                                      # noqa: E402

PLANES, STIFFNESS, FARTHEST = 24, 16.0, 4    # planes of the period; planes that can be neighbors
WAVES = {12: "2", 8: "3", 6: "4", 4: "6"}    # waves in the period: length in planes


class Lattice:
    """Spacing 1 at no stretch; the sums of plane pairs at a distance d along the stretch."""

    def __init__(self, dim, stretch, h, name):
        side = stretch ** (-1 / (dim - 1))
        far = np.arange(-np.ceil(2 * h / side) - 1, np.ceil(2 * h / side) + 2) * side
        across = np.meshgrid(far, far) if dim == 3 else [far]
        self.across2 = sum(x ** 2 for x in across).ravel()
        self.h, self.name, self.stretch = h, name, stretch

    def pairs(self, d):
        """W'/r and r^2 of the pairs of a particle with a plane."""
        r2 = d * d + self.across2
        r2 = r2[(r2 > 1e-12) & (r2 < (2 * self.h) ** 2)]
        r = np.sqrt(r2)
        return sph_kernels.kernel(self.name, r / self.h)[1] / r, r2

    def moment(self):
        return -sum((self.pairs(n * self.stretch)[0] * (n * self.stretch) ** 2).sum() for n in range(-FARTHEST, FARTHEST + 1))


def driven(lattice, norm, u):
    """Force of a tension of 1 on planes that are displaced by u."""
    x = lattice.stretch * np.arange(PLANES) + u
    K, g = np.zeros(PLANES), {}
    for i in range(PLANES):
        moment = 0.0
        for n in range(-FARTHEST, FARTHEST + 1):
            j = (i + n) % PLANES
            d = x[j] - x[i] + lattice.stretch * PLANES * ((i + n) // PLANES)
            f = lattice.pairs(d)[0] / norm
            g[i, n] = (f * d).sum()
            moment -= (f * d * d).sum()
        K[i] = 1 / moment
    return np.array([-sum((K[i] + K[(i + n) % PLANES]) * g[i, n] for n in range(-FARTHEST, FARTHEST + 1)) for i in range(PLANES)])


def controlled(lattice, norm, weight):
    """The matrix from displacements of planes to forces of hourglass control."""
    residual, force = np.zeros((PLANES, PLANES)), np.zeros((PLANES, PLANES))
    for i in range(PLANES):
        weights, linear, rows = 0.0, np.zeros(PLANES), []
        for n in range(-FARTHEST, FARTHEST + 1):
            j, d = (i + n) % PLANES, n * lattice.stretch
            f, r2 = lattice.pairs(d)
            rows.append((j, d, -f.sum()))
            weights -= f.sum()
            linear[j] -= (f * d).sum() / lattice.moment()
            linear[i] += (f * d).sum() / lattice.moment()
            w = weight(f, np.sqrt(r2) / lattice.h) * d * d / r2
            force[i, i] += w.sum() / norm
            force[i, j] -= w.sum() / norm
        for j, d, w in rows:    # off the linear field of the neighbors
            residual[i, i] += w / weights
            residual[i, j] -= w / weights
            residual[i] += w * d / weights * linear
    return STIFFNESS * force @ residual


def stiffness(matrix_or_force, waves):
    u = np.cos(2 * np.pi * waves / PLANES * np.arange(PLANES))
    f = matrix_or_force(u) if callable(matrix_or_force) else matrix_or_force @ u
    return (f * u).sum() / (u * u).sum()


def margins(dim, stretch, h, name, weight, scale=1.0):
    norm = Lattice(dim, 1.0, h, name).moment()
    lattice, small = Lattice(dim, stretch, h, name), 1e-5
    control = controlled(lattice, norm, weight)
    apart = lambda u: (driven(lattice, norm, small * u) - driven(lattice, norm, -small * u)) / (2 * small)
    return {w: -scale * stiffness(control, w) / stiffness(apart, w) for w in WAVES}


def main():
    options = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    options.add_argument("--ratio", type=float, default=1.2, help="smoothing length over spacing")
    options.add_argument("--kernel", default="hyperbolic", choices=("hyperbolic", "cubic", "wendland/c2", "wendland/c4"))
    options.add_argument("--weight", default="gradient", choices=("gradient", "square"))
    given = options.parse_args()
    weights = {"gradient": lambda f, q: f, "square": lambda f, q: -q * q * np.maximum(1 - q / 2, 0)}
    print("%s %g, %s; stiffness of hourglass control over that of the instability, wave length in planes" % (given.kernel, given.ratio, given.weight))
    for dim in (2, 3):
        longest = min(WAVES)
        now = margins(dim, 1.0, given.ratio, given.kernel, weights["gradient"])
        scale = now[longest] / margins(dim, 1.0, given.ratio, given.kernel, weights[given.weight])[longest]
        print("%dD  stretch  " % dim + "  ".join("%5s" % WAVES[w] for w in WAVES))
        for stretch in (1.0, 1.1, 1.2, 1.3, 1.4, 1.5, 1.6, 1.8, 2.0):
            of = margins(dim, stretch, given.ratio, given.kernel, weights[given.weight], scale)
            print("    %7.1f  " % stretch + "  ".join("%5.2f" % of[w] for w in WAVES))


if __name__ == "__main__":
    main()
