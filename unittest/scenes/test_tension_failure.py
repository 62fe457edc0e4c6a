"""A square bar of Weldox 460E is drawn until it breaks: engineering stress and strain against finite elements, with the
default stabilization, and what breaks it. SPHTM_ROWS: particles over the side (6), SPHTM_FASTER: pull so many times
faster than the finite elements (4).

Bar 20 x 2.4 x 2.4 mm, both ends pulled with 1 - exp(-t) m/s, t in ms; Johnson and Cook's hardening and damage without
rate and temperature. Finite elements: 571.6 MPa at a strain of 0.0987, half of it at 0.192."""
import os

import numpy as np

from sphtm_scene import SPACE, Checks, run

ROWS, FASTER = int(os.environ.get("SPHTM_ROWS", "6")), float(os.environ.get("SPHTM_FASTER", "4"))
STRAIN = [0.002, 0.005, 0.01, 0.02, 0.05, 0.08, 0.10, 0.15]
STRESS = [420.2, 522.5, 536.1, 549.5, 566.1, 571.0, 571.5, 522.3]    # MPa
LARGEST, HALF = 571.6, 0.192
SCRIPT = SPACE + """
variable        dx equal 2.4e-3/%d
lattice         sc ${dx} origin 0.5 0.5 0.5
region          box block -16e-3 16e-3 -4e-3 4e-3 -4e-3 4e-3 units box
create_box      1 box
region          work block $(-10e-3-2*v_dx) $(10e-3+2*v_dx) -1.2e-3 1.2e-3 -1.2e-3 1.2e-3 units box
create_atoms    1 region work
region          left block INF -10e-3 INF INF INF INF units box
region          right block 10e-3 INF INF INF INF INF units box
group           left region left
group           right region right
group           gauge subtract all left right
pair_style      sph/tm hyperbolic 1.2 spacing ${dx}
pair_coeff      1 1 density 7750 elastic 211e9 0.33 strength johnson/cook 499e6 382e6 0.458 0 1 300 1800 1 &
                damage johnson/cook 0.636 1.936 -2.969 0 0
fix             body all sph/tm effects heat off energy yes
variable        v equal %g*(1-exp(-1e3*%g*time))
variable        w equal -v_v
fix             hold left sph/tm/drive v_w 0 0
fix             pull right sph/tm/drive v_v 0 0
compute         p all sph/tm/atom damage pstrain
compute         most gauge reduce max c_p[1] c_p[2]
compute         failed gauge reduce sum c_p[1]
variable        start equal $(xcm(right,x)-xcm(left,x))
variable        strain equal (xcm(right,x)-xcm(left,x)-v_start)/20e-3
variable        stress equal 0.5*(f_hold[1]-f_pull[1])/5.76e-6
fix             curve all ave/time 1 50 50 v_strain v_stress c_most[1] c_most[2] file curve.dat
thermo          2000
thermo_style    custom step time dt v_strain v_stress c_most[1] c_most[2] f_body[1] f_body[7] f_body[9] f_body[15]
variable        left equal 0.21-v_strain
fix             end all halt 20 v_left < 0 error continue message no
run             10000000
write_dump      all custom end.dump id x y z c_p[*] modify sort id
""" % (ROWS, FASTER, FASTER)

checks = Checks()
result = run(SCRIPT, timeout=3000)
curve = result.columns("curve.dat")
width = max(1, int(round(len(curve) * 0.002 / curve[-1, 1])))
strain, stress = (np.convolve(curve[:, k], np.ones(width) / width, "valid") for k in (1, 2))
stress = stress / 1e6
top = stress.argmax()
gone = np.flatnonzero(stress[top:] < 0.5 * stress[top])
half = strain[top + gone[0]] if len(gone) else None
t, end = result.thermo[-1], result.dump("end.dump")[-1]
failed = (end["c_p[1]"] >= 1.0).sum()
off = [np.interp(e, strain, stress) / s - 1 for e, s in zip(STRAIN, STRESS)]
print("rows %d: largest stress %.1f MPa at %.4f, half of it at %s; largest damage %.3f, failed %d, numerical fracture %d"
      % (ROWS, stress[top], strain[top], half, curve[:, 3].max(), failed, t["f_body[15]"][-1]))
print("stress at strains of %s: off by %s %%" % (STRAIN, ["%+.1f" % (100 * x) for x in off]))
checks.near("largest stress", stress[top], LARGEST, relative=0.002)
checks.near("its strain", strain[top], 0.0987, absolute=0.01)
for e, x in list(zip(STRAIN, off))[1:7]:
    checks.below("stress at a strain of %g" % e, abs(x), 0.003)
# the neck loses its neighbors along the axis at a local strain of 0.85, before the material fails: not what finite
# elements show, and reported as what it is
checks.note("half of it", "%.4f, finite elements %.3f" % (half or 1.0, HALF))
checks.above("it does not part before", half or 1.0, 0.13)
checks.true("what parts without damage is reported", failed > 0 or t["f_body[15]"][-1] > 0)
checks.true("with where and when", "numerical fracture: a particle has lost its neighbors" in result.output)
checks.end()
