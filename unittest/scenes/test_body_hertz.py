"""The stiffness of contact between two bodies of particles: Hertz, and the compliance of the contact itself.

Hertz: a rigid spherical cap of particles, driven, is pressed into a flat layer of particles on a rigid base, both with the law
of bodies (pair_coeff contact). F = 4/3 E* sqrt(R) d^1.5 times the factor of a bonded layer of finite thickness
(Dimitriadis et al. 2002, as in test_contact_press.py, where the cap is a mesh). The cap is a lattice whose columns are
shifted by rho^2/(2 R); the cap over the particles of the layer, and moved by half a spacing along both axes. The contact is *penalty
material*: it has the compliance of the half spacing on either side that particles do not have.

Compliance: a column is pressed on another with pressure p; the gap closes by p dp (E1 + E2)/(PFAC E1 E2), whatever the
offset of the lattices, and at half the spacing by half of it. The columns are periodic."""
import numpy as np
from contact_scene import block, header, particles
from sphtm_scene import Checks, run
from test_contact_press import E, NU, THICK, WIDE, layer_factor

HERTZ = """
pair_coeff 1 1 density 1000 elastic {E} {nu}
pair_coeff 2 2 density 1000 elastic {E} {nu}
pair_coeff 3 3 density 1000 elastic {E} {nu}
pair_coeff 1 3 contact penalty material damping 0.2
pair_coeff 2 3 none
group free type 1 3
group cap type 3
fix body free sph/tm
variable v equal -{speed}*(1-exp(-time/{rise}))
fix push cap sph/tm/drive 0 0 v_v
compute z cap reduce min z
thermo_style custom step time f_push[3] c_z
thermo_modify norm no format float %.12g
thermo 10
run {steps}
"""


def hertz(checks):
    layer = block((WIDE, WIDE, THICK), 1.0, (-0.5 * WIDE, -0.5 * WIDE, -THICK))
    types = np.where(layer[:, 2] < -THICK + 2, 2, 1)
    speed = 0.005 * np.sqrt(E / 1000)
    for name, shift, radius in (("over particles", 0.0, 8.0), ("half a spacing aside", 0.5, 16.0)):
        cap = block((15, 15, 3), 1.0, (-7.5, -7.5, 0.0))
        cap[:, 2] += (cap[:, 0] ** 2 + cap[:, 1] ** 2) / (2 * radius)
        x = np.r_[layer, cap + [shift, shift, 0.02]]
        script = header(1.0) + HERTZ.format(E=E, nu=NU, speed=speed, rise=0.02, steps=2600)
        t = run(script, files={"data.scene": particles(x, [(-12, 12), (-12, 12), (-14, 20)],
                                                       types=np.r_[types, 3 * np.ones(len(cap), int)])}).thermo[-1]
        d, F = 0.5 - t["c_z"], abs(t["f_push[3]"])
        due = 4 / 3 * E / (1 - NU ** 2) * np.sqrt(radius) * np.maximum(d, 1e-9) ** 1.5
        for depth in (0.5, 0.65, 0.8):
            at = np.argmin(abs(d - depth))
            a = np.sqrt(radius * d[at])
            checks.near("cap of %g dp %s: contact radius %.1f dp, d %.2f: F/F_due" % (radius, name, a, d[at]),
                        F[at] / due[at] / layer_factor(d[at], radius, THICK - 2.0, NU), 1.0, relative=0.1)


COLUMN = """
pair_coeff 1 1 density 1000 elastic 1e7 0.3
pair_coeff 2 2 density 1000 elastic 3e7 0.3
pair_coeff 1 2 contact damping 1 penalty 0.5
group one type 1
group two type 2
fix body all sph/tm
fix press one addforce 0 {press} 0
fix hold two setforce 0 0 0
fix side one setforce 0 NULL 0
compute y one reduce min y
thermo_style custom step time c_y f_hold[2]
thermo_modify norm no format float %.12g
thermo 100
run 4000
"""


def compliance(checks):
    p, k = 1e5, 0.5 * 1e7 * 3e7 / 4e7
    for dx in (0.01, 0.005):
        for offset in (0.0, 0.25, 0.5):
            n = int(round(0.1 / dx))
            one, two = [block((n, 3, 1), dx, (-0.05, y, -0.5 * dx)) for y in (0, -3 * dx)]
            one[:, 0] += offset * dx
            script = header(dx, 2, boundary="p f p") + COLUMN.format(press=-p * dx / 3)
            x = np.r_[one, two]
            t = run(script, files={"data.scene": particles(x, [(-0.05, 0.05), (-0.1, 0.1), (-0.5 * dx, 0.5 * dx)], types=np.r_[
                np.ones(len(one), int), 2 * np.ones(len(two), int)])}).thermo[-1]
            gap = 0.5 * dx - t["c_y"][-1]
            checks.near("spacing %g, offset %.2f: closing of the gap over p dp/k" % (dx, offset), gap / (p * dx / k), 1,
                        relative=0.03)


if __name__ == "__main__":
    checks = Checks()
    compliance(checks)
    hertz(checks)
    checks.end()
