"""fix sph/tm audit: the difference of the rates in use to those of a fresh search in double with every effect on.

zero     every effect on, rows searched in every step, smoothing lengths that follow the density in every step: 0
rows     two bars meet and yield: the stale rows' share grows with the threshold of fix adapt/neigh
causes   each effect that is off, single precision, and lengths that lag are seen, by themselves, and nothing else
faces    second order at free faces adds the same that it lacks where it is off, and nothing without faces
ranks    the same numbers on 1, 2 and 4 ranks, across a periodic boundary, with another skin; the same run without
"""
import numpy as np
from contact_scene import block, particles
from sphtm_scene import Checks, run

# those that are off, then what those that are on add
OFF = "viscosity artstress correction faces xsph conduction".split()
ON = ["on " + name for name in "viscosity artstress hourglass xsph faces".split()]
NAMES = "all rows precision smoothing".split() + OFF + ON
SCENE = """
units           si
dimension       {dim}
boundary        {boundary}
atom_style      atomic
newton          off
{processors}
read_data       data.in
variable        part atom x<0.009
group           part variable part
{skin}
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 {options}
pair_coeff      1 1 density 2700 elastic 70e9 0.33 {strength} heat 200 900 0.9
fix             body all sph/tm temperature 300 {fix}
{lists}
fix_modify      body temperature part 400
thermo          {every}
thermo_style    custom step time {outputs}
thermo_modify   format float %.15g
run             {steps}
dump            d all custom 1 out.dump id x y z vx vy vz fx fy fz
dump_modify     d sort id format float %.17g
run             0 post no
"""
OUT = " ".join("f_body[%d]" % k for k in range(16, 17 + len(NAMES)))
ALL_ON = "artstress 0.3 4 hourglass auto correction yes xsph 0.5"
NONE = "viscosity 0 0 hourglass 0 correction no"    # no artificial term
DX = 1e-3
checks = Checks()


def scene(dim=2, options="", fix="", audit="audit 20 40", lists="", steps=100, every=20, periodic=False, processors="",
          skin="", strength="strength plastic 100e6 1e9", endless=False, **arguments):
    x = block((18, 12, 6 if dim == 3 else 1), DX, (0, 0, 0 if dim == 3 else -0.5 * DX))
    v = np.where(x[:, :1] < 9 * DX, [60.0, 8, 0], [0.0, 0, 0])
    lo, hi = x.min(0) - 8 * DX, x.max(0) + 8 * DX
    if periodic:
        lo[1], hi[1] = 0, 12 * DX
    if endless:
        lo[0], hi[0] = 0, 18 * DX
    if dim == 2:
        lo[2], hi[2] = -0.5 * DX, 0.5 * DX
    text = SCENE.format(
        dim=dim, options=options, strength=strength, fix=fix + " " + audit, lists="fix lists all adapt/neigh " + lists if lists else "",
        steps=steps, every=every, boundary="p p p" if endless else "f p p" if periodic else "f f " + ("f" if dim == 3 else "p"),
        processors=processors, skin=skin, outputs=OUT if audit else "dt")
    return run(text, files={"data.in": particles(x, list(zip(lo, hi)), v)}, **arguments)


def meter(result):
    """Cause -> its values at the audits; 'time': their share of the run."""
    t = result.thermo[0]
    return {name: t["f_body[%d]" % (16 + k)][1:] for k, name in enumerate(NAMES + ["time"])}


# nothing differs where everything is in use
for name, arguments in (("2D", {}), ("3D", dict(dim=3, steps=40)),
                        ("2D, periodic, 2 ranks", dict(periodic=True, ranks=2))):
    m = meter(scene(options=ALL_ON, lists="threshold 0 asph density every 1", **arguments))
    worst = [np.abs(m[cause]).max() for cause in NAMES if cause not in ON]
    checks.below("zero, " + name, max(worst), 1e-15)    # sizes in records are made with other vector instructions
    checks.true("exactly zero but for sizes, " + name,
                not any(worst[k] for k in range(1, len(worst)) if NAMES[k] != "smoothing"))
    checks.above("audits take time, " + name, m["time"].min(), 1e-6)
m = meter(scene())
checks.true("lists of LAMMPS are not stale", not m["rows"].any(), str(m["rows"]))

# the share of rows that are kept
share = []
# up to 1e-4 all that yields is searched in each of these steps
for threshold in ("0", "1e-4", "3e-4", "1e-3", "1e-2"):
    m = meter(scene(lists="threshold " + threshold, steps=200, fix="dt 4e-8"))
    share.append(np.sqrt(np.mean(m["rows"][5:]**2)))
    checks.note("stale rows, threshold " + threshold, "%.3e" % share[-1])
checks.true("exactly 0 with threshold 0", share[0] == 0.0)
checks.true("grows with the threshold", all(np.diff(share) >= 0) and 0 < share[2] < share[3] < share[4], str(share))

# each cause
m = meter(scene(options=NONE, fix="effects conduction off"))
for name in "viscosity artstress correction xsph conduction smoothing".split():
    checks.above("seen where it is off: " + name, m[name].max(), 1e-4)
for name in "rows", "precision":
    checks.true("not there: " + name, not m[name].any())
full = scene(options=ALL_ON)
m = meter(full)
checks.above("lengths that do not follow the density", m["smoothing"].max(), 1e-5)
for name in "rows precision viscosity artstress correction xsph conduction".split():
    checks.true("in use, no difference: " + name, not m[name].any(), str(m[name].max()))
for name, options in (("viscosity", "viscosity 0 0"), ("artstress", "hourglass 0"), ("xsph", ""), ("correction", "correction no")):
    m = meter(scene(options=options))
    checks.above("off alone: " + name, m[name].max(), 1e-4)
m = meter(scene(options="precision mixed"))
checks.true("single precision", 1e-9 < m["precision"].max() < 1e-5, "%g" % m["precision"].max())
checks.true("single precision: rows are not stale", not m["rows"].any(), str(m["rows"]))
lag = [meter(scene(lists="asph psi every %d" % n))["smoothing"].max() for n in (1, 20)]
checks.true("lengths that follow the neighborhood late", 0 < lag[0] < lag[1], "%g %g" % tuple(lag))
form = meter(scene(options="form f14"))
checks.true("form f14 has no correction", not form["correction"].any())

# artificial terms that are on: what they add, each alone; those that are off have no such number
on = meter(scene(options="viscosity 0.7 0.7 artstress 0.3 4 hourglass 0.02 xsph 0.5"))
for name in ON[:-1]:
    checks.above("added, " + name, on[name].max(), 1e-4)
checks.true("rows are not stale with hourglass control", not on["rows"].any(), str(on["rows"]))
m = meter(scene(options=NONE))
for name in ON:
    checks.true("nothing is added: " + name, not m[name].any(), str(m[name]))
# the same difference, seen from the run without: what it would add. At the first audit both runs are at the same place,
# so it is the run of one step
one = dict(steps=1, audit="audit 1 1000")
with_it, without = (meter(scene(options=NONE + " artstress %g 4" % eps, **one)) for eps in (0.3, 0))
checks.note("artificial stress that is on, that is off", "%.4g %.4g" % (with_it["on artstress"][-1], without["artstress"][-1]))
twice = [meter(scene(options="viscosity %g %g" % (a, a), **one))["on viscosity"][-1] for a in (1e-3, 2e-3)]
checks.near("viscosity: twice the coefficient adds twice as much", twice[1] / twice[0], 2, relative=0.02)
balanced = scene(options="viscosity 0 0 artstress 0.3 4 balanced")
checks.above("balanced artificial stress adds too", meter(balanced)["on artstress"].max(), 1e-5)
checks.true("the table has a line for what is on", "artificial: artstress" in balanced.output and
            "artificial: viscosity" not in balanced.output)

# second order at faces: on in elastic scenes
elastic = dict(strength="", **one)
for name, more in (("2D", {}), ("3D", dict(dim=3))):
    with_it, without = (meter(scene(options=options, **elastic, **more)) for options in ("", "correction linear"))
    on, off = with_it["on faces"][-1], without["faces"][-1]
    checks.above("second order at faces, " + name, on, 1e-3)
    checks.near("what it adds, on and off, " + name, off / on, 1, relative=0.05)
    checks.true("each where it is, " + name, not with_it["faces"].any() and not without["on faces"].any())
m = meter(scene(periodic=True, endless=True, strength="", audit="audit 1 1000", steps=20, every=5))
checks.below("nothing is added where there are no faces", m["on faces"].max(), 1e-3)
checks.above("but the rates are there", m["on viscosity"].max(), 1e-3)
text = scene(strength="").output.split("audits: ")[-1]
checks.true("the table has a line for it", "second order at faces" in text and "no faces" not in text, text)

# the table at the end
text = full.output.split("audits: ")[-1]
checks.true("the table names what differs", "smoothing length" in text and "no viscosity" not in text, text)
text = scene(options=NONE, lists="threshold 1e-3").output.split("audits: ")[-1]
for line in ("stale rows", "no viscosity", "no artstress", "no correction", "no xsph", "all of them"):
    checks.true("a line for: " + line, line in text)

# ranks, skin; the run itself stays what it is
for name, arguments in (("2D", {}), ("3D", dict(dim=3, steps=40)), ("periodic", dict(periodic=True)),
                        ("kept rows", dict(lists="threshold 1e-3")), ("default", dict(options=""))):
    arguments = dict({"options": NONE}, **arguments)
    one = meter(scene(**arguments))
    several = [("2 ranks", dict(ranks=2)), ("another skin", dict(skin="neighbor 8e-4 bin"))]
    if name == "2D":
        several.append(("4 ranks", dict(ranks=4, processors="processors 2 2 1")))
    for what, change in several:
        m = meter(scene(**dict(arguments, **change)))
        worst = max(np.abs(m[k] - one[k]).max() for k in NAMES)
        checks.below("%s, %s: largest difference" % (name, what), worst, 1e-9)


def last(r):
    with open(r.path("out.dump")) as f:
        return f.read().split("ITEM: ATOMS", 1)[1]


for name, arguments in (("", {}), (", kept rows", dict(lists="threshold 1e-3")),
                        (", energy book", dict(fix="energy yes"))):
    a, b = (scene(audit=audit, **arguments) for audit in ("audit 7 30", ""))
    checks.true("audits leave the bits of the run" + name, last(a) == last(b))
default = scene(audit="audit yes", steps=20)
checks.true("audit yes", "f_body" in " ".join(default.thermo[0]))
small = meter(scene(audit="audit 20 100000"))
checks.true("more than there are: all", small["smoothing"].max() > 0)
checks.end()
