"""Prescribed velocity of a group, its force and work; restart and ranks, together with a heat fix."""
import numpy as np

from sphtm_scene import Checks, run

# a bar: its left end is held, its right end accelerates to speed and goes on, free across
BAR = """
units {units}
dimension {dim}
boundary f f {bz}
atom_style atomic
newton off
atom_modify map array
variable dx equal {dx!r}
lattice {lattice} ${{dx}} origin 0.5 0.5 {origin}
region box block $(-8*v_dx) $(32*v_dx) $(-8*v_dx) $(16*v_dx) {z} units box
create_box 1 box
region work block 0 $(24*v_dx) 0 $(8*v_dx) {flat} units box
create_atoms 1 region work
region left block INF $(4*v_dx) INF INF INF INF units box
region right block $(20*v_dx) INF INF INF INF INF units box
group left region left
group right region right
group ends union left right
group rest subtract all ends
pair_style sph/tm hyperbolic 1.2 spacing ${{dx}}
pair_coeff 1 1 density {density} elastic {E} 0.3 heat {k} {cp} 0.9
{more}
"""
PULL = """
fix body all sph/tm energy yes temperature 300
variable v equal "{v}*((time<{ramp})*time/{ramp}+(time>={ramp}))"
fix hold left sph/tm/drive 0 0 0
fix pull right sph/tm/drive v_v NULL NULL
compute c right reduce ave vx x
variable p equal mass(rest)*vcm(rest,x)
thermo_style custom step time dt c_c[1] v_v c_c[2] f_hold[1] f_hold[2] f_hold[4] &
  f_pull[1] f_pull[2] f_pull[4] f_body[8] f_body[9] f_body[13] v_p
thermo_modify format float %.16g
thermo 1
run 300
"""
SI = dict(units="si", dx=1e-3, density=2700, E="70e9", k=200, cp=900)
checks = Checks()


def bar(more, dim=2, **units):
    flat = dim == 2
    return BAR.format(dim=dim, lattice="sq" if flat else "sc", origin=0 if flat else 0.5, bz="p" if flat else "f",
                      z="$(-v_dx) ${dx}" if flat else "$(-4*v_dx) $(10*v_dx)",
                      flat="INF INF" if flat else "0 $(6*v_dx)", more=more, **dict(SI, **units))


for dim in (2, 3):
    result = run(bar(PULL.format(v=20.0, ramp=6e-6), dim))
    log, name = result.thermo[0], "%dD: " % dim
    t, v, x, dt = log["Time"], log["c_c[1]"], log["c_c[2]"], log["Dt"]
    checks.below(name + "velocity less what is prescribed", abs(v - log["v_v"]).max() / 20, 1e-13)
    checks.below(name + "position less the integral of the velocity",
                 abs(np.diff(x) - 0.5 * dt[1:] * (v[1:] + v[:-1])).max() / 1e-3, 1e-12)
    # what the ends feel, the rest of the body feels the other way round
    momentum, force = np.diff(log["v_p"]), -(log["f_hold[1]"] + log["f_pull[1]"])[1:] * dt[1:]
    checks.below(name + "momentum of the rest", abs(momentum - force).max() / abs(force).max(), 1e-10)
    checks.true(name + "the body pulls the drive back", log["f_pull[1]"][20:].max() < 0)
    checks.below(name + "force across is free", abs(log["f_pull[2]"]).max(), 0)
    work = log["f_hold[4]"] + log["f_pull[4]"]
    checks.below(name + "work less the book's", abs(work + log["f_body[8]"]).max() / work[-1], 1e-10)
    checks.below(name + "drift of the energy sum but for the stress, over the work",
                 abs(log["f_body[9]"] + log["f_body[13]"]).max() / work[-1], 1e-4)
    checks.below(name + "work of the stress that is not stored, over the work", abs(log["f_body[13]"]).max() / work[-1], 2e-3)
    if dim == 2:
        si = log

# the same bar in micrometres, picograms and microseconds
micro = run(bar(PULL.format(v=20.0, ramp=6.0), units="micro", dx=1e3, density=2.7, E="70e6", k=2e8 * 1e3,
                cp=9e2 * 1e3)).thermo[0]
last = -1
checks.near("units micro: time", micro["Time"][last] * 1e-6, si["Time"][last], relative=1e-9)
# per unit thickness: forces are pg um/us^2 = 1e-9 N per um, 1e-3 N per m; work is 1e-15 J per um
checks.near("units micro: force", micro["f_pull[1]"][last] * 1e-9 / 1e-6, si["f_pull[1]"][last], relative=1e-6)
checks.near("units micro: work", micro["f_pull[4]"][last] * 1e-15 / 1e-6, si["f_pull[4]"][last], relative=1e-6)

# --- restart and ranks: a plastic bar with heat from outside
FIXES = """
variable T equal 400+time*1e7
fix body all sph/tm energy yes
fix cool rest sph/tm/heat convection 1e7 250
fix warm left sph/tm/heat temperature v_T
variable v equal "20*((time<6e-6)*time/6e-6+(time>=6e-6))"
fix hold left sph/tm/drive 0 0 NULL
fix pull right sph/tm/drive v_v NULL NULL
compute p all sph/tm/atom temperature pstrain density vonmises
thermo_style custom step time dt f_pull[1] f_pull[4] f_hold[4] f_cool f_cool[2] f_warm f_warm[2] f_body[4] f_body[9]
thermo_modify format float %.17g
thermo 40
"""
WRITE = "write_dump all custom {} id x y vx vy c_p[1] c_p[2] c_p[3] c_p[4] modify format float %.17g\n"
whole = bar(FIXES + "run 80\nwrite_restart half\nrun 80\n" + WRITE.format("whole.dump"))
whole = whole.replace("heat 200 900 0.9", "strength plastic 200e6 1e9 heat 200 900 0.9")
first = run(whole)
AGAIN = "\nread_restart half\n" + FIXES + "run 80\n" + WRITE.format("again.dump")
second = run(AGAIN, folder=first.folder)
a, b = first.dump("whole.dump")[-1], second.dump("again.dump")[-1]
checks.true("restart: the bar yields", a["c_p[2]"].max() > 1e-3, "%g" % a["c_p[2]"].max())
for name in ("x", "y", "vx", "vy", "c_p[1]", "c_p[2]", "c_p[3]", "c_p[4]"):
    checks.true("restart bit for bit: " + name, np.array_equal(a[name], b[name]), "%g" % abs(a[name] - b[name]).max())
for name in first.thermo[1]:
    one, two = first.thermo[1][name][-1], second.thermo[-1][name][-1]
    checks.near("restart: " + name, two, one, relative=0 if name != "f_body[9]" else 1e-9)
checks.below("heat: drift of the energy sum over the heat", abs(first.thermo[1]["f_body[9]"]).max() /
             abs(first.thermo[1]["f_warm[2]"][-1]), 1e-4)
two = run(AGAIN, ranks=2, folder=first.folder)    # the same tags
c = two.dump("again.dump")[-1]
for name in ("x", "vx", "c_p[1]", "c_p[2]", "c_p[4]"):
    checks.below("two ranks: " + name, abs(a[name] - c[name]).max() / abs(a[name]).max(), 1e-10)
for name in ("f_pull[1]", "f_pull[4]", "f_cool", "f_cool[2]", "f_warm[2]"):
    checks.near("two ranks: " + name, two.thermo[-1][name][-1], first.thermo[-1][name][-1], relative=1e-9)

# --- messages
for words, expected in (
        ("fix d right sph/tm/drive 0 0 0\nfix body all sph/tm", ""),
        ("fix body all sph/tm\nfix d right sph/tm/drive 0 0", "needs three velocities"),
        ("fix body all sph/tm\nfix d right sph/tm/drive NULL NULL 0", "all are NULL"),
        ("fix body all sph/tm\nfix d right sph/tm/drive fast 0 0", "must be a number or v_name, got fast"),
        ("fix body all sph/tm\nvariable a atom x\nfix d right sph/tm/drive v_a 0 0", "not of equal style"),
        ("fix body rest sph/tm\nfix d right sph/tm/drive 0 0 0", "are not in the group of fix sph/tm"),
        ("group none empty\nfix body all sph/tm\nfix d none sph/tm/drive 5 0 0", ""),
        ("pair_style zero 1.0\npair_coeff * *\nmass * 1\nfix d right sph/tm/drive 0 0 0", "needs a fix sph/tm")):
    result = run(bar(words + "\nrun 0\n"), expect_error=True)
    checks.true("message for '%s'" % words.splitlines()[-1],
                expected in result.errors() and bool(result.status) == bool(expected), result.errors()[:120])
late = run(bar("fix body all sph/tm\nfix d right sph/tm/drive 0 0 0\nfix g all addforce 1 0 0\n"
               "fix l left setforce 0 0 0\nrun 0\n"))
said = [w for w in late.warnings() if "after fix sph/tm/drive" in w]
nothing = run(bar("group none empty\nfix body all sph/tm\nfix d none sph/tm/drive 5 0 0\nrun 0\n"))
checks.true("warning of a group without particles", any("no particles in group none" in w for w in nothing.warnings()), str(nothing.warnings())[:140])
checks.true("warning of later forces", len(said) == 1 and "Fix g" in said[0], str(said)[:140])
checks.end()
