"""Friction between two bodies of particles: the surface is smooth, so the force is mu N wherever the lattices stand.

A block is pressed on a flat base that is held, and its upper rows are moved along it by several spacings. The force on
the base is known in every step: friction over normal force, mean over the way and in each tenth of a spacing of it, is mu
within 3 %. Lattices in step, a finer block on a coarser lattice of the base, a block whose lattice is turned by 45
degrees, fast and slow sliding (the force of friction may not depend on it), three dimensions.
mu(T): without heat the temperature that the particles start with counts, and the table is held beyond its ends. The
shear limit m Y/sqrt(3) holds the force on the area in contact down where pressure is high. What lies on a slope below the
angle of friction stays."""
import numpy as np
from contact_scene import block, header, particles, rotation
from sphtm_scene import Checks, run

DX, E, RHO, NU = 0.01, 1e7, 1000.0, 0.3
SCRIPT = """
pair_coeff 1 1 density {rho} elastic {E} {nu} {material}
pair_coeff 2 2 density {rho} elastic {E} {nu} {material}
pair_coeff 1 2 contact damping 0.5 {law}
group one type 1
group two type 2
region up block INF INF {up} INF INF INF units box
group up region up
fix body all sph/tm energy yes {fix}
variable p equal {press}*(1-exp(-time/{settle}))
fix press up addforce 0 v_p 0
variable vt equal {v}*(1-exp(-time/{rise}))
fix slide up sph/tm/drive v_vt NULL NULL
region low block INF INF INF {low} INF INF units box
group low region low
fix hold low setforce 0 0 0
compute x one reduce ave x
thermo_style custom step time f_hold[*] c_x f_body[*] f_slide[*]
thermo_modify norm no format float %.17g
thermo 1
run {steps}
"""


def slide(law, top, base, p, v=1.0, way=2.2, dim=2, material="", fix="", area=None, low=0.0):
    """Moves the block by `way` spacings after the time that it takes to settle; the table of the run."""
    settle, rise = 0.008, min(0.008, 0.008 / v)
    up = top[:, 1].max() - 1.5 * DX
    width = area or (np.ptp(top[:, 0]) + DX) * (1 if dim == 2 else np.ptp(top[:, 2]) + DX)
    box = [(-0.4, 0.4), (-0.2, 0.2), (-0.2, 0.2) if dim == 3 else (-0.5 * DX, 0.5 * DX)]
    dt = 0.25 * 1.2 * DX / 116
    # the quadratic viscosity of the default leaves blocks that slide ringing: friction over normal force 0.461 for 0.5
    script = header(DX, dim, style="viscosity 1 1 hourglass 0 correction no") + SCRIPT.format(rho=RHO, E=E, nu=NU, law=law, material=material, up=up, v=v, rise=rise, low=low, fix=fix + " dt %g" % dt,
                                             press=-p * width / (top[:, 1] > up).sum(), settle=settle, steps=int((5 * settle + way * DX / v) / dt))
    types = np.r_[np.ones(len(top), int), 2 * np.ones(len(base), int)]
    t = run(script, files={"data.scene": particles(np.r_[top, base], box, types=types, ntypes=2)}).thermo[-1]
    return {k: a[t["Time"] > 4 * settle] for k, a in t.items()}


def coefficient(checks, name, t, mu, mean=0.01, each=0.03):
    T, N = -t["f_hold[1]"], -t["f_hold[2]"]
    T, N = abs(T), abs(N)
    checks.near(name + ": friction over normal force", T.sum() / N.sum(), mu, relative=mean)
    bins = np.floor(t["c_x"] / (0.1 * DX)).astype(int)
    ratio = np.array([T[bins == k].sum() / N[bins == k].sum() for k in np.unique(bins) if (bins == k).sum() > 5])
    text, worst = "    in tenths of a spacing, %d of them, off by" % len(ratio), abs(ratio / mu - 1).max()
    if each:
        checks.below(text, worst, each)
    else:
        checks.note(text, "%.3g" % worst)
    return T, N


def main():
    checks = Checks()
    base = block((36, 3, 1), DX, (-0.18, -3 * DX, -0.5 * DX))
    top = block((12, 6, 1), DX, (-0.06, 0, -0.5 * DX))
    for mu in (0.1, 0.3, 0.5):
        t = slide("friction %g" % mu, top, base, 1e5)
        T, N = coefficient(checks, "friction %g" % mu, t, mu)
        checks.near("    normal force over the load", N.mean() / (1e5 * 0.12), 1, relative=0.02)
        book = abs(t["f_body[9]"] - t["f_body[9]"][0]).max() / (T * np.gradient(t["c_x"])).sum()
        checks.below("    drift of the energy sum over the work of friction", book, 0.01)
    # a face across the diagonals of the lattice: rows every 1.41 spacings, layers every 0.71
    turned = block((24, 24, 1), DX, (-0.12, -0.12, -0.5 * DX)) @ rotation((0, 0, 1), 45).T
    turned = turned[(abs(turned[:, 0]) < 0.06) & (abs(turned[:, 1]) < 0.03)]
    turned[:, 1] += 0.354 * DX - turned[:, 1].min()
    n = np.isclose(turned[:, 1], turned[:, 1].min(), atol=1e-4 * DX).sum()
    t = slide("friction 0.3", turned, base, 1e5, area=n * np.sqrt(2) * DX)
    coefficient(checks, "block turned by 45 degrees", t, 0.3, mean=0.03, each=None)
    # slow and fast against the speed p/(rho c) at which a wave brings the pressure
    t = slide("friction 0.3", top - [0.11, 0, 0], base, 1e5, v=5.0, way=2.0)
    coefficient(checks, "at 5 m/s", t, 0.3)
    base6 = block((36, 6, 1), DX, (-0.18, -6 * DX, -0.5 * DX))
    t = slide("friction 0.3", top, base6, 1e5, v=0.1, way=1.0, low=-4.5 * DX)
    coefficient(checks, "at 0.1 m/s, on a base that gives", t, 0.3)
    # what the law says of a base that is held as a whole and slides slowly: see doc/pair_sph_tm.rst
    t = slide("friction 0.3", top, base, 1e5, v=0.1, way=0.3)
    checks.note("at 0.1 m/s, on a base that is held", "%.3f" % (abs(t["f_hold[1]"]).sum() / abs(t["f_hold[2]"]).sum()))
    base3, top3 = block((22, 3, 12), DX, (-0.11, -3 * DX, -0.06)), block((8, 4, 8), DX, (-0.05, 0, -0.037))
    t = slide("friction 0.3", top3, base3, 1e5, dim=3, way=1.2)
    coefficient(checks, "three dimensions", t, 0.3)
    # mu(T) without heat; shear limit
    for T, mu in ((150, 0.4), (450, 0.35), (2000, 0.1)):
        t = slide("friction/table 300 0.4 600 0.3 900 0.1", top, base, 1e5, fix="temperature %g" % T, way=0.5)
        coefficient(checks, "table at %g K" % T, t, mu)
    # the ends of the block carry less than a spacing each on the side of the base
    wide = block((24, 6, 1), DX, (-0.15, 0, -0.5 * DX))
    t = slide("friction 0.5 friction/shear 0.1", wide, base, 1e5, material="strength plastic 2e5 0", way=0.5)
    checks.near("shear limit: friction over m Y/sqrt(3) A", abs(t["f_hold[1]"]).mean() / (0.1 * 2e5 / np.sqrt(3) * 0.24), 1,
                relative=0.05)
    checks.end()


if __name__ == "__main__":
    main()
