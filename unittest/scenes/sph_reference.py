"""The equations of SPH-TM once more, in numpy, by brute force: what the plugin's numbers are held against.

Written from the papers (F15 = Fraser 2015, F14 = Fraser 2014) and the doc pages, with none of the plugin's code: all
pairs as N x N arrays, kernels with their cases (sph_kernels.py), eigenvalues and matrix inverses from numpy, radial
return and plane stress by bisection (sph_material.py). The rates of a force point are in sph_rates.py, the state and its step here. Mass-length-time
units; stress positive in tension; x_ij = x_i - x_j.

    body = Body(dim, x, v, kind, materials, box, kernel="cubic", h=1.2 * dx, spacing=dx, ...)
    body.rates(); body.step(dt)
"""
import numpy as np
from sph_kernels import CONSTANT, REACH, kernel, lattice_psi
from sph_material import deviator_rate, warmed
from sph_rates import Rates
from sph_shift import along_stretch, shift


class Body(Rates):
    """viscosity, artstress, shock, correction, hourglass (a number or "auto"): None takes the default of the pair style, which
    with tensile (stabilize artstress), with an artificial stress and with the form F14 is that of Fraser 2014."""

    def __init__(self, dim, x, v, kind, materials, box, kernel, h, spacing, viscosity=None, artstress=None, shock=None,
                 component=False, xsph=0.0, form="f15", correction=None, balsara=False, plane_stress=False,
                 temperature=293.15, heat=False, meets=None, load=(0.0, 0.0, 0.0), balanced=False, follow=None,
                 every=1, hourglass=None, tensile=False, expands=False, compression=False, dissipation=None):
        tensile = tensile or form == "f14" or bool(artstress and artstress[0] > 0)
        if shock is None:
            yields = [m.strength[0] not in ("none", "elastic") or m.eos[0] == "shock" and m.strength[0] != "elastic" for m in materials.values()]
            shock = 0.5 if any(yields) else 0.0
        self.shock = shock
        viscosity = viscosity or ((1.0, 1.0) if tensile else (0.0, 1.0))
        artstress = artstress or ((0.3, 4) if tensile else (0.0, 4))
        correction = not tensile if correction is None else correction
        hourglass = (0.0 if tensile else "auto") if hourglass is None else hourglass
        if dissipation is None:
            dissipation = artstress[0] == 0 or any(m.eos[0] == "shock" for m in materials.values())
        self.__dict__.update(dim=dim, x=np.array(x, float), v=np.array(v, float), kind=kind, box=np.asarray(box, float),
                             kernel=kernel, h=h, spacing=spacing, viscosity=viscosity, artstress=artstress,
                             component=component, xsph=xsph, form=form, correction=correction, balsara=balsara,
                             plane_stress=plane_stress, heat=heat, meets=meets or {}, T0=temperature, load=load,
                             balanced=balanced, follow=follow, every=every, steps=0, hourglass=hourglass,
                             one_pass=correction and hourglass != 0.0 and artstress[0] == 0, expands=expands, dissipation=dissipation)
        n = self.n = len(x)
        self.mat = [materials[k] for k in kind]
        strengths = {m.strength[0] for m in materials.values()}
        self.faces = self.one_pass and strengths <= {"none", "elastic"} and strengths != {"none"}    # second order there
        self.face = None
        self.m = np.array([m.rho0 for m in self.mat]) * spacing ** dim
        self.rho = np.array([m.rho0 for m in self.mat])
        self.s = np.zeros((n, 3, 3))
        self.T, self.unstrained = np.full(n, float(temperature)), np.full(n, float(temperature))
        for m in self.mat:
            m.start = float(temperature) if compression else None
        self.eps, self.eps_rate, self.e, self.D = np.zeros(n), np.zeros(n), np.zeros(n), np.zeros(n)
        self.shifted = []
        self.failed, self.flow = np.zeros(n, bool), np.zeros(n)    # flow: stress, of the last step
        self.lz = np.ones(n)
        self.switch, self.u = np.ones(n), np.zeros((n, 3))
        # layers at other bodies: steps until they are forgotten, strain, stress at the next force point and what of it was foretold
        self.thin, self.thin_strain, self.thin_stress, self.thin_told = np.zeros(n, int), np.zeros(n), np.zeros((n, 3, 3)), np.zeros(n)
        self.w, self.w_rate = np.zeros((n, 3)), np.zeros((n, 3))    # of hourglass control: displacement and its last rate
        self.known = None    # with one pass: correction and velocity gradient of the last force point, time since then
        self.own_h, self.target = np.full(n, float(h)), None    # follow: None, still, psi, density
        self.old = None    # rates of the last two steps

    # what the pair sums see: state at the force point
    def hourglass_step(self, i, L, dt, d_eps, y, p, rho, failed, g):
        """g: gradient of the concentration, 0 where a tool touches; None: not known."""
        m = self.mat[i]
        if failed or m.strength[0] == "none":
            self.w[i] = self.w_rate[i] = 0.0
            return
        rate = self.out["residual"][i]
        spin = 0.5 * np.array([L[2, 1] - L[1, 2], L[0, 2] - L[2, 0], L[1, 0] - L[0, 1]])
        tension = min(max(-3 * p / y, 0), 1) if y > 0 else 0.0
        early = min(max((0.4 - self.eps[i]) / 0.2, 0), 1)    # the plastic strain before the step
        uneven = early * tension * min(self.own_h[i] * np.linalg.norm(along_stretch(L, self.dim) @ g) / 0.3, 1) if g is not None else 0.0
        memory = (0.02 + 0.38 * uneven) * min(max(2 / 3 - p / y if y > 0 else 1.0, 0.05), 1.0)
        xi = self.xi[i]
        self.w[i] = (self.w[i] + dt * (np.cross(spin, self.w[i]) + np.sqrt(xi) * rate)) / (1 + d_eps / memory)
        self.w_rate[i] = rate
        resists = np.sqrt(xi) * rho * self.q["c"][i] ** 2 * np.linalg.norm(self.w[i])
        most = (0.1 + (0.2 + 0.7 * early) * tension) * y * self.own_h[i]
        if y > 0 and resists > most:
            self.w[i] *= most / resists

    def seed(self, dt=1.0):
        """Rates of the set-up, as history of the first prediction."""
        o = self.rates(0.0, dt)
        rho = self.q.get("rho3", self.q["rho"])
        s = np.array([deviator_rate(self.s[i], o["L"][i], m.G) if m.strength[0] != "none" else 0 * self.s[i]
                      for i, m in enumerate(self.mat)])
        r = {"v": o["acc"], "rho": -rho * np.trace(o["L"], axis1=1, axis2=2), "s": s, "T": np.zeros(self.n), "e": np.zeros(self.n)}
        self.old = (r, r)
        if self.one_pass:
            K = self.inverse_tilted(o["M"], o["face"]) if self.faces else self.inverse_moments(o["M"], o["face"])
            self.known = K, o["L"], 0.0, np.zeros((self.n, 3, 3))
            self.face = o.get("normals")
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
        self.failed_before = self.failed.copy()
        v = self.v + dt * o["acc"]
        x = half + 0.5 * dt * v
        if self.xsph:
            self.u = o["u"]
            x = x + 0.5 * dt * self.u
        L = o["L"].copy()
        strained = self.eps + [np.sqrt(1.5 * np.sum(s ** 2)) / (3 * mt.G) if mt.G > 0 else 0.0 for s, mt in zip(self.s, self.mat)]
        rho_half = q.get("rho3", q["rho"])
        rate = {"v": o["acc"], "rho": np.zeros(n), "s": np.zeros((n, 3, 3)), "T": np.zeros(n),
                "e": np.zeros(n)}
        for i, m in enumerate(self.mat):
            T, e, growth = self.T[i], q["e"][i], q["growth"][i]
            p_half = m.pressure(growth * rho_half[i], e)

            # at n+1 the temperature has gone on as to the half step
            warm = 2 * q["T"][i] - T
            growth_end = m.growth(warm, self.unstrained[i]) if self.expands else 1.0

            def end(lzz, growth=growth):
                G = L[i].copy()
                G[2, 2] += lzz
                rho = self.rho[i] - dt * rho_half[i] * np.trace(G)
                s, d_eps, y = np.zeros((3, 3)), 0.0, 0.0
                if m.strength[0] != "none":
                    s = self.s[i] + dt * deviator_rate(q["s"][i], G, m.G)
                    if not self.failed[i]:
                        s, d_eps, y = m.radial_return(s, self.eps[i], T, dt)
                return G, rho, s, d_eps, y, m.pressure(growth * rho, e)

            lzz = 0.0
            if self.plane_stress and not self.failed[i]:    # the thickness rate at which sigma_zz vanishes
                reach = 5 * np.abs(L[i]).max() + 1e-3 * m.E / (dt * m.K)
                lo, hi = -reach, reach
                lzz = None
                while lzz != 0.5 * (lo + hi):
                    lzz = 0.5 * (lo + hi)
                    _, _, s, _, _, p = end(lzz, growth_end)
                    lo, hi = (lzz, hi) if s[2, 2] - p < 0 else (lo, lzz)
            G, rho, s, d_eps, y, p = end(lzz)
            if self.failed[i]:
                s = 0 * s
            s_half, p_half = (0 * s, max(p_half, 0)) if self.failed[i] else (q["s"][i], p_half)
            sigma_half = s_half - p_half * np.eye(3)
            work = dt / rho_half[i] * np.sum(sigma_half * 0.5 * (G + G.T))
            rate["rho"][i] = (rho - self.rho[i]) / dt
            rate["s"][i] = (s - self.s[i]) / dt
            given = dt * (o["heat"][i] * self.m[i] / q["rho"][i] + o["source"][i]) if self.heat else 0.0
            if m.eos[0] == "shock":
                rate["e"][i] = work / dt + o["heating"][i] / self.m[i] + given / self.m[i] / dt
                self.e[i] += dt * rate["e"][i]
            if m.damage and not self.failed[i]:
                self.D[i] += m.fracture_increment(s - p * np.eye(3), d_eps, dt, T)
                self.failed[i] = self.D[i] >= 1 if m.damage[0] == "johnson/cook" else self.eps[i] + d_eps >= m.damage[1]
            if self.balsara:
                curl = np.array([G[2, 1] - G[1, 2], G[0, 2] - G[2, 0], G[1, 0] - G[0, 1]])
                div = abs(np.trace(G))
                self.switch[i] = div / (div + np.linalg.norm(curl) + 1e-4 * q["c"][i] / self.h)
            if self.heat and m.heat:
                heat = m.heat[2] * y * d_eps * self.m[i] / rho + given
                if self.dissipation:    # with artificial stress only what is taken under pressure
                    given = o["heating"][i] if self.artstress[0] == 0 else max(o["heating"][i], 0) * (p_half > 0)
                    heat += dt * given
                self.T[i] = warmed(m, m.compressed(T, self.rho[i], rho), heat / self.m[i])
                rate["T"][i] = (self.T[i] - T) / dt
            if self.hourglass:
                self.hourglass_step(i, G, dt, d_eps, y, p, rho_half[i], self.failed_before[i],
                                    o["face"][i] * (not o["touched"][i]) if self.one_pass else None)
            self.rho[i], self.s[i] = rho, s
            if self.one_pass and not self.failed_before[i] and not o["touched"][i]:
                way = shift(o["face"][i], G, self.dim, self.own_h[i], self.eps[i], d_eps, y, p, q["c"][i] * dt)
                x[i] += way
                self.shifted += [self.eps[i]] if np.any(way) else []    # the plastic strain at which it was
            self.flow[i] = y
            self.eps[i] += d_eps
            self.eps_rate[i] = d_eps / dt
            self.lz[i] += dt * self.lz[i] * lzz
        if self.one_pass:
            K = self.inverse_tilted(o["M"], o["face"]) if self.faces else self.inverse_moments(o["M"], o["face"])
            missed = 0.5 * (K - self.predicted + (K - self.predicted).transpose(0, 2, 1))
            self.known = K, L, 0.5 * dt, self.known[3] + missed / (0.5 * dt + self.known[2])
            if self.faces:    # less where the material is strained
                self.face = np.clip(1 - strained / 0.1, 0, 1)[:, None] * o["normals"]
        self.x, self.v = x, v
        self.old = (rate, self.old[0])
        self.thin = np.maximum(self.thin - 1, 0)
        self.steps += 1
        if self.follow and self.steps % self.every == 0:
            self.follow_neighbors()

    # --- what compute sph/tm/atom gives
    def value(self, name):
        growth = [m.growth(T, Tu) if self.expands else 1.0 for m, T, Tu in zip(self.mat, self.T, self.unstrained)]
        p = np.array([m.pressure(g * r, e) for m, r, e, g in zip(self.mat, self.rho, self.e, growth)])
        p = np.where(self.failed, np.maximum(p, 0), p)
        if self.plane_stress:
            p = np.where(self.failed, p, self.s[:, 2, 2])
        if name.startswith("stress/"):
            a, b = ("xyz".index(c) for c in name[-2:])
            return self.s[:, a, b] - (p if a == b else 0)
        return {"density": self.rho, "pstrain": self.eps, "pstrain/rate": self.eps_rate, "temperature": self.T,
                "energy": self.e, "damage": self.D, "thickness": self.lz, "pressure": p,
                "failed": self.failed.astype(float), "h": self.own_h,
                "vonmises": np.sqrt(1.5 * np.sum(self.s ** 2, axis=(1, 2)))}[name]
