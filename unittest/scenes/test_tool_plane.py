"""A tool in two dimensions: its area per triangle is per thickness, so force over area is a stress, however long the mesh is along z; the power of
compute cutting/force is the work that a tool gives which moves, turns, or both."""
import numpy as np
from contact_scene import mesh, read_vtk
from sphtm_scene import PLANE, Checks, new_folder, run

SCRIPT = PLANE + """
lattice         sq 1e-3 origin 0.5 0.5 0
region          box block -20e-3 30e-3 -20e-3 30e-3 -0.5e-3 0.5e-3 units box
create_box      1 box
region          body block 0 12e-3 0 6e-3 INF INF units box
create_atoms    1 region body
region          foot block INF INF INF 1e-3 INF INF units box
group           foot region foot
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 2700 elastic 70e9 0.33 strength plastic 300e6 0
fix             body all sph/tm energy yes
fix             held foot setforce 0 0 0
"""
PRESS = """
fix             tool all contact/tri file block.stl scale 1e-3 1e-3 {z} move 4e-3 8e-3 0 friction 0.2 vtk 100 tool.*.vtk local 100
fix_modify      tool move linear 5 -20 0
thermo_style    custom step f_tool[1] f_tool[2]
thermo_modify   format float %.15g
dump            tri all local 100 tri.*.dump index f_tool[*]
thermo          100
run             300
"""
TURN = """
fix             tool all contact/tri file block.stl scale 1e-3 1e-3 1e-2 move {at} 0 reference {at} 0 friction 0.2
fix_modify      tool move {motion}
compute         c all cutting/force tool
thermo_style    custom step dt f_body[8] c_c[5]
thermo_modify   format float %.15g
thermo          1
run             {steps}
"""
checks, folder = Checks(), new_folder()
mesh(folder, "block.stl", "block --size 6 4 4 --cells 3 2 1")

forces = {}
for z in "1e-3", "1e-2":
    r = run(SCRIPT + PRESS.format(z=z), folder=folder)
    force = np.array([r.thermo[-1]["f_tool[1]"][-1], r.thermo[-1]["f_tool[2]"][-1]])
    m = read_vtk(r.path("tool.300.vtk"))
    area, stress = np.asarray(m["area"]), np.asarray(m["stress"])
    name = "mesh of %s along z" % z
    checks.true("%s: metal is pressed" % name, abs(force[1]) > 1e5, "%s" % force)
    checks.near("%s: areas of all are its circumference" % name, area.sum(), 20e-3, 1e-6)
    sums = (stress * area[:, None]).sum(axis=0)
    for d in 0, 1:
        checks.near("%s: stress times area, %s" % (name, "xy"[d]), sums[d], force[d], 1e-5)
    # no triangle bears more than a punch can press, 2 k (1 + pi/2) = 2.97 Y, and a contact that is between two of them
    checks.below("%s: largest pressure over that of a punch" % name, np.asarray(m["normal_stress_average"]).max() / (2.97 * 300e6), 1.5)
    forces[z] = force
checks.near("the same force with both", forces["1e-2"][1], forces["1e-3"][1], 1e-9)

for name, motion, at, steps in (("moves", "linear 5 -20 0", "4e-3 8e-3", 400), ("turns", "rotate 4e-3 8.5e-3 0 0 0 1 1e-3", "4e-3 8.5e-3", 4000),
                                ("does both", "transrot 0 -20 0 4e-3 8.2e-3 0 0 0 1 1e-3", "4e-3 8.2e-3", 400)):
    t = run(SCRIPT + TURN.format(at=at, motion=motion, steps=steps), folder=folder).thermo[-1]
    work, given = (t["c_c[5]"][1:] * t["Dt"][1:]).sum(), -t["f_body[8]"][-1]
    checks.true("%s: works" % name, given > 1.0, "%.4g J/m" % given)
    checks.near("tool that %s: sum of power times step over the work of the energy balance" % name, work / given, 1, 0.02)
checks.end()
