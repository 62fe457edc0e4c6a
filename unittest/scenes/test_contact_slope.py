"""A block on an inclined mesh, just below and just above the friction angle.

A block of SPH particles lies on an inclined plane of triangles. Gravity grows over many of the block's own
periods, so that it is never shaken loose. With mu = 1.02 tan(a) it must stay: over a time in which it would slide
nearly two spacings without friction it may creep by no more than a thousandth of a spacing. With mu = 0.98 and
0.7 tan(a) it must slide with g (sin a - mu cos a); at 0.98 that is a fiftieth of g sin a, so friction has to be
right to a thousandth. In 2d and 3d."""
import numpy as np
from contact_scene import MATERIAL, block, header, mesh, particles, rotation
from sphtm_scene import Checks, new_folder, run

DX, G, ANGLE = 0.01, 10.0, 20.0
# Plain gradients and viscosity 1 1: an elastic block without damping of its own flutters as it slides, whatever the time
# step. With the default the vibration grows from 2.5e-9 to 5e-5 J within 40 ms, and at mu 0.98 tan(a) the block slides with
# 0.101 (2d) and 0.152 m/s^2 (3d) instead of 0.068.
STYLE = "stabilize artstress"
RAMP, STEPS = 0.02, 5900
SCRIPT = """
pair_coeff 1 1 {material}
variable g equal {g}*(time<{ramp})*time/{ramp}+{g}*(time>={ramp})
fix body all sph/tm
fix gravity all gravity v_g vector 0 -1 0
fix slope all contact/tri file plane.stl rotate axis 1 0 0 angle -90 rotate axis 0 0 1 angle -{angle} &
    friction {mu!r} penalty 1 damping 0.5
compute x all reduce ave x y
thermo_style custom step time c_x[1] c_x[2] f_slope[1] f_slope[2] f_slope[12] f_slope[13]
thermo_modify norm no format float %.12g
thermo 100
run {steps}
"""


def slide(dim, share):
    """Time, way down the slope and force on the slope over the weight, of a block with mu = share tan(a)."""
    mu, a = share * np.tan(np.radians(ANGLE)), np.radians(ANGLE)
    x = block((10, 5, 6 if dim == 3 else 1), DX, (-0.05, 0.0, -0.03 if dim == 3 else -0.005))
    x = x @ rotation((0, 0, 1), -ANGLE).T
    folder = new_folder()
    mesh(folder, "plane.stl", "plane --size 1 0.2 --cells 23 7")
    box = [(-0.3, 0.3), (-0.3, 0.3), (-0.08, 0.08) if dim == 3 else (-0.005, 0.005)]
    script = header(DX, dim, style=STYLE) + SCRIPT.format(material=MATERIAL, g=G, ramp=RAMP, angle=ANGLE, mu=mu, steps=STEPS)
    t = run(script, files={"data.scene": particles(x, box)}, folder=folder).thermo[-1]
    force = np.array([t["f_slope[1]"], t["f_slope[2]"]]).T / (len(x) * 1000 * DX ** dim * G)
    return t["Time"], t["c_x[1]"] * np.cos(a) - t["c_x[2]"] * np.sin(a), force


def main():
    checks = Checks()
    a = np.radians(ANGLE)
    for dim in (2, 3):
        name = "%dd " % dim
        time, way, force = slide(dim, 1.02)
        late = time > RAMP
        free = 0.5 * G * np.sin(a) * (time[-1] - RAMP) ** 2 / DX
        checks.above(name + "without friction it would slide, spacings", free, 1.5)
        checks.below(name + "mu 1.02 tan a: it creeps, spacings", np.ptp(way[late]) / DX, 1e-3)
        checks.near(name + "force on the slope over weight, down", -force[late, 1].mean(), 1.0, relative=0.01)
        checks.near(name + "force on the slope over weight, across", force[late, 0].mean(), 0.0, absolute=0.01)
        for share in (0.98, 0.7, 0.0):
            time, way, force = slide(dim, share)
            late = time > 1.5 * RAMP
            due = G * (np.sin(a) - share * np.tan(a) * np.cos(a))
            checks.near(name + "mu %.2f tan a: acceleration" % share, 2 * np.polyfit(time[late], way[late], 2)[0], due,
                        relative=0.005)
    checks.end()


main()
