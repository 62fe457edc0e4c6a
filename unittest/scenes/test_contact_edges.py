"""A particle slides across 1000 triangle edges and feels no bump; with F15's inside-outside test it can.

Plane: pressed down by gravity, it slides along the middle, obliquely, exactly along a row of vertices and almost along
it; the normal force may not ripple (the bound is 1 %, what is found is round-off). Cylinder of 720 chords turning
under a particle that is held: the distance to the chords varies by their sagitta R (1 - cos(pi/720)), and the force
may ripple by no more than the stiffness times that. The same with method f15, for comparison."""
import numpy as np
from contact_scene import MATERIAL, header, mesh, particles, write_stl
from sphtm_scene import Checks, new_folder, run

DX, RHO = 0.1, 1000.0
STIFF, MASS = 1e7 * DX, RHO * DX ** 3
WEIGHT = 0.01 * STIFF * DX       # presses it in by a hundredth of a spacing
DT = 0.25 * np.sqrt(MASS / STIFF)
SLIDE = """
pair_coeff 1 1 {material}
fix body all sph/tm dt {dt!r}
fix g all gravity {g!r} vector 0 0 -1
fix tool all contact/tri file plane.stl penalty 1 damping 1 method {method} overlap allow
compute x all reduce ave x y z
thermo_style custom step f_tool[3] f_tool[12] c_x[1] c_x[2]
thermo_modify norm no format float %.12g
thermo 100000
run 400
velocity all set {vx!r} {vy!r} 0
thermo 1
run {steps}
"""
TURN = """
pair_coeff 1 1 {material}
fix body all sph/tm dt {dt!r}
fix tool all contact/tri file cylinder.stl penalty 1 damping 0 method {method} overlap allow
fix_modify tool move rotate 0 0 0 0 1 0 {period!r}
fix hold all setforce 0 0 0
thermo_style custom step f_tool[1] f_tool[2] f_tool[3] f_tool[12]
thermo_modify norm no format float %.12g
thermo 1
run {steps}
"""


def edges_crossed(x, y, nx, ny, sx, sy):
    """Edges of the structured plane between successive places: lines of x, of y and of the diagonals."""
    u, v = x / sx * nx, y / sy * ny
    return int(sum(abs(np.diff(np.floor(w + 1e-9))).sum() for w in (u, v, u - v)))


def plane(checks):
    cases = (("along the middle", 0.13, 0.0), ("obliquely", -0.43, 0.0143), ("along a row of vertices", 0.0, 0.0),
             ("almost along it", 0.0, 1e-6))
    cells, size, length, steps = (600, 4), (60.0, 1.0), 56.0, 6000
    for name, y, slope in cases:
        for method in ("closest", "f15"):
            folder = new_folder()
            mesh(folder, "plane.stl", "plane --size %g %g --cells %d %d" % (size + cells))
            vx = length / (steps * DT)
            script = header(DX) + SLIDE.format(material=MATERIAL, dt=float(DT), g=WEIGHT / MASS, method=method,
                                               vx=float(vx), vy=float(slope * vx), steps=steps)
            start = (-28.0, y, 0.5 * DX - WEIGHT / STIFF)
            data = particles([start], [(-31, 31), (-1, 1), (-2, 2)])
            t = run(script, files={"data.scene": data}, folder=folder).thermo[-1]
            force = -t["f_tool[3]"] / WEIGHT
            text = "plane, %s, %s: ripple of the force" % (name, method)
            if method == "closest":
                checks.below(text, np.ptp(force), 1e-8)
                checks.above("    edges crossed", edges_crossed(t["c_x[1]"], t["c_x[2]"], *cells, *size), 1000)
                checks.near("    normal force over weight", force.mean(), 1, relative=1e-8)
                checks.true("    always one contact", (t["f_tool[12]"] == 1).all())
            else:
                checks.note(text, "%.3g; contacts %d to %d" % (np.ptp(force), t["f_tool[12]"].min(),
                                                               t["f_tool[12]"].max()))


def cylinder_mesh(folder, n, radius, width):
    a = 2 * np.pi * np.arange(n + 1) / n
    a[-1] = 0.0
    ring = np.stack([radius * np.sin(a), 0 * a, radius * np.cos(a)], 1)
    lo, hi = ring - [0, 0.5 * width, 0], ring + [0, 0.5 * width, 0]
    triangles = []
    for k in range(n):
        triangles += [(lo[k], lo[k + 1], hi[k + 1]), (lo[k], hi[k + 1], hi[k])]
        triangles += [((0, -0.5 * width, 0), lo[k + 1], lo[k]), ((0, 0.5 * width, 0), hi[k], hi[k + 1])]
    write_stl(folder, "cylinder.stl", triangles)


def cylinder(checks):
    n, radius, delta, steps = 720, 20 * DX, 0.1 * DX, 9000
    sagitta = radius * (1 - np.cos(np.pi / n))
    for method in ("closest", "f15"):
        folder = new_folder()
        cylinder_mesh(folder, n, radius, 1.0)
        script = header(DX) + TURN.format(material=MATERIAL, dt=float(DT), method=method,
                                          period=float(DT * steps), steps=steps)
        data = particles([(0, 0.1, radius + 0.5 * DX - delta)], [(-3, 3), (-1, 1), (-3, 3)])
        t = run(script, files={"data.scene": data}, folder=folder).thermo[-1]
        force = -t["f_tool[3]"][1:] / (STIFF * delta)
        if method == "closest":
            checks.below("cylinder, closest: ripple of the force", np.ptp(force), 1.001 * sagitta / delta)
            checks.below("    force over the tangent, most", abs(t["f_tool[1]"]).max() / (STIFF * delta),
                         1.1 * np.pi / n)
            checks.true("    always one contact", (t["f_tool[12]"] == 1).all())
        else:
            checks.note("cylinder, f15: ripple of the force", "%.3g, %d of %d steps without contact" %
                        (np.ptp(force), (t["f_tool[12]"][1:] == 0).sum(), steps))


if __name__ == "__main__":
    checks = Checks()
    plane(checks)
    cylinder(checks)
    checks.end()
