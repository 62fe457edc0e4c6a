"""What fix contact/tri and compute cutting/force notice during and between runs: a tool that jumps, friction heat,
values that are asked for when there are none, a restart with another tool. Each is an error or a warning that names
what is wrong, and the control beside it runs without a word."""
import os
import re
import shutil
import struct

from contact_scene import mesh
from sphtm_scene import SOURCE, Checks, lattice_block, new_folder, run

MESHES = os.path.join(SOURCE, "unittest", "meshes")
HEAD = lattice_block("0 4e-3 0 4e-3 0 4e-3", "-5e-3 25e-3 -5e-3 15e-3 -5e-3 15e-3", dim=3)
BODY = """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 2700 elastic 70e9 0.33{heat}
fix             body all sph/tm {body}
"""
TOOL = "fix tool all contact/tri file tool.stl scale 2e-3 move {x} 1e-3 1e-3 "
T = "contact/tri tool"
checks = Checks()


def scene(text, body="", x="10e-3", tool="", head=HEAD, folder=None, heat="", ranks=1):
    folder = folder or new_folder()
    if not os.path.exists(os.path.join(folder, "tool.stl")):
        shutil.copy(os.path.join(MESHES, "ascii.stl"), os.path.join(folder, "tool.stl"))
    return run(head + BODY.format(body=body, heat=heat) + TOOL.format(x=x) + tool + "\n" + text + "\n", folder=folder,
               ranks=ranks, expect_error=True, timeout=120)


def judge(name, result, *fragments, warned=False, step=None):
    """An error, or a warning of a run that goes to its end, with these fragments; none of them: neither."""
    said = "\n".join(result.warnings()) if warned or not fragments else result.errors()
    missing = [f for f in fragments if f not in said]
    ended = result.status == 0 if warned or not fragments else 0 < result.status < 128
    silent = fragments or not said
    steps = [int(s) for s in re.findall(r"^ +(\d+) ", result.output, re.M)]
    there = step is None or (steps and steps[-1] == step)
    text = "; ".join(["status %d" % result.status] * (not ended) + ["not said: " + m for m in missing] +
                     ["last step %s" % steps[-1:]] * (not there))
    checks.true(name, ended and not missing and silent and there, text + "   <- " + (said or result.errors())[:220])


# --- jumps ---------------------------------------------------------------------------------------------------------

VARIABLE = "variable d equal %s\nfix_modify tool move variable v_d NULL NULL NULL NULL NULL\nthermo 1\n"
LINEAR = "thermo 1\nfix_modify tool move linear %s 0 0\nrun 3"


def jumps():
    fixed = dict(body="dt 5e-8")
    judge("fixed dt, 0.4 spacings in a step", scene(LINEAR % "8000", **fixed))
    limit = ("Fix sph/tm dt 5e-08 is not stable", "motion of a tool", "fix tool contact/tri")
    judge("fixed dt, 0.6 spacings in a step", scene(LINEAR % "12000", **fixed), *limit, "4.16667e-08")
    judge("away and back within a step", scene("fix_modify tool move wiggle 1e-4 0 0 5e-8\nrun 3", **fixed), *limit)
    judge("rotation, far corner", scene("fix_modify tool move rotate 0 0 0 0 0 1 5e-6\nrun 3", **fixed), *limit)
    judge("automatic step, no jump", scene(LINEAR % "12000"))
    judge("variable that jumps", scene(VARIABLE % "2e-3*(step>5)" + "run 20"), T, "stops at step 6", "0.002",
          "2 times the smallest", "variable", step=5)
    judge("variable that jumps, two ranks", scene(VARIABLE % "2e-3*(step>5)" + "run 20", ranks=2), T,
          "stops at step 6")
    judge("variable that jumps by less than half a spacing", scene(VARIABLE % "0.4e-3*(step>5)" + "run 20"))
    judge("variable that is not a number", scene(VARIABLE % "0*exp(1000)" + "run 20"), T, "not a finite number")
    judge("variable that becomes infinite", scene(VARIABLE % "exp(1000*(step>5))-1" + "run 20"), T, "stops at step 6",
          "not a finite number")
    judge("velocity variable of 1e300", scene(
        "variable u equal 1e300*(step>3)\nfix_modify tool move variable NULL NULL NULL v_u NULL NULL\nrun 9"), T,
          "stops at step 4", "not a finite number")
    judge("variables that contradict each other: no way, but a speed", scene(
        "variable u equal 1e9\n" + (VARIABLE % "0").replace("v_d NULL NULL NULL", "v_d NULL NULL v_u") + "run 9"), T,
          "1e+09", "ten times the speed of sound")
    judge("variable that begins elsewhere is the place of the tool", scene(VARIABLE % "3e-3" + "run 5"))
    between = VARIABLE % "0" + "run 5\n%s\nrun 5"
    judge("another value between runs", scene(between % "variable d delete\nvariable d equal 2e-3"), T,
          "jump between runs", "0.002", step=5)
    judge("another motion between runs",
          scene("run 5\n" + VARIABLE % "2e-3" + "run 5"), T, "jump between runs", "0.002")
    judge("motions that follow each other", scene(
        VARIABLE % "10*time" + "run 5\nfix_modify tool move linear 10 0 0\nrun 5\nfix_modify tool move none\nrun 5"))
    judge("temperature by a variable that is not one",
          scene("variable T equal 300-100*step\nrun 10", tool="temperature v_T"), T, "variable T", "positive")


# --- friction heat -------------------------------------------------------------------------------------------------

RUBS = """
fix_modify tool move linear 0 50 0
compute T all sph/tm/atom temperature
compute sum all reduce sum c_T
thermo 1
thermo_style custom step dt f_tool[10] f_tool[11] c_sum
thermo_modify norm no format float %.17g
run 60
"""


def heat():
    """Elastic particles with heat constants and a tool with friction: nothing else calls for heat."""
    for more, share in (("friction 0.3", 0.5), ("friction/table 300 0.3 900 0.2 share 0.25", 0.25)):
        folder = new_folder()
        mesh(folder, "tool.stl", "block --size 1 1 1")
        result = scene(RUBS, x="4.9e-3", folder=folder, tool=more + " overlap allow", heat=" heat 0 900 0.9",
                       body="effects artificial-heat off")
        why = re.findall("^sph/tm effect heat +(.*)", result.output, re.M)
        checks.true(more + ": heat is on", "on   friction of fix contact/tri tool" in why, " | ".join(why))
        t = result.thermo[-1]
        work = (t["f_tool[10]"][1:] * t["Dt"][1:]).sum()
        warmth = 2700 * 1e-9 * 900 * (t["c_sum"][-1] - t["c_sum"][0])
        checks.above("    friction work, J", work, 1e-3)
        checks.near("    heat of the particles over it", warmth / work, share, absolute=1e-9)
    for name, more, constants in (("no friction", "", " heat 0 900 0.9"), ("no heat constants", "friction 0.3", "")):
        why = re.findall("^sph/tm effect heat +(.*)", scene("run 0", tool=more, heat=constants).output, re.M)
        checks.true(name + ": heat is off", why == ["off  nothing in the scene calls for it"], " | ".join(why))


# --- values between runs -------------------------------------------------------------------------------------------

FC = "compute fc all cutting/force tool\n"
RUN = FC + "thermo_style custom step f_tool[1] c_fc\nrun 5\nthermo_style one\n"


# --- what is most likely wrong about a tool or about what is asked of it -----------------------------------------------

def plane(folder, order):
    """Of two triangles at x = 5e-3 in front of the block, whose normals are along x or against it by the order of their corners."""
    corners = {"a": (5e-3, -2e-3, -2e-3), "b": (5e-3, 8e-3, -2e-3), "c": (5e-3, 8e-3, 8e-3), "d": (5e-3, -2e-3, 8e-3)}
    facets = ["facet normal 0 0 0\nouter loop\n%sendloop\nendfacet\n" % "".join("vertex %g %g %g\n" % corners[k] for k in triple) for triple in order]
    with open(os.path.join(folder, "plane.stl"), "w") as f: f.write("solid plane\n%sendsolid plane\n" % "".join(facets))
    return folder


def mistakes():
    at = "\nfix wall all contact/tri file plane.stl %s\nrun 0"
    toward, away = ("acb", "adc"), ("abc", "acd")
    judge("an open plane that faces the block", scene(at % "", folder=plane(new_folder(), toward)), "open edges", warned=True)
    for name, said, text, order in (("away from it", True, "", away), ("away from it, flip yes", False, "flip yes", away),
                                    ("away from it, sides two", False, "sides two", away), ("toward it", False, "", toward)):
        lines = [w for w in scene(at % text, folder=plane(new_folder(), order)).warnings() if "lie behind its triangles" in w]
        checks.true("an open plane that faces %s: a warning" % name if said else "an open plane that faces %s: none" % name,
                    len(lines) == said and all("fix contact/tri wall" in w.lower() and "flip yes" in w for w in lines), str(lines))
    judge("a tool a thousand times too small", scene("run 0", tool="scale 1e-3"), T, "of the spacing of the particles", "scale", warned=True)
    judge("a tool of 20 K", scene("run 0", tool="temperature 20"), "temperature is 20 K", "kelvin", warned=True)
    judge("a tool of 293 K", scene("run 0", tool="temperature 293"))
    judge("a tool of 300, then 25 K", scene("run 0\nfix_modify tool temperature 25\nrun 0", tool="temperature 300"), "is 25 K", "kelvin", warned=True)
    judge("air of 20 K", scene("fix air all sph/tm/heat convection 100 20\nrun 0", heat=" heat 200 900 0.9"), "Tinf is 20 K", "kelvin", warned=True)
    folder = new_folder()
    for name, order in (("right", "abcd"), ("turned", "badc")):
        lines = []
        for k, (lo, hi) in enumerate((((6e-3, 0, 0), (8e-3, 2e-3, 2e-3)), ((6e-3, 3e-3, 0), (7e-3, 4e-3, 1e-3)))):
            turn = k == 1 and name == "turned"
            at = lambda i, j, l: tuple((lo, hi)[n][d] for d, n in enumerate((i, j, l)))
            quads = [((0, 0, 0), (0, 0, 1), (0, 1, 1), (0, 1, 0)), ((1, 0, 0), (1, 1, 0), (1, 1, 1), (1, 0, 1)),
                     ((0, 0, 0), (1, 0, 0), (1, 0, 1), (0, 0, 1)), ((0, 1, 0), (0, 1, 1), (1, 1, 1), (1, 1, 0)),
                     ((0, 0, 0), (0, 1, 0), (1, 1, 0), (1, 0, 0)), ((0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1))]
            for q in quads:
                for three in ((0, 1, 2), (0, 2, 3)):
                    corner = [at(*q[n]) for n in (three[::-1] if turn else three)]
                    lines.append("facet normal 0 0 0\nouter loop\n%sendloop\nendfacet\n" % "".join("vertex %g %g %g\n" % c for c in corner))
        with open(os.path.join(folder, name + ".stl"), "w") as f: f.write("solid two\n%sendsolid two\n" % "".join(lines))
    two = "\nfix two all contact/tri file %s.stl\nrun 0"
    judge("two bodies in a file", scene(two % "right", folder=folder))
    judge("two bodies in a file, one inside out", scene(two % "turned", folder=folder), "contact/tri", "turned.stl", "some bodies", "with a corner at 0.006 0.004 0.001", "flip no")
    C = "compute c all cutting/force tool %s\nthermo_style custom step c_c\nrun 1"
    judge("away along direction", scene(C % "direction 0 2 0"), "Compute cutting/force c", "away 0 1 0", "direction 0 1 0")
    judge("away against direction", scene(C % "direction 1 0 0 away -3 0 0"), "Compute cutting/force c", "away -1 0 0")
    move = "fix_modify tool move linear %s\n"
    judge("a tool that moves along away", scene(move % "0 1 0" + C % ""), "Compute cutting/force c", "moves along away", warned=True)
    judge("a tool that moves across", scene(move % "-1 0 0" + C % ""))


def prints(name, result, value):
    found = re.findall(r"^VALUE (\S+)", result.output, re.M)
    checks.true(name, result.status == 0 and found and abs(float(found[-1]) - value) < 1e-12 + 1e-6 * abs(value),
                "%s, status %d, %s" % (found, result.status, result.errors()[:100]))


def ask(what):
    return "print 'VALUE $(%s)'\n" % what


def values():
    judge("force before the first run", scene(ask("f_tool[1]")), T, "no current values")
    judge("force before the first run, two ranks", scene(ask("f_tool[1]"), ranks=2), T, "no current values")
    judge("force in a variable before the first run", scene("variable f equal f_tool[13]\n" + ask("v_f")), T,
          "no current values")
    judge("cutting force before the first run", scene(FC + ask("c_fc[1]")), "before initialization by a run")
    judge("temperature that is not known yet", scene(ask("f_tool")), T, "no current values")
    prints("temperature that is given", scene(ask("f_tool"), tool="temperature 412"), 412)
    prints("reference point before the first run", scene(ask("f_tool[7]")), 10e-3)
    prints("force after a run", scene(RUN + ask("f_tool[1]")), 0)
    prints("cutting force after a run", scene(RUN + ask("c_fc[1]")), 0)
    for what, gone in (("unfix body", "unfix body"), ("pair_style none", "pair_style none"),
                       ("another fix sph/tm", "unfix body\nfix body all sph/tm"),
                       ("plugin unload", "thermo_modify lost ignore\nplugin unload pair sph/tm")):
        judge("force after " + what, scene(RUN + gone + "\n" + ask("f_tool[1]")), T, "no current values")
        judge("cutting force after " + what, scene(RUN + gone + "\n" + ask("c_fc[1]")), T, "no current values")
        prints("reference point after " + what, scene(RUN + gone + "\n" + ask("f_tool[7]")), 10e-3)
        prints("temperature after " + what, scene(RUN + gone + "\n" + ask("f_tool")), 293.15)
    judge("force after all plugins are gone", scene(RUN + "plugin clear\n" + ask("f_tool[1]")), "Invalid fix ID 'tool'")
    judge("cutting force after unfix tool", scene(RUN + "unfix tool\n" + ask("c_fc[1]")), "cutting/force fc", "tool",
          "not the ID")
    again = "unfix tool\n" + TOOL.format(x="10e-3") + "\n"
    judge("cutting force of a new tool", scene(RUN + again + ask("c_fc[1]")), T, "no current values")
    prints("cutting force of a new tool after a run", scene(RUN + again + "run 0\n" + ask("c_fc[1]")), 0)
    judge("run after unfix tool", scene(RUN + "unfix tool\nrun 1"), "cutting/force fc", "tool", "not the ID")

    local = "write_dump all local rows.txt f_tool[1]\n"
    for name, text in (("before the first run", "%s"), ("after a run", "run 2\n%s"),
                       ("after unfix body", "run 2\nunfix body\n%s"),
                       ("after pair_style none", "run 2\npair_style none\n%s")):
        judge("info memory " + name, scene(text % "info memory"))
        judge("restart file " + name, scene(text % "write_restart at.restart"),
              *["sph/tm needs"] * ("unfix" in text or "none" in text))
        for what, command in (("rows of triangles ", local),
                              ("picture ", "write_dump all image tool.ppm type type fix tool type 0 0\n")):
            result = scene(text % command, tool="local 1")
            checks.true(what + name, 0 <= result.status < 128, "status %d %s" % (result.status, result.errors()[:120]))
    result = scene("group none_of_it empty\nunfix tool\nunfix body\npair_style none\nclear")
    judge("all is taken away before the first run", result)


# --- restart -------------------------------------------------------------------------------------------------------

KEYS = "friction 0.2 penalty 0.5 damping 0.2 temperature 350 "
MOVE = "fix_modify tool move linear -40 0 0\n"
READ = "newton off\nread_restart at.restart\n"


def hash_of(raw):
    h, mask = 1469598103934665603, 2**64 - 1
    for k in range(0, len(raw), 8):
        h = (h ^ struct.unpack("<Q", raw[k:k + 8])[0]) * 1099511628211 & mask
        h ^= h >> 32
    return h


def block_at(raw):
    """Where the values of the tool's block begin, and how many they are."""
    magic, at = struct.pack("<Q", 0x324d545f48505321), -1
    while True:
        at = raw.index(magic, at + 1)
        values = struct.unpack("<Q", raw[at + 8:at + 16])[0] // 8
        if values == 66:
            return at, values


def restarts():
    folder = new_folder()
    first = scene(MOVE + "run 20\nwrite_restart at.restart\n" + ask("f_tool[7]"), tool=KEYS, folder=folder)
    reached = float(re.findall(r"^VALUE (\S+)", first.output, re.M)[-1])

    def again(name, *fragments, tool=KEYS, x="10e-3", text=MOVE + "run 5"):
        judge("restart: " + name, scene(text, tool=tool, x=x, head=READ, folder=folder), *fragments, warned=True)

    again("the same tool")
    again("the same tool, other output", tool=KEYS + "vtk 5 tool.*.vtk overlap allow maxsize 100")
    again("the same, written otherwise", tool="damping 0.20 friction 2e-1 penalty 5.0e-1 sides one temperature 350.0")
    prints("restart: place of the tool",
           scene("run 0\n" + ask("f_tool[7]"), tool=KEYS, head=READ, folder=folder), reached)
    again("another placement", T, "tool.stl", "placement", "restart file", x="10.1e-3")
    two = scene(MOVE + "run 5", tool=KEYS, x="10.1e-3", head=READ, folder=folder, ranks=2)
    judge("restart: another placement, two ranks", two, T, "placement", warned=True)
    said = [w for w in two.warnings() if "contact/tri" in w]
    checks.true("    said once", len(said) == 1, "%d warnings" % len(said))
    again("another edge angle", T, "tool.stl", "placement", tool=KEYS + "smooth 40")
    again("another friction and penalty", T, "other values of friction, penalty;", "restart file",
          tool="damping 0.2 temperature 350")
    again("friction by table", T, "other values of friction;",
          tool=KEYS.replace("friction 0.2", "friction/table 300 0.2 900 0.1"))
    again("another layer", T, "other values of layer;", tool=KEYS + "layer strains")
    again("sides, method", T, "other values of approach, sides, share;", tool=KEYS + "sides two approach yes share 0.4")
    again("another temperature", T, "other values of temperature;", "350", tool=KEYS.replace("350", "400"))
    prints("restart: the temperature is that of the file",
           scene("run 0\n" + ask("f_tool"), tool=KEYS.replace("350", "400"), head=READ, folder=folder), 350)
    shutil.copy(os.path.join(MESHES, "ascii_crlf.stl"), os.path.join(folder, "tool.stl"))
    again("another content", T, "tool.stl", "content", "restart file")
    shutil.copy(os.path.join(MESHES, "ascii.stl"), os.path.join(folder, "tool.stl"))

    with open(os.path.join(folder, "at.restart"), "rb") as f:
        whole = f.read()
    at, n = block_at(whole)
    names = {"clock": (0, -1.0), "kind": (36, 7.0), "kind, a fraction": (36, 1.5), "period": (37, 0.0),
             "ramp": (38, -1.0), "frame": (36 + 19, 2.0)}
    for name, (k, value) in names.items():
        v = bytearray(whole[at + 24:at + 24 + 8 * n])
        v[8 * k:8 * k + 8] = struct.pack("<d", value)
        with open(os.path.join(folder, "at.restart"), "wb") as f:
            f.write(whole[:at + 16] + struct.pack("<Q", hash_of(bytes(v))) + bytes(v) + whole[at + 24 + 8 * n:])
        judge("restart: impossible " + name, scene("run 1", tool=KEYS, head=READ, folder=folder), T, "damaged")
    for k in (0, 8, 17, 24, 30 + 8 * 40, 23 + 8 * n):
        raw = bytearray(whole)
        raw[at + k] ^= 4
        with open(os.path.join(folder, "at.restart"), "wb") as f:
            f.write(raw)
        judge("restart: byte %d of the block" % k, scene("run 1", tool=KEYS, head=READ, folder=folder), "fix tool",
              "damaged")


def restarts_by_variable():
    folder = new_folder()
    by = VARIABLE % "-40*time"
    first = scene(by + "run 20\nwrite_restart at.restart\n" + ask("f_tool[7]"), folder=folder)
    reached = float(re.findall(r"^VALUE (\S+)", first.output, re.M)[-1])
    judge("restart: the same variable", scene(by + "run 5", head=READ, folder=folder))
    judge("restart: a variable elsewhere", scene(VARIABLE % "2e-3" + "run 5", head=READ, folder=folder), T,
          "jump between runs")
    judge("restart: no motion given", scene("run 5", head=READ, folder=folder), "contact/tri", "motion by variables")
    for style in ("linear 0 0 0", "none"):
        prints("restart: %s stays where it was" % style,
               scene("fix_modify tool move %s\nrun 5\n" % style + ask("f_tool[7]"), head=READ, folder=folder), reached)
    scene("write_restart at.restart", folder=folder)
    judge("restart file of before the first run", scene("run 5", head=READ, folder=folder))


if __name__ == "__main__":
    jumps()
    heat()
    mistakes()
    values()
    restarts()
    restarts_by_variable()
    checks.end()
