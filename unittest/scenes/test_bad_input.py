"""A corpus of malformed scripts: each must stop before step 0 (or warn), and say what is wrong, where, and what to
write instead.

Each case is a name, the lines that take the place of lines of a good script, and the fragments that the message must
hold. A line is known by its label; an empty text removes it. 'wrong' cases must fail before the first step, 'warned'
cases must run to the end with the fragments in a WARNING, 'fine' cases must run without one.

    test_bad_input.py [word...]    only cases whose name holds one of the words; -v shows every message
"""
import os
import re
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

from sphtm_scene import SOURCE, Checks, Result, new_folder, run

BASE = {
    "units": "units si",
    "dimension": "dimension 2",
    "boundary": "boundary f f p",
    "atom_style": "atom_style atomic",
    "newton": "newton off",
    "lattice": "lattice sq 1e-3 origin 0.5 0.5 0",
    "box": "region box block -5e-3 15e-3 -5e-3 15e-3 -0.5e-3 0.5e-3 units box",
    "create_box": "create_box 1 box",
    "work": "region work block 0 8e-3 0 8e-3 INF INF units box",
    "atoms": "create_atoms 1 region work",
    "pair_style": "pair_style sph/tm hyperbolic 1.2 spacing 1e-3",
    "pair_coeff": "pair_coeff 1 1 density 2700 elastic 70e9 0.33 strength plastic 300e6 1e9",
    "fix": "fix body all sph/tm",
    "more": "",
    "compute": "compute p all sph/tm/atom pstrain",
    "thermo": "thermo 5",
    "run": "run 5",
}
GOOD = "density 2700 elastic 70e9 0.33"
JC = GOOD + " strength johnson/cook 428e6 327e6 1.008 0.01 1.31 293 855 1.0"
HEAT = " heat 200 900 0.9"
TWO = {"create_box": "create_box 2 box"}
THREE_D = {"dimension": "dimension 3", "boundary": "boundary f f f", "lattice": "lattice sc 1e-3 origin 0.5 0.5 0.5",
           "box": "region box block -5e-3 15e-3 -5e-3 15e-3 -5e-3 15e-3 units box",
           "work": "region work block 0 5e-3 0 5e-3 0 5e-3 units box"}
CARD = """material one
  density 2700
  elastic 70e9 0.33
  strength johnson/cook 428e6 327e6 1.008 0.01 1.31 293 855 1.0
  heat 200 900 0.9
end
"""
CASES = []


def case(kind, name, lines, *fragments, files=None, env=None, first=None):
    CASES.append((kind, name, lines, fragments, files or {}, env or {}, first))


def wrong(name, lines, *fragments, **more):
    case("wrong", name, lines, *fragments, **more)


def warned(name, lines, *fragments, **more):
    case("warned", name, lines, *fragments, **more)


def fine(name, lines, **more):
    case("fine", name, lines, **more)


def style(text):
    return {"pair_style": "pair_style sph/tm " + text}


def coeff(text):
    return {"pair_coeff": "pair_coeff 1 1 " + text}


def fix(text):
    return {"fix": "fix body all sph/tm " + text}


# --- the base script itself, and its variants used below ----------------------------------------------------

fine("base script", {})
fine("base script in 3D", THREE_D)
fine("two types with materials", dict(TWO, more="pair_coeff 2 2 " + GOOD))
fine("material from a card", coeff("cards.sphtm one"), files={"cards.sphtm": CARD})

# --- pair_style ---------------------------------------------------------------------------------------------

S = "sph/tm"
wrong("pair_style without arguments", style(""), S, "kernel", "spacing")
wrong("pair_style with a kernel only", style("hyperbolic"), S, "spacing")
wrong("unknown kernel", style("gauss 1.2 spacing 1e-3"), S, "kernel", "gauss", "hyperbolic", "wendland/c4")
for bad in ("0", "-1.2", "nan", "inf", "0.5", "20", "abc"):
    wrong("ratio " + bad, style("hyperbolic %s spacing 1e-3" % bad), S if bad != "abc" else "", bad)
wrong("no spacing", style("hyperbolic 1.2 xsph 0.5"), S, "spacing")
wrong("spacing without value", style("hyperbolic 1.2 spacing"), S, "spacing")
wrong("spacing twice without value", style("hyperbolic 1.2 spacing 1e-3 spacing"), S, "spacing", "1 value")
for bad in ("0", "-1e-3", "nan", "inf"):
    wrong("spacing " + bad, style("hyperbolic 1.2 spacing " + bad), S, "spacing", "positive", bad)
wrong("unknown pair_style keyword", style("hyperbolic 1.2 spacing 1e-3 viscous 1 1"), S, "viscous", "known are", "viscosity")
wrong("viscosity with one value", style("hyperbolic 1.2 spacing 1e-3 viscosity 1"), S, "viscosity", "2 values")
wrong("negative viscosity", style("hyperbolic 1.2 spacing 1e-3 viscosity -1 1"), S, "viscosity alpha", "-1", ">= 0")
wrong("viscosity beta nan", style("hyperbolic 1.2 spacing 1e-3 viscosity 1 nan"), S, "viscosity beta", "nan")
wrong("artstress 2", style("hyperbolic 1.2 spacing 1e-3 artstress 2 4"), S, "artstress", "0 to 1", "2")
wrong("artstress exponent 0", style("hyperbolic 1.2 spacing 1e-3 artstress 0.3 0"), S, "artstress exponent", "1 to 8", "0")
wrong("artstress exponent 2.5", style("hyperbolic 1.2 spacing 1e-3 artstress 0.3 2.5"), "2.5", "integer")
wrong("artstress with a wrong form", style("hyperbolic 1.2 spacing 1e-3 artstress 0.3 4 principle"), S, "principle")
wrong("xsph 1.5", style("hyperbolic 1.2 spacing 1e-3 xsph 1.5"), S, "xsph", "0 to 1", "1.5")
wrong("precision single", style("hyperbolic 1.2 spacing 1e-3 precision single"), S, "precision", "double or mixed", "single")
wrong("form f16", style("hyperbolic 1.2 spacing 1e-3 form f16"), S, "form", "f15 or f14", "f16")
wrong("balsara perhaps", style("hyperbolic 1.2 spacing 1e-3 balsara perhaps"), "perhaps")
wrong("correction with form f14", style("hyperbolic 1.2 spacing 1e-3 correction yes form f14"), S, "correction", "form f15")
wrong("plane bend", style("hyperbolic 1.2 spacing 1e-3 plane bend"), S, "plane", "strain or stress", "bend")
wrong("plane stress in 3D", dict(THREE_D, **style("hyperbolic 1.2 spacing 1e-3 plane stress")), S, "plane stress", "dimension 2")
warned("spacing far below the lattice", style("hyperbolic 1.2 spacing 0.1e-3"), S, "spacing", "0.0001", "no particle has a neighbor")
warned("spacing below the lattice", style("hyperbolic 1.2 spacing 0.6e-3"), S, "spacing", "0.0006", "0.001")
warned("spacing above the lattice", style("hyperbolic 1.2 spacing 2e-3"), S, "spacing", "0.002", "0.001")
wrong("spacing in another unit", style("hyperbolic 1.2 spacing 1"), S, "spacing 1", "area of 64", "0.0004")
wrong("/kk without Kokkos", {"pair_style": "pair_style sph/tm/kk hyperbolic 1.2 spacing 1e-3"}, "sph/tm/kk", "KOKKOS")
wrong("fix /kk", {"fix": "fix body all sph/tm/kk"}, "sph/tm/kk", "sph/tm")
wrong("compute /kk without Kokkos", {"compute": "compute p all sph/tm/atom/kk pstrain"}, "sph/tm/atom/kk", "KOKKOS")

# --- pair_coeff: constants ----------------------------------------------------------------------------------

C = "sph/tm coeff"
wrong("pair_coeff before pair_style", {"pair_style": "", "more": ""}, "pair_coeff", "without a pair style")
wrong("pair_coeff without material", coeff(""), "sph/tm", "material")
wrong("unknown material keyword", coeff(GOOD + " colour red"), C, "colour", "known are", "strength")
wrong("density missing", coeff("elastic 70e9 0.33"), C, "density")
wrong("elastic missing", coeff("density 2700"), C, "elastic")
wrong("elastic with one value", coeff("density 2700 elastic 70e9"), C, "elastic", "missing")
wrong("elastic with one value, then a keyword", coeff("density 2700 elastic 70e9 strength elastic"), C, "elastic", "too few")
wrong("elastic with three values", coeff("density 2700 elastic 70e9 0.33 5"), C, "elastic", "2 values", "5")
wrong("keyword twice", coeff(GOOD + " density 2800"), C, "density", "twice")
for bad in ("-2700", "0", "nan", "inf", "-inf", "1e999"):
    wrong("density " + bad, coeff("density %s elastic 70e9 0.33" % bad), C, "density", bad)
for bad in ("-70e9", "0", "nan"):
    wrong("young " + bad, coeff("density 2700 elastic %s 0.33" % bad), C, "elastic", bad)
for bad in ("0.5", "0.6", "-1", "nan"):
    wrong("poisson " + bad, coeff("density 2700 elastic 70e9 " + bad), C, "poisson", "below 0.5" if bad != "nan" else "number", bad)
wrong("density as a word", coeff("density heavy elastic 70e9 0.33"), C, "density", "heavy", "number")
wrong("unknown strength", coeff(GOOD + " strength steel"), C, "strength", "steel", "johnson/cook")
wrong("strength without kind", coeff(GOOD + " strength"), C, "strength", "johnson/cook", "nothing")
wrong("negative yield", coeff(GOOD + " strength plastic -1 0"), C, "yield", "-1")
wrong("johnson/cook with seven values", coeff(GOOD + " strength johnson/cook 4e8 3e8 1 0.01 1.3 293 855"), C, "johnson/cook",
      "missing")
wrong("johnson/cook melts below its reference", coeff(GOOD + " strength johnson/cook 4e8 3e8 1 0.01 1.3 293 200 1"), C,
      "t_melt", "t_ref", "293")
wrong("johnson/cook rate0 0", coeff(GOOD + " strength johnson/cook 4e8 3e8 1 0.01 1.3 293 855 0"), C, "rate0", "0")
wrong("unknown eos", coeff(GOOD + " eos ideal"), C, "eos", "ideal", "shock")
wrong("shock c0 0", coeff(GOOD + " eos shock 0 1.4 2"), C, "c0", "0")
wrong("tait without exponent", coeff(GOOD + " eos tait"), C, "tait", "missing")
wrong("damage of an elastic material", coeff(GOOD + " damage strain 0.3"), C, "damage", "plastic")
wrong("damage strain negative", coeff(JC + " damage strain -0.3"), C, "strain_max", "-0.3")
wrong("heat with two values", coeff(JC + " heat 200 900"), C, "heat", "missing")
wrong("negative conductivity", coeff(JC + " heat -200 900 0.9"), C, "conductivity", "-200")
wrong("capacity 0", coeff(JC + " heat 200 0 0.9"), C, "capacity", "0")
wrong("Taylor-Quinney 1.5", coeff(JC + " heat 200 900 1.5"), C, "taylor_quinney", "1.5")
wrong("table too long", coeff(JC + " heat table/99 1 1 900 0.9"), C, "table", "99")
wrong("table that does not increase", coeff(JC + " heat table/2 400 1 300 2 900 0.9"), C, "table", "increasing", "300")
wrong("table that ends early", coeff(JC + " heat table/3 300 1 400 2"), C, "table")
wrong("emissivity 2", coeff(JC + HEAT + " emissivity 2"), C, "emissivity", "2")
wrong("emissivity without heat", coeff(GOOD + " emissivity 0.5"), C, "emissivity", "heat")
wrong("body liquid", coeff(GOOD + " body liquid"), C, "body", "liquid", "solid")
wrong("heat body without heat constants", coeff(GOOD + " body heat"), C, "body heat", "heat k cp chi")
wrong("set of an unknown constant", coeff(JC + " set jc_q 0"), C, "jc_q", "jc_c")
wrong("set of a constant that is not there", coeff(GOOD + " set jc_c 0"), C, "jc_c", "johnson/cook")
wrong("set without value", coeff(JC + " set jc_c"), C, "jc_c", "missing")
wrong("set twice", coeff(JC + " set jc_c 0 set jc_c 1"), C, "jc_c", "twice")

# --- pair_coeff: cards --------------------------------------------------------------------------------------

wrong("card file missing", coeff("nowhere.sphtm one"), C, "nowhere.sphtm", "SPHTM_MATERIALS")
wrong("card unknown", coeff("cards.sphtm two"), C, "two", "cards.sphtm", "one", files={"cards.sphtm": CARD})
wrong("card file without a name", coeff("cards.sphtm"), C, "cards.sphtm", files={"cards.sphtm": CARD})
wrong("card without end", coeff("cards.sphtm one"), C, "one", "end", files={"cards.sphtm": CARD.replace("end\n", "")})
wrong("card with a wrong keyword", coeff("cards.sphtm one"), C, "cards.sphtm line 3", "elastik",
      files={"cards.sphtm": CARD.replace("elastic", "elastik")})
wrong("card with a negative constant", coeff("cards.sphtm one"), C, "line 2", "density", "-2700",
      files={"cards.sphtm": CARD.replace("2700", "-2700")})
wrong("card with a wrong count", coeff("cards.sphtm one"), C, "line 3", "elastic", "missing",
      files={"cards.sphtm": CARD.replace("70e9 0.33", "70e9")})
wrong("card file that is empty", coeff("cards.sphtm one"), C, "one", "cards.sphtm", files={"cards.sphtm": ""})
wrong("card file that is a web page", coeff("cards.sphtm one"), C, "cards.sphtm line 1", "material",
      files={"cards.sphtm": "<html><body>404 not found</body></html>\n"})
wrong("card in units lj", dict(coeff("cards.sphtm one"), units="units lj"), C, "SI", "lj", files={"cards.sphtm": CARD})

# --- pair_coeff: types --------------------------------------------------------------------------------------

wrong("no material for type 2", TWO, S, "type 2", "pair_coeff 2 2")
wrong("no material at all", {"pair_coeff": ""}, "pair coeffs are not set")
wrong("type out of range", {"pair_coeff": "pair_coeff 3 3 " + GOOD}, "3")
wrong("material for two different types", dict(TWO, more="pair_coeff 1 2 " + GOOD), C, "1 2", "pair_coeff 2 2")
wrong("meeting of one type", {"more": "pair_coeff 1 1 contact friction 0.3"}, C, "contact", "two different types")
both = dict(TWO, more="pair_coeff 2 2 " + GOOD + "\npair_coeff 1 2 ")
wrong("unknown contact keyword", dict(both, more=both["more"] + "contact mu 0.3"), C, "contact", "mu", "friction")
wrong("negative friction", dict(both, more=both["more"] + "contact friction -0.3"), C, "friction", "-0.3")
wrong("penalty 0", dict(both, more=both["more"] + "contact penalty 0"), C, "penalty", "0")
wrong("contact keyword without value", dict(both, more=both["more"] + "contact penalty"), C, "penalty", "value")
wrong("conductance of a bond", dict(both, more=both["more"] + "bond conductance 5"), C, "bond", "conductance")
wrong("conductance negative", dict(both, more=both["more"] + "heat conductance -5"), C, "conductance", "-5")
wrong("bond with a heat body", dict(TWO, more="pair_coeff 2 2 " + GOOD + HEAT + " body heat\npair_coeff 1 2 bond"), "sph/tm",
      "heat body", "'heat' or 'none'")

# --- fix ----------------------------------------------------------------------------------------------------

F = "sph/tm"
wrong("pair without fix", {"fix": "", "compute": ""}, S, "fix", "fix body all sph/tm")
wrong("fix without pair", {"pair_style": "", "pair_coeff": "", "more": "mass 1 1"}, "fix sph/tm", "pair style sph/tm")
wrong("fix with another pair style", {"pair_style": "pair_style zero 3e-3", "pair_coeff": "pair_coeff * *",
                                     "more": "mass 1 1"}, "Fix sph/tm", "pair style sph/tm")
wrong("two fixes", {"more": "fix again all sph/tm"}, "fix sph/tm", "More than one")
wrong("fix of an unknown group", {"fix": "fix body some sph/tm"}, "group", "some")
wrong("unknown fix keyword", fix("temprature 300"), F, "temprature", "known are", "temperature")
wrong("temperature without value", fix("temperature"), F, "temperature", "1 value")
for bad in ("0", "-5", "nan", "inf"):
    wrong("temperature " + bad, fix("temperature " + bad), F, "temperature", bad)
for bad in ("0", "-0.4", "1.5", "nan"):
    wrong("courant " + bad, fix("courant " + bad), F, "courant", bad)
for bad in ("0", "-1e-8", "nan", "inf"):
    wrong("dt " + bad, fix("dt " + bad), F, "dt", bad)
wrong("dt/max 0", fix("dt/max 0"), F, "dt/max", "0")
wrong("unstable time step", fix("dt 1e-6"), F, "dt 1e-06", "not stable", "dt auto")
wrong("unstable time step of conduction", dict(coeff(JC + " heat 2e8 900 0.9"), fix="fix body all sph/tm dt 2e-8"), F,
      "dt 2e-08", "not stable", "conduction", "dt auto")
wrong("lost perhaps", fix("lost perhaps"), F, "lost", "perhaps", "error or ignore")
wrong("audit without values", fix("audit"), F, "audit", "1 value")
wrong("audit with one number", fix("audit 100"), F, "audit", "2 values")
wrong("audit perhaps", fix("audit perhaps"), F, "audit", "perhaps")
for bad in "0 10", "-5 10", "1.5 10", "1e3 10", "two 10":
    wrong("audit " + bad, fix("audit " + bad), F, "audit N", bad.split()[0])
for bad in "10 0", "10 -3", "10 2.5", "10 many", "10 2000000":
    wrong("audit " + bad, fix("audit " + bad), F, "audit M", bad.split()[1])
wrong("energy perhaps", fix("energy perhaps"), "perhaps")
wrong("unknown effect", fix("effects fracture on"), F, "fracture", "damage")
wrong("effect without value", fix("effects heat"), F, "effects", "2 values")
wrong("effect perhaps", fix("effects heat perhaps"), "perhaps")
wrong("effect on and off", fix("effects heat on effects heat off"), F, "heat", "on and off")
wrong("conduction without heat", fix("effects conduction on"), F, "conduction", "heat is off")
wrong("correction forced on with form f14", dict(style("hyperbolic 1.2 spacing 1e-3 form f14"),
                                                 **fix("effects correction on")), F, "correction", "form f15")
wrong("balsara without viscosity", dict(style("hyperbolic 1.2 spacing 1e-3 viscosity 0 0"), **fix("effects balsara on")), F,
      "balsara", "viscosity")
wrong("heat on, but one type has no heat constants", dict(TWO, **dict(coeff(JC + HEAT), more="pair_coeff 2 2 " + GOOD)), F,
      "type 2", "heat k cp chi")
wrong("heat forced on without constants", fix("effects heat on"), F, "type 1", "heat k cp chi")
wrong("respa", {"more": "run_style respa 2 2 pair 2"}, F, "respa")
wrong("minimize", {"run": "minimize 0 1e-6 10 10"}, F, "minimize")
wrong("fix_modify temperature of an unknown group", {"more": "fix_modify body temperature hot 500"}, F, "hot")
wrong("fix_modify temperature without value", {"more": "fix_modify body temperature all"}, F, "temperature")
for bad in ("-5", "nan", "inf"):
    wrong("fix_modify temperature " + bad, dict(coeff(JC + HEAT), more="fix_modify body temperature all " + bad), F,
          "temperature", bad)
wrong("fix_modify unknown", {"more": "fix_modify body colour red"}, "fix_modify", "colour")

# --- fix adapt/neigh refine ----------------------------------------------------------------------------------

AN = "adapt/neigh"
PATTERN = "refine square epsilon 0.4 alpha 0.6 "


def adapt(text, before=""):
    return {"more": before + "\nfix ad all adapt/neigh " + text}


fine("refine", adapt(PATTERN + "when pstrain above 0.1 and not region work or gradient vonmises above 1e9 level 2 every 10"))
fine("refine and coarsen", adapt(PATTERN + "when neighbors below 3 coarsen when pstrain below 1 or c_k[2] below 5",
                                 "compute k all property/atom x y"))
wrong("refine without pattern", adapt("refine"), AN, "refine", "square", "icosahedron")
wrong("refine with an unknown pattern", adapt("refine triangle epsilon 1 alpha 1 when neighbors above 1"), AN, "triangle", "hexagon")
wrong("refine with a pattern of 3D", adapt("refine cube epsilon 0.5 alpha 0.6 when neighbors above 1"), AN, "cube", "3 dimensions")
wrong("refine twice", adapt((PATTERN + "when pstrain above 0.1 ") * 2), AN, "refine", "twice")
wrong("refine without epsilon", adapt("refine square alpha 0.6 when neighbors above 1"), AN, "epsilon", "smoothing lengths")
wrong("refine without alpha", adapt("refine square epsilon 0.5 when neighbors above 1"), AN, "alpha")
wrong("refine without when", adapt(PATTERN), AN, "refine square", "when")
for bad in ("0", "-1", "nan"):
    wrong("refine epsilon " + bad, adapt("refine square epsilon %s alpha 0.6 when neighbors above 1" % bad), AN, "epsilon", bad)
for bad in ("0", "1.1", "nan"):
    wrong("refine alpha " + bad, adapt("refine square epsilon 0.4 alpha %s when neighbors above 1" % bad), AN, "alpha", bad)
wrong("refine with a negative mass", adapt("refine hexagon epsilon 0.3 alpha 0.8 when neighbors above 1"), AN, "hexagon", "0.3", "0.8",
      "hyperbolic", "negative", "-0.62", "larger epsilon")
wrong("refine with no mass for the corners", adapt("refine hexagon epsilon 0.6 alpha 1 when neighbors above 1"), AN, "all but one", "no mass", "smaller alpha")
wrong("refine with coinciding children", adapt("refine hexagon epsilon 1e-7 alpha 0.8 when neighbors above 1"), AN, "close together")
wrong("refine level 0", adapt(PATTERN + "when neighbors above 1 level 0"), AN, "level", "1 to 8")
wrong("refine every 0", adapt(PATTERN + "when neighbors above 1 every 0"), AN, "every", "0")
wrong("refine velocity own", adapt(PATTERN + "when neighbors above 1 velocity own"), AN, "velocity", "parent or linear", "own")
wrong("criterion that ends", adapt(PATTERN + "when pstrain"), AN, "refine when", "above or below")
wrong("criterion without limit", adapt(PATTERN + "when pstrain above"), AN, "refine when", "a limit")
wrong("criterion with a bad limit", adapt(PATTERN + "when pstrain above much"), AN, "pstrain above", "much")
wrong("criterion over", adapt(PATTERN + "when pstrain over 0.1"), AN, "above or below", "over")
wrong("criterion after and", adapt(PATTERN + "when pstrain above 0.1 and"), AN, "a criterion")
wrong("criterion of an unknown value", adapt(PATTERN + "when strain above 0.1"), AN, "strain", "c_ID", "compute sph/tm/atom")
wrong("criterion of no region", adapt(PATTERN + "when region elsewhere"), AN, "region elsewhere")
wrong("criterion of no compute", adapt(PATTERN + "when c_none above 0.1"), AN, "compute none")
wrong("criterion of a column too many", adapt(PATTERN + "when c_k[3] above 0.1", "compute k all property/atom x y"), AN, "k[n]", "2")
wrong("criterion of an array without column", adapt(PATTERN + "when c_k above 0.1", "compute k all property/atom x y"), AN, "k[n]")
wrong("criterion of a global compute", adapt(PATTERN + "when c_thermo_temp above 0.1"), AN, "thermo_temp", "no values of particles")
wrong("criterion of an equal variable", adapt(PATTERN + "when v_a above 0.1", "variable a equal 1"), AN, "variable a", "style atom")
wrong("criterion of no fix", adapt(PATTERN + "when f_none above 0.1"), AN, "fix none")
wrong("criterion of a fix at other steps", adapt(PATTERN + "when f_a above 0.1 every 10", "fix a all ave/atom 1 5 15 vx"), AN, "fix a", "15", "10")
wrong("coarsen without refine", adapt("coarsen fallen"), AN, "coarsen", "refine")
wrong("coarsen alone", adapt(PATTERN + "when neighbors above 1 coarsen"), AN, "coarsen", "fallen")
wrong("coarsen never", adapt(PATTERN + "when neighbors above 1 coarsen never"), AN, "coarsen", "never")

# --- fix contact/tri: meshes (unittest/meshes tests the reader itself) ---------------------------------------

T = "contact/tri tool"
MESH = os.path.join(SOURCE, "unittest", "meshes", "")


def tool(text, more=""):
    return dict(THREE_D, more="fix tool all contact/tri %s\n%s" % (text.replace("@", MESH), more))


AWAY = "file @ascii.stl scale 1e-3 move 10e-3 0 0 "
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
wrong("mesh inside out", tool("file @inside_out.stl scale 1e-3 move 10e-3 0 0"), T, "inside_out.stl", "flip yes", "flip no")
fine("mesh inside out, flipped", tool("file @inside_out.stl scale 1e-3 move 10e-3 0 0 flip yes"))

# --- fix contact/tri: keywords ------------------------------------------------------------------------------

K = "contact/tri"
wrong("unknown tool keyword", tool(AWAY + "frictoin 0.3"), K, "frictoin", "known are", "friction")
wrong("tool keyword without value", tool(AWAY + "friction"), K, "friction", "1 value")
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
wrong("friction/shear 2", tool(AWAY + "friction/shear 2"), K, "friction/shear", "2")
for bad in ("0", "-1", "nan", "inf"):
    wrong("tool penalty " + bad, tool(AWAY + "penalty " + bad), K, "penalty", bad)
wrong("tool damping -1", tool(AWAY + "damping -1"), K, "damping", "-1")
wrong("approach perhaps", tool(AWAY + "approach perhaps"), K, "approach", "perhaps")
wrong("method guess", tool(AWAY + "method guess"), K, "method", "closest or f15", "guess")
wrong("sides three", tool(AWAY + "sides three"), K, "sides", "one or two", "three")
wrong("tool heat some", tool(AWAY + "heat some"), K, "heat", "perfect or conductance", "some")
wrong("tool conductance -1", tool(AWAY + "heat conductance -1"), K, "heat", "-1")
wrong("tool temperature -5", tool(AWAY + "temperature -5"), K, "temperature", "-5")
wrong("tool share 2", tool(AWAY + "share 2"), K, "share", "2")
wrong("tool share and effusivity", tool(AWAY + "share 0.5 effusivity 1000"), K, "share or effusivity")
wrong("tool lumped 0", tool(AWAY + "lumped 0 500 300"), K, "lumped", "0")
wrong("tool heat without heat constants", tool(AWAY + "heat perfect"), "heat is on", "fix contact/tri tool", "type 1",
      "heat k cp chi")
wrong("tool particles of no type", dict(tool(AWAY + "particles 7"), **coeff(JC + HEAT)), K, "particles", "7")
wrong("tool particles that are no heat body", dict(tool(AWAY + "particles 1"), **coeff(JC + HEAT)), K, "particles", "type 1")
wrong("vtk without a star", tool(AWAY + "vtk 10 tool.vtk"), K, "vtk", "tool.vtk", "*")
wrong("vtk every 0 steps", tool(AWAY + "vtk 0 tool.*.vtk"), K, "vtk", "0")
wrong("vtk into a folder that is not there", tool(AWAY + "vtk 1 nowhere/tool.*.vtk"), K, "nowhere/tool")
wrong("unknown motion", tool(AWAY, "fix_modify tool move forward 1 0 0"), K, "move", "forward", "linear")
wrong("motion with two values", tool(AWAY, "fix_modify tool move linear 1 0"), K, "move linear", "Vx Vy Vz")
wrong("motion nan", tool(AWAY, "fix_modify tool move linear nan 0 0"), K, "move linear", "nan")
wrong("wiggle with period 0", tool(AWAY, "fix_modify tool move wiggle 1 0 0 0"), K, "wiggle", "period")
wrong("rotation about nothing", tool(AWAY, "fix_modify tool move rotate 0 0 0 0 0 0 1"), K, "rotate", "axis")
wrong("motion by no variable", tool(AWAY, "fix_modify tool move variable v_a NULL NULL NULL NULL NULL"), K, "variable a")
wrong("motion by an atom variable", tool(AWAY, "variable a atom x\nfix_modify tool move variable v_a NULL NULL NULL NULL NULL"),
      K, "variable a", "equal-style")
wrong("ramp -1", tool(AWAY, "fix_modify tool move linear 1 0 0 ramp -1"), K, "ramp", "-1")
wrong("tool before the state", dict(tool(AWAY), fix="", more="fix tool all contact/tri " + AWAY.replace("@", MESH)
                                    + "\nfix body all sph/tm"), K, "after fix body sph/tm")
wrong("tool without the state", dict(tool(AWAY), fix="", compute="", pair_style="pair_style zero 3e-3",
                                     pair_coeff="pair_coeff * *\nmass 1 1"), K, "fix body all sph/tm")
wrong("tool in 2D that is not extruded", {"more": "fix tool all contact/tri " + AWAY.replace("@", MESH)}, K, "2d", "extruded",
      "scale")

# --- fix contact/tri: overlap at the start; the mesh is the octahedron or wedge of unittest/meshes -------------

wrong("tool overlaps the work", tool("file @ascii.stl scale 2e-3 move 4.2e-3 1.5e-3 1.5e-3"), T, "overlaps", "by ", "along",
      "move it by that along +x", "particle", "overlap allow")
wrong("tool swallows the work", tool("file @ascii.stl scale 60e-3 move -5e-3 -5e-3 -5e-3"), T, "overlaps", "overlap allow")
fine("tool moved by what the message says", tool("file @ascii.stl scale 2e-3 move 5.006e-3 1.5e-3 1.5e-3"))
wrong("tool moved by a little less", tool("file @ascii.stl scale 2e-3 move 4.985e-3 1.5e-3 1.5e-3"), T, "overlaps", "+x")
fine("tool overlaps the work and may", tool("file @ascii.stl scale 2e-3 move 4.2e-3 1.5e-3 1.5e-3 overlap allow penalty 0.001"))

A = "fix adapt/neigh asph"


def asph(words, **more):
    return dict({"more": "fix lists all adapt/neigh " + words}, **more)


wrong("asph without a mode", asph("asph"), A, "psi or density")
wrong("asph of an unknown mode", asph("asph tensor"), A, "psi or density", "tensor")
wrong("asph twice", asph("asph psi asph density"), A, "twice")
wrong("asph every 0", asph("asph psi every 0"), A, "every", "0")
wrong("asph every without a number", asph("asph psi every"), A, "every", "value")
wrong("asph limits above 1", asph("asph psi limits 1.5 2"), A, "limits lo", "1.5")
wrong("asph limits below 1", asph("asph psi limits 0.5 0.9"), A, "limits hi", "0.9")
wrong("asph, its effect forced off", asph("asph psi", fix="fix body all sph/tm effects smoothing off"), A, "smoothing",
      "forced off")
wrong("adapt/neigh with an unknown keyword", asph("h psi"), "fix adapt/neigh", "h", "asph")
fine("asph", asph("asph psi every 2 limits 0.5 2"))

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
wrong("cutting width -1", cut("tool width -1"), U, "width", "-1")

# --- heat fixes and drive -----------------------------------------------------------------------------------

HOT = coeff(JC + HEAT)


def heat_fix(text):
    return dict(HOT, more="fix h all sph/tm/heat " + text)


fine("heat fix", heat_fix("convection 100 400"))
H = "sph/tm/heat"
wrong("heat fix without mode", heat_fix(""), H, "mode", "flux")
wrong("heat fix with a wrong mode", heat_fix("conduction 5"), H, "conduction", "convection")
wrong("heat fix without value", heat_fix("flux"), H, "flux", "number or v_name")
for bad in ("nan", "inf", "hot"):
    wrong("flux " + bad, heat_fix("flux " + bad), H, "flux", bad)
wrong("heat fix temperature -5", heat_fix("temperature -5"), H, "temperature", "-5")
wrong("convection with one value", heat_fix("convection 100"), H, "convection", "Tinf")
wrong("radiation emissivity 2", heat_fix("radiation 400 emissivity 2"), H, "emissivity", "2")
wrong("heat fix unknown keyword", heat_fix("flux 100 colour red"), H, "colour", "facing")
wrong("heat fix area -1", heat_fix("flux 100 area -1"), H, "area", "-1")
wrong("heat fix area nan", heat_fix("flux 100 area nan"), H, "area", "nan")
wrong("heat fix without heat", dict(heat_fix("flux 100"), **fix("effects heat off")), H, "heat", "effects")
wrong("heat fix without constants", {"more": "fix h all sph/tm/heat flux 100"}, "heat is on", "type 1", "heat k cp chi")
wrong("heat fix by no variable", heat_fix("flux v_q"), H, "q")
wrong("heat fix before the state", dict(HOT, fix="fix h all sph/tm/heat flux 1\nfix body all sph/tm"), H, "after fix sph/tm")
wrong("drive with two velocities", {"more": "fix d all sph/tm/drive 1 0"}, "sph/tm/drive", "vx vy vz")
wrong("drive without any", {"more": "fix d all sph/tm/drive NULL NULL NULL"}, "sph/tm/drive", "NULL")
wrong("drive with nan", {"more": "fix d all sph/tm/drive nan 0 0"}, "sph/tm/drive", "vx", "nan")
wrong("drive of particles that nobody moves", {"fix": "group some id 1:10\nfix body some sph/tm",
                                              "more": "fix d all sph/tm/drive 1 0 0"}, "sph/tm/drive", "group", "not in")

# --- particles ----------------------------------------------------------------------------------------------

wrong("two particles in one place", {"atoms": "create_atoms 1 region work\ncreate_atoms 1 single 2.5e-3 3.5e-3 0 units box"}, S,
      "same place", "delete_atoms overlap")
wrong("two particles almost in one place", {"atoms": "create_atoms 1 region work\ncreate_atoms 1 single 2.51e-3 3.5e-3 0 units box"},
      S, "apart", "delete_atoms overlap")
wrong("a velocity that is no number", {"more": "variable bad atom exp(1000)\nvelocity all set v_bad NULL NULL"}, F,
      "velocity", "particle")
warned("mass of another material", {"more": "mass 1 5.0"}, S, "mass", "type 1", "0.0027")
warned("atom style with masses of its own", {"atom_style": "atom_style sphere"}, S, "mass", "0.0027", "set type")

# --- compute ------------------------------------------------------------------------------------------------

wrong("unknown attribute", {"compute": "compute p all sph/tm/atom strain"}, "sph/tm/atom", "strain", "pstrain")
wrong("no attribute", {"compute": "compute p all sph/tm/atom"}, "sph/tm/atom", "attribute", "pstrain")
wrong("compute without fix", {"pair_style": "pair_style zero 3e-3", "pair_coeff": "pair_coeff * *", "fix": "",
                              "more": "mass 1 1"}, "sph/tm/atom", "fix sph/tm")
wrong("vector of the fix without energy", {"thermo": "thermo 5\nthermo_style custom step f_body[2]"}, F, "energy yes")
wrong("vector of the fix out of range", {"thermo": "thermo 5\nthermo_style custom step f_body[13]"}, "out-of-range")

# --- warnings -----------------------------------------------------------------------------------------------

warned("Johnson-Cook with heat off", dict(coeff(JC + HEAT), **fix("effects heat off")), F, "heat is forced off", "softens")
warned("Johnson-Cook without heat constants", coeff(JC), F, "Johnson-Cook", "heat constants")
warned("plasticity forced off", fix("effects plasticity off"), F, "plasticity is forced off", "yields")
warned("damage forced off", dict(coeff(JC + HEAT + " damage strain 0.3"), **fix("effects damage off")), F,
       "damage is forced off", "damage law")
warned("another integrator", {"more": "fix 2 all nve"}, "nve", "also integrates")
fine("effects forced on that have no use", fix("effects damage on effects surface on effects xsph on"))
fine("everything off", dict(style("hyperbolic 1.2 spacing 1e-3 viscosity 0 0 artstress 0 4"), **fix("effects heat off")))

# --- restart files and other hosts --------------------------------------------------------------------------

FIRST = {"run": "run 5\nwrite_restart state.restart"}
READ = {k: "" for k in ("units", "dimension", "boundary", "atom_style", "newton", "lattice", "box", "create_box", "work",
                        "atoms", "pair_style", "pair_coeff")}
fine("restart", dict(READ, units="read_restart state.restart"), first=FIRST)
wrong("restart without the fix", dict(READ, units="read_restart state.restart", fix="", compute=""), S, "fix body all sph/tm",
      first=FIRST)
wrong("restart with another ID of the fix", dict(READ, units="read_restart state.restart", fix="fix other all sph/tm"), F,
      "other", "body", first=FIRST)
wrong("restart truncated", dict(READ, units="read_restart short.restart"), "corrupted", "restart", first=FIRST)
wrong("restart from a missing file", dict(READ, units="read_restart nowhere.restart"), "nowhere.restart")
wrong("plugin of another LAMMPS version", {}, "SPH-TM was built for LAMMPS", "is not loaded into LAMMPS", "LAMMPS_SOURCE_DIR",
      env={"other": "1"})


def script(lines):
    unknown = set(lines) - set(BASE)
    assert not unknown, unknown
    return "\n".join({**BASE, **lines}.values()) + "\n"


def foreign_plugin():
    """The plugin as if built for a LAMMPS of another date: the version string replaced in a copy."""
    with open(os.path.join(os.environ["LAMMPS_PLUGIN_PATH"], "sphtmplugin.so"), "rb") as f:
        code = f.read()
    found = re.search(rb"(\d{1,2} (?:Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec) 20\d\d)\x00", code)
    assert found, "no LAMMPS version in the plugin"
    folder = new_folder()
    with open(os.path.join(folder, "sphtmplugin.so"), "wb") as f:
        f.write(code.replace(found.group(1), found.group(1)[:-1] + b"0"))
    return folder


def attempt(c):
    kind, name, lines, fragments, files, env, first = c
    folder = new_folder()
    if first:
        run(script(first), folder=folder, files=files)
        with open(os.path.join(folder, "state.restart"), "rb") as f:
            short = f.read()
        with open(os.path.join(folder, "short.restart"), "wb") as f:
            f.write(short[:len(short) * 2 // 3])
    environment = {"LAMMPS_PLUGIN_PATH": foreign_plugin()} if env else None
    try:
        return run(script(lines), folder=folder, files=files, expect_error=True, timeout=60, environment=environment)
    except subprocess.TimeoutExpired as late:
        return Result(folder, "%s\nERROR: still running after 60 s" % late.stdout, 124)


def judge(checks, c, result, verbose):
    kind, name, _, fragments, _, _, _ = c
    errors = result.errors()
    said = errors if kind == "wrong" else "\n".join(result.warnings())
    if c[5]:
        said += "\n".join(result.warnings())
    missing = [f for f in fragments if f.lower() not in said.lower()]
    started = re.search(r"^ *Step\b.*\n *0 ", result.output, re.M)
    if kind == "wrong":
        ok = result.status not in (0, 124) and result.status > 0 and errors and not started and not missing
    elif kind == "warned":
        ok = result.status == 0 and not errors and not missing
    else:
        ok = result.status == 0 and not errors and not said
    why = []
    if kind == "wrong" and result.status == 0:
        why.append("it ran to the end")
    if kind == "wrong" and started:
        why.append("it took a step")
    if kind != "wrong" and result.status != 0:
        why.append("it failed: " + errors)
    if missing:
        why.append("not said: " + ", ".join(missing))
    if result.status < 0 or result.status > 128:
        why.append("it crashed with status %d" % result.status)
    checks.say(ok, kind + ": " + name, "; ".join(why) + ("   <- " + " | ".join(said.splitlines())[:400] if why or verbose else ""))


def main():
    verbose = "-v" in sys.argv
    wanted = [a for a in sys.argv[1:] if a != "-v"]
    todo = [c for c in CASES if not wanted or any(w in c[1] for w in wanted)]
    checks = Checks()
    run(script({}))    # ends the test with its output where even the good script fails
    with ThreadPoolExecutor(2) as pool:
        for c, result in zip(todo, pool.map(attempt, todo)):
            judge(checks, c, result, verbose)
    print(len(todo), "scripts")
    checks.end()


main()
