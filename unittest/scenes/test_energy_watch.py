"""The sum of the energies speaks up: what went in, how far it drifted, what artificial terms took; warnings once, a stop,
and the line of the closing table. Melting and welded types are said once."""
import re

from sphtm_scene import Checks, lattice_block, run

SCENE = lattice_block("0 12e-3 0 12e-3", "-0.1 0.1 -0.1 0.1", types=2, more="atom_modify     map array\n") + """
region          right block 6e-3 INF INF INF INF INF units box
set             region right type 2
pair_style      sph/tm hyperbolic 1.2 spacing lattice {style}
pair_coeff      1 1 density 2700 elastic 70e9 0.33 {strength}
pair_coeff      2 2 density 2700 elastic 70e9 0.33 {strength}
fix             body all sph/tm {fix}
variable        vx atom 20*sin(200*x)
velocity        all set v_vx 0 0 units box
thermo          100
thermo_style    custom step ke f_body[1]
"""
# steps, steps from one push to the next, factor on the velocities
PUSH = ('variable ux atom {2}*vx\nvariable uy atom {2}*vy\n'
        'run {0} pre no every {1} "velocity all set v_ux v_uy NULL sum no units box"\n')
BARE = "hourglass 0 viscosity "    # no artificial term but the viscosity
LITTLE, SHORT = PUSH.format(2010, 30, 1.02), PUSH.format(200, 100, 1.2)
checks = Checks()


def scene(lines, style=BARE + "0 0", strength="", fix="energy yes", **more):
    return run(SCENE.format(style=style, strength=strength, fix=fix) + lines, expect_error=True, **more)


def energy_line(r):
    return (re.findall(r"^  energy: (.*)", r.output, re.M) or [""])[-1]


for ranks in 1, 2:
    r = scene("run 1000\n", ranks=ranks, fix="energy yes courant 0.2")    # waves decay by (omega dt)^4/8 a step
    took = re.match(r"(\S+) went in; the sum drifted by (\S+) % of it, artificial terms took (\S+) %", energy_line(r))
    checks.true("quiet, %d ranks: no warning, one line" % ranks, r.status == 0 and not r.warnings() and took,
                "%s %s" % (r.warnings(), energy_line(r)))
    checks.near("quiet: what went in is the kinetic energy of the start", float(took.group(1)), r.thermo[0]["f_body[1]"][0],
                relative=1e-5)
    checks.below("quiet: drift, %", abs(float(took.group(2))), 0.5)
checks.true("energy no: the table says that nothing was summed", "not summed up" in energy_line(scene("run 100\n", fix="")))
checks.true("nothing moves", energy_line(scene("velocity all set 0 0 0\nrun 100\n")) == "no work went in")

r = scene("run 1500\nrun 1500\n", style=BARE + "1 1")
said = [w for w in r.warnings() if "artificial terms" in w]
checks.true("viscosity: warns once, in all runs", r.status == 0 and len(said) == 1 and "have taken" in said[0], "%s" % r.warnings())

# a shove at the start, whose energy is a hundredth of what comes later: what was said then is said anew at the end
r = scene("velocity all scale 1\nrun 1200\nvelocity all set v_vx10 0 0 units box\nrun 1200\n".replace("velocity all scale 1\n", "variable vx10 atom 200*sin(200*x)\n"),
          style=BARE + "1 1")
said = [w for w in r.warnings() if "artificial terms" in w]
checks.true("viscosity: warns again at the end of a run with ten times the energy", r.status == 0 and len(said) == 2, "%s" % r.warnings())

r = scene(LITTLE)
checks.true("energy from nowhere stops the run", r.status == 1 and "stops at step 300" in r.errors() and
            all(w in r.errors() for w in ("the sum of the energies has drifted by +", "energy/drift", "not to be trusted")),
            r.errors())
r = scene(LITTLE, fix="energy yes energy/drift none")
said = [w for w in r.warnings() if "has drifted" in w]
checks.true("energy/drift none: warns once", r.status == 0 and len(said) == 1, "%d %s" % (r.status, r.warnings()))
r = scene(LITTLE, fix="energy yes energy/drift 0.5")
checks.true("energy/drift 0.5: later", r.status == 1 and "stops at step 600" in r.errors(), r.errors())
r = scene("thermo_modify lost ignore\n" + LITTLE, fix="energy yes lost ignore")
checks.true("lost ignore: the same while nothing is lost", r.status == 1 and "stops at step 300" in r.errors(), r.errors())
r = scene("thermo_modify lost ignore\nset atom 1 x 0.09999\nset atom 1 vx 60\n" + LITTLE + "write_restart lost.restart\n", fix="energy yes lost ignore")
checks.true("and once a particle has left", r.status == 1 and "has drifted by +" in r.errors(), "%d %s" % (r.status, r.errors()))
# a part that flies out of the box, deformed, takes its energies along; the rest goes on
OUT = ("region out block 9e-3 INF INF INF INF INF units box\ngroup out region out\ndisplace_atoms out move 86.5e-3 0 0 units box\n"
       "velocity out set 900 0 0 sum yes units box\nthermo_modify lost ignore\n")
for ranks in 1, 2:
    r = scene(OUT + "run 150\nwrite_restart lost.restart\nrun 350\n", fix="energy yes lost ignore courant 0.1", ranks=ranks)
    took = re.match(r"(\S+) went in, (\S+) % left with particles; the sum drifted by (\S+) %", energy_line(r))
    checks.true("particles leave, %d ranks: the run goes on" % ranks, r.status == 0 and took, "%s %s" % (r.errors(), energy_line(r)))
    checks.above("and take most of the energy, %", float(took.group(2)), 60)
    checks.below("and the sum stays, %", abs(float(took.group(3))), 0.02)
    checks.below("so does [13]", abs(float(re.search(r"; (\S+) % is work", energy_line(r)).group(1))), 0.02)
again = run("read_restart lost.restart\nfix body all sph/tm energy yes lost ignore courant 0.1\nthermo 100\nthermo_modify lost ignore\nrun 350\n", folder=r.folder, ranks=2)
checks.true("also in a run that goes on from a file", energy_line(again) == energy_line(r), "%s | %s" % (energy_line(again), energy_line(r)))
r = scene(SHORT)
checks.true("a short run ends with the error", r.status == 1 and "stops at step 200" in r.errors(), r.errors())
r = scene("run 200\nvelocity all set 40 0 0 units box\nrun 200\nvelocity all set 0 0 0\nrun 200\n")
checks.true("velocities between runs are no drift", r.status == 0 and not r.warnings(), "%s %s" % (r.errors(), r.warnings()))

# waves of four spacings decay with the time step: work of the stress that is neither stored nor dissipated, said at the end, once
for courant, warned in (0.4, 1), (0.1, 0):
    r = run(SCENE.replace("200*x", "1500*x").format(style=BARE + "0 0", strength="", fix="energy yes energy/drift none courant %g" % courant) + "run 1000\nrun 1000\n")
    said = [w for w in r.warnings() if "neither stored nor dissipated" in w and "half the courant" in w]
    checks.true("short waves, courant %g: %d warnings of work that is lost" % (courant, warned), len(said) == warned, "%s" % r.warnings())

# over a restart: the same line, and nothing said twice
r = scene("run 1500\nwrite_restart half.restart\nrun 1500\n", style=BARE + "1 1")
again = run("read_restart half.restart\nfix body all sph/tm energy yes\nthermo 100\nrun 1500\n", folder=r.folder)
checks.true("restart: the same energies, no second warning", energy_line(again) == energy_line(r) and not again.warnings(),
            "%s | %s | %s" % (energy_line(again), energy_line(r), again.warnings()))

# said once
r = scene("run 10\nrun 10\n")
checks.true("types that are one body", r.output.count("types 1 and 2 are one body where they touch") == 1)
r = scene("pair_coeff 1 2 contact\nrun 10\n")
checks.true("two bodies: nothing of that", "are one body" not in r.output)
HOT = "strength johnson/cook 428e6 327e6 1.0 0.01 1.3 293 855 1.0 heat 0 900 0.9"
for ranks in 1, 2:
    r = scene("group one id 30\nfix glow one sph/tm/heat source 1e15\nrun 100\nrun 100\n", strength=HOT, fix="", ranks=ranks)
    said = [w for w in r.warnings() if "above the melting temperature 855" in w]
    checks.true("the first that melts, %d ranks" % ranks, r.status == 0 and len(said) == 1 and "particle 30 " in said[0],
                "%d %s %s" % (r.status, r.errors()[:200], r.warnings()))
checks.end()
