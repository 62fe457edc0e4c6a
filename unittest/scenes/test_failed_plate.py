"""Failed material carries compression and no tension, in plane stress as in plane strain: a plate that fails at a plastic
strain of 1e-4 is pushed together by 2 %, held, and drawn apart again; pressure against the equation of state."""
import numpy as np

from sphtm_scene import PLANE, Checks, run

E, NU = 70e9, 0.33
K = E / (3 * (1 - 2 * NU))
SCENE = PLANE.replace("f f p", "f p p") + """
lattice         sq 1e-3 origin 0.5 0.5 0
region          box block -5e-3 35e-3 0 8e-3 -5e-4 5e-4 units box
create_box      1 box
region          work block 0 30e-3 INF INF INF INF units box
create_atoms    1 region work
region          left block INF 3e-3 INF INF INF INF units box
region          right block 27e-3 INF INF INF INF INF units box
region          middle block 10e-3 20e-3 INF INF INF INF units box
group           left region left
group           right region right
group           middle region middle
pair_style      sph/tm cubic 1.3 spacing 1e-3 viscosity 1 0 artstress 0 4 correction yes plane {plane}
pair_coeff      1 1 density 2700 elastic 70e9 0.33 strength plastic 10e6 0 damage strain 1e-4
fix             body all sph/tm energy yes
# 2 % of 24 mm from both sides in 40 us, a rest, and back by twice as much
variable        v equal (time<40e-6)*6*(1-cos(2*PI*time/40e-6))-(time>60e-6)*12*(1-cos(2*PI*(time-60e-6)/40e-6))
variable        w equal -v_v
variable        now equal time
fix             push left sph/tm/drive v_v 0 NULL
fix             pull right sph/tm/drive v_w 0 NULL
compute         p middle sph/tm/atom density stress/xx stress/zz thickness failed
compute         mean middle reduce ave c_p[*]
thermo          20
thermo_style    custom step time c_mean[1] c_mean[2] c_mean[3] c_mean[4] c_mean[5] f_body[9] f_body[8]
thermo_modify   format float %.12g
fix             stop all halt 1 v_now > 100e-6 error continue
run             100000
"""
checks = Checks()
for plane in "stress", "strain":
    log = run(SCENE.format(plane=plane)).thermo[-1]
    t = log["Time"]
    pressed, apart = (t > 45e-6) & (t < 60e-6), t > 97e-6
    rho, stress, cross = (log["c_mean[%d]" % k][pressed].mean() for k in (1, 2, 3))
    name = "plane %s: " % plane
    checks.true(name + "all have failed", log["c_mean[5]"][-1] == 1.0)
    checks.near(name + "density", rho / 2700 - 1, 0.02, relative=0.1)
    checks.near(name + "stress along, over K (rho/rho0 - 1)", -stress / (K * (rho / 2700 - 1)), 1.0, relative=0.01)
    checks.near(name + "stress across the plate over that along", cross / stress, 1.0, relative=0.01)
    checks.near(name + "thickness", log["c_mean[4]"][-1], 1.0, absolute=1e-3)
    checks.below(name + "drawn apart: stress over that before", abs(log["c_mean[2]"][apart].mean() / stress), 0.01)
checks.end()
