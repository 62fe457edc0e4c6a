"""Hourglass control: it holds patterns that no gradient sees, resists nothing else, and keeps momentum and energy.

A chessboard of velocities in a block; a linear field, with the fit of passes of its own and with corrected gradients in the
rate pass; momentum, angular momentum, energy of a block that spins and rings."""
import numpy as np

from sphtm_scene import PLANE, Checks, run

# A block of 20 x 20 particles, free in a vacuum; E 200 GPa, c = 5.9 km/s
SCENE = PLANE + """
lattice         sq 1e-3 origin 0.5 0.5 0
region          box block -0.02 0.04 -0.02 0.04 -0.001 0.001 units box
create_box      1 box
region          body block 0 0.02 0 0.02 INF INF units box
create_atoms    1 region body
pair_style      sph/tm cubic 1.3 spacing 1e-3 {options}
pair_coeff      1 1 density 7830 elastic 200e9 0.29 {material}
fix             body all sph/tm energy yes {fix}
run             0
{start}
compute         p all sph/tm/atom hourglass vonmises
compute         most all reduce max c_p[*]
variable        lz atom mass*(x*vy-y*vx)
compute         lz all reduce sum v_lz
variable        px equal mass(all)*vcm(all,x)
variable        py equal mass(all)*vcm(all,y)
thermo          {every}
thermo_style    custom step time v_px v_py c_lz c_most[1] c_most[2] f_body[1] f_body[2] f_body[7] f_body[9]
thermo_modify   format float %.16g
dump            1 all custom {every} out.dump id x y vx vy
dump_modify     1 sort id format float %.17g
run             {steps}
"""
BARE = "viscosity 0 0 "
CHESS = "variable        c atom 2*((round(x/1e-3-0.5)+round(y/1e-3-0.5))%2)-1\nvelocity        all set v_c 0 0 units box"
checks = Checks()


def scene(options, start, steps, material="strength elastic", fix="", every=None):
    return run(SCENE.format(options=options, start=start, steps=steps, material=material, fix=fix, every=every or steps // 20))


def amplitude(result):
    """Largest displacement of the particles inside, in spacings, in each frame."""
    frames = result.dump("out.dump")
    at = np.stack([frames[0]["x"], frames[0]["y"]], 1)
    inner = (at.min(1) > 5e-3) & (at.max(1) < 15e-3)
    return np.array([np.hypot(f["x"] - frames[0]["x"], f["y"] - frames[0]["y"])[inner].max() for f in frames]) / 1e-3


# --- a chessboard of +-1 m/s: without hourglass control it goes on for ever, with it it swings back and is damped
steps = 2000
# the prediction takes (omega dt)^4/8 a step from it: a tenth of its energy in all, so energy/drift does not judge it
free = scene(BARE + "hourglass 0 correction no", CHESS, steps, fix="energy/drift none")
checks.above("pattern without hourglass control, way of a particle (spacings)", amplitude(free)[-1], 0.05)
# the spring of a chessboard: omega^2 = 2 xi c^2 sum V |W'|/r (1 - cos) x^2/r^2 (1 - s); its half period is less than 5 us
for options in "hourglass 0.02 correction no", "hourglass 0.02", "hourglass auto":
    held = scene(BARE + options, CHESS, steps)
    first, *rest = held.dump("out.dump")
    # without stress nothing but the damping acts: 1 m/s is gone in some h/(0.1 c)
    checks.below(options + ": largest way (spacings)", amplitude(held).max(), 3e-3)
    inside = (abs(first["x"] - 0.01) < 5e-3) & (abs(first["y"] - 0.01) < 5e-3)
    checks.below(options + ": largest velocity inside at the end, over the first", abs(rest[-1]["vx"][inside]).max(), 0.05)
for correction in "no", "yes":    # a stiff spring, so that the damping is far below critical
    first, *rest = scene(BARE + "hourglass 1 correction " + correction, CHESS, 200, every=2).dump("out.dump")
    checks.above("hourglass 1 correction %s: the particles inside turn back, velocity over the first" % correction,
                 max(-(f["vx"] * first["vx"])[inside].max() for f in rest), 0.5)

# --- a homogeneous field makes no displacement: stretched at 400 1/s and sheared, no stress but that of the strain
LINEAR = "variable        vx atom 400*x+300*y\nvariable        vy atom -200*x+100*y\nvelocity        all set v_vx v_vy 0 units box"


def off_linear(result):
    """Displacement after a step, over that of a particle 1 mm from the origin."""
    t = result.thermo[-1]
    return t["c_most[1]"][1] / (t["Time"][1] * 500e-3)


for correction, allowed in ("no", 1e-11), ("linear", 5e-6):
    plain, held = (scene(BARE + "%s correction %s" % (more, correction), LINEAR, 20, fix="dt 1e-8", every=1)
                   for more in ("hourglass 0", "hourglass 1"))
    name = "linear field, correction " + correction
    checks.below(name + ": displacement after a step, over that of a particle 1 mm from the origin", off_linear(held), allowed)
    for column in ("x", "y"):
        a, b = (r.dump("out.dump")[1][column] for r in (plain, held))
        checks.below(name + ": %s after a step, difference over a spacing" % column, abs(a - b).max() / 1e-3, 1e-13)
second = scene(BARE + "hourglass 1", LINEAR, 20, fix="dt 1e-8", every=1)    # of second order at free faces
checks.below("linear field, correction yes: displacement after a step, over that of a particle 1 mm from the origin", off_linear(second), 5e-6)
# in the rate pass the correction is that of the step before: what is left falls with the strain of a step
half = scene(BARE + "hourglass 1 correction linear", LINEAR, 20, fix="dt 5e-9", every=1)
checks.near("linear field, correction linear: displacement with twice the step, over that", off_linear(held) / off_linear(half), 2,
            relative=0.05)

# --- momentum and energy: a block that spins, rings and flows, with xi far above what is meant for use, and by default
SPIN = ("variable        vx atom -4e3*(y-0.01)+60*sin(400*x)\nvariable        vy atom 4e3*(x-0.01)+60*sin(300*x+200*y)\n"
        "velocity        all set v_vx v_vy 0 units box")
ELASTIC, PLASTIC = "strength elastic", "strength plastic 400e6 100e6"
for options in ("hourglass 0.3 correction no", "hourglass 0.3", ""):
    for material in ELASTIC, PLASTIC:
        t = scene(options, SPIN, 1200, material, fix="courant 0.2").thermo[-1]
        name = "%s, %s" % (options or "default", material.split()[1])
        impulse = 7830e-6 * 400 * 60.0
        checks.below(name + ": momentum, change over that of one part", max(abs(t[k] - t[k][0]).max() for k in ("v_px", "v_py")) / impulse,
                     1e-11)
        if "correction no" not in options:    # plain sums have a torque of their own at surfaces
            checks.below(name + ": angular momentum, change over itself", abs(t["c_lz"] / t["c_lz"][0] - 1).max(), 5e-5)
        checks.below(name + ": energy sum, change over the kinetic energy", abs(t["f_body[9]"] - t["f_body[9]"][0]).max() / t["f_body[1]"][0],
                     3e-3)
        checks.above(name + ": it acts (largest displacement over a spacing)", t["c_most[1]"].max() / 1e-3, 1e-4)
# with the largest step the error of the time integration is not larger than that of the block without hourglass control
drift = []
for options in "hourglass 0", "hourglass 0.3", "":
    t = scene(options, SPIN, 600, ELASTIC).thermo[-1]
    drift.append(abs(t["f_body[9]"] - t["f_body[9]"][0]).max() / t["f_body[1]"][0])
checks.below("energy sum, change, with xi 0.3 over that without", drift[1] / drift[0], 1.0)
checks.below("energy sum, change, by default over that without", drift[2] / drift[0], 1.0)
checks.end()
