"""mu(T) of a tool and between bodies, with and without heat: it is that of the temperature of the particles.

One particle slides on a plane under a weight; f_tool[1]/f_tool[3] is mu. Without heat the temperature is that which fix
sph/tm gives at the start; with heat forced off, that of the particle's group too. Beyond its ends the table is constant:
nothing is extrapolated. The same for a block that slides on a block, in test_body_friction.py."""
import numpy as np
from contact_scene import header, mesh, particles
from sphtm_scene import Checks, new_folder, run

DX = 0.01
SCRIPT = """
pair_coeff 1 1 density 2700 elastic 7e10 0.33 {heat}
fix body all sph/tm temperature {T} dt 1e-7 {effects}
{more}
fix g all gravity 1e4 vector 0 0 -1
fix tool all contact/tri file plane.stl damping 1 friction/table 300 0.4 600 0.3 900 0.1
thermo_style custom step f_tool[1] f_tool[3]
thermo_modify format float %.17g
thermo 500
run 2000
"""
HEAT = "heat 120 899 0.9"
OFF = "effects heat off"


def mu(T, heat="", effects="", more="", folder=None, expect_error=False):
    data = particles([(0.01, 0, 0.5 * DX)], [(-0.5, 0.5)] * 3, v=[(10, 0, 0)])
    script = header(DX) + SCRIPT.format(T=T, heat=heat, effects=effects, more=more)
    result = run(script, files={"data.scene": data}, folder=folder, expect_error=expect_error)
    t = result.thermo[-1]
    return -t["f_tool[1]"][-1] / t["f_tool[3]"][-1], result


checks = Checks()
folder = new_folder()
mesh(folder, "plane.stl", "plane --size 0.6 0.2 --cells 7 3")
for T, due in ((150, 0.4), (300, 0.4), (450, 0.35), (750, 0.2), (900, 0.1), (2500, 0.1)):
    checks.near("friction at %g K, no heat" % T, abs(mu(T, folder=folder)[0]), due, relative=1e-6)
    if T < 900:
        value = abs(mu(T, HEAT, folder=folder)[0])
        checks.near("    with heat (it warms a little)", value, due, absolute=0.002)
group = "group hot id 1\nfix_modify body temperature hot 750"
for T in (300, 900):
    value = abs(mu(T, HEAT, OFF, group, folder=folder)[0])
    checks.near("group at 750 K, all at %g K, heat forced off" % T, value, 0.2, relative=1e-6)
    checks.near("    heat on", abs(mu(T, HEAT, "", group, folder=folder)[0]), 0.2, absolute=0.002)
checks.end()
