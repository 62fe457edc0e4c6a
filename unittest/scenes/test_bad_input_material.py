"""Malformed scripts: pair_coeff, its constants, cards and how types meet. See bad_input.py."""
from bad_input import CARD, GOOD, HEAT, JC, TWO, coeff, fine, run_all, warned, wrong

S = "sph/tm"
C = "sph/tm coeff"

fine("two types with materials", dict(TWO, more="pair_coeff 2 2 " + GOOD))
fine("all types, then one with another density, and again",
     dict(TWO, **dict(coeff(GOOD), more="pair_coeff * * " + GOOD + "\npair_coeff 2 2 density 7800 elastic 210e9 0.3\npair_coeff 2 2 " + GOOD)))
warned("a mass of the script", dict(TWO, more="pair_coeff 2 2 " + GOOD + "\nmass 2 1.0\npair_coeff 2 2 density 7800 elastic 210e9 0.3"),
       "mass of type 2 is 1", "the mass is kept")
fine("material from a card", coeff("cards.sphtm one"), files={"cards.sphtm": CARD})

# --- pair_coeff: constants ----------------------------------------------------------------------------------

wrong("pair_coeff before pair_style", {"pair_style": "", "more": ""}, "pair_coeff", "without a pair style")
wrong("pair_coeff without material", coeff(""), "sph/tm", "material")
wrong("conduction alone without conductivity", dict(coeff("density 7800 body heat heat 0 500 0"), fix="fix body all sph/tm temperature 300"),
      "Fix sph/tm", "nothing limits the time step", "dt/max")
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
TANH, ZA = " strength johnson/cook/tanh 4e8 3e8 1 0.01 1.3 293 855 1", " strength zerilli/armstrong "
fine("johnson/cook/tanh", coeff(GOOD + TANH + " 1.6 0.4 1 6 1" + HEAT))
fine("zerilli/armstrong", coeff(GOOD + ZA + "65e6 0 890e6 0.0028 0.000115 0 1 1 1356" + HEAT))
wrong("johnson/cook/tanh without softening", coeff(GOOD + TANH), C, "johnson/cook/tanh value 9 of 13", "tanh_a", "missing")
wrong("johnson/cook/tanh negative exponent", coeff(GOOD + TANH + " 1.6 -0.4 1 6 1"), C, "tanh_b", ">= 0", "-0.4")
wrong("johnson/cook/tanh melts below its reference", coeff(GOOD + TANH.replace("855", "200") + " 1.6 0.4 1 6 1"), C,
      "johnson/cook/tanh", "t_melt", "t_ref")
wrong("zerilli/armstrong without melting", coeff(GOOD + ZA + "65e6 0 890e6 0.0028 0.000115 0 1 1"), C, "t_melt", "missing")
wrong("zerilli/armstrong rate0 0", coeff(GOOD + ZA + "65e6 0 890e6 0.0028 0.000115 0 1 0 1356"), C, "za_rate0", "0")
wrong("zerilli/armstrong set of another law", coeff(GOOD + ZA + "65e6 0 890e6 0.0028 0.000115 0 1 1 1356 set jc_a 1"), C,
      "jc_a", "johnson/cook", "does not have")
fine("zerilli/armstrong set t_melt", coeff(GOOD + ZA + "65e6 0 890e6 0.0028 0.000115 0 1 1 1356" + HEAT +
     " set t_melt 1300"))
wrong("zerilli/armstrong and damage by rate", coeff(GOOD + ZA + "65e6 0 890e6 0.0028 0.000115 0 1 1 1356 "
      "damage johnson/cook 0.05 3.44 -2.12 0.002 0.61"), C, "d4", "johnson/cook")
warned("zerilli/armstrong in MPa", coeff(GOOD + ZA + "65 0 890 0.0028 0.000115 0 1 1 1356"),
       "za_c0 + za_c1 + za_c2 + za_c5 955", "MPa?")
wrong("unknown eos", coeff(GOOD + " eos ideal"), C, "eos", "ideal", "shock")
warned("shock c0 in km/s", coeff(GOOD + " strength plastic 3e8 0 eos shock 5.2 1.4 2"), "c0 5.2", "bulk modulus", "units of the run")
fine("shock c0 in m/s", coeff(GOOD + " strength plastic 3e8 0 eos shock 5200 1.4 2"))
wrong("shock c0 0", coeff(GOOD + " eos shock 0 1.4 2"), C, "c0", "0")
wrong("tait without exponent", coeff(GOOD + " eos tait"), C, "tait", "missing")
wrong("damage of an elastic material", coeff(GOOD + " damage strain 0.3"), C, "damage", "plastic")
wrong("damage strain negative", coeff(JC + " damage strain -0.3"), C, "strain_max", "-0.3")
wrong("damage strain 0", coeff(JC + " damage strain 0"), C, "strain_max", "0")
for zeros in ("0 0 0 0 0", "-0.1 0.05 -1 0 0"):
    wrong("damage johnson/cook " + zeros, coeff(JC + " damage johnson/cook " + zeros), C, "damage johnson/cook",
          "strain at fracture", "s = 1/3", "above 0", "damage none")
wrong("damage set to 0", coeff(JC + " damage johnson/cook 0.1 0 0 0 0 set d1 0"), C, "strain at fracture")
warned("damage at once where it is pulled from all sides", coeff(JC + " damage johnson/cook -0.09 0.25 -1.5 0 0"),
       "damage johnson/cook -0.09", "s = 1.5", "at once")
warned("damage with d3 of another sign", coeff(JC + " damage johnson/cook 0.05 3.44 2.12 0.002 0.61"), "grows with tension", "d3 is below 0")
warned("damage at once where it is hot", coeff(JC + " damage johnson/cook 0.5 1 -3 0 -1.2"), "d5 = -1.2", "melting")
fine("damage", coeff(JC + HEAT + " damage johnson/cook 0.05 3.44 -2.12 0.002 0.61"))
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

# --- pair_coeff: numbers in other units -------------------------------------------------------------------------

PLASTIC = " strength plastic "
warned("density in g/cm3", coeff("density 2.7 elastic 70e9 0.33 strength plastic 300e6 1e9"),
       "pair_coeff 1 1: density 2.7 in units si is 2.7 kg/m3", "100 to 25000",
       "was it given in g/cm3? units si takes kg/m3")
warned("density in t/mm3", coeff("density 2.7e-9 elastic 70e9 0.33 strength plastic 300e6 1e9"), "t/mm3")
warned("elastic, young in GPa", coeff("density 7850 elastic 200 0.3"), "young 200", "speed of sound of 0.16 m/s", "units si")
warned("elastic, density in g/cm3", coeff("density 7.85 elastic 200e9 0.3"), "density 7.85", "speed of sound of 1.6e+05 m/s")
fine("jelly", coeff("density 1000 elastic 1e3 0.45"))
warned("density too large", coeff("density 27000 elastic 70e9 0.33 strength plastic 300e6 1e9"), "density 27000")
JC_OF = " strength johnson/cook %s 3e8 %s %s 1.3 293 855 1"
fine("johnson/cook of a metal", coeff(GOOD + JC_OF % ("4e8", "0.3", "0.01") + HEAT))
fine("johnson/cook without a first yield stress", coeff(GOOD + JC_OF % ("0", "0.3", "0.01") + HEAT))
warned("jc_a in MPa, the rest in Pa", coeff(GOOD + JC_OF % ("400", "0.3", "0.01") + HEAT), "jc_a 400", "was it given in MPa?")
warned("jc_n a hundred times too large", coeff(GOOD + JC_OF % ("4e8", "30", "0.01") + HEAT), "jc_n is 30", "at most 3")
warned("jc_c a hundred times too large", coeff(GOOD + JC_OF % ("4e8", "0.3", "1") + HEAT), "jc_c is 1", "at most 0.5")
warned("all stresses in MPa", coeff("density 2700 elastic 70e3 0.33 strength plastic 300 1000"), "young 70000",
       "70000 Pa", "yield 300", "was it given in MPa? units si takes Pa")
warned("yield in MPa", coeff(GOOD + " strength johnson/cook 428 327 1.008 0.01 1.31 293 855 1"), "jc_a + jc_b 755",
       "MPa?")
warned("yield beyond a tenth of E", coeff(GOOD + PLASTIC + "10e9 0"), "yield 1e+10", "10000 to 7e+09")
warned("melting at 150 K", coeff(GOOD + " strength johnson/cook 428e6 327e6 1.008 0.01 1.31 100 150 1"), "t_melt 150",
       "at least 200")
warned("capacity in J/(g K)", coeff(JC + " heat 200 0.9 0.9"), "capacity 0.9", "J/(g K)?", "takes J/(kg K)")
warned("a capacity table", coeff(JC + " heat 200 table/2 300 0.9 800 900 0.9"), "capacity 0.9")
warned("conductivity in mW/(m K)", coeff(JC + " heat 200e3 900 0.9"), "conductivity 200000", "at most 10000",
       "mW/(m K)?")
warned("a second type", dict(TWO, more="pair_coeff 2 2 density 2.7 elastic 70e9 0.33 strength plastic 300e6 1e9"),
       "pair_coeff 2 2: density")
warned("a card in other units", coeff("cards.sphtm one"), "density 2.7", "g/cm3",
       files={"cards.sphtm": CARD.replace("2700", "2.7")})
CGS = {"units": "units cgs", "lattice": "lattice sq 0.1 origin 0.5 0.5 0",
       "box": "region box block -0.5 1.5 -0.5 1.5 -0.05 0.05 units box",
       "work": "region work block 0 0.8 0 0.8 INF INF units box",
       "pair_style": "pair_style sph/tm hyperbolic 1.2 spacing 0.1"}
warned("SI numbers in units cgs", dict(CGS, **coeff("density 2700 elastic 70e9 0.33 strength plastic 300e6 1e9")),
       "density 2700 in units cgs is 2.7e+06 kg/m3", "was it given in kg/m3? units cgs takes g/cm3")
fine("units cgs", dict(CGS, **coeff("density 2.7 elastic 70e10 0.33 strength plastic 300e7 1e10 heat 2e7 9e6 0.9")))
fine("a mass scaled by 1000", coeff(JC.replace("2700", "2.7e6") + " heat 200 0.9 0.9"))
fine("an elastic body of any density", coeff("density 1 elastic 1e4 0.3"))
fine("a tungsten", coeff("density 19300 elastic 400e9 0.28 strength johnson/cook 1500e6 180e6 0.12 0.016 1 293 3695 1 "
                         "heat 170 134 0.9"))
fine("polythene as a metal", coeff("density 950 elastic 1e9 0.4 strength plastic 25e6 0 heat 0.4 2300 0.9"))

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
wrong("friction table that goes back", dict(both, more=both["more"] + "contact friction/table 300 0.3 200 0.1"), C,
      "friction/table", "must increase", "200")
wrong("friction table without pairs", dict(both, more=both["more"] + "contact friction/table damping 0.3"), C,
      "friction/table", "T1 mu1")
wrong("shear limit alone", dict(both, more=both["more"] + "contact friction/shear 0.5"), C, "friction/shear", "0.5", "give friction")
wrong("shear limit above 1", dict(both, more=both["more"] + "contact friction/shear 1.5"), C, "friction/shear", "1.5")
wrong("penalty 0", dict(both, more=both["more"] + "contact penalty 0"), C, "penalty", "0")
wrong("contact keyword without value", dict(both, more=both["more"] + "contact penalty"), C, "penalty", "value")
wrong("conductance of a bond", dict(both, more=both["more"] + "bond conductance 5"), C, "bond", "conductance")
wrong("conductance negative", dict(both, more=both["more"] + "heat conductance -5"), C, "conductance", "-5")
wrong("bond with a heat body", dict(TWO, more="pair_coeff 2 2 " + GOOD + HEAT + " body heat\npair_coeff 1 2 bond"),
      "sph/tm", "conduction-only material", "'heat' or 'none'")

run_all()
