"""A square bar of Weldox 460E is drawn until it breaks: engineering stress and strain against finite elements, and what
breaks it. With the default a neck loses its neighbors along the axis before the material fails, which is reported; pairs
that are kept (total-Lagrangian) follow the neck to failure by damage, and the halves go on. SPHTM_FASTER: pull so many
times faster than the finite elements (4).

Bar 20 x 2.4 x 2.4 mm, both ends pulled with 1 - exp(-t) m/s, t in ms; Johnson and Cook's hardening and damage without
rate and temperature. Finite elements: 571.6 MPa at a strain of 0.0987, half of it at 0.192."""
import os

import numpy as np

from sphtm_scene import SPACE, Checks, run

FASTER = float(os.environ.get("SPHTM_FASTER", "4"))
STRAIN = [0.002, 0.005, 0.01, 0.02, 0.05, 0.08, 0.10, 0.15]
STRESS = [420.2, 522.5, 536.1, 549.5, 566.1, 571.0, 571.5, 522.3]    # MPa
LARGEST, HALF = 571.6, 0.192
SCRIPT = SPACE + """
variable        dx equal 2.4e-3/{rows}
lattice         sc ${{dx}} origin 0.5 0.5 0.5
region          box block -16e-3 16e-3 -4e-3 4e-3 -4e-3 4e-3 units box
create_box      1 box
region          work block $(-10e-3-2*v_dx) $(10e-3+2*v_dx) -1.2e-3 1.2e-3 -1.2e-3 1.2e-3 units box
create_atoms    1 region work
region          left block INF -10e-3 INF INF INF INF units box
region          right block 10e-3 INF INF INF INF INF units box
group           left region left
group           right region right
group           gauge subtract all left right
pair_style      sph/tm hyperbolic 1.2 spacing ${{dx}}
pair_coeff      1 1 density 7750 elastic 211e9 0.33 strength johnson/cook 499e6 382e6 0.458 0 1 300 1800 1 &
                damage johnson/cook 0.636 1.936 -2.969 0 0
fix             body all sph/tm effects heat off energy yes
{lists}
variable        v equal {faster}*(1-exp(-1e3*{faster}*time))
variable        w equal -v_v
fix             hold left sph/tm/drive v_w 0 0
fix             pull right sph/tm/drive v_v 0 0
compute         p all sph/tm/atom damage pstrain
compute         most gauge reduce max c_p[1] c_p[2]
variable        start equal $(xcm(right,x)-xcm(left,x))
variable        strain equal (xcm(right,x)-xcm(left,x)-v_start)/20e-3
variable        stress equal 0.5*(f_hold[1]-f_pull[1])/5.76e-6
fix             curve all ave/time 1 50 50 v_strain v_stress c_most[1] c_most[2] file curve.dat
thermo          2000
thermo_style    custom step time dt v_strain v_stress c_most[1] c_most[2] f_body[1] f_body[7] f_body[8] f_body[9] f_body[15]
variable        left equal {until}-v_strain
fix             end all halt 20 v_left < 0 error continue message no
run             10000000
write_dump      all custom end.dump id x y z c_p[*] modify sort id
"""
KEPT = "fix lists all adapt/neigh threshold inf"


class Drawn:
    """rows: particles over the side."""

    def __init__(self, rows, lists, until):
        self.result = run(SCRIPT.format(rows=rows, lists=lists, until=until, faster="%g" % FASTER), timeout=3000)
        curve = self.result.columns("curve.dat")
        width = max(1, int(round(len(curve) * 0.002 / curve[-1, 1])))
        strain, stress = (np.convolve(curve[:, k], np.ones(width) / width, "valid") for k in (1, 2))
        stress = stress / 1e6
        top = stress.argmax()
        gone = np.flatnonzero(stress[top:] < 0.5 * stress[top])
        self.largest, self.at = stress[top], strain[top]
        self.half = strain[top + gone[0]] if len(gone) else None
        self.last = stress[-1] / stress[top]
        self.off = dict(zip(STRAIN, [np.interp(e, strain, stress) / s - 1 for e, s in zip(STRAIN, STRESS)]))
        self.damage, self.pstrain = curve[:, 3].max(), curve[:, 4].max()
        self.t, self.end = self.result.thermo[-1], self.result.dump("end.dump")[-1]
        self.failed, self.torn = (self.end["c_p[1]"] >= 1.0).sum(), self.t["f_body[15]"][-1]
        self.first = strain[np.searchsorted(curve[:, 3], 1.0)] if self.damage >= 1.0 else None
        print("%d particles, %s: largest stress %.1f MPa at %.4f, half of it at %s; first failure at %s; largest damage %.3f, "
              "plastic strain %.2f, failed %d, numerical fracture %d; at the end %.2f of the largest stress"
              % (rows, "kept" if lists else "default", self.largest, self.at, self.half, self.first, self.damage,
                 self.pstrain, self.failed, self.torn, self.last))
        print("    stress off by " + ", ".join("%+.1f %% at %g" % (100 * self.off[e], e) for e in STRAIN))


checks = Checks()


def same(name, d, last, within):
    checks.near(name + "largest stress", d.largest, LARGEST, relative=0.002)
    checks.near(name + "its strain", d.at, 0.0987, absolute=0.01)
    for e in STRAIN[1:last]:
        checks.below(name + "stress at a strain of %g" % e, abs(d.off[e]), within)


d = Drawn(6, "", 0.21)
same("6 particles: ", d, 7, 0.003)
# the neck loses its neighbors along the axis at a local strain of 0.85, before the material fails: not what finite
# elements show, and reported as what it is
checks.note("half of it", "%.4f, finite elements %.3f" % (d.half or 1.0, HALF))
checks.above("it does not part before", d.half or 1.0, 0.13)
checks.true("what parts without damage is reported", d.failed > 0 or d.torn > 0)
checks.true("with where and when, and what helps", "numerical fracture: a particle has lost its neighbors" in d.result.output
            and "adapt/neigh threshold inf" in d.result.output)

for rows, curve, parts in (6, 0.03, 0.14), (8, 0.03, 0.05):    # over finite elements: the stress, the strain at half of it
    d = Drawn(rows, KEPT, 0.25)
    name = "kept, %d particles: " % rows
    same(name, d, 7, 0.003)
    checks.below(name + "stress at a strain of 0.15", abs(d.off[0.15]), curve)
    checks.near(name + "half of it", d.half or 1.0, HALF, relative=parts)
    checks.near(name + "strain of the first failure", d.first or 1.0, HALF, relative=parts)
    checks.above(name + "a neck, local strain", d.pstrain, 0.9)
    checks.above(name + "failed by damage, over a cross section", d.failed / rows ** 2, 1.0)
    checks.true(name + "which is no numerical fracture", d.torn == 0 and "numerical fracture: none" in d.result.output, "%g" % d.torn)
    checks.below(name + "broken, and goes on: stress at the end over the largest", abs(d.last), 0.2)
    checks.below(name + "drift of the energy sum over the work", abs(d.t["f_body[9]"][-1] - d.t["f_body[9]"][0]) / abs(d.t["f_body[8]"]).max(), 0.001)
checks.end()
