"""Metal against metal that flows: two blocks of particles, one a punch for the other, pressed between plates, with the defaults of the pair
style, so with shifting. The sum of the energies stays: nothing that is part of a surface which another body touches is shifted. With
shifting alone in the metal next to it, springs of the contact would move without work."""
import os

import numpy as np

from sphtm_scene import SOURCE, Checks, run

checks = Checks()
SCENE = """
shell           /usr/bin/python3 %s block --size 40 10 10 -o plate.stl > made
units           si
dimension       2
boundary        f f p
atom_style      atomic
newton          off
variable        dx equal 0.4e-3
lattice         sq ${dx} origin 0.5 0.5 0
region          box block -14e-3 14e-3 -6e-3 14e-3 $(-v_dx) ${dx} units box
create_box      2 box
region          work block -5.2e-3 5.2e-3 0 4e-3 INF INF units box
region          punch block -2e-3 2e-3 4e-3 8e-3 INF INF units box
create_atoms    1 region work
create_atoms    2 region punch
pair_style      sph/tm hyperbolic 1.2 spacing ${dx}
pair_coeff      * * density 7850 elastic 210e9 0.3 strength plastic 400e6 0
pair_coeff      1 2 contact friction FRICTION
fix             body all sph/tm energy yes table no effects shifting SHIFTING
fix             up all contact/tri file plate.stl scale 1e-3 move 0 13e-3 0 reference 0 8e-3 0 friction 0.2
fix             lo all contact/tri file plate.stl scale 1e-3 move 0 -5e-3 0 reference 0 0 0 friction 0.2
fix_modify      up move linear 0 -20 0 ramp 2e-5
variable        h equal f_up[8]-f_lo[8]
compute         p all sph/tm/atom pstrain
compute         m all reduce max c_p
compute         low all reduce min c_p
thermo_style    custom step time v_h f_up[2] c_m f_body[8] f_body[9]
thermo_modify   format float %%.15g
thermo          200
variable        left equal v_h-6e-3
fix             stop all halt 100 v_left <= 0 error continue message no
run             100000
""" % os.path.join(SOURCE, "tools", "make_tool.py")

for friction in "0", "0.2":
    r = run(SCENE.replace("FRICTION", friction).replace("SHIFTING", "on"))
    t = r.thermo[-1]
    checks.above("friction %s: largest plastic strain" % friction, t["c_m"][-1], 0.6)
    checks.below("friction %s: drift of the energy sum over the work" % friction, np.ptp(t["f_body[9]"]) / np.abs(t["f_body[8]"]).max(), 1e-5)
checks.end()
