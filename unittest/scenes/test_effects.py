"""Only what a scene calls for: which effects are on and why, what they cost in memory, and that an effect forced
off leaves the results of a scene that never asks for it, bit for bit."""
import re

from sphtm_scene import PLANE, Checks, run

# two blocks fly at each other; 'number' in the material card of a scene decides what happens
SCENE = PLANE + """
lattice         sq 1e-3 origin 0.5 0.5 0
region          box block -0.02 0.04 -0.02 0.03 -0.001 0.001 units box
create_box      1 box
region          left block 0 0.01 0 0.01 INF INF units box
region          right block 0.01 0.02 0 0.01 INF INF units box
create_atoms    1 region left
create_atoms    1 region right
group           right region right
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 {options}
pair_coeff      1 1 density 7830 elastic 200e9 0.29 {material}
fix             body all sph/tm temperature 300 {fix}
run             0
velocity        right set -200 0 0 units box
thermo          60
thermo_style    custom step time dt ke
run             60
write_dump      all custom end.dump id x y vx vy fx fy modify format float %.17g
"""
# the same with 20 000 particles
BIG = SCENE.replace("1e-3", "1e-4").replace("-0.001 0.001", "-0.0001 0.0001").replace("run             60", "run             2")
YIELDS = "strength plastic 400e6 100e6"
STEEL = "strength johnson/cook 792e6 510e6 0.26 0.014 1.03 298 1793 1"
HEAT = "heat 38 477 0.9"
ALL = ("viscosity artstress heat conduction plasticity damage correction faces balsara xsph surface internal-energy bodies energy "
       "smoothing hourglass fracture contact-layer shifting expansion compression-heat artificial-heat").split()
NONE = "viscosity 0 0 hourglass 0 correction no"    # no artificial term
STEP = "dt 5e-8 "    # the coefficient of the viscosity, on or off, is part of the automatic step
checks = Checks()


def scene(material, options="", fix="", text=SCENE, **more):
    return run(text.format(material=material, options=options, fix=fix), **more)


def effects(result):
    """Effect -> (on, reason), as the log of the run prints them."""
    return {name: (state == "on", reason.strip()) for name, state, reason in
            re.findall(r"^sph/tm effect (\S+) +(on|off) +(.*)", result.output, re.M)}


def memory(result):
    """Megabytes, as LAMMPS prints them with four digits."""
    return float(re.findall(r"^Per MPI rank memory allocation \(min/avg/max\) = ([\d.]+)", result.output, re.M)[-1])


def end(result):
    with open(result.path("end.dump")) as f:
        return f.read()


def expect(name, result, on):
    lines = effects(result)
    checks.true(name + ": one line for every effect", sorted(lines) == sorted(ALL), " ".join(lines))
    is_on = {e for e in lines if lines[e][0]}
    checks.true(name + ": what is on", is_on == set(on), " ".join(sorted(is_on)))
    checks.true(name + ": every line has a reason", all(reason for _, reason in lines.values()))
    return lines


# --- what each kind of scene turns on
plain = {"viscosity", "hourglass", "correction", "fracture"}
old = {"viscosity", "artstress", "fracture"}
heated = {"heat", "conduction", "artificial-heat"}
elastic = scene("strength elastic")
plastic = scene(YIELDS)
johnson_cook = scene(STEEL + " " + HEAT)
expect("elastic", elastic, plain | {"faces"})
lines = expect("plastic", plastic, plain | {"plasticity", "shifting"})
checks.true("plastic: the reason names the type", "type 1" in lines["plasticity"][1], lines["plasticity"][1])
checks.true("plastic: the line of faces says what that means", "material can flow" in lines["faces"][1] and "correction second" in lines["faces"][1],
            lines["faces"][1])
checks.true("plastic: the line of heat says what is missing", "type 1" in lines["heat"][1] and "no heat constants" in lines["heat"][1], lines["heat"][1])
expect("plastic, heat constants", scene(YIELDS + " " + HEAT), plain | {"plasticity", "shifting"} | heated)
expect("plastic, heat constants, chi 0", scene(YIELDS + " heat 38 477 0"), plain | {"plasticity", "shifting"})
expect("Johnson-Cook, no heat constants", scene(STEEL), plain | {"plasticity", "shifting"})
lines = expect("Johnson-Cook", johnson_cook, plain | {"plasticity", "shifting"} | heated)
checks.true("Johnson-Cook: the reason of heat", "plastic work" in lines["heat"][1], lines["heat"][1])
expect("no conductivity", scene(STEEL + " heat 0 477 0.9"), plain | {"plasticity", "shifting", "heat", "artificial-heat"})
expect("damage, shock", scene(STEEL + " eos shock 4570 1.49 1.9 damage strain 1.0"),
       plain | {"plasticity", "shifting", "damage", "internal-energy"})
said = lambda result: re.findall(r"^sph/tm shock (\S+) +(.*)|WARNING: (Pair style sph/tm shock .*?) \(", result.output, re.M)
shocked = STEEL + " eos shock 4570 1.49 1.9"
for name, result, due, why in (("shock equation of state", scene(shocked), "0.5", "type 1"),
                               ("linear equation of state", scene(STEEL), "0.5", "yields"),
                               ("shock equation of state, elastic", scene("strength elastic eos shock 4570 1.49 1.9"), None, None),
                               ("shock equation of state, shock 0", scene(shocked, "shock 0"), "0", "asked for"),
                               ("linear equation of state, shock 1", scene(STEEL, "shock 1"), "1", "asked for"),
                               ("shock equation of state, correction second", scene(shocked, "correction second"), "0", "second order"),
                               ("shock equation of state, artificial stress", scene(shocked, "stabilize artstress"), "0", "needs gradient correction"),
                               ("shock equation of state, lists that keep pairs",
                                scene(shocked, fix="\nfix lists all adapt/neigh threshold inf"), "0", "keep pairs"),
                               ("shock 0.5, elastic", scene("strength elastic", "shock 0.5"), "", "no material flows")):
    found = said(result)
    checks.true("bulk viscosity of shocks, " + name, found == [] if due is None else len(found) == 1 and found[0][0] == due and why in "".join(found[0]), str(found))
expect("thermal expansion", scene(YIELDS + " expansion 1.2e-5 " + HEAT),
       plain | {"plasticity", "shifting", "expansion", "compression-heat"} | heated)
expect("shock, heat constants", scene("strength elastic eos shock 4570 1.49 1.9 " + HEAT),
       plain | {"faces", "internal-energy", "compression-heat"} | heated)
expect("heat, artificial stress", scene(YIELDS + " " + HEAT, "stabilize artstress"),
       old | {"plasticity", "heat", "conduction"})
expect("all settings",
       scene("strength elastic", "balsara yes xsph 0.1 artstress 0.3 4 correction yes hourglass auto", "energy yes"),
       plain | {"artstress", "balsara", "xsph", "energy"})
checks.true("energy yes, then no: off", not effects(scene("strength elastic", fix="energy yes energy no"))["energy"][0])
for options in "stabilize artstress", "artstress 0.3 4", "form f14":
    expect(options, scene("strength elastic", options), old)
expect("nothing artificial", scene("strength elastic", NONE), {"fracture"})
a, b, c = (end(scene(YIELDS, options, STEP)) for options in
           ("stabilize artstress", "artstress 0.3 4", "viscosity 1 1 artstress 0.3 4 hourglass 0 correction no"))
checks.true("stabilize artstress: the results of its single settings, every digit", a == b == c)
a, b = (end(scene(YIELDS, options, STEP)) for options in
        ("", "viscosity 0 1 balsara no artstress 0 4 hourglass auto correction yes xsph 0 stabilize hourglass"))
checks.true("the default: the results of its single settings, every digit", a == b)

# --- forced off: a warning where the scene needs it, and the results of a scene that never asks
for effect, scene_with, scene_without, warns in (
        ("heat", (STEEL + " " + HEAT, ""), (STEEL, ""), True),
        ("conduction", (STEEL + " " + HEAT, ""), (STEEL + " heat 0 477 0.9", ""), False),
        ("plasticity", (YIELDS, ""), ("strength elastic", ""), True),
        ("damage", (STEEL + " damage strain 0.01", ""), (STEEL, ""), True),
        ("viscosity", (YIELDS, ""), (YIELDS, "viscosity 0 0"), False),
        ("artstress", (YIELDS, "stabilize artstress"), (YIELDS, "stabilize artstress artstress 0 4"), False),
        ("artstress", (YIELDS, "artstress 0.3 4 hourglass auto correction yes"), (YIELDS, "viscosity 1 1"), False),
        ("balsara", (YIELDS, "balsara yes"), (YIELDS, ""), False),
        ("xsph", (YIELDS, "xsph 0.1"), (YIELDS, ""), False),
        ("correction", (YIELDS, ""), (YIELDS, "correction no"), False),
        ("correction", (YIELDS, "hourglass 0"), (YIELDS, "hourglass 0 correction no"), False),
        ("hourglass", (YIELDS, ""), (YIELDS, "hourglass 0"), False),
        ("faces", ("strength elastic", ""), ("strength elastic", "correction linear"), False),
        ("faces", (YIELDS, "correction second"), (YIELDS, ""), False),
        ("hourglass", (YIELDS, "hourglass 0.02 correction no"), (YIELDS, "hourglass 0 correction no"), False)):
    asked = scene(*scene_with, STEP)
    off = scene(*scene_with, STEP + "effects %s off" % effect)
    without = scene(*scene_without, STEP)
    line = effects(off)[effect]
    checks.true(effect + " off: the line", line == (False, "forced off in fix sph/tm"), "%s %s" % line)
    checks.true(effect + " off: warns" + ("" if warns else " not"),
                any(effect + " is forced off" in w for w in off.warnings()) == warns, "; ".join(off.warnings()))
    checks.true(effect + " off: the results of a scene without, every digit", end(off) == end(without))
    checks.true(effect + " on: other results, so the scene has a use for it", end(asked) != end(without))

counted, off = scene(YIELDS, "", STEP), scene(YIELDS, "", STEP + "effects fracture off")
checks.true("fracture off: the line", effects(off)["fracture"] == (False, "forced off in fix sph/tm"))
checks.true("fracture is counted: the same results, every digit", end(counted) == end(off))

# --- forced on: no results change where there is nothing to act on; contradictions are refused
for effect, material in (("heat", "strength elastic heat 0 477 0.9"), ("conduction", "strength elastic " + HEAT),
                         ("plasticity", "strength elastic"), ("damage", YIELDS), ("surface", YIELDS), ("energy", YIELDS),
                         ("internal-energy", YIELDS)):
    if effect == "conduction":    # its loops are compiled apart: round-off of the forces; with heat, which it needs
        on, auto = scene(material, fix="effects heat on"), scene(material)
        checks.true("conduction on: the line", effects(on)[effect][0], effects(on)[effect][1])
        a, b = (r.dump("end.dump")[-1] for r in (on, auto))
        checks.below("conduction on: velocities differ by", abs(a["vx"] - b["vx"]).max() / 200, 1e-12)
        continue
    on, auto = scene(material, fix="effects %s on" % effect), scene(material)
    checks.true(effect + " on: the line", effects(on)[effect] == (True, "asked for in fix sph/tm"), effects(on)[effect][1])
    if effect == "surface":    # a loop of its own, compiled for many effects at once: round-off of the forces
        a, b = (r.dump("end.dump")[-1] for r in (on, auto))
        checks.below(effect + " on: velocities differ by", abs(a["vx"] - b["vx"]).max() / 200, 1e-12)
    else:
        checks.true(effect + " on: the same results, every digit", end(on) == end(auto))
for fix, words in (("effects conduction on", "heat is off"), ("effects warmth on", "warmth"),
                   ("effects heat maybe", "maybe")):
    refused = scene(YIELDS, fix=fix, expect_error=True)
    checks.true(fix + ": refused", refused.status != 0 and words in refused.errors(), refused.errors())

# --- memory: what is off takes none. 20 000 particles; a column of doubles is atom->nmax * 8 bytes
bare_elastic = scene("strength elastic", NONE, text=BIG)
for name, columns, arguments in (
        # at least the columns of the state (tm_fields.h) and of the records and rates
        ("artstress", 6, ("strength elastic", "viscosity 0 0 artstress 0.3 4")),
        ("plasticity", 3, (YIELDS, NONE)),
        ("heat", 3, (YIELDS + " heat 0 477 0.9", NONE)),
        ("damage", 2, (YIELDS + " damage strain 1", NONE)),
        ("correction", 9 + 6, ("strength elastic", "viscosity 0 0 hourglass 0 correction yes")),
        ("balsara", 1, ("strength elastic", "viscosity 1 1 hourglass 0 correction no balsara yes")),
        ("xsph", 3, ("strength elastic", NONE + " xsph 0.1")),
        ("hourglass", 6 + 4 + 3, ("strength elastic", "viscosity 0 0 correction no hourglass 0.02")),
        ("expansion", 1, (YIELDS + " heat 0 477 0.9 expansion 1e-5", NONE)),
        ("artificial-heat", 1, (YIELDS + " heat 0 477 0.9", "viscosity 1 1 hourglass 0 correction no")),
        ("surface", 3, ("strength elastic", NONE, "effects surface on")),
        ("faces", 6 + 3 + 6, ("strength elastic", "")),
        ("internal-energy", 1, ("strength elastic eos shock 4570 1.49 1.9", NONE))):
    on = scene(*arguments, text=BIG)
    off = scene(*arguments[:2], "effects %s off" % name, text=BIG)
    per_column = 20000 * 8 / 2.0**20
    bare = bare_elastic
    if name in ("heat", "damage"):
        bare = scene(YIELDS, NONE, text=BIG)
    if name == "faces":
        bare = scene("strength elastic", "correction linear", text=BIG)
    if name in ("expansion", "artificial-heat"):
        bare = scene(YIELDS + " heat 0 477 0.9", NONE, text=BIG)
    checks.near(name + " off: megabytes, those of a scene without", memory(off), memory(bare), absolute=0.0011)
    checks.above(name + " on: megabytes more", memory(on) - memory(off), 0.99 * columns * per_column)
# the state of both in one pass, and the reference of what counts numerical fracture
both = scene("strength elastic", "viscosity 0 0 correction linear", text=BIG)
checks.above("hourglass and correction on: megabytes more", memory(both) - memory(bare_elastic), 0.99 * (6 + 16) * per_column)
uncounted = scene("strength elastic", NONE, "effects fracture off", text=BIG)
checks.above("fracture on: megabytes more", memory(bare_elastic) - memory(uncounted), 0.99 * 7 * per_column)
checks.end()
