"""The table at the end of a run: what each effect costs, no line for an effect that is off, parts that sum to the
whole."""
import re

from sphtm_scene import Checks, lattice_block, run

SCENE = lattice_block("0 0.05 0 0.05", "-0.02 0.07 -0.02 0.07") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 {options}
pair_coeff      1 1 density 7830 elastic 200e9 0.29 {material}
fix             body all sph/tm temperature 300 {fix}
{more}
velocity        all ramp vx 0 100 x 0 0.05 units box
thermo          {steps}
thermo_style    custom step time {output}
run             {steps}
"""
JC = "strength johnson/cook 792e6 510e6 0.26 0.014 1.03 298 1793 1 heat 38 477 0.9"
BARE = "viscosity 0 0 hourglass 0 correction no"
checks = Checks()


def scene(material="strength elastic", options="", fix="", more="", steps=200, output="dt", **arguments):
    return run(SCENE.format(material=material, options=options, fix=fix, more=more, steps=steps, output=output),
               **arguments)


def table(result):
    """Line -> seconds, percent, ns per particle and step, bytes per particle (None: not said); of the last table."""
    parts = result.output.split("effect or part")
    if len(parts) < 2:
        return {}
    lines = re.findall(r"^  (\S.{25}) +(-?[\d.e+-]+) +(-?[\d.]+) +(-?[\d.]+) +(-|\d+)(?:  |$)", parts[-1], re.M)
    return {name.strip(): tuple(None if v == "-" else float(v) for v in values) for name, *values in lines}


full = scene(JC, fix="energy yes", more="fix warm all sph/tm/heat convection 100 300")
lines = table(full)
on = {"viscosity", "correction", "hourglass", "fracture", "heat", "conduction", "plasticity", "surface", "energy"}
ALL = ("viscosity artstress heat conduction plasticity damage correction balsara xsph surface internal-energy bodies "
       "energy hourglass fracture").split()
checks.true("a line for every effect that is on, none for others", {e for e in lines if e in ALL} == on,
            " ".join(lines))
checks.true("a line for the other fix", "fix warm sph/tm/heat" in lines)
parts = [v for name, v in lines.items() if name != "all"]
checks.near("the seconds sum to the whole", sum(p[0] for p in parts), lines["all"][0], relative=2e-3)
checks.near("so do the percents", sum(p[1] for p in parts), 100.0, absolute=1.0)
checks.near("ns per particle and step", lines["all"][2], lines["all"][0] * 1e9 / 2500 / 200, relative=2e-3)
loop = float(re.search(r"Loop time of (\S+)", full.output)[1])
checks.near("the whole is LAMMPS's loop time", lines["all"][0], loop, relative=0.1, absolute=0.05)
# columns of tm_fields.h, records and rates: 8 bytes each; a record array may be an eighth larger, and holds ghosts
old = table(scene(JC, options="stabilize artstress"))
for label, rows, columns in (
        ("", lines, dict(viscosity=0, correction=16 + 16 + 6 + 6, hourglass=6 + 3, fracture=7, heat=3 + 2 + 1, conduction=1,
                         plasticity=3, surface=3, energy=3 + 1, mechanics=1 + 6 + 20 + 16 + 9)),
        (", stabilize artstress", old, dict(artstress=6, mechanics=1 + 6 + 20 + 16 + 9))):
    for effect, n in columns.items():
        checks.true("bytes of " + effect + label, 8 * n <= rows[effect][3] <= 9.5 * n, "%g" % rows[effect][3])
checks.true("stabilize artstress: no line of the other", not {"correction", "hourglass"} & set(old), " ".join(old))

bare = table(scene(options=BARE, fix="effects fracture off"))
checks.true("all effects off: no line of an effect", bare and not set(ALL) & set(bare), " ".join(bare))
checks.true("table no: none", not table(scene(fix="table no")))
checks.true("a run of 5 steps: none", not table(scene(steps=5)))
waits = table(scene(JC, fix="table wait"))
checks.true("table wait: the same lines, but for energy and surface", set(waits) == set(lines) -
            {"energy", "surface", "fix warm sph/tm/heat"}, " ".join(waits))
refused = scene(fix="table maybe", expect_error=True)
checks.true("table maybe: refused", refused.status != 0 and "table" in refused.errors() and "maybe" in refused.errors(),
            refused.errors())

two = scene(JC, fix="energy yes", more="fix warm all sph/tm/heat convection 100 300", ranks=2)
checks.true("two ranks: the same lines", set(table(two)) == set(lines), " ".join(table(two)))
again = "run 100\nwrite_dump all custom end.dump id x y vx vy modify sort id format float %.17g"
r = run(SCENE.format(material=JC, options="", fix="table yes", more="", steps=200, output="dt ke") + again)
s = run(SCENE.format(material=JC, options="", fix="table no", more="", steps=200, output="dt ke") + again)
with open(r.path("end.dump")) as a, open(s.path("end.dump")) as b:
    checks.true("a run after the probe goes on with the same bits", a.read() == b.read())

times = scene(JC, output="f_body[1][2] f_body[2][2] f_body[3][2] f_body[4][2]").thermo[-1]
now = [times["f_body[%d][2]" % k][-1] for k in (1, 2, 3, 4)]
checks.true("times as output of the fix", min(now) > 0 and now[0] > sum(now[1:]), str(now))
checks.end()
