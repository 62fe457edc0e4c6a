"""One material point, for sph_reference.py: equations of state, strength, damage, heat."""
import numpy as np


class Material:
    """Constants by their names in the doc page of pair sph/tm; what is not given is off."""

    def __init__(self, density, young, poisson, eos=("linear",), strength=("elastic",), damage=None, heat=None,
                 expansion=0.0):
        self.rho0, self.E, self.nu = density, young, poisson
        self.G, self.K = young / (2 * (1 + poisson)), young / (3 * (1 - 2 * poisson))
        self.eos, self.strength, self.damage, self.heat, self.expansion = eos, strength, damage, heat, expansion
        self.start = None    # temperature of the start, where compression heats

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
        return np.sqrt(max(slope, 0.01 * self.K / self.rho0) + 4 / 3 * G / max(rho, 0.5 * self.rho0))

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
        """c_v where compression heats: c_p - c_v = (3 alpha)^2 K T/rho; in shocks that of the start for all T."""
        cp = at(self.heat[1], T)
        if self.start is None:
            return cp
        if self.eos[0] == "shock":
            c0, _, gamma = self.eos[1:]
            return cp / (1 + gamma ** 2 * at(self.heat[1], self.start) * self.start / c0 ** 2)
        return cp - 9 * at(self.expansion, T) ** 2 * self.K * T / self.rho0

    def growth(self, T, without):
        """Of a free volume from the temperature without thermal strain to T."""
        if self.eos[0] == "shock":
            return 1.0
        if np.isscalar(self.expansion):
            return (1 + self.expansion * (T - without)) ** 3
        t = np.unique(np.concatenate([[T, without], [x for x, _ in self.expansion if min(T, without) < x < max(T, without)]]))
        a = at(self.expansion, t)
        return (1 + np.sign(T - without) * (np.diff(t) * (a[1:] + a[:-1]) / 2).sum()) ** 3

    def compressed(self, T, before, after):
        """T after an isentropic change of density, Gamma rho constant."""
        if self.start is None:
            return T
        each = self.eos[3] * self.rho0 if self.eos[0] == "shock" else 3 * at(self.expansion, T) * self.K / self.capacity(T)
        return T * np.exp(each * (1 / before - 1 / after))


def at(table, T):
    """A number, or a list of (temperature, value)."""
    if np.isscalar(table):
        return table
    t, y = np.transpose(table)
    return np.interp(T, t, y)


def deviator(a):
    return a - np.trace(a) / 3 * np.eye(3)


def deviator_rate(s, L, G):
    """Jaumann's, and what makes s : D/rho the rate of s : s/(4 G rho)."""
    D, W = 0.5 * (L + L.T), 0.5 * (L - L.T)
    return 2 * G * deviator(D) + W @ s - s @ W - 0.5 * np.trace(L) * s


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
