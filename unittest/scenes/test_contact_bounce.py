"""A particle that bounces 1000 times on closed meshes: no energy without damping, the right loss with it.

Without damping the energy in flight must not grow: over 1000 bounces on a block, and over 1000 bounces of all
directions inside a hollow cube (mesh turned inside out), where faces, edges and corners are hit. A bounce that begins
and ends between two steps is off by the order of (w dt)^2, as often up as down. A single particle keeps within
2 (w dt)^2 for ever (regular at some steps, wandering within that band at others); the mean of 100 particles stays. With damping, the share z of the
critical one, the rebound is that of a spring-dashpot whose force is never tensile (closed form)."""
import numpy as np
from contact_scene import MATERIAL, header, mesh, particles
from sphtm_scene import Checks, new_folder, run

DX, E, RHO = 0.1, 1e7, 1000.0
OMEGA = np.sqrt(E / RHO) / DX          # of one particle on its penalty spring
SCRIPT = """
pair_coeff 1 1 {material}
fix body all sph/tm energy yes
{fixes}
thermo_style custom step time f_body[1] f_body[5] f_tool[12] f_tool[13] {more}
thermo_modify norm no format float %.15g
thermo {every}
run {steps}
"""


def restitution(z):
    """Rebound over impact speed of a spring-dashpot whose force is never tensile, damping ratio z."""
    if z >= 1:
        raise ValueError
    w = np.sqrt(1 - z * z)
    # x = sin(w t) e^-zt/w; force x + 2 z x' = 0 first at
    t = (np.pi - np.arctan2(2 * z * w, 1 - 2 * z * z)) / w
    return np.exp(-z * t) * abs(np.cos(w * t) - z / w * np.sin(w * t))


def bounces(t):
    """Number of contacts that began."""
    return int((np.diff((t["f_tool[12]"] > 0).astype(int)) > 0).sum())


def on_a_block(checks, dt):
    """Falls from a height of 2 spacings; the flight takes about as long as the contact. dt in 1/w."""
    folder = new_folder()
    mesh(folder, "block.stl", "block --size 1 1 0.4 --cells 7 7 3")
    g = 0.05 * OMEGA ** 2 * DX      # weight = 0.05 k dp: static penetration a twentieth of a spacing
    z0 = 0.2 + 0.5 * DX + 0.3 * DX
    fixes = "fix g all gravity %r vector 0 0 -1\nfix tool all contact/tri file block.stl penalty 1 damping 0" % float(g)
    steps = int(12000 / dt)
    script = header(DX) + SCRIPT.format(material=MATERIAL, fixes=fixes, every=1, steps=steps, more="c_z")
    script = script.replace("energy yes", "energy yes dt %r" % (dt / OMEGA))
    script = script.replace("thermo_style", "compute z all reduce ave z\nthermo_style", 1)
    t = run(script, files={"data.scene": particles([(0.013, 0.021, z0)], [(-1, 1)] * 3)}, folder=folder).thermo[-1]
    mass = RHO * DX ** 3
    n = bounces(t)
    checks.above("on a block, w dt %g: bounces" % dt, n, 1000)
    # in free flight the energy is exact: kinetic and potential at the same time
    free = t["f_tool[13]"] == 0
    free[0] = True
    energy = (t["f_body[1]"] + mass * g * (t["c_z"] - 0.25)) / (mass * g * (z0 - 0.25))
    checks.note("    steps per bounce", "%.1f" % (len(t["Step"]) / n))
    checks.below("    highest energy in flight over the first, less 1", energy[free].max() - 1, 2 * dt ** 2)
    checks.below("    lowest: loss", 1 - energy[free].min(), 2 * dt ** 2)


def in_a_cube(checks, dt, steps, bound, damping=0.0):
    """100 particles that do not see each other, thrown about inside a cube of 3 spacings without gravity; kinetic
    energy of those in flight, over that at the start."""
    name = "inside a cube, damping %g, dt %s: " % (damping, dt)
    folder = new_folder()
    mesh(folder, "cube.stl", "block --size 0.3 0.3 0.3 --cells 2 3 4")
    rng = np.random.default_rng(1)
    v = rng.normal(size=(100, 3))
    v *= 0.2 * DX * OMEGA / np.linalg.norm(v, axis=1)[:, None]
    x = rng.uniform(-0.09, 0.09, (100, 3))
    fixes = "neigh_modify exclude type 1 1\nfix tool all contact/tri file cube.stl flip yes penalty 1 damping %g" % damping
    fixes += "\ndump d all custom %d cube.dump id x y z vx vy vz\ndump_modify d format float %%.15g" % (steps // 50)
    script = header(DX) + SCRIPT.format(material=MATERIAL, fixes=fixes, every=10, steps=steps, more="")
    script = script.replace("energy yes", "energy yes dt %s" % dt)
    result = run(script, files={"data.scene": particles(x, [(-1, 1)] * 3, v=v)}, folder=folder)
    t, frames = result.thermo[-1], result.dump("cube.dump")
    # an undamped touch lasts pi/w
    touches = t["f_tool[12]"].mean() / 100 * t["Time"][-1] * OMEGA / np.pi
    checks.above(name + "touches of each particle", touches, 1000 if damping == 0 else 10)
    position = np.array([[f[k] for k in ("x", "y", "z")] for f in frames]).transpose(0, 2, 1)
    energy = sum(np.array([f[k] for f in frames]) ** 2 for k in ("vx", "vy", "vz")) / (0.2 * DX * OMEGA) ** 2
    free = (abs(position) < 0.15 - 0.5 * DX).all(axis=2)
    checks.true("    all stay inside", (abs(position) < 0.15).all())
    if damping:
        checks.below("    energy left", energy[-1].max(), 1e-3)
        return
    each = np.array([e[m].mean() for e, m in zip(energy[-5:].T, free[-5:].T) if m.any()])
    error = each.std() / np.sqrt(len(each))
    checks.note("    they wander by, rms", "%.2g" % each.std())
    checks.note("    mean change of energy and its standard error", "%.2g +- %.2g" % (each.mean() - 1, error))
    checks.below("    mean gain less three standard errors", each.mean() - 1 - 3 * error, 0.0)
    checks.below("    mean gain", each.mean() - 1, bound)
    checks.below("    largest energy of a particle, less 1", each.max() - 1, 20 * bound)


def rebound(checks):
    """One bounce with damping: speed after over before."""
    folder = new_folder()
    mesh(folder, "plane.stl", "plane --size 1 1 --cells 3 3")
    for z in (0.05, 0.2, 0.5, 0.9):
        v = -0.1 * DX * OMEGA
        fixes = "fix tool all contact/tri file plane.stl penalty 1 damping %r" % z
        script = header(DX) + SCRIPT.format(material=MATERIAL, fixes=fixes, every=1, steps=400, more="")
        script = script.replace("energy yes", "energy yes dt %r" % (0.02 / OMEGA))
        data = particles([(0.1, 0.2, 0.5 * DX + 0.01 * DX)], [(-1, 1)] * 3, v=[(0, 0, v)])
        t = run(script, files={"data.scene": data}, folder=folder).thermo[-1]
        e = np.sqrt(t["f_body[1]"][-1] / t["f_body[1]"][0])
        checks.near("damping %.2f: rebound speed" % z, e, restitution(z), relative=0.01)
        checks.near("    lost energy is booked as damping",
                    t["f_body[5]"][-1] / t["f_body[1]"][0], 1 - e * e, relative=1e-3)


def main():
    checks = Checks()
    for dt in (0.25, 0.2, 0.16, 0.13, 0.08):
        on_a_block(checks, dt)
    in_a_cube(checks, "auto", 48000, 0.01)
    in_a_cube(checks, "1.3e-4", 80000, 5e-3)
    in_a_cube(checks, "auto", 48000, 0.01, damping=0.05)
    rebound(checks)
    checks.end()


main()
