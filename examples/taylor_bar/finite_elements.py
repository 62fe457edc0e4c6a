#!/usr/bin/python3
"""Taylor bars by explicit finite elements: finite_elements.py [bar [elements over the radius ...]]

Needs numpy; installs nothing. Axisymmetric, frictionless rigid wall at z = 0; bars and constants of copper as in case_taylor_bar.py.
Quadrilaterals with one stress each and the exact mean over their volume of the velocity gradient: forces are the derivatives of the work
of that mean. Pressure from the volume, deviator by the Jaumann rate in the middle of the step and radial return; plastic work heats,
nothing conducts. Viscous hourglass control; bulk viscosity in compression. A node that would pass the wall ends its step on it, and the
wall never pulls. Central differences; the step follows from a bound of the highest frequency of every element.

finite_elements.csv gets a line per bar and mesh; with arguments it only prints. Radius: largest of all nodes; edge: of the node that was
the edge of the foot. As of 6 and 12 rings: what measure.py gets from particles at the places of make_bar.py that move with the elements.
Parts of the kinetic energy of the shot: hourglass control, bulk viscosity, what nodes lost as they met the wall, and the excess of the sum
of these, of the work of the stresses and of the kinetic energy that is left."""
import os
import sys
import time

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
MESHES = 6, 12, 24, 48
LONG, HOURGLASS, LINEAR, QUADRATIC, COURANT = 1.0, 0.05, 0.06, 1.2, 0.9        # LONG: height over width of the elements
ELASTIC = {"linear": (8930, 117e9, 0.35), "ofhc": (8960, 124e9, 0.34)}         # density, Young's modulus, Poisson's ratio
YIELD, HARDENING = 400e6, 100e6                                                # linear
A, B, N, C, M = 90e6, 292e6, 0.31, 0.025, 1.09                                 # ofhc: Johnson-Cook
RATE, COLD, MELT = 1.0, 298.0, 1356.0
CAPACITY, HEAT = 383, 0.9                                                      # ofhc; part of the plastic work that heats
# material, radius, length (mm), speed, end (us); johnson_cook_190 is the bar of fe_190
BARS = {"linear_227": ("linear", 3.2, 32.4, 227, 81), "fe_190": ("ofhc", 3.81, 25.4, 190, 75),
        "wilkins_guinan_210": ("ofhc", 3.81, 23.47, 210, 75), "zelepugin_225": ("ofhc", 3.9, 34.5, 225, 100)}
NEXT, LAST = [1, 2, 3, 0], [3, 0, 1, 2]


def corners(a):
    """Values at the corners of every element, counterclockwise from low r and z; nodes are numbered [z, r]."""
    return np.stack((a[:-1, :-1], a[:-1, 1:], a[1:, 1:], a[1:, :-1]))


def gather(e):
    """Sum at the nodes of what elements give to their corners."""
    a = np.zeros((e.shape[1] + 1, e.shape[2] + 1))
    for part, place in zip(e, (a[:-1, :-1], a[:-1, 1:], a[1:, 1:], a[1:, :-1])):
        place += part
    return a


def total(weights, values):
    return np.einsum("eij,eij->ij", weights, values)


class Elements:
    """Volume per radian; integrals over it of d/dr, d/dz and 1/r as weights of the corners; the shape that these do not see."""

    def __init__(self, r, z):
        r, z = corners(r), corners(z)
        r1, z1, r0, z0 = r[NEXT], z[NEXT], r[LAST], z[LAST]
        triangle = 0.5 * ((r - r0) * (z1 - z) - (r1 - r) * (z - z0))           # of a corner and those beside it
        self.area = 0.5 * triangle.sum(0)
        self.hoop = (self.area + triangle) / 6
        self.z = (r0 - r1) * (r0 + r + r1) / 6                                 # derivatives of the volume: this, and r + hoop
        self.r = ((r0 + 2 * r) * (z - z0) + (2 * r + r1) * (z1 - z)) / 6 - self.hoop
        self.volume = total(self.z, z)
        self.side = self.volume * np.sqrt(2 / (total(self.r, self.r) + total(self.z, self.z)))    # of a square; else the shorter
        self.hourglass = triangle[[2, 3, 0, 1]] * (2 / self.area)
        self.hourglass[1::2] *= -1


def strength(material, eps, T):
    """Flow stress at rest."""
    if material == "linear":
        return YIELD + HARDENING * eps
    return np.maximum(1 - np.clip((T - COLD) / (MELT - COLD), 0, 1)**M, 1e-6) * (A + B * eps**N)


def increment(material, shear, trial, eps, T, dt):
    """Plastic strain of a step whose trial stress is above strength(); T from its start. Johnson-Cook: in x = ln d the rest
    trial - 3 G d - Y is concave and falls, so that Newton's steps from a bound above come down to the root."""
    first = strength(material, eps, T)
    if material == "linear":
        return (trial - first) / (3 * shear + HARDENING)
    slow, soft = np.log(dt * RATE), first / (A + B * eps**N)
    x = np.minimum(np.log((trial - first) / (3 * shear)), slow + (trial / first - 1) / C)
    for _ in range(60):
        d = np.exp(x)
        hard, rate = soft * (A + B * (eps + d)**N), 1 + C * np.maximum(x - slow, 0)
        slope = d * (3 * shear + soft * B * N * (eps + d)**(N - 1) * rate) + hard * C * (x > slow)
        step = (trial - 3 * shear * d - hard * rate) / slope
        x = x + step
        if np.abs(step).max() < 1e-9:
            break
    return np.exp(x)


def turned(s, angle):
    """Deviator (rr, zz, rz) turned from z to r."""
    c, d, m = np.cos(angle)**2, np.sin(angle)**2, np.sin(2 * angle)
    return [c * s[0] + d * s[1] + m * s[2], d * s[0] + c * s[1] - m * s[2], (c - d) * s[2] - 0.5 * m * (s[0] - s[1])]


class Bar:
    def __init__(self, bar, n):
        """n elements over the radius."""
        self.material, radius, length, speed, end = BARS[bar]
        self.radius, self.length, self.end = 1e-3 * radius, 1e-3 * length, 1e-6 * end
        self.rho, E, nu = ELASTIC[self.material]
        self.shear, self.bulk = E / (2 + 2 * nu), E / (3 - 6 * nu)
        self.modulus = self.bulk + 4 * self.shear / 3
        self.z, self.r = np.meshgrid(np.linspace(0, self.length, 1 + round(length / radius * n / LONG)),
                                     np.linspace(0, self.radius, n + 1), indexing="ij")
        self.now, r = Elements(self.r, self.z), corners(self.r)
        self.share = self.rho * self.now.area / 12 * (r + r[[0, 1, 1, 0]] + r[[1, 0, 0, 1]])      # mass of the corners, per radian
        self.mass = gather(self.share)
        self.u, self.w, self.force_r, self.force_z = np.zeros((4,) + self.r.shape)
        self.w -= speed
        self.volume, zero = self.now.volume, np.zeros_like(self.now.volume)
        self.s, self.p, self.eps, self.T, self.swift = [zero] * 3, zero, zero.copy(), zero + COLD, zero
        self.t, self.dt, self.steps, self.shot = 0.0, 0.0, 0, self.kinetic()
        self.taken = {"stress": 0.0, "hourglass": 0.0, "viscosity": 0.0, "wall": 0.0}

    def kinetic(self):
        return 0.5 * (self.mass * (self.u**2 + self.w**2)).sum()

    def next_dt(self):
        """Trace of stiffness over mass of every element, which is not less than the square of its highest frequency."""
        e, damped = self.now, LINEAR + self.swift
        fastest = self.modulus * ((e.r**2 + e.z**2 + e.hoop**2) / self.share).sum(0) / e.volume
        dt = 2 * COURANT * ((np.sqrt(1 + damped**2) - damped) / np.sqrt(fastest)).min()
        return min(dt, 1.1 * self.dt or dt, max(self.end - self.t, 1e-15))

    def move(self, dt):
        """Velocities to the middle of the step, nodes to its end."""
        before, span = self.w, 0.5 * (dt + self.dt) / self.mass
        self.u = self.u + span * self.force_r
        self.u[:, 0] = 0
        free = before + span * self.force_z
        self.w = np.maximum(free, -self.z / dt)
        self.taken["wall"] -= 0.5 * (self.mass * (self.w - free) * (self.w + before)).sum()
        self.r, self.z = self.r + dt * self.u, self.z + dt * self.w
        self.old, self.now = self.now, Elements(self.r, self.z)
        if not self.now.volume.min() > 0:
            raise ArithmeticError("an element turned over at %.1f us" % (1e6 * self.t))
        self.t, self.dt, self.steps = self.t + dt, dt, self.steps + 1

    def deform(self, dt, rr, zz, hoop, shearing, spin):
        """Deviator and pressure at the end of the step; power of the mean stress of the step per volume."""
        G, trace = self.shear, rr + zz + hoop
        first = turned(self.s, 0.5 * dt * spin)
        s = [first[0] + 2 * G * dt * (rr - trace / 3), first[1] + 2 * G * dt * (zz - trace / 3), first[2] + G * dt * shearing]
        trial = np.sqrt(3 * (s[0]**2 + s[1]**2 + s[0] * s[1] + s[2]**2))
        flows = trial > strength(self.material, self.eps, self.T)
        if flows.any():
            d = increment(self.material, G, trial[flows], self.eps[flows], self.T[flows], dt)
            stress = trial[flows] - 3 * G * d
            for a in s:
                a[flows] *= stress / trial[flows]
            self.eps[flows] += d
            self.T[flows] += HEAT * stress * d / (self.rho * CAPACITY)
        p, self.p = self.p, self.bulk * (self.volume / self.now.volume - 1)
        self.s = turned(s, 0.5 * dt * spin)
        a, b, c = (0.5 * (x + y) for x, y in zip(first, s))
        return a * (rr - hoop) + b * (zz - hoop) + c * shearing - 0.5 * (self.p + p) * trace

    def step(self):
        dt = self.next_dt()
        self.move(dt)
        old, now, u, w = self.old, self.now, corners(self.u), corners(self.w)
        volume, by_r, by_z = 0.5 * (old.volume + now.volume), old.r + now.r, old.z + now.z
        rr, rz, zr, zz, hoop = (total(*of) / (2 * volume) for of in ((by_r, u), (by_z, u), (by_r, w), (by_z, w), (old.hoop + now.hoop, u)))
        stress = self.deform(dt, rr, zz, hoop, rz + zr, 0.5 * (rz - zr))
        squeeze, sound = np.maximum(-rr - zz - hoop, 0), np.sqrt(self.modulus / self.rho)
        self.swift = QUADRATIC**2 * now.side * squeeze / sound
        q = self.rho * self.volume / now.volume * sound * now.side * squeeze * (LINEAR + self.swift)
        gr, gz = total(now.hourglass, u), total(now.hourglass, w)
        damper = HOURGLASS * self.rho * sound * volume / now.side
        for kind, power in (("stress", stress * volume), ("viscosity", q * squeeze * volume), ("hourglass", damper * (gr**2 + gz**2))):
            self.taken[kind] += dt * power.sum()
        rr, zz, rz = self.s
        rr, zz, hoop = rr - self.p - q, zz - self.p - q, -rr - zz - self.p - q
        self.force_r = -gather(rr * now.r + rz * now.z + hoop * now.hoop + damper * gr * now.hourglass)
        self.force_z = -gather(zz * now.z + rz * now.r + damper * gz * now.hourglass)

    def run(self):
        while self.t < self.end:
            self.step()
        return self

    def shares(self):
        out = {kind: value / self.shot for kind, value in self.taken.items()}
        out["excess"] = sum(out.values()) + self.kinetic() / self.shot - 1
        return out

    def as_particles(self, rings):
        """Length and radius by measure.py of particles that move with the elements."""
        area = np.pi * self.radius**2 / (1 + 3 * rings * (rings + 1))
        layers = int(round(self.length / np.sqrt(area)))
        dx, (rows, columns) = (area * self.length / layers)**(1 / 3), self.r.shape
        i, j = (np.arange(layers) + 0.5) / layers * (rows - 1), np.arange(rings + 1) / (rings + 0.5) * (columns - 1)
        r, z = (np.array([np.interp(i, np.arange(rows), b) for b in np.transpose([np.interp(j, np.arange(columns), a) for a in values])])
                for values in (self.r, self.z))
        return np.ptp(z) + dx, r[z < z.min() + 2.5 * dx].max() + dx / 2


def main():
    lines = []
    for bar in sys.argv[1:2] or BARS:
        for n in [int(word) for word in sys.argv[2:]] or MESHES:
            began, b = time.time(), Bar(bar, n).run()
            sizes, shares = (np.ptp(b.z), b.r.max(), b.r[0, -1], *b.as_particles(6), *b.as_particles(12)), b.shares()
            lines.append("%s,%d,%s,%s\n" % (bar, n, ",".join("%.3f" % (1e3 * v) for v in sizes),
                                            ",".join("%.5f" % shares[kind] for kind in ("hourglass", "viscosity", "wall", "excess"))))
            print(lines[-1].strip(), "; largest plastic strain %.2f; %d steps, %.0f s"
                  % (b.eps.max(), b.steps, time.time() - began), flush=True)
    if len(sys.argv) == 1:
        with open(os.path.join(HERE, "finite_elements.csv"), "w") as f:
            f.write("# Taylor bars, finite_elements.py; mm, and parts of the kinetic energy of the shot\n"
                    "# bar, elements over the radius, length, radius, edge, length and radius as of 6 rings, the same of 12 rings, "
                    "hourglass, viscosity, wall, excess\n")
            f.writelines(lines)


if __name__ == "__main__":
    main()
