"""Malformed scripts: pair_coeff, its constants, cards and how types meet. See bad_input.py."""
from bad_input import CARD, GOOD, HEAT, JC, TWO, coeff, fine, run_all, wrong

S = "sph/tm"
C = "sph/tm coeff"

fine("two types with materials", dict(TWO, more="pair_coeff 2 2 " + GOOD))
fine("material from a card", coeff("cards.sphtm one"), files={"cards.sphtm": CARD})

# --- pair_coeff: constants ----------------------------------------------------------------------------------

wrong("pair_coeff before pair_style", {"pair_style": "", "more": ""}, "pair_coeff", "without a pair style")
wrong("pair_coeff without material", coeff(""), "sph/tm", "material")
wrong("unknown material keyword", coeff(GOOD + " colour red"), C, "colour", "known are", "strength")
wrong("density missing", coeff("elastic 70e9 0.33"), C, "density")
wrong("elastic missing", coeff("density 2700"), C, "elastic")
wrong("elastic with one value", coeff("density 2700 elastic 70e9"), C, "elastic", "missing")
wrong("elastic with one value, then a keyword", coeff("density 2700 elastic 70e9 strength elastic"), C, "elastic",
      "too few")
wrong("elastic with three values", coeff("density 2700 elastic 70e9 0.33 5"), C, "elastic", "2 values", "5")
wrong("keyword twice", coeff(GOOD + " density 2800"), C, "density", "twice")
for bad in ("-2700", "0", "nan", "inf", "-inf", "1e999"):
    wrong("density " + bad, coeff("density %s elastic 70e9 0.33" % bad), C, "density", bad)
for bad in ("-70e9", "0", "nan"):
    wrong("young " + bad, coeff("density 2700 elastic %s 0.33" % bad), C, "elastic", bad)
for bad in ("0.5", "0.6", "-1", "nan"):
    wrong("poisson " + bad, coeff("density 2700 elastic 70e9 " + bad), C, "poisson",
          "below 0.5" if bad != "nan" else "number", bad)
wrong("density as a word", coeff("density heavy elastic 70e9 0.33"), C, "density", "heavy", "number")
wrong("unknown strength", coeff(GOOD + " strength steel"), C, "strength", "steel", "johnson/cook")
wrong("strength without kind", coeff(GOOD + " strength"), C, "strength", "johnson/cook", "nothing")
wrong("negative yield", coeff(GOOD + " strength plastic -1 0"), C, "yield", "-1")
wrong("johnson/cook with seven values", coeff(GOOD + " strength johnson/cook 4e8 3e8 1 0.01 1.3 293 855"), C,
      "johnson/cook", "missing")
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
wrong("bond with a heat body", dict(TWO, more="pair_coeff 2 2 " + GOOD + HEAT + " body heat\npair_coeff 1 2 bond"),
      "sph/tm", "heat body", "'heat' or 'none'")

run_all()
