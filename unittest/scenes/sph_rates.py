"""What one pass over the neighbors gives, for sph_reference.py: moments and free faces, hourglass control, artificial terms, heat, contact
of bodies."""
import math

import numpy as np
from sph_kernels import CONSTANT, REACH, factors, kernel, lattice_sums, tensile_share

ROOT = 0.25    # weight of the older rate in the prediction of the half step, doc/fix_sph_tm.rst


class Rates:
    """The rates of a Body, from its state."""

    def point(self, ahead):
        q = {"x": self.x, "v": self.v, "rho": self.rho, "s": self.s, "T": self.T, "e": self.e}
        if ahead and self.old:
            new, older = self.old
            for name, rate in new.items():
                q[name] = q[name] + ahead * ((1 + 2 * ROOT) * rate - 2 * ROOT * older[name])
        if ahead:
            q["x"] = self.x + ahead * (self.v + self.u)
        q["growth"] = np.array([m.growth(T, Tu) if self.expands else 1.0
                                for m, T, Tu in zip(self.mat, q["T"], self.unstrained)])
        sigma = np.empty((self.n, 3, 3))
        c = np.empty(self.n)
        for i, m in enumerate(self.mat):
            p = m.pressure(q["growth"][i] * q["rho"][i], q["e"][i])
            c[i] = m.sound_speed(q["rho"][i], q["e"][i])
            s = q["s"][i]
            if self.failed[i]:
                p, s = max(p, 0.0), 0 * s
            elif self.plane_stress:
                p = s[2, 2]
            sigma[i] = s - p * np.eye(3)
        q["shock"] = self.shock_pressure(ahead, q["rho"], c)
        q.update(sigma=sigma - q["shock"][:, None, None] * np.eye(3), c=c, stress=sigma)
        if self.plane_stress:    # sums over areas: density and stress count times the thickness
            q["rho3"] = q["rho"]
            q["rho"] = q["rho"] * self.lz
            q["sigma"] = sigma * self.lz[:, None, None]
        return q

    def inside(self, ahead):
        """1 where the correction is 1, falling to 0 where it is off by 0.3."""
        K = self.turned_moments(None, None, ahead)[:, :self.dim, :self.dim] - np.eye(self.dim)
        return np.maximum(1 - np.sum(K ** 2, axis=(1, 2)) / self.dim / 0.3 ** 2, 0)

    def shock_pressure(self, ahead, rho, c):
        """Bulk viscosity inside a body: compression that is fast for what the metal bears, bounded by what a rate bears that is a
        step old."""
        if not (self.shock and self.one_pass and ahead and self.old) or self.plane_stress:
            return np.zeros(self.n)
        flows = np.array([m.strength[0] != "elastic" for m in self.mat])
        squeezed = np.maximum(self.old[0]["rho"] / rho, 0) * self.own_h / c
        Z = 10 * squeezed / np.maximum(self.flow / (rho * c ** 2), 5e-4)
        turn = 1.7 * c * 2 * ahead / self.own_h    # of the shortest waves in a step
        b = np.minimum(self.shock * np.maximum(Z ** 2 - 0.01, 0) / (1 + Z ** 2), 0.85 * np.maximum(1 - turn, 0) / (1.7 * turn))
        return np.where(flows, self.inside(ahead) * b * rho * c ** 2 * squeezed, 0.0)

    def layers(self, L, n, dt):
        """The half spacing of each particle along n where a metal that flows strains there: thicker by, d by/d strain, strain, its rate."""
        half = 0.5 * self.spacing
        x0 = np.where(self.thin, self.thin_strain, 0.0)
        rate = np.einsum("ia,iab,ib->i", n, L, n)
        strain = x0 + 0.5 * dt * rate
        q = 1 + (strain / np.where(strain < 0, 1.1, 0.4)) ** 4
        stretch = np.exp(strain / q ** 0.25)
        return half * (stretch - 1), half * stretch / q ** 1.25, strain, rate

    def contact(self, out, touch, r, d, vij, dt, ahead):
        """Two bodies: F15 (9)-(16) of each particle against the smooth surface psi of the other body, from both sides
        with half of the stiffness; DFAC = 1 is critical damping of the reduced mass; friction takes 1.5 times the sliding
        that the step would end with at most; its heat is shared by effusivity. The half spacing up to the surface strains in
        metal that flows, and the force on it is a stress of the particle at the next force point."""
        mu, penalty, damping = next(law[1:] for law in self.meets.values() if law[0] == "contact")
        width, s, dim = 0.845, self.spacing, self.dim
        reach = min(2.4, REACH.get(self.kernel, 2.0) * self.h / s) ** 2
        edge = np.exp(-reach / width)

        def plane(g):
            """Of a layer at distance g: integrals of the weight and of its fall."""
            y, e = reach - g * g, np.exp(-g * g / width)
            if y <= 0:
                return np.zeros(2)
            if dim == 3:
                return np.pi * np.array([width * (e - edge) - edge * (y + y * y / (2 * width)),
                                         2 * g / width * (width * (e - edge) - edge * y)])
            line = np.sqrt(np.pi * width) * e * math.erf(np.sqrt(y / width))
            return np.array([line - edge * (2 * np.sqrt(y) + 4 * y ** 1.5 / (3 * width)),
                             2 * g / width * (line - 2 * np.sqrt(y) * edge)])

        norm, slope = plane(1) + plane(2)
        bend = 2 * norm / slope
        x = np.where(touch, (r / s) ** 2, 1e30)
        near = x < reach
        w = np.where(near, np.exp(-x / width) - edge * (1 + (reach - x) / width), 0.0) / norm
        fall = np.where(near, 2 * (np.exp(-x / width) - edge) / (width * s * s), 0.0) / norm
        psi = w.sum(axis=1)
        out["touched"] = psi > 0    # in range, where nothing is shifted
        known = psi > 0.35
        q = 1 - bend * np.log(np.where(known, psi, 1.0))
        deep, at = q <= 0.16, np.exp(0.84 / bend)    # linear in psi from there
        root, of = np.sqrt(np.maximum(q, 0.16)), np.where(deep, at, np.where(known, psi, 1.0))
        rate = np.where(known, s * 0.5 * bend / (of * root), 0.0)
        delta = np.where(known, s * (1 - root) + np.where(deep, rate * (psi - at), 0.0), -s)
        p = w / np.maximum(psi, 1e-300)[:, None]    # shares of the neighbors
        normal = np.einsum("ij,ija->ia", fall, d)
        steep = np.linalg.norm(normal, axis=1)
        n = normal / np.maximum(steep, 1e-300)[:, None]
        by, arm, strain, of_strain = self.layers(out["L"], n, dt if ahead else 0.0)
        flows = np.array([m.strength[0] not in ("none", "elastic") for m in self.mat])
        thin = flows & ((psi > 1) | (self.thin > 0) & (psi > 0))    # from touch on, until the other body is away
        by, grows = np.where(thin, by, 0.0), np.where(thin, arm * of_strain, 0.0)
        mean = p @ by
        w_rate = -fall * np.einsum("ija,ija->ij", d, vij)
        delta = delta + by + mean
        hit = known & (delta > 0)
        E = np.array([m.E for m in self.mat])
        k = np.sum(p * penalty * E[:, None] * E[None] / (E[:, None] + E[None]) * (s if dim == 3 else 1.0), axis=1)
        under = p @ self.m
        mass = self.m * under / (self.m + under)
        closing = rate * w_rate.sum(axis=1) + grows + p @ grows + (w_rate @ by - mean * w_rate.sum(axis=1)) / np.maximum(psi, 1e-300)
        c = 2 * damping * np.sqrt(k * mass)
        f = np.where(hit, 0.5 * np.maximum(k * delta + c * closing, 0), 0.0)
        if ahead:
            then = np.where(f > 0, 0.5 * np.maximum(k * (delta + dt * closing) + c * closing, 0), 0.0)
            per = arm * self.q["rho"] / self.m
            now, then = (f + p.T @ f) * per, (then + p.T @ then) * per
            lacks = now - np.where(self.thin == 3, self.thin_told, 0.0)
            self.thin_told = np.where(thin, then, self.thin_told)
            self.thin_stress = np.where(thin[:, None, None], (then + lacks)[:, None, None] * n[:, :, None] * n[:, None], self.thin_stress)
            self.thin_strain = np.where(thin, strain + 0.5 * dt * of_strain, self.thin_strain)
            self.thin = np.where(thin, 4, self.thin)
        v = np.einsum("ij,ija->ia", p, vij)
        end = self.v + dt * out["acc"]    # of the step, by the forces so far
        slide = end - p @ end
        slide = slide - np.sum(slide * n, axis=1)[:, None] * n
        speed = np.linalg.norm(slide, axis=1)
        ft = np.minimum(mu * f * rate * steep, 0.75 * mass * speed / dt)
        friction = np.where(hit & (speed > 0), -ft / np.maximum(speed, 1e-300), 0.0)[:, None] * slide
        a = f[:, None] * (rate[:, None] + (by[None] - mean[:, None]) / np.maximum(psi, 1e-300)[:, None]) * fall
        give = p[..., None] * friction[:, None]
        force = (a + a.T)[..., None] * d + give - give.transpose(1, 0, 2)
        out["acc"] = out["acc"] + np.sum(force, axis=1) / self.m[:, None]
        if self.heat:
            b = np.array([np.sqrt(m.conductivity(self.T0) * m.capacity(self.T0) * m.rho0) for m in self.mat])
            share = b / (b + p @ b)
            power = -np.sum(friction * v, axis=1)
            out["source"] = share * power + p.T @ ((1 - share) * power)
        self.contacts = int(np.sum(f > 0))

    def distances(self, x):
        """x_ij and its size, of the nearest image; a particle is far from itself."""
        d = x[:, None] - x[None]
        for k in range(3):
            if self.box[k] > 0:
                d[..., k] -= self.box[k] * np.round(d[..., k] / self.box[k])
        if self.dim == 2:
            d[..., 2] = 0
        r = np.sqrt(np.sum(d * d, axis=2))
        np.fill_diagonal(r, 1e30)
        self.r = r
        return d, r

    def meetings(self):
        """Of each pair: is it of one continuum, does it conduct, do bodies touch, conductance of the interface."""
        n = self.n
        same, heat_pair = np.ones((n, n), bool), np.ones((n, n), bool)
        touch = np.zeros((n, n), bool)
        hc = np.full((n, n), np.inf)
        for (a, b), law in self.meets.items():
            of_a, of_b = self.kind == a, self.kind == b
            mask = (of_a[:, None] & of_b[None]) | (of_b[:, None] & of_a[None])
            same[mask] = False
            heat_pair[mask] = law[0] == "heat"
            touch[mask] = law[0] == "contact"
            if law[0] == "heat" and law[1]:
                hc[mask] = law[1]
        return same, heat_pair, touch, hc

    def tensile(self, sigma, rho):
        """Artificial stress of a particle F14 (18), without the thickness: R belongs to the stress of the material."""
        dim, R = self.dim, np.zeros((self.n, 3, 3))
        for i in range(self.n):
            t = sigma[i][:dim, :dim] / self.lz[i]
            if self.component:
                t = np.maximum(t, 0)
            else:
                value, vector = np.linalg.eigh(t)
                t = vector @ np.diag(np.maximum(value, 0)) @ vector.T
            R[i, :dim, :dim] = -self.artstress[0] * t * self.lz[i] / rho[i] ** 2
        return R

    def inverse_moments(self, M, face):
        """Of Bonet and Lok; eigenvalues below 0.1 count as 0.1. Of a particle that hangs loose less: |K sum V gradW| is at
        most 1.9/h."""
        M = M.copy()
        if self.dim == 2:
            M[:, 2, 2] = 1.0
        value, vector = np.linalg.eigh(M)
        K = np.einsum("iab,ib,icb->iac", vector, 1 / np.maximum(value, 0.1), vector)
        size = self.own_h * np.linalg.norm(np.einsum("iab,ib->ia", K, face), axis=1)
        return K * np.minimum(1, 1.9 / np.maximum(size, 1e-300))[:, None, None]

    def inverse_tilted(self, M, face):
        """The same of moments that normals of free faces have made unsymmetric."""
        M = M.copy()
        if self.dim == 2:
            M[:, 2, :] = M[:, :, 2] = 0.0
            M[:, 2, 2] = 1.0
        K = np.empty_like(M)
        for i in range(self.n):
            value, vector = np.linalg.eigh(0.5 * (M[i] + M[i].T))
            bounded = value.min() < 0.1
            K[i] = vector @ np.diag(1 / np.maximum(value, 0.1)) @ vector.T if bounded else np.linalg.inv(M[i])
        size = self.own_h * np.linalg.norm(np.einsum("iba,ib->ia", K, face), axis=1)
        return K * np.minimum(1, 1.9 / np.maximum(size, 1e-300))[:, None, None]

    def normals(self, face, plain):
        """Of free faces, from sum V gradW and the moments without them."""
        size = np.linalg.norm(face, axis=1)
        tilt = 2.055 * self.own_h * size
        lacks = self.dim - np.trace(plain[:, :self.dim, :self.dim], axis1=1, axis2=2)
        length = np.minimum(tilt, 1.4) / 1.18 * np.clip((tilt - 0.15) / 0.45, 0, 1) * np.clip((1.5 - lacks) / 0.85, 0, 1)
        return face * (length / np.maximum(size, 1e-300))[:, None]

    def tilted(self, d, gm, b):
        """gradW of the particle of each row, with weights by the depth of its neighbor."""
        kappa, g = 1.18 / self.own_h, np.einsum("ija,ija->ij", gm, d) / np.maximum(np.einsum("ija,ija->ij", d, d), 1e-300)
        s = -np.einsum("ia,ija->ij", b, d)
        across = (kappa / (np.sum(b ** 2, axis=1) + 1e-30))[:, None] * s ** 2
        return g[..., None] * ((1 - kappa[:, None] * s)[..., None] * d - across[..., None] * b[:, None])

    def turn_since(self, ahead):
        """The rotation by the spin of the last force point since then."""
        _, L, since, _ = self.known
        angle = 0.25 * (ahead + since) * np.stack([L[:, 2, 1] - L[:, 1, 2], L[:, 0, 2] - L[:, 2, 0],
                                                   L[:, 1, 0] - L[:, 0, 1]], 1)
        A = np.zeros((self.n, 3, 3))    # Cayley: R = (1 - A)^-1 (1 + A), A x = angle/2 x x
        A[:, 2, 1], A[:, 0, 2], A[:, 1, 0] = angle.T
        A -= A.transpose(0, 2, 1)
        return np.linalg.solve(np.eye(3) - A, np.eye(3) + A)

    def turned_moments(self, M, face, ahead):
        """The correction of the gradients: that of the last force point and its rate, turned by the spin since then; at the
        set-up its own."""
        if ahead == 0.0 or not self.one_pass:
            return self.inverse_tilted(M, face) if self.faces else self.inverse_moments(M, face)
        K, L, since, rate = self.known
        R = self.turn_since(ahead)
        size = (ahead + since) * np.sqrt(np.sum(rate ** 2, axis=(1, 2)))
        K = K + ((ahead + since) * np.minimum(1, 0.1 / np.maximum(size, 1e-300)))[:, None, None] * rate
        self.predicted = R @ K @ R.transpose(0, 2, 1)
        return self.predicted

    def residual(self, d, vij, gm, W, same, r, L):
        """By how much the velocity of a particle is off the linear field of its neighbors: with the corrected gradient of
        the pass, weights -m_j W'/r; else from a fit of constant and gradient, weights m_j/rho_j W."""
        if self.one_pass:
            g = np.einsum("ija,ija->ij", gm, d) / r ** 2 * self.m
            off = np.einsum("ij,ija->ia", g, vij) - np.einsum("iab,ij,ijb->ia", L, g, d)
            return off / np.sum(g, axis=1)[:, None]
        out, dim = np.zeros((self.n, 3)), self.dim
        for i in range(self.n):
            near = same[i] & (W[i] > 0)
            root = np.sqrt(self.m[near] / self.q["rho"][near] * W[i, near])[:, None]
            lines = root * np.hstack([np.ones((near.sum(), 1)), -d[i, near, :dim] / self.spacing])
            fit = np.linalg.lstsq(lines, root * -vij[i, near], rcond=None)[0]    # of v_j - v_i
            out[i] = -fit[0]
        return out

    @staticmethod
    def drawn(flow, p, eps):
        """How far hourglass control takes metal for drawn."""
        return min(max((eps - 0.15) / 0.25, 0), 1) * min(max(-3 * p / flow, 0), 1) if flow > 0 else 0.0

    def hourglass_force(self, d, r, gm, ahead):
        """Force per m_j of pairs against differences of displacements, at the force point, and damping."""
        q, rho = self.q, self.q["rho"]
        k = rho * q["c"] ** 2
        p = -np.trace(q["stress"], axis1=1, axis2=2) / 3
        s = q["stress"] + p[:, None, None] * np.eye(3)
        mises = np.sqrt(1.5 * np.sum(s ** 2, axis=(1, 2)))
        drawn = np.array([self.drawn(*a) for a in zip(mises, p, self.eps if self.one_pass else 0 * self.eps)])
        zeta = 12.0 * (1 + 2 * drawn)
        xi = np.minimum(4.0, zeta * (mises + np.maximum(-p, 0)) * self.lz / k) if self.hourglass == "auto" else np.full(self.n, self.hourglass)
        xi = np.where(self.failed | [m.strength[0] == "none" for m in self.mat], 0.0, xi)
        self.xi = xi
        W = np.sqrt(xi)[:, None] * self.w + (ahead * xi)[:, None] * self.w_rate + (0.1 * self.h / q["c"])[:, None] * self.w_rate
        per = 4 / (rho[:, None] + rho[None]) ** 2 if self.one_pass else 1 / (rho[:, None] * rho[None])
        across = np.einsum("ija,ija->ij", W[:, None] - W[None], d) / r ** 2
        return (np.minimum(k[:, None], k[None]) * per * across)[..., None] * gm

    def rates(self, ahead=0.0, dt=1.0):
        """Everything that one pass over the neighbours gives, at the force point."""
        q = self.q = self.point(ahead)
        dim, n, m, rho, v = self.dim, self.n, self.m, q["rho"], q["v"]
        d, r = self.distances(q["x"])
        h = np.sqrt(self.own_h[:, None] * self.own_h[None])
        constant = CONSTANT[self.kernel][dim - 2] / h ** dim
        shape, slope = kernel(self.kernel, r / h)
        gradient, across = lattice_sums(self.kernel, dim, self.h / self.spacing)
        W, dW = constant * shape, constant * slope / (h * gradient)
        if self.follow:    # each pair has the mean of the factors of the two
            factor = factors(self.kernel, dim, self.own_h / (m / rho) ** (1 / dim))
            dW = constant * slope / h * 0.5 * (factor[:, None] + factor[None])
        grad = (dW / r)[..., None] * d                          # gradient of W with respect to x_i
        same, heat_pair, touch, hc = self.meetings()
        gm = np.where(same[..., None], grad, 0.0)               # of the mechanical neighbours
        vij = v[:, None] - v[None]
        if dim == 2:
            vij[..., 2] = 0
        f14 = self.form == "f14"

        # velocity gradient: F15 (2) with rho_i outside, or volumes m/rho_j
        volume = np.broadcast_to(m / rho, (n, n)) if f14 else m[None] / rho[:, None]
        out = {"L": -np.einsum("ij,ija,ijb->iab", volume, vij, gm),
               "M": -np.einsum("ij,ija,ijb->iab", volume, d, gm), "face": np.einsum("ij,ija->ia", volume, gm)}

        sigma = q["sigma"]
        R = self.tensile(sigma, rho)

        # momentum: F15 (4), F14 (6); corrected per particle after Bonet and Lok
        P = sigma + np.where(self.thin == 3, 1.0, 0.0)[:, None, None] * self.thin_stress
        P = P if f14 else P / rho[:, None, None] ** 2
        if self.balanced:    # what R takes from the tension of a lattice is given back
            back = tensile_share(self.kernel, dim, self.h / self.spacing, self.artstress[1]) * R
            P = P - (back * rho[:, None, None] ** 2 if f14 else back)
        if self.faces:
            out["normals"] = self.normals(out["face"], out["M"])
            b = out["normals"]
            if ahead:
                b = np.einsum("iab,ib->ia", self.turn_since(ahead), self.face)
            gi = self.tilted(d, gm, b)
            out["L"] = -np.einsum("ij,ija,ijb->iab", volume, vij, gi)
            out["M"] = -np.einsum("ij,ija,ijb->iab", volume, d, gi)
            K = self.turned_moments(out["M"], out["face"], ahead)
            out["L"] = np.einsum("iab,ibc->iac", out["L"], K)
            P = np.einsum("iab,icb->iac", P, K)
            acc = np.einsum("j,iab,ijb->ia", m, P, gi) - np.einsum("j,jab,jib->ia", m, P, gi)
        else:
            if self.correction:
                K = self.turned_moments(out["M"], out["face"], ahead)
                out["L"] = np.einsum("iab,ibc->iac", out["L"], K)
                P = np.einsum("iab,ibc->iac", P, K)
            pair = P[:, None] + P[None]
            if f14:
                pair = pair / (rho[:, None] * rho[None])[..., None, None]
            acc = np.einsum("j,ijab,ijb->ia", m, pair, gm)

        # artificial stress of a pair F14 (15)-(17)
        art = np.zeros((n, n, 3))
        if self.artstress[0] > 0:
            at_spacing = kernel(self.kernel, np.array([self.spacing / self.h]))[0][0]
            f = (shape / at_spacing) ** self.artstress[1]
            art += np.einsum("ij,ijab,ijb->ija", f, R[:, None] + R[None], gm)
        # viscosity, Monaghan 1992
        alpha, beta = self.viscosity
        vx = np.sum(vij * d, axis=2)
        mu = np.where(vx < 0, h * vx / (r ** 2 + 0.01 * h ** 2), 0.0)
        ac, rho_mean = alpha * q["c"], 0.5 * (rho[:, None] + rho[None])
        pi = (-0.5 * (ac[:, None] + ac[None]) * mu + beta * mu ** 2) / rho_mean
        if self.balsara:
            pi = pi * 0.5 * (self.switch[:, None] + self.switch[None])
        art -= pi[..., None] * gm
        if self.hourglass:
            art += self.hourglass_force(d, r, gm, ahead)
            out["residual"] = self.residual(d, vij, gm, W, same, r, out["L"])
        out["acc"] = acc + np.einsum("j,ija->ia", m, art)
        out["acc"] = out["acc"] + np.asarray(self.load) / m[:, None]
        out["source"], out["touched"] = np.zeros(n), np.zeros(n, bool)
        if touch.any():
            self.contact(out, touch, r, d, vij, dt, ahead)
        if dim == 2:
            out["acc"][:, 2] = 0
        out["heating"] = -0.5 * m * np.einsum("j,ija,ija->i", m, art, vij)
        out["heating"] = out["heating"] - m / rho * q["shock"] * np.trace(out["L"], axis1=1, axis2=2)
        if self.balanced:
            out["heating"] = out["heating"] - m * rho * np.einsum("iab,iab->i", back, out["L"])

        if self.heat:    # F15 (6), a power per volume; a finite conductance is a resistance in series
            k = np.array([mt.conductivity(T) for mt, T in zip(self.mat, q["T"])])
            hc = hc * gradient / across
            with np.errstate(divide="ignore"):
                conduct = 1 / (1 / (2 * k[:, None]) + 1 / (2 * k[None]) + 1 / (hc * r))
            out["heat"] = np.einsum("j,ij->i", m / rho,
                                    np.where(heat_pair, conduct * 2 * (q["T"][:, None] - q["T"][None]) * dW / r, 0.0))
        if self.xsph:
            mean = 0.5 * (rho[:, None] + rho[None])
            out["u"] = -self.xsph * np.einsum("ij,ija->ia", np.where(same, m[None] / mean * W, 0.0), vij)
        self.out = out
        return out
