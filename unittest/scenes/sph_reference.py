"""The equations of SPH-TM once more, in numpy, by brute force: what the plugin's numbers are held against.

Written from the papers (F15 = Fraser 2015, F14 = Fraser 2014), DESIGN.md and the doc pages, with none of the
plugin's code: all pairs as N x N arrays, kernels with their cases, eigenvalues and matrix inverses from numpy,
radial return and plane stress by bisection. Mass-length-time units; stress positive in tension; x_ij = x_i - x_j.

    body = Body(dim, x, v, kind, materials, box, kernel="cubic", h=1.2 * dx, spacing=dx, ...)
    body.rates(); body.step(dt)
"""
import numpy as np

ROOT = 0.25    # weight of the older rate in the prediction of the half step, doc/fix_sph_tm.rst


# --- kernels: W(q) without its constant, and dW/dq ----------------------------------------------------------

def kernel(name, q):
    """Shape and slope as piecewise polynomials, straight from REFERENCE.md section 1."""
    w, s = np.zeros_like(q), np.zeros_like(q)
    if name == "hyperbolic":
        a, b = q < 1, (q >= 1) & (q < 2)
        w[a] = q[a] ** 3 - 6 * q[a] + 6
        s[a] = 3 * q[a] ** 2 - 6
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


# --- one material point -------------------------------------------------------------------------------------

class Material:
    """Constants by their names in the doc page of pair sph/tm; what is not given is off."""

    def __init__(self, density, young, poisson, eos=("linear",), strength=("elastic",), damage=None, heat=None):
        self.rho0, self.E, self.nu = density, young, poisson
        self.G, self.K = young / (2 * (1 + poisson)), young / (3 * (1 - 2 * poisson))
        self.eos, self.strength, self.damage, self.heat = eos, strength, damage, heat

    def pressure(self, rho, e=0.0):
        x = rho / self.rho0
        if self.eos[0] == "tait":
            return self.K / self.eos[1] * (x ** self.eos[1] - 1)
        if self.eos[0] == "shock":
            c0, s, gamma = self.eos[1:]
            if np.real(x) <= 1:
                return self.rho0 * c0 ** 2 * (x - 1) + gamma * self.rho0 * e
            eta = 1 - 1 / x
            hugoniot = self.rho0 * c0 ** 2 * eta / (1 - s * eta) ** 2
            return hugoniot * (1 - gamma * eta / 2) + gamma * self.rho0 * e
        return self.K * (x - 1)

    def sound_speed(self, rho, e=0.0):
        """Longitudinal waves; dp/drho at constant entropy by a complex step (de = p/rho^2 drho)."""
        tiny = 1e-30 * rho
        work = max(self.pressure(rho, e), 0.0) / rho ** 2 if self.eos[0] == "shock" else 0.0
        slope = self.pressure(rho + 1j * tiny, e + 1j * work * tiny).imag / tiny
        G = 0.0 if self.strength[0] == "none" else self.G
        return np.sqrt(max(slope, 0.01 * self.K / self.rho0) + 4 / 3 * G / rho)

    def flow_stress(self, eps, rate, T):
        if self.strength[0] == "plastic":
            return self.strength[1] + self.strength[2] * eps
        A, B, n, C, m, Tref, Tmelt, rate0 = self.strength[1:]
        t = np.clip((T - Tref) / (Tmelt - Tref), 0, 1)
        return max((A + B * eps ** n) * (1 + C * np.log(max(rate / rate0, 1.0))) * (1 - t ** m), 0.0)

    def yields(self):
        return self.strength[0] in ("plastic", "johnson/cook")

    def radial_return(self, s, eps, T, dt):
        """Deviator, plastic increment and flow stress at the end of a step; s is the trial deviator."""
        if not self.yields():
            return s, 0.0, 0.0
        trial = np.sqrt(1.5 * np.sum(s * s))
        before = self.flow_stress(eps, 0.0, T)
        if trial <= before:
            return s, 0.0, before
        lo, hi = 0.0, trial / (3 * self.G)
        d = None
        while d != 0.5 * (lo + hi):
            d = 0.5 * (lo + hi)
            if trial - 3 * self.G * d > self.flow_stress(eps + d, d / dt, T):
                lo = d
            else:
                hi = d
        y = trial - 3 * self.G * d
        return s * (y / trial), d, y

    def fracture_increment(self, sigma, d_eps, dt, T):
        if not self.damage or d_eps <= 0:
            return 0.0
        if self.damage[0] == "strain":
            return d_eps / self.damage[1]
        d1, d2, d3, d4, d5 = self.damage[1:]
        mean = np.trace(sigma) / 3
        dev = sigma - mean * np.eye(3)
        mises = np.sqrt(1.5 * np.sum(dev * dev))
        _, _, _, _, _, Tref, Tmelt, rate0 = self.strength[1:]
        t = np.clip((T - Tref) / (Tmelt - Tref), 0, 1)
        ratio = np.clip(mean / mises, -3, 1.5)
        rate = np.log(max(d_eps / dt / rate0, 1.0))
        return d_eps / ((d1 + d2 * np.exp(d3 * ratio)) * (1 + d4 * rate) * (1 + d5 * t))

    def conductivity(self, T):
        return at(self.heat[0], T) if self.heat else 0.0

    def capacity(self, T):
        return at(self.heat[1], T)


def at(table, T):
    """A number, or a list of (temperature, value)."""
    if np.isscalar(table):
        return table
    t, y = np.transpose(table)
    return np.interp(T, t, y)


def deviator(a):
    return a - np.trace(a) / 3 * np.eye(3)


def jaumann(s, L, G):
    D, W = 0.5 * (L + L.T), 0.5 * (L - L.T)
    return 2 * G * deviator(D) + W @ s - s @ W


# --- a body of particles ------------------------------------------------------------------------------------

def lattice_sums(name, dim, h):
    """On a lattice of spacing 1: the gradient that the sums make of a unit gradient, and twice the sum of |W'| over
    the pairs across a unit of a plane between two layers."""
    side = np.arange(-12, 13.0)
    x, y, z = np.meshgrid(side, side, side if dim == 3 else [0.0])
    r = np.sqrt(x * x + y * y + z * z)
    r[r == 0] = 1e30
    dW = CONSTANT[name][dim - 2] / h ** (dim + 1) * kernel(name, r / h)[1]
    return -np.sum(dW / r * x * x), -2 * np.sum(np.where(x > 0, dW * x, 0))


def tensile_share(name, dim, h, power):
    """The part of a tension that an artificial stress of strength 1 takes on that lattice."""
    side = np.arange(-12, 13.0)
    x, y, z = np.meshgrid(side, side, side if dim == 3 else [0.0])
    r = np.sqrt(x * x + y * y + z * z)
    r[r == 0] = 1e30
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
    """Psi of the lattice without the particle itself, REFERENCE.md section 7."""
    side = np.arange(-12, 13.0)
    x, y, z = np.meshgrid(side, side, side if dim == 3 else [0.0])
    r = np.sqrt(x * x + y * y + z * z)
    return (CONSTANT[name][dim - 2] * kernel(name, r[r > 0] / n_h)[0].sum()) ** (1 / dim)


def warmed(m, T, heat):
    """Temperature after a heat per mass, the integral of a capacity that is linear meanwhile; by bisection."""
    if not heat:
        return T
    lo, hi = T + heat / m.capacity(T) * np.array([0.25, 4] if heat > 0 else [4, 0.25])
    for _ in range(200):
        mid = 0.5 * (lo + hi)
        if (mid - T) * 0.5 * (m.capacity(T) + m.capacity(mid)) < heat:
            lo = mid
        else:
            hi = mid
    return 0.5 * (lo + hi)


class Body:
    def __init__(self, dim, x, v, kind, materials, box, kernel, h, spacing, viscosity=(1.0, 1.0), artstress=(0.3, 4),
                 component=False, xsph=0.0, form="f15", correction=False, balsara=False, plane_stress=False,
                 temperature=293.15, heat=False, meets=None, load=(0.0, 0.0, 0.0), balanced=False, follow=None,
                 every=1):
        self.__dict__.update(dim=dim, x=np.array(x, float), v=np.array(v, float), kind=kind, box=np.asarray(box, float),
                             kernel=kernel, h=h, spacing=spacing, viscosity=viscosity, artstress=artstress,
                             component=component, xsph=xsph, form=form, correction=correction, balsara=balsara,
                             plane_stress=plane_stress, heat=heat, meets=meets or {}, T0=temperature, load=load,
                             balanced=balanced, follow=follow, every=every, steps=0)
        n = self.n = len(x)
        self.mat = [materials[k] for k in kind]
        self.m = np.array([m.rho0 for m in self.mat]) * spacing ** dim
        self.rho = np.array([m.rho0 for m in self.mat])
        self.s = np.zeros((n, 3, 3))
        self.T = np.full(n, float(temperature))
        self.eps, self.eps_rate, self.e, self.D = np.zeros(n), np.zeros(n), np.zeros(n), np.zeros(n)
        self.failed = np.zeros(n, bool)
        self.lz = np.ones(n)
        self.switch, self.u = np.ones(n), np.zeros((n, 3))
        self.own_h, self.target = np.full(n, float(h)), None    # follow: None, still, psi, density
        self.old = None    # rates of the last two steps

    # what the pair sums see: state at the force point
    def point(self, ahead):
        q = {"x": self.x, "v": self.v, "rho": self.rho, "s": self.s, "T": self.T}
        if ahead and self.old:
            new, older = self.old
            for name, rate in new.items():
                q[name] = q[name] + ahead * ((1 + 2 * ROOT) * rate - 2 * ROOT * older[name])
        if ahead:
            q["x"] = self.x + ahead * (self.v + self.u)
        sigma = np.empty((self.n, 3, 3))
        c = np.empty(self.n)
        for i, m in enumerate(self.mat):
            p = m.pressure(q["rho"][i], self.e[i])
            c[i] = m.sound_speed(q["rho"][i], self.e[i])
            s = q["s"][i]
            if self.failed[i]:
                p, s = max(p, 0.0), 0 * s
            if self.plane_stress:
                p = s[2, 2]
            sigma[i] = s - p * np.eye(3)
        q.update(sigma=sigma, c=c)
        if self.plane_stress:    # sums over areas: density and stress count times the thickness
            q["rho3"] = q["rho"]
            q["rho"] = q["rho"] * self.lz
            q["sigma"] = sigma * self.lz[:, None, None]
        return q

    def contact(self, out, touch, r, d, vij, dt):
        """Two bodies: F15 (9)-(16) between spheres one spacing wide; DFAC = 1 is critical damping; friction may
        take a quarter of the sliding within a step; its heat is shared by effusivity."""
        mu, penalty, damping = next(law[1:] for law in self.meets.values() if law[0] == "contact")
        E = np.array([m.E for m in self.mat])
        delta = np.where(touch, self.spacing - r, 0.0)
        k = penalty * E[:, None] * E[None] / (E[:, None] + E[None]) * (self.spacing if self.dim == 3 else 1.0)
        mass = self.m[:, None] * self.m[None] / (self.m[:, None] + self.m[None])
        normal = d / r[..., None]
        vn = np.sum(vij * normal, axis=2)
        fn = np.where(delta > 0, np.maximum(k * delta - 2 * damping * np.sqrt(k * mass) * vn, 0), 0.0)
        vt = vij - vn[..., None] * normal
        speed = np.linalg.norm(vt, axis=2)
        ft = np.minimum(mu * fn, 0.25 * mass * speed / dt)
        force = fn[..., None] * normal - np.where(speed > 0, ft / np.maximum(speed, 1e-300), 0.0)[..., None] * vt
        out["acc"] = out["acc"] + np.sum(force, axis=1) / self.m[:, None]
        if self.heat:
            b = np.array([np.sqrt(m.conductivity(self.T0) * m.capacity(self.T0) * m.rho0) for m in self.mat])
            out["source"] = np.sum(ft * speed * b[:, None] / (b[:, None] + b[None]), axis=1)
        self.contacts = int(np.sum(fn > 0))

    def rates(self, ahead=0.0, dt=1.0):
        """Everything that one pass over the neighbours gives, at the force point."""
        q = self.q = self.point(ahead)
        dim, n, m, rho, v = self.dim, self.n, self.m, q["rho"], q["v"]
        d = q["x"][:, None] - q["x"][None]                      # x_ij
        for k in range(3):
            if self.box[k] > 0:
                d[..., k] -= self.box[k] * np.round(d[..., k] / self.box[k])
        if dim == 2:
            d[..., 2] = 0
        r = np.sqrt(np.sum(d * d, axis=2))
        np.fill_diagonal(r, 1e30)
        self.r = r
        h = np.sqrt(self.own_h[:, None] * self.own_h[None])
        constant = CONSTANT[self.kernel][dim - 2] / h ** dim
        shape, slope = kernel(self.kernel, r / h)
        gradient, across = lattice_sums(self.kernel, dim, self.h / self.spacing)
        W, dW = constant * shape, constant * slope / (h * gradient)
        if self.follow:    # each pair has the mean of the factors of the two
            factor = factors(self.kernel, dim, self.own_h / (m / rho) ** (1 / dim))
            dW = constant * slope / h * 0.5 * (factor[:, None] + factor[None])
        grad = (dW / r)[..., None] * d                          # gradient of W with respect to x_i
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
        gm = np.where(same[..., None], grad, 0.0)               # of the mechanical neighbours
        vij = v[:, None] - v[None]
        if dim == 2:
            vij[..., 2] = 0
        f14 = self.form == "f14"

        # velocity gradient: F15 (2) with rho_i outside, or volumes m/rho_j
        volume = np.broadcast_to(m / rho, (n, n)) if f14 else m[None] / rho[:, None]
        out = {"L": -np.einsum("ij,ija,ijb->iab", volume, vij, gm),
               "M": -np.einsum("ij,ija,ijb->iab", volume, d, gm)}

        # artificial stress of a particle F14 (18), without the thickness: R belongs to the stress of the material
        sigma = q["sigma"]
        R = np.zeros((n, 3, 3))
        for i in range(n):
            t = sigma[i][:dim, :dim] / self.lz[i]
            if self.component:
                t = np.maximum(t, 0)
            else:
                value, vector = np.linalg.eigh(t)
                t = vector @ np.diag(np.maximum(value, 0)) @ vector.T
            R[i, :dim, :dim] = -self.artstress[0] * t * self.lz[i] / rho[i] ** 2

        # momentum: F15 (4), F14 (6); corrected per particle after Bonet and Lok
        P = sigma if f14 else sigma / rho[:, None, None] ** 2
        if self.balanced:    # what R takes from the tension of a lattice is given back
            back = tensile_share(self.kernel, dim, self.h / self.spacing, self.artstress[1]) * R
            P = P - (back * rho[:, None, None] ** 2 if f14 else back)
        if self.correction:
            M = out["M"]
            if dim == 2:
                M[:, 2, 2] = 1.0
            value, vector = np.linalg.eigh(M)    # eigenvalues below 0.1 count as 0.1
            K = np.einsum("iab,ib,icb->iac", vector, 1 / np.maximum(value, 0.1), vector)
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
        c_mean, rho_mean = 0.5 * (q["c"][:, None] + q["c"][None]), 0.5 * (rho[:, None] + rho[None])
        pi = (-alpha * c_mean * mu + beta * mu ** 2) / rho_mean
        if self.balsara:
            pi = pi * 0.5 * (self.switch[:, None] + self.switch[None])
        art -= pi[..., None] * gm
        out["acc"] = acc + np.einsum("j,ija->ia", m, art)
        out["acc"] = out["acc"] + np.asarray(self.load) / m[:, None]
        out["source"] = np.zeros(n)
        if touch.any():
            self.contact(out, touch, r, d, vij, dt)
        if dim == 2:
            out["acc"][:, 2] = 0
        out["heating"] = -0.5 * m * np.einsum("j,ija,ija->i", m, art, vij)
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

    def seed(self, dt=1.0):
        """Rates of the set-up, as history of the first prediction."""
        o = self.rates(0.0, dt)
        rho = self.q.get("rho3", self.q["rho"])
        s = np.array([jaumann(self.s[i], o["L"][i], m.G) if m.strength[0] != "none" else 0 * self.s[i]
                      for i, m in enumerate(self.mat)])
        r = {"v": o["acc"], "rho": -rho * np.trace(o["L"], axis1=1, axis2=2), "s": s, "T": np.zeros(self.n)}
        self.old = (r, r)
        if self.follow == "psi":
            self.target = np.array([self.nodes(i) for i in range(self.n)])

    def nodes(self, i):
        """n_h of the lattice that has the Psi of particle i: by 256 values and straight lines between, read
        backwards."""
        if not hasattr(self, "psi"):
            self.n_h = np.linspace(1 / REACH.get(self.kernel, 2.0), 4, 256)
            self.psi = [lattice_psi(self.kernel, self.dim, n) for n in self.n_h]
        sum_ = kernel(self.kernel, np.delete(self.r[i], i) / self.own_h[i])[0].sum()
        return np.interp((CONSTANT[self.kernel][self.dim - 2] * sum_) ** (1 / self.dim), self.psi, self.n_h)

    def follow_neighbors(self):
        """S13 (2), (3), or (4); the limits 0.5 and 2."""
        if self.follow == "psi":
            s = np.clip(self.target / [self.nodes(i) for i in range(self.n)], 0.25, 4)
            a = np.where(s < 1, 0.4 * (1 + s ** 2), 0.4 * (1 + s ** -3.0))
            self.own_h = self.own_h * (1 - a + a * s)
        if self.follow == "density":
            self.own_h = self.h * (np.array([m.rho0 for m in self.mat]) / self.rho) ** (1 / self.dim)
        self.own_h = np.clip(self.own_h, 0.5 * self.h, 2 * self.h)

    def step(self, dt):
        if self.old is None:
            self.seed(dt)
        o = self.rates(0.5 * dt, dt)
        q, n = self.q, self.n
        half = q["x"]
        v = self.v + dt * o["acc"]
        x = half + 0.5 * dt * v
        if self.xsph:
            self.u = o["u"]
            x = x + 0.5 * dt * self.u
        L = o["L"].copy()
        rho_half = q.get("rho3", q["rho"])
        rate = {"v": o["acc"], "rho": np.zeros(n), "s": np.zeros((n, 3, 3)), "T": np.zeros(n)}
        for i, m in enumerate(self.mat):
            T, e = self.T[i], self.e[i]
            p_half = m.pressure(rho_half[i], e)

            def end(lzz):
                G = L[i].copy()
                G[2, 2] += lzz
                rho = self.rho[i] - dt * rho_half[i] * np.trace(G)
                s, d_eps, y = np.zeros((3, 3)), 0.0, 0.0
                if m.strength[0] != "none":
                    s = self.s[i] + dt * jaumann(q["s"][i], G, m.G)
                    if not self.failed[i]:
                        s, d_eps, y = m.radial_return(s, self.eps[i], T, dt)
                return G, rho, s, d_eps, y, m.pressure(rho, e)

            lzz = 0.0
            if self.plane_stress:    # the thickness rate at which sigma_zz vanishes
                reach = 5 * np.abs(L[i]).max() + 1e-3 * m.E / (dt * m.K)
                lo, hi = -reach, reach
                lzz = None
                while lzz != 0.5 * (lo + hi):
                    lzz = 0.5 * (lo + hi)
                    _, _, s, _, _, p = end(lzz)
                    lo, hi = (lzz, hi) if s[2, 2] - p < 0 else (lo, lzz)
            G, rho, s, d_eps, y, p = end(lzz)
            if self.failed[i]:
                s = 0 * s
            s_half, p_half = (0 * s, max(p_half, 0)) if self.failed[i] else (q["s"][i], p_half)
            sigma_half = s_half - p_half * np.eye(3)
            work = dt / rho_half[i] * np.sum(sigma_half * 0.5 * (G + G.T))
            rate["rho"][i] = (rho - self.rho[i]) / dt
            rate["s"][i] = (s - self.s[i]) / dt
            if m.eos[0] == "shock":
                self.e[i] += work + dt * o["heating"][i] / self.m[i]
            if m.damage and not self.failed[i]:
                self.D[i] += m.fracture_increment(s - m.pressure(rho, e) * np.eye(3), d_eps, dt, T)
                self.failed[i] = self.D[i] >= 1 if m.damage[0] == "johnson/cook" else self.eps[i] + d_eps >= m.damage[1]
            if self.balsara:
                curl = np.array([G[2, 1] - G[1, 2], G[0, 2] - G[2, 0], G[1, 0] - G[0, 1]])
                div = abs(np.trace(G))
                self.switch[i] = div / (div + np.linalg.norm(curl) + 1e-4 * q["c"][i] / self.h)
            if self.heat and m.heat:
                power = m.heat[2] * y * d_eps / dt * self.m[i] / rho
                power = power + o["heat"][i] * self.m[i] / q["rho"][i] + o["source"][i]
                self.T[i] = warmed(m, T, dt * power / self.m[i])
                rate["T"][i] = (self.T[i] - T) / dt
            self.rho[i], self.s[i] = rho, s
            self.eps[i] += d_eps
            self.eps_rate[i] = d_eps / dt
            self.lz[i] += dt * self.lz[i] * lzz
        self.x, self.v = x, v
        self.old = (rate, self.old[0])
        self.steps += 1
        if self.follow and self.steps % self.every == 0:
            self.follow_neighbors()

    # --- what compute sph/tm/atom gives
    def value(self, name):
        p = np.array([m.pressure(r, e) for m, r, e in zip(self.mat, self.rho, self.e)])
        p = np.where(self.failed, np.maximum(p, 0), p)
        if self.plane_stress:
            p = self.s[:, 2, 2]
        if name.startswith("stress/"):
            a, b = ("xyz".index(c) for c in name[-2:])
            return self.s[:, a, b] - (p if a == b else 0)
        return {"density": self.rho, "pstrain": self.eps, "pstrain/rate": self.eps_rate, "temperature": self.T,
                "energy": self.e, "damage": self.D, "thickness": self.lz, "pressure": p,
                "failed": self.failed.astype(float), "h": self.own_h,
                "vonmises": np.sqrt(1.5 * np.sum(self.s ** 2, axis=(1, 2)))}[name]
