"""What the bodies of a scene are, where a script leaves it open: faces of one body that meet, bodies that begin inside of each
other or with different spacings, metal that has a velocity and stands still, fixes that take particles for atoms. A warning
each, and beside it the control that runs without one."""
import numpy as np
from sphtm_scene import Checks, lattice_block, run

checks = Checks()
STEEL = "density 7800 elastic 210e9 0.3 strength plastic 500e6 1e9"


def warns(name, r, *words):
    """A run that ends well, with one warning that has these words; without words: with none."""
    said = [w for w in r.warnings() if all(x in w for x in words)] if words else r.warnings()
    good = r.status == 0 and len(said) == (1 if words else 0)
    checks.true(name, good, "" if good else "%d %s %s" % (r.status, r.errors()[:200], [w[:150] for w in r.warnings()]))


# --- faces of one body that meet: a block that flies past another, at a gap
PASS = lattice_block("0 10e-3 0 6e-3", "-0.04 0.06 -0.04 0.04", types=2) + """
region          other block -10e-3 0 -6e-3 0 INF INF units box
create_atoms    {type} region other
group           other region other
displace_atoms  other move {start} -{gap} 0 units box
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      * * """ + STEEL + """
pair_coeff      1 2 contact
fix             body all sph/tm {fix}
velocity        other set 200 0 0 units box
compute         p all sph/tm/atom pstrain
compute         most all reduce max c_p
variable        v equal vcm(other,x)
thermo          200
thermo_style    custom step time v_v c_most
run             {steps}
"""


def passing(gap, type=1, start=-8e-3, steps=1500, fix="", ranks=1):
    return run(PASS.format(gap=gap, type=type, start=start, steps=steps, fix=fix), ranks=ranks)


for ranks in 1, 2:
    r = passing(0.7e-3, ranks=ranks)
    warns("a block that drags another past it, %d ranks" % ranks, r, "two faces of one body", "1.4 spacings", "contact")
checks.below("it is braked", r.thermo[-1]["v_v"][-1], 199.0)
r = passing(0.7e-3, type=2)
warns("the same as two types in contact", r)
checks.near("which fly on", r.thermo[-1]["v_v"][-1], 200.0, 1e-12)
r = passing(1.5e-3)
warns("out of reach", r)
checks.near("which fly on, too", r.thermo[-1]["v_v"][-1], 200.0, 1e-12)
warns("without the effect fracture", passing(0.7e-3, fix="effects fracture off"))

STRIP = lattice_block("0 20e-3 2e-3 4e-3", "-10e-3 30e-3 -20e-3 20e-3", dx="0.5e-3") + """
region          low block 0 20e-3 -4e-3 -2e-3 INF INF units box
region          bow block 0 2e-3 -2e-3 2e-3 INF INF units box
create_atoms    1 region low
create_atoms    1 region bow
region          ends block 17.5e-3 INF INF INF INF INF units box
region          above block INF INF 0 INF INF INF units box
group           ends region ends
group           above region above
group           up intersect ends above
group           down subtract ends above
pair_style      sph/tm hyperbolic 1.2 spacing 0.5e-3
pair_coeff      * * """ + STEEL + """
fix             body all sph/tm
fix             up up sph/tm/drive NULL -{speed} NULL
fix             down down sph/tm/drive NULL {speed} NULL
thermo          500
thermo_style    custom step time
run             {steps}
"""
warns("arms of a strip that are bent together", run(STRIP.format(speed=100, steps=1200)), "faces of one body", "(type 1)")
HEM = lattice_block("0 12e-3 0 4e-3", "-0.02 0.04 -0.02 0.04") + """
region          other block 0 12e-3 {low} {high} INF INF units box
lattice         sq 1e-3 origin 0.5 {origin} 0
create_atoms    1 region other
region          top block INF INF $({high}-2e-3) INF INF INF units box
group           top region top
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      * * """ + STEEL + """
fix             body all sph/tm
fix             top top sph/tm/drive 0 -{speed} 0
thermo          500
run             {steps}
"""


def hem(gap, speed=0.0, steps=200):
    return run(HEM.format(origin=(gap + 0.5) % 1, low=(4 + gap) * 1e-3, high=(8 + gap) * 1e-3, speed=speed, steps=steps))


for gap in 0.5, 1.0, 1.3:
    warns("a slit of %g spacings at the start" % gap, hem(gap), "two faces of one body", "before particle")
warns("one that is wider than the kernel", hem(1.5))
for gap in 2.0, 3.0, 5.0:
    warns("one of %g spacings that is closed" % gap, hem(gap, 100.0, 1400), "two faces of one body")

warns("bent half of the way", run(STRIP.format(speed=100, steps=400)))

# a block pressed to half its height and one sheared: its faces become shorter and fold nothing
PRESSED = lattice_block("0 12e-3 0 12e-3", "-0.05 0.06 -0.03 0.04") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      * * """ + STEEL + """
region          low block INF INF INF 1.6e-3 INF INF units box
region          top block INF INF 10.4e-3 INF INF INF units box
group           low region low
group           top region top
fix             body all sph/tm
fix             low low sph/tm/drive 0 0 0
fix             top top sph/tm/drive {x} {y} 0
thermo          1000
run             {steps}
"""
warns("a block pressed to half", run(PRESSED.format(x=0, y=-100, steps=1000)))
# its top becomes shorter by as much as that, and roughens, but stays one face
SHORTER = lattice_block("0 24e-3 0 9e-3", "-0.02 0.05 -0.02 0.05") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      * * density 7850 elastic 210e9 0.3 strength plastic 350e6 2000e6
region          left block INF 2e-3 INF INF INF INF units box
region          right block 22e-3 INF INF INF INF INF units box
group           left region left
group           right region right
fix             body all sph/tm
fix             left left sph/tm/drive 100 NULL 0
fix             right right sph/tm/drive -100 NULL 0
thermo          1000
run             2400
"""
r = run(SHORTER)
said = [w for w in r.warnings() if "two faces" in w]
checks.true("a face that becomes shorter by more than half does not meet itself", r.status == 0 and not said, "%s" % said)
warns("a block sheared by its height", run(PRESSED.format(x=100, y=0, steps=1800)))

# --- bodies that begin inside of each other, or with another spacing
TWO = """
units           si
dimension       2
boundary        f f p
atom_style      atomic
newton          off
region          box block -0.02 0.06 -0.02 0.03 -1e-3 1e-3 units box
create_box      2 box
lattice         sq 1e-3 origin 0.5 0.5 0
region          a block 0 10e-3 0 10e-3 INF INF units box
create_atoms    1 region a
lattice         sq $(1e-3/{ratio}) origin 0.5 0.5 0
region          b block 10e-3 20e-3 0 10e-3 INF INF units box
create_atoms    2 region b
group           b type 2
displace_atoms  b move {gap} 0 0 units box
{masses}
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      * * """ + STEEL + """
pair_coeff      1 2 contact
fix             body all sph/tm energy yes {fix}
velocity        b set {speed} 0 0 units box
variable        v equal vcm(b,x)
thermo          1
thermo_style    custom step time v_v f_body[1] f_body[5]
run             {steps}
"""


def touching(gap=0.0, speed=0.0, ratio=1, steps=400):
    sizes = ratio != 1
    return run(TWO.format(gap=gap, speed=speed, ratio=ratio, steps=steps, fix="effects smoothing on" if sizes else "",
                          masses="" if not sizes else
                          "fix m all property/atom rmass ghost yes\nset type 1 mass 7.8e-3\nset type 2 mass $(7.8e-3/%d)" % ratio ** 2))


r = touching()
warns("bodies that touch", r)
checks.near("stay", abs(r.thermo[-1]["v_v"]).max(), 0.0, absolute=1e-9)
for overlap in 0.02e-3, 0.05e-3, 0.09e-3:
    r = touching(-overlap)
    warns("bodies %g mm inside of each other" % (1e3 * overlap), r, "inside of each other", "throw them apart", "%.2g" % (1e3 * overlap))
    checks.above("fly apart", r.thermo[-1]["v_v"].max(), 2.0)
warns("which hit with 1000 m/s", touching(-0.05e-3, speed=-1000.0, steps=5))
# particles find the lattice of a body three times as coarse uneven: 10, 14 m/s and 550, 1300 J where it is not allowed for
for ratio, most, energy in (2, 0.1, 0.1), (3, 5.0, 25.0), (4, 5.0, 40.0):
    r = touching(ratio=ratio)
    checks.below("spacing %d times as small on one side, at touch: speed (m/s)" % ratio, abs(r.thermo[-1]["v_v"]).max(), most)
    checks.below("energy of its springs (J)", r.thermo[-1]["f_body[5]"].max(), energy)

# --- metal with a velocity outside of the group
OUTSIDE = lattice_block("0 10e-3 0 6e-3", "-0.02 0.04 -0.02 0.03") + """
region          left block INF 3e-3 INF INF INF INF units box
group           left region left
group           right subtract all left
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      * * """ + STEEL + """
fix             body right sph/tm dt 1e-8
{more}
velocity        all set {v} 0 0 units box
thermo          1
run             3
"""
for ranks in 1, 2:
    warns("a clamp that has a velocity and does not move, %d ranks" % ranks, run(OUTSIDE.format(v=-20, more=""), ranks=ranks),
          "18 particles outside of its group", "up to 20", "drive")
warns("one at rest", run(OUTSIDE.format(v=0, more="")))
warns("one that fix move moves", run(OUTSIDE.format(v=-20, more="fix m left move linear -20 0 0 units box")))

# --- fixes made for atoms
BLOCK = lattice_block("0 6e-3 0 6e-3", "-0.02 0.04 -0.02 0.03") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      * * """ + STEEL + """
fix             body all sph/tm
{more}
run             3
"""
for fix in "langevin 300 300 1e-6 4711", "temp/berendsen 300 300 1e-6", "temp/rescale 1 300 300 1 1":
    warns("fix " + fix, run(BLOCK.format(more="velocity all create 1e20 4711\nfix t all " + fix)), "takes the velocities", "relax")
r = run(BLOCK.replace("f f p", "p p p").format(more="fix t all press/berendsen iso 1e5 1e5 1e-6"), expect_error=True)
checks.true("fix press/berendsen is refused", r.status != 0 and "press/berendsen does not work" in r.errors(), r.errors()[:200])

warns("lists that come too late", run(BLOCK.format(more="velocity all set 500 0 0 units box\nneigh_modify every 1000 delay 0 check no").replace("run             3", "run 500")),
      "renewed too late", "check yes")
warns("lists that are made often enough", run(BLOCK.format(more="velocity all set 500 0 0 units box\nneigh_modify every 5 delay 0 check no").replace("run             3", "run 500")))
r = run(OUTSIDE.format(v=0, more=""))
checks.true("how many particles move", "fix body moves 42 of 60 particles of metal" in r.output)
r = run(BLOCK.format(more="compute p all sph/tm/atom triaxiality pressure vonmises stress/xx stress/yy stress/zz\n"
                          "velocity all ramp vx -5 5 x 0 6e-3 units box\ndump d all custom 3 out.dump id c_p[*]\ndump_modify d sort id format float %.17g"))
frames = r.dump("out.dump")
start, end = frames[0], frames[-1]
mean = (end["c_p[4]"] + end["c_p[5]"] + end["c_p[6]"]) / 3.0
checks.true("no triaxiality without stress", np.all(start["c_p[1]"] == 0.0))
checks.near("triaxiality of stress", abs(end["c_p[1]"] * end["c_p[3]"] - mean).max() / abs(mean).max(), 0.0, absolute=1e-9)
checks.above("which is that of tension", end["c_p[1]"].mean(), 0.3)

# --- solids that pass through each other
for law, words in ("none", "types 1 and 2 pass through each other"), ("heat", "types 1 and 2 pass through each other"), ("contact", ""):
    r = run(TWO.format(gap=1e-3, speed=0, ratio=1, steps=1, fix="", masses="").replace("1 2 contact", "1 2 " + law))
    checks.true("solids with %s" % law, r.status == 0 and ("pass through" in r.output) == bool(words) and words in r.output)

# --- wide kernels: waves are as short as with narrow ones, and so is the step
WAVE = lattice_block("0 20e-3 0 10e-3", "-0.02 0.04 -0.02 0.03") + """
pair_style      sph/tm {kernel} spacing 1e-3
pair_coeff      * * """ + STEEL + """
region          left block INF 3e-3 INF INF INF INF units box
region          right block 17e-3 INF INF INF INF INF units box
group           left region left
group           right region right
fix             body all sph/tm energy yes
fix_modify      body energy/drift none
velocity        right set 20 0 0 units box
velocity        left set -20 0 0 units box
variable        left equal 11e-6-time
fix             stop all halt 1 v_left < 0 error continue message no
thermo          50
thermo_style    custom step time f_body[9]
run             3000
"""
for kernel in "hyperbolic 1.2", "hyperbolic 1.7", "cubic 3", "cubic 4":
    t = run(WAVE.format(kernel=kernel)).thermo[-1]["f_body[9]"]
    checks.below("drift of the sum of energies in 11 us, " + kernel, abs(t[-1] / t[0] - 1.0), 0.02)
assert np.isfinite(t).all()
checks.end()
