"""Malformed scripts: fix adapt/neigh, refine and asph. See bad_input.py."""
from bad_input import fine, run_all, warned, wrong

AN = "adapt/neigh"
PATTERN = "refine square epsilon 0.4 alpha 0.6 "


def adapt(text, before=""):
    return {"more": before + "\nfix ad all adapt/neigh " + text}


fine("refine",
     adapt(PATTERN + "when pstrain above 0.1 and not region work or gradient vonmises above 1e9 level 2 every 10"))
fine("refine and coarsen", adapt(PATTERN + "when neighbors below 3 coarsen when pstrain below 1 or c_k[2] below 5",
                                 "compute k all property/atom x y"))
wrong("refine without pattern", adapt("refine"), AN, "refine", "square", "icosahedron")
wrong("refine with an unknown pattern", adapt("refine triangle epsilon 1 alpha 1 when neighbors above 1"), AN,
      "triangle", "hexagon")
wrong("refine with a pattern of 3D", adapt("refine cube epsilon 0.5 alpha 0.6 when neighbors above 1"), AN, "cube",
      "3 dimensions")
wrong("refine twice", adapt((PATTERN + "when pstrain above 0.1 ") * 2), AN, "refine", "twice")
wrong("refine without epsilon", adapt("refine square alpha 0.6 when neighbors above 1"), AN, "epsilon",
      "smoothing lengths")
wrong("refine without alpha", adapt("refine square epsilon 0.5 when neighbors above 1"), AN, "alpha")
wrong("refine without when", adapt(PATTERN), AN, "refine square", "when")
for bad in ("0", "-1", "nan"):
    wrong("refine epsilon " + bad, adapt("refine square epsilon %s alpha 0.6 when neighbors above 1" % bad), AN,
          "epsilon", bad)
for far in ("1.01", "9"):
    wrong("refine epsilon " + far, adapt("refine square epsilon %s alpha 0.6 when neighbors above 1" % far), AN,
          "epsilon", "at most 1", far, "smoothing lengths", "neighbors")
for bad in ("0", "1.1", "nan"):
    wrong("refine alpha " + bad, adapt("refine square epsilon 0.4 alpha %s when neighbors above 1" % bad), AN, "alpha",
          bad)
wrong("refine with a negative mass", adapt("refine hexagon epsilon 0.3 alpha 0.8 when neighbors above 1"), AN,
      "hexagon", "0.3", "0.8", "hyperbolic", "negative", "-0.62", "larger epsilon")
wrong("refine with no mass for the corners", adapt("refine hexagon epsilon 0.6 alpha 1 when neighbors above 1"), AN,
      "all but one", "no mass", "smaller alpha")
wrong("refine with coinciding children", adapt("refine hexagon epsilon 1e-7 alpha 0.8 when neighbors above 1"), AN,
      "close together")
for bad, words in (("levl", "when pstrain above 0.1 levl 2"), ("vleocity", "vleocity linear when pstrain above 0.1"),
                   ("pstrain", "level 2 pstrain above 0.1")):
    wrong("refine with the unknown option " + bad, adapt(PATTERN + words), "keyword " + bad, "known are", "threshold",
          "options of refine are epsilon, alpha, when, level")
wrong("refine with an unknown option before one it needs",
      adapt("refine square epsilon 0.4 alfa 0.6 when pstrain above 1"),
      "keyword alfa", "options of refine are epsilon, alpha")
wrong("refine option without value", adapt(PATTERN + "when neighbors above 1 level"), AN, "refine", "level", "1 value")
wrong("refine velocity without value", adapt(PATTERN + "when neighbors above 1 velocity"), AN, "velocity",
      "parent or linear")
wrong("refine level 2.5", adapt(PATTERN + "when neighbors above 1 level 2.5"), AN, "refine level", "2.5")
wrong("refine level 0", adapt(PATTERN + "when neighbors above 1 level 0"), AN, "level", "1 to 8")
wrong("refine every 0", adapt(PATTERN + "when neighbors above 1 every 0"), AN, "every", "0")
wrong("refine velocity own", adapt(PATTERN + "when neighbors above 1 velocity own"), AN, "velocity", "parent or linear",
      "own")
wrong("criterion that ends", adapt(PATTERN + "when pstrain"), AN, "refine when", "above or below")
wrong("criterion without limit", adapt(PATTERN + "when pstrain above"), AN, "refine when", "a limit")
wrong("criterion with a bad limit", adapt(PATTERN + "when pstrain above much"), AN, "pstrain above", "much")
wrong("criterion over", adapt(PATTERN + "when pstrain over 0.1"), AN, "above or below", "over")
wrong("criterion after and", adapt(PATTERN + "when pstrain above 0.1 and"), AN, "a criterion")
wrong("criterion of an unknown value", adapt(PATTERN + "when strain above 0.1"), AN, "strain", "c_ID",
      "compute sph/tm/atom")
wrong("criterion of no region", adapt(PATTERN + "when region elsewhere"), AN, "region elsewhere")
wrong("criterion of no compute", adapt(PATTERN + "when c_none above 0.1"), AN, "compute none")
wrong("criterion of a column too many", adapt(PATTERN + "when c_k[3] above 0.1", "compute k all property/atom x y"), AN,
      "k[n]", "2")
wrong("criterion of an array without column", adapt(PATTERN + "when c_k above 0.1", "compute k all property/atom x y"),
      AN, "k[n]")
wrong("criterion of a global compute", adapt(PATTERN + "when c_thermo_temp above 0.1"), AN, "thermo_temp",
      "no values of particles")
wrong("criterion of an equal variable", adapt(PATTERN + "when v_a above 0.1", "variable a equal 1"), AN, "variable a",
      "style atom")
wrong("criterion of no fix", adapt(PATTERN + "when f_none above 0.1"), AN, "fix none")
wrong("criterion of a fix at other steps",
      adapt(PATTERN + "when f_a above 0.1 every 10", "fix a all ave/atom 1 5 15 vx"), AN, "fix a", "15", "10")
wrong("coarsen without refine", adapt("coarsen fallen"), AN, "coarsen", "refine")
wrong("coarsen alone", adapt(PATTERN + "when neighbors above 1 coarsen"), AN, "coarsen", "fallen")
wrong("coarsen never", adapt(PATTERN + "when neighbors above 1 coarsen never"), AN, "coarsen", "never")

# --- asph --------------------------------------------------------------------------------------------------

A = "fix adapt/neigh asph"


def asph(words, **more):
    return dict({"more": "fix lists all adapt/neigh " + words}, **more)


wrong("asph without a mode", asph("asph"), A, "psi or density")
wrong("asph of an unknown mode", asph("asph tensor"), A, "psi or density", "tensor")
wrong("asph twice", asph("asph psi asph density"), A, "twice")
wrong("asph every 0", asph("asph psi every 0"), A, "every", "0")
wrong("asph every without a number", asph("asph psi every"), A, "every", "value")
wrong("asph every 1.5", asph("asph psi every 1.5"), A + " every", "1.5")
wrong("asph with an unknown option", asph("asph psi evry 2"), "keyword evry", "known are asph",
      "options of asph are every, limits")
wrong("asph limits with one value", asph("asph psi limits 0.5"), A, "limits", "2 values")
wrong("asph limits above 1", asph("asph psi limits 1.5 2"), A, "limits lo", "1.5")
wrong("asph limits below 1", asph("asph psi limits 0.5 0.9"), A, "limits hi", "0.9")
wrong("asph, its effect forced off", asph("asph psi", fix="fix body all sph/tm effects smoothing off"), A, "smoothing",
      "forced off")
for key in ("threshold", "rows", "margin", "stretch", "approach"):
    wrong(key + " without value", asph(key), "fix adapt/neigh", key, "1 value")
    wrong(key + " nan", asph("threshold 0 %s nan" % key), "fix adapt/neigh " + key, "nan")
wrong("rows 2.5", asph("threshold 0 rows 2.5"), "fix adapt/neigh rows", "2.5")
wrong("adapt/neigh with an unknown keyword", asph("h psi"), "fix adapt/neigh", "h", "asph")
fine("asph", asph("asph psi every 2 limits 0.5 2"))

# --- groups ------------------------------------------------------------------------------------------------

for words in "threshold 0", PATTERN + "when pstrain above 0.1":
    warned("an empty group, " + words.split()[0],
           {"more": "group none empty\nfix ad none adapt/neigh " + words}, AN + " ad", "no particle", "group none")
wrong("a dynamic group",
      {"more": "group moving dynamic all region work every 5\nfix ad moving adapt/neigh threshold 0"}, AN,
      "dynamic group")

run_all()
