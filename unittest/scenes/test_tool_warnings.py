"""What runs, but not as it was meant: tools that cross a periodic face, pass no heat, damped while they move, chips of kept pairs,
motions that contradict themselves. A warning each, and beside it the control that runs without one."""
import os
import shutil

from sphtm_scene import SOURCE, Checks, lattice_block, new_folder, run

checks = Checks()
HEAD = lattice_block("0 4e-3 0 4e-3 0 4e-3", "-5e-3 25e-3 -5e-3 15e-3 -5e-3 15e-3", dim=3)
SCENE = """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 2700 elastic 70e9 0.33 {material}
fix             body all sph/tm {body}
{before}
fix             tool all contact/tri file tool.stl scale {scale} move {at} {tool}
"""
HEATED, FLOWS = "heat 200 900 0.9", "strength plastic 100e6 1e9"


def scene(lines, head=HEAD, folder=None, body="", before="", material="", at="10e-3 1e-3 1e-3", tool="", scale="2e-3", ranks=1):
    folder = folder or new_folder()
    shutil.copy(os.path.join(SOURCE, "unittest", "meshes", "ascii.stl"), os.path.join(folder, "tool.stl"))
    text = SCENE.format(material=material, body=body, before=before, at=at, tool=tool, scale=scale) + lines + "\n"
    return run(head + text, folder=folder, ranks=ranks, expect_error=True)


def warns(name, r, *words):
    """A run that ends well, with one warning that has these words; without words: with none."""
    said = [w for w in r.warnings() if all(x in w for x in words)] if words else r.warnings()
    good = r.status == 0 and len(said) == (1 if words else 0)
    checks.true(name, good, "" if good else "%d %s %s" % (r.status, r.errors()[:200], [w[:150] for w in r.warnings()]))


# --- where the tool is
PERIODIC = HEAD.replace("boundary        f f f", "boundary        p f f")
assert PERIODIC != HEAD
for ranks in 1, 2:
    warns("a tool across a periodic face, %d ranks" % ranks, scene("run 5", head=PERIODIC, at="24e-3 1e-3 1e-3", ranks=ranks),
          "crosses a periodic face", "along x", "24")
warns("across a face that is fixed", scene("run 5", at="24e-3 1e-3 1e-3"))
warns("between both faces", scene("run 5", head=PERIODIC))
BOX = PERIODIC.replace("-5e-3 25e-3", "0 4e-3")
warns("beyond both faces", scene("run 5", head=BOX, at="-2e-3 8e-3 1e-3", scale="8e-3 2e-3 2e-3"))

# --- how thick it is: what is pressed beyond its middle comes out on the other side
for thick, speed, words in ("0.2e-3", 2000, ("spacings behind the surface", "other side of the tool")), ("0.2e-3", 20, ()), ("8e-3", 400, ()):
    warns("a block at %g m/s on a plate of %s" % (speed, thick), scene(
        "velocity all set 0 0 -%g units box\nrun 60" % speed, material=FLOWS, at="-2e-3 -2e-3 -%s" % thick, scale="8e-3 8e-3 " + thick), *words)

# --- what it touches
GROUP = "region low block INF INF INF INF INF 2e-3 units box\ngroup low region low\ngroup high subtract all low\n"
for group, words in ("high", ("particles of metal that are not in its group", "(high)")), ("all", ()):
    lines = GROUP + "fix mine %s contact/tri file tool.stl scale 2e-3 move 1e-3 1e-3 -1e-3 overlap allow\nrun 5" % group
    r = scene(lines, material=FLOWS)
    said = [w for w in r.warnings() if "not in its group" in w]
    checks.true("metal in a tool whose group is %s" % group, r.status == 0 and len(said) == bool(words) and all(x in said[0] for x in words),
                "%d %s %s" % (r.status, r.errors()[:200], [w[:160] for w in r.warnings()]))
    checks.true("  that it touched nothing", ("mine: no particle has touched" in r.output) == (group == "high"))
for mu, more, words in ("30", "", ("Fix contact/tri tool", "friction 30", "ratio")), ("10", " friction/shear 0.9", ()), ("0.9", "", ()):
    warns("friction %s%s" % (mu, more), scene("run 1", material=FLOWS, tool="friction " + mu + more), *words)

# --- inertia in fast motion: rho v^2 over the flow stress
for v, scale, words in (200, 10, ("time/scale 10", "inertia", "type 1")), (30, 10, ()), (200, 1, ()):
    r = scene("fix_modify tool move linear -%g 0 0\nrun 5" % v, material=FLOWS, body="time/scale %g" % scale)
    warns("a tool at %g m/s with time/scale %g" % (v, scale), r, *words)
    checks.true("  what its output is", ("Powers (of tools" in r.output) == (scale != 1))

# --- heat
HOT = dict(material=HEATED, tool="heat conductance 1e5 temperature 400")
warns("a tool at rest that nothing presses on passes no heat", scene("run 5\nrun 5", **HOT), "has passed", "contact force")
warns("one that comes nearer", scene("fix_modify tool move linear -10 0 0\nrun 5", **HOT))
warns("one without heat", scene("run 5", material=HEATED, tool="temperature 400"))

# --- how it moves
warns("a ramp begins at rest", scene("fix_modify tool move linear 10 0 0\nrun 5\nfix_modify tool move linear -10 0 0 ramp 1e-6\nrun 5"),
      "ramp", "jumps to 0")
warns("a ramp of a tool at rest", scene("fix_modify tool move linear 10 0 0 ramp 1e-6\nrun 5\nfix_modify tool move none\nrun 5\n"
                                        "fix_modify tool move linear -10 0 0 ramp 1e-6\nrun 5"))
RAMP = "fix_modify tool move linear %d 0 0 ramp 1e-6\n"
folder = new_folder()
first = scene(RAMP % -10 + "run 5\nwrite_restart tool.restart", folder=folder)
for name, speed, words in ("goes on after a restart", -10, ()), ("is another after a restart", -20, ("ramp", "jumps to 0")):
    r = scene(RAMP % speed + "run 5", head="read_restart tool.restart\n", folder=folder)
    warns("a ramp that " + name, r, *words)
BOTH = "variable d equal 1000*time\nvariable w equal %s\nfix_modify tool move variable v_d NULL NULL v_w NULL NULL\nrun 100"
for wrong in "500", "-1000":
    warns("a velocity of %s beside a way of 1000 a second" % wrong, scene(BOTH % wrong), "rate of its displacement")
warns("the right one", scene(BOTH % "1000"))
MOVES = "fix_modify tool move linear -10 0 0\n"
warns("relaxation while a tool moves", scene(MOVES + "fix rest all sph/tm/relax damping 1e4\nrun 5"), "damps while",
      "contact/tri tool")
warns("relaxation while a tool stands", scene("fix rest all sph/tm/relax damping 1e4\nrun 5"))
warns("kept pairs in a cut", scene(MOVES + "run 5", material=FLOWS, before="fix l all adapt/neigh threshold inf"), "threshold inf",
      "stays tied")
warns("kept pairs of what is elastic", scene(MOVES + "run 5", before="fix l all adapt/neigh threshold inf"))
warns("kept pairs beside a tool at rest", scene("run 5", material=FLOWS, before="fix l all adapt/neigh threshold inf"))
REFINE = "fix l all adapt/neigh refine cube epsilon %s alpha 1 when vonmises above 1e20 every 100"
for ratio, said in ("0.6", ["half a spacing apart", "0.41667"]), ("0.41667", []):
    warns("children %s h apart" % ratio, scene("run 5", before=REFINE % ratio), *said)

ELASTIC = "\npair_coeff 1 1 density 2700 elastic 70e9 0.33\nrun 5"
warns("what flowed is elastic after a run", scene("run 5" + ELASTIC, material=FLOWS), "is elastic now", "another stiffness")
warns("what was elastic stays so", scene("run 5" + ELASTIC))

# --- what else is out of the usual
warns("courant 0.9", scene("run 1", body="courant 0.9"), "courant", "0.65")
warns("courant 0.6", scene("run 1", body="courant 0.6"))
warns("sleep at nearly the speed of the tool", scene(MOVES + "run 5", body="active near 5e-3 speed 8"), "active", "0.8 times")
warns("sleep at a tenth of it", scene(MOVES + "run 5", body="active near 5e-3 speed 1"))

# --- restarts
folder = new_folder()
warns("writing", scene(MOVES + "run 5\nwrite_restart at.restart", folder=folder, body="time/scale 10"))
AGAIN = """newton off
read_restart at.restart
fix body all sph/tm {scale}
fix {tool} all contact/tri file tool.stl scale 2e-3 move 10e-3 1e-3 1e-3
{lines}
run 5
"""
for name, values, words in (("the same", {}, []), ("another time/scale", {"scale": ""}, ["time/scale 10", "this run has 1"]),
                            ("another ID of the tool", {"tool": "other"}, ["no tool of this ID"])):
    given = dict({"scale": "time/scale 10", "tool": "tool", "lines": MOVES if not values.get("tool") else ""}, **values)
    warns("restart: " + name, run(AGAIN.format(**given), folder=folder, expect_error=True), *words)
r = run(AGAIN.format(scale="time/scale 10", tool="tool", lines=""), folder=folder, expect_error=True)
warns("restart: no motion given", r)
checks.true("it goes on, and that is said", "goes on with the motion of the restart file" in r.output)
dense = AGAIN.format(scale="time/scale 10", tool="tool", lines="pair_coeff 1 1 density 5000 elastic 70e9 0.33")
r = run(dense, folder=folder, expect_error=True)
checks.true("restart: another density is refused", r.status == 1 and "density of type 1" in r.errors() and "2700" in r.errors(), r.errors()[:200])
checks.end()
