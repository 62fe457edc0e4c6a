"""Malformed scripts: fix contact/tri and compute cutting/force. See bad_input.py."""
import os

from bad_input import GOOD, HEAT, JC, THREE_D, coeff, fine, run_all, warned, wrong
from sphtm_scene import SOURCE

T = "contact/tri tool"
MESH = os.path.join(SOURCE, "unittest", "meshes", "")
AWAY = "file @ascii.stl scale 1e-3 move 10e-3 0 0 "


def tool(text, more=""):
    return dict(THREE_D, more="fix tool all contact/tri %s\n%s" % (text.replace("@", MESH), more))


fine("tool", tool(AWAY))
fine("tool from VTK with motion", tool("file @poly_ascii_30.vtk scale 1e-3 move 10e-3 0 0 friction 0.3",
                                       "fix_modify tool move linear -1 0 0 ramp 1e-6"))
wrong("tool without mesh", tool("friction 0.3"), "contact/tri", "file insert.stl")
wrong("mesh missing", tool("file nowhere.stl"), T, "nowhere.stl", "cannot")
wrong("mesh is a folder", tool("file ."), T, "mesh file .", "directory")
wrong("mesh empty", tool("file @empty.stl"), T, "empty.stl", "empty")
wrong("mesh without triangles", tool("file @binary_none.stl"), T, "binary_none.stl", "no triangles")
wrong("mesh is a web page", tool("file @page.stl"), T, "page.stl", "web page", "save the file itself")
wrong("mesh is a text", tool("file @text.stl"), T, "text.stl")
wrong("mesh is an archive", tool("file @zip.stl"), T, "zip.stl")
wrong("mesh truncated, ASCII", tool("file @ascii_cut_facet.stl"), T, "ascii_cut_facet.stl", "line")
wrong("mesh truncated, binary", tool("file @binary_cut.stl"), T, "binary_cut.stl", "byte")
wrong("mesh with half a header", tool("file @binary_half_header.stl"), T, "binary_half_header.stl")
wrong("mesh with a NaN vertex", tool("file @ascii_nan.stl"), T, "ascii_nan.stl", "facet 2", "NaN")
wrong("mesh with a NaN vertex, binary", tool("file @binary_nan.stl"), T, "binary_nan.stl")
wrong("mesh with an infinite vertex", tool("file @ascii_inf.stl"), T, "ascii_inf.stl")
wrong("mesh of no area", tool("file @all_degenerate.stl"), T, "all_degenerate.stl", "area")
wrong("mesh in one point", tool("file @all_in_one_point.stl"), T, "all_in_one_point.stl")
wrong("mesh with a wrong word", tool("file @ascii_bad_word.stl"), T, "ascii_bad_word.stl", "line")
wrong("mesh of quadrangles", tool("file @quads.vtk"), T, "quads.vtk", "triang")
wrong("mesh cut, VTK", tool("file @cut_cells.vtk"), T, "cut_cells.vtk")
warned("mesh with a hole", tool("file @open.stl scale 1e-3 move 10e-3 0 0"), T, "open")
wrong("mesh inside out", tool("file @inside_out.stl scale 1e-3 move 10e-3 0 0"), T, "inside_out.stl", "flip yes",
      "flip no")
wrong("a good mesh, flipped", tool("file @ascii.stl scale 1e-3 move 10e-3 0 0 flip yes"), T, "leave out 'flip yes'")
fine("mesh inside out, flipped", tool("file @inside_out.stl scale 1e-3 move 10e-3 0 0 flip yes"))

# the words of fix surface/global
INPUT = AWAY.replace("file", "input stl 2 3")
for mols in "3", "*", "1*4", "1,3", "3*":
    fine("input stl, move " + mols, tool(INPUT, "fix_modify tool move %s linear -1 0 0 ramp 1e-6" % mols))
fine("file, move 1", tool(AWAY, "fix_modify tool move 1 linear -1 0 0"))
wrong("input stl, move of another surface", tool(INPUT, "fix_modify tool move 1,4* linear -1 0 0"), "contact/tri move 1,4*", "number 3")
wrong("input stl, move of no surface", tool(INPUT, "fix_modify tool move 5*4 linear -1 0 0"), "index 5 is out of bounds")
wrong("input stl, move without style", tool(INPUT, "fix_modify tool move 3"), "move")
wrong("input mol", tool("input mol lines"), "contact/tri input", "input stl type mol file", "got mol")
wrong("input alone", tool("input"), "contact/tri input", "got nothing")
wrong("input stl without a file", tool("input stl 1 1"), "contact/tri keyword input", "3 values")
wrong("input stl of type 0", tool(INPUT.replace("2 3", "0 3")), "contact/tri input", "type", "got 0")
wrong("two inputs", tool(INPUT + "input stl 1 1 @ascii.stl"), "contact/tri input", "fix contact/tri of its own")
wrong("a file behind an input", tool(INPUT + "file @ascii.stl"), "contact/tri file", "fix contact/tri of its own")
wrong("two files", tool(AWAY + "file @ascii.stl"), "contact/tri file", "fix contact/tri of its own")
wrong("a granular model", tool(INPUT + "model 1 1 hooke 1 1 1 1 0 1"), "contact/tri model", "penalty, damping, friction")

for first in "friction 0.2", "friction/table 300 0.3 900 0.1":
    for second in "friction 0.3", "friction/table 300 0.3 900 0.1":
        wrong("%s, then %s" % (first, second), tool(AWAY + first + " " + second), "contact/tri " + second.split()[0], "has been given before", "give it once")

# --- fix contact/tri: keywords ------------------------------------------------------------------------------

K = "contact/tri"
wrong("unknown tool keyword", tool(AWAY + "frictoin 0.3"), K, "frictoin", "known are", "friction")
wrong("tool keyword without value", tool(AWAY + "friction"), K, "friction", "1 value")
for key, count in (("file", "1 value"), ("move", "3 values"), ("lumped", "3 values"), ("reference", "3 values"),
                   ("vtk", "2 values"), ("local", "1 value"), ("temperature", "1 value"), ("heat", "none, perfect")):
    wrong("tool without the values of " + key, tool(AWAY + key), K, key, count)
wrong("scale with two values", tool("file @ascii.stl scale 1 2"), K, "scale", "3 values")
wrong("merge 1", tool(AWAY + "merge 1"), K, "merge", "0 to 0.01", "got 1")
wrong("smooth -1", tool(AWAY + "smooth -1"), K, "smooth", "0 to 90", "-1")
for bad in ("0", "-1", "0.5", "much"):
    wrong("maxsize " + bad, tool(AWAY + "maxsize " + bad), K, "maxsize", "MB", "1 to 1000000", bad)
wrong("flip perhaps", tool(AWAY + "flip perhaps"), K, "flip", "perhaps")
wrong("overlap perhaps", tool(AWAY + "overlap perhaps"), K, "overlap", "stop or allow", "perhaps")
wrong("reference nan", tool(AWAY + "reference 0 nan 0"), K, "reference", "nan")
wrong("local ten", tool(AWAY + "local ten"), K, "local", "integer", "ten")
wrong("vtk every 2.5 steps", tool(AWAY + "vtk 2.5 tool.*.vtk"), K, "vtk", "integer", "2.5")
wrong("particles by name", tool(AWAY + "particles steel"), K, "particles", "atom type", "steel")
wrong("effusivity -1", tool(AWAY + "effusivity -1"), K, "effusivity", "-1")
wrong("friction/table with an odd count", tool(AWAY + "friction/table 300 0.2 500"), K, "friction/table", "1 value")
wrong("friction/table with a negative coefficient", tool(AWAY + "friction/table 300 -0.2"), K, "friction/table", "-0.2")
wrong("scale 0", tool("file @ascii.stl scale 0"), K, "scale", "0")
wrong("scale nan", tool("file @ascii.stl scale nan"), K, "scale", "nan")
wrong("scale a word", tool("file @ascii.stl scale small"), K, "scale", "small")
wrong("move with two values", tool("file @ascii.stl move 1 2"), K, "move", "3 values")
wrong("move inf", tool("file @ascii.stl move inf 0 0"), K, "move", "inf")
wrong("rotate without axis", tool("file @ascii.stl rotate 0 0 1 90"), K, "rotate", "axis", "angle")
wrong("rotate about nothing", tool("file @ascii.stl rotate axis 0 0 0 angle 90"), K, "rotate", "zero")
wrong("rotate by nan", tool("file @ascii.stl rotate axis 0 0 1 angle nan"), K, "rotate", "nan")
for bad in ("-0.3", "nan", "inf"):
    wrong("tool friction " + bad, tool(AWAY + "friction " + bad), K, "friction", bad)
wrong("friction/table falling", tool(AWAY + "friction/table 500 0.3 300 0.2"), K, "friction/table", "increase")
wrong("friction/table without pairs", tool(AWAY + "friction/table damping 0.1"), K, "friction/table", "T1 mu1")
wrong("friction/shear alone", tool(AWAY + "friction/shear 0.5"), K, "friction/shear", "0.5", "give friction")
wrong("friction/shear 2", tool(AWAY + "friction/shear 2"), K, "friction/shear", "2")
for bad in ("0", "-1", "nan", "inf"):
    wrong("tool penalty " + bad, tool(AWAY + "penalty " + bad), K, "penalty", bad)
wrong("tool damping -1", tool(AWAY + "damping -1"), K, "damping", "-1")
wrong("approach perhaps", tool(AWAY + "approach perhaps"), K, "approach", "perhaps")
wrong("approach yes layer strains", tool(AWAY + "approach yes layer strains"), "Fix contact/tri", "approach yes", "layer strains")
wrong("layer soft", tool(AWAY + "layer soft"), K, "layer", "soft")
wrong("method f15 layer strains", tool(AWAY + "method f15 layer strains"), K, "layer", "f15")
wrong("method guess", tool(AWAY + "method guess"), K, "method", "closest or f15", "guess")
wrong("sides three", tool(AWAY + "sides three"), K, "sides", "one or two", "three")
wrong("tool heat some", tool(AWAY + "heat some"), K, "heat", "perfect or conductance", "some")
wrong("tool conductance -1", tool(AWAY + "heat conductance -1"), K, "heat", "-1")
wrong("tool temperature -5", tool(AWAY + "temperature -5"), K, "temperature", "-5")
wrong("tool share 2", tool(AWAY + "share 2"), K, "share", "2")
wrong("tool material without heat capacity", tool(AWAY + "material 50 7800"), K, "material", "3")
wrong("tool material of no density", tool(AWAY + "material 50 0 460"), K, "material", "density", "0")
wrong("tool share and material", tool(AWAY + "share 0.5 material 50 7800 460"), K, "share", "material")
wrong("tool share and effusivity", tool(AWAY + "share 0.5 effusivity 1000"), K, "share or effusivity")
wrong("tool lumped 0", tool(AWAY + "lumped 0 500 300"), K, "lumped", "0")
wrong("tool heat without heat constants", tool(AWAY + "heat perfect"), "heat is on", "fix contact/tri tool", "type 1",
      "heat k cp chi")
wrong("tool particles of no type", dict(tool(AWAY + "particles 7"), **coeff(JC + HEAT)), K, "particles", "7")
wrong("tool particles that are no heat body", dict(tool(AWAY + "particles 1"), **coeff(JC + HEAT)), K, "particles",
      "type 1")
wrong("vtk without a star", tool(AWAY + "vtk 10 tool.vtk"), K, "vtk", "tool.vtk", "*")
wrong("vtk every 0 steps", tool(AWAY + "vtk 0 tool.*.vtk"), K, "vtk", "0")
wrong("vtk into a folder that is not there", tool(AWAY + "vtk 1 nowhere/tool.*.vtk"), K, "nowhere/tool")
wrong("vtk as XML, two stars", tool(AWAY + "vtk 10 tool.*.*.vtp"), T, "vtk", "tool.*.*.vtp", "more than one *")
wrong("vtk as XML into a folder that is not there", tool(AWAY + "vtk 1 nowhere/tool.*.vtp"), T, "nowhere/tool")
fine("vtk as XML", tool(AWAY + "vtk 1 tool.*.vtp"))
wrong("unknown motion", tool(AWAY, "fix_modify tool move forward 1 0 0"), K, "move", "forward", "linear")
wrong("motion with two values", tool(AWAY, "fix_modify tool move linear 1 0"), K, "move linear", "Vx Vy Vz")
wrong("motion nan", tool(AWAY, "fix_modify tool move linear nan 0 0"), K, "move linear", "nan")
wrong("wiggle with period 0", tool(AWAY, "fix_modify tool move wiggle 1 0 0 0"), K, "wiggle", "period")
wrong("rotation about nothing", tool(AWAY, "fix_modify tool move rotate 0 0 0 0 0 0 1"), K, "rotate", "axis")
wrong("motion by no variable", tool(AWAY, "fix_modify tool move variable v_a NULL NULL NULL NULL NULL"), K,
      "variable a")
wrong("motion by an atom variable",
      tool(AWAY, "variable a atom x\nfix_modify tool move variable v_a NULL NULL NULL NULL NULL"),
      K, "variable a", "equal-style")
wrong("ramp without value", tool(AWAY, "fix_modify tool move linear 1 0 0 ramp"), K, "move linear", "ramp", "1 value")
wrong("ramp -1", tool(AWAY, "fix_modify tool move linear 1 0 0 ramp -1"), K, "ramp", "-1")
wrong("tool before the state", dict(tool(AWAY), fix="", more="fix tool all contact/tri " + AWAY.replace("@", MESH)
                                    + "\nfix body all sph/tm"), K, "after fix body sph/tm")
wrong("tool without the state", dict(tool(AWAY), fix="", compute="", pair_style="pair_style zero 3e-3",
                                     pair_coeff="pair_coeff * *\nmass 1 1"), K, "fix body all sph/tm")
wrong("tool in 2D that is not extruded", {"more": "fix tool all contact/tri " + AWAY.replace("@", MESH)}, K, "2d",
      "extruded", "scale", "ascii.stl")

# --- fix contact/tri: speeds, groups, heat that goes nowhere ------------------------------------------------------

for words, says in (("linear 1e300 0 0", "1e+300"), ("linear 0 0 -1e5", "100000"),
                    ("wiggle 1e-3 0 0 1e-9", "ten times"), ("rotate 0 0 0 0 0 1 1e-8", "ten times"),
                    ("transrot 1e9 0 0 0 0 0 0 0 1 1", "ten times"),
                    ("rotate 0 0 0 0 0 1 1e-308", "not a finite number")):
    wrong("tool that moves " + words, tool(AWAY, "fix_modify tool move " + words), T, "speed", says, "units")
fine("tool at 5 km/s", tool(AWAY, "fix_modify tool move linear 5e3 0 0"))
GROUP = "group some dynamic all every 1\nfix tool some contact/tri " + AWAY.replace("@", MESH)
wrong("tool with a dynamic group", dict(THREE_D, more=GROUP), "contact/tri", "dynamic group")
NOBODY = "group nobody empty\nfix tool nobody contact/tri " + AWAY.replace("@", MESH)
warned("tool with an empty group", dict(THREE_D, more=NOBODY), T, "group nobody", "no particles")
warned("particles that only conduct", dict(tool(AWAY + "heat conductance 100"), **coeff("density 2700 body heat" + HEAT)), T,
       "type 1", "only conduct heat", "sph/tm/heat")
warned("tool far away", tool("file @ascii.stl scale 1e-3 move 1 0 0"), T, "away from the simulation box", "units")
warned("tool in other units", tool("file @ascii.stl move 10 0 0 overlap allow"), T, "simulation box", "units")
warned("share without heat constants", tool(AWAY + "friction 0.3 share 0.4"), T, "share has no use", "type 1",
       "no heat constants")
warned("effusivity without heat constants", tool(AWAY + "effusivity 5000"), T, "effusivity has no use", "type 1")
fine("friction without heat constants", tool(AWAY + "friction 0.3"))
fine("friction with heat constants", dict(tool(AWAY + "friction 0.3"), **coeff(GOOD + HEAT)))
FORCED = dict(tool(AWAY + "friction 0.3"), fix="fix body all sph/tm effects heat off", **coeff(GOOD + HEAT))
warned("friction with heat forced off", FORCED, T, "heat is forced off", "friction warms nothing")
warned("share with heat forced off", dict(FORCED, more=FORCED["more"].replace("friction 0.3", "share 0.3")), T,
       "heat is forced off", "share has no use")
MIXED = dict(tool(AWAY + "friction 0.3"), create_box="create_box 2 box", **coeff(GOOD + HEAT))
MIXED["pair_coeff"] += "\npair_coeff 2 2 " + GOOD + "\npair_coeff 1 2 none"
warned("friction with a type that has no heat constants", MIXED, T, "friction warms nothing", "type 2",
       "no heat constants")

# --- fix contact/tri: overlap at the start; the mesh is the octahedron or wedge of unittest/meshes -------------

wrong("tool overlaps the work", tool("file @ascii.stl scale 2e-3 move 4.2e-3 1.5e-3 1.5e-3"), T, "overlaps", "by ",
      "along", "move it by that along +x", "particle", "overlap allow")
wrong("tool swallows the work", tool("file @ascii.stl scale 60e-3 move -5e-3 -5e-3 -5e-3"), T, "overlaps",
      "overlap allow")
fine("tool moved by what the message says", tool("file @ascii.stl scale 2e-3 move 5.006e-3 1.5e-3 1.5e-3"))
wrong("tool moved by a little less", tool("file @ascii.stl scale 2e-3 move 4.985e-3 1.5e-3 1.5e-3"), T, "overlaps",
      "+x")
fine("tool overlaps the work and may",
     tool("file @ascii.stl scale 2e-3 move 4.2e-3 1.5e-3 1.5e-3 overlap allow penalty 0.001"))

# --- compute cutting/force -----------------------------------------------------------------------------------


def cut(text):
    return dict(tool(AWAY, "fix_modify tool move linear -1 0 0"), compute="compute p all cutting/force " + text,
                thermo="thermo 5\nthermo_style custom step c_p[1]")


U = "cutting/force"
fine("cutting force", cut("tool"))
wrong("cutting force without tool", cut(""), U)
wrong("cutting force of no tool", cut("body"), U, "body", "fix contact/tri")
wrong("cutting force keyword", cut("tool depth 1"), U, "depth", "direction")
wrong("cutting direction 0", cut("tool direction 0 0 0"), U, "direction", "zero")
wrong("cutting direction nan", cut("tool direction 1 nan 0"), U, "direction", "nan")
wrong("cutting away with two values", cut("tool away 0 1"), U, "away", "3 values")
wrong("cutting width without value", cut("tool width"), U, "width", "1 value")
wrong("cutting width -1", cut("tool width -1"), U, "width", "-1")

run_all()
