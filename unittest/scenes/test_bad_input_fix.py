"""Malformed scripts: fix sph/tm, its particles, compute sph/tm/atom and warnings. See bad_input.py."""
from bad_input import GOOD, HEAT, JC, TWO, coeff, fine, fix, run_all, style, warned, wrong

S = F = "sph/tm"

wrong("pair without fix", {"fix": "", "compute": ""}, S, "fix", "fix body all sph/tm")
wrong("fix without pair", {"pair_style": "", "pair_coeff": "", "more": "mass 1 1"}, "fix sph/tm", "pair style sph/tm")
wrong("fix with another pair style", {"pair_style": "pair_style zero 3e-3", "pair_coeff": "pair_coeff * *",
                                     "more": "mass 1 1"}, "Fix sph/tm", "pair style sph/tm")
wrong("two fixes", {"more": "fix again all sph/tm"}, "fix sph/tm", "More than one")
wrong("particles of the pair style under nve", {"fix": "group some id > 20\ngroup other id <= 20\nfix body some sph/tm", "more": "fix n other nve"},
      "Fix n nve", "20 particles", "outside of group some")
wrong("nve in addition", {"more": "fix n all nve"}, "Fix n nve", "also integrates 64 particles")
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
wrong("unstable time step of conduction",
      dict(coeff(JC + " heat 2e8 900 0.9"), fix="fix body all sph/tm dt 2e-8 conduction explicit"), F,
      "dt 2e-08", "not stable", "conduction", "dt auto")
wrong("lost perhaps", fix("lost perhaps"), F, "lost", "perhaps", "error or ignore")
wrong("audit without values", fix("audit"), F, "audit", "1 value")
wrong("audit with one number", fix("audit 100"), F, "audit", "2 values")
wrong("audit perhaps", fix("audit perhaps"), F, "audit", "perhaps")
for bad in "0 10", "-5 10", "1.5 10", "1e3 10", "two 10":
    wrong("audit " + bad, fix("audit " + bad), F, "audit N", bad.split()[0])
for bad in "10 0", "10 -3", "10 2.5", "10 many", "10 2000000":
    wrong("audit " + bad, fix("audit " + bad), F, "audit M", bad.split()[1])
for bad, *said in (("active", "values"), ("active region all speed", "values"), ("active perhaps all speed 1", "perhaps", "region"),
                   ("active region all rest 1", "speed V"), ("active region all speed 0", "speed", "0"),
                   ("active region all speed fast", "speed", "fast"), ("active near 0 speed 1", "near", "0"),
                   ("active region nowhere speed 1", "active", "no region nowhere"),
                   ("active near 1e-3 speed 1", "active near", "contact/tri"),
                   ("active region work speed 1 every 0", "every", "0"),
                   ("active region work speed 1 audit yes", "active", "audit")):
    wrong(bad, fix(bad), F, *said)
wrong("active with adapt/neigh", dict(fix("active region work speed 1"), more="fix lists all adapt/neigh threshold 0"), F,
      "active", "adapt/neigh")
wrong("active with a pass of its own for the correction",
      dict(style("hyperbolic 1.2 spacing 1e-3 stabilize artstress correction yes"), **fix("active region work speed 1")), F,
      "active", "correction")
fine("active with artstress", dict(style("hyperbolic 1.2 spacing 1e-3 stabilize artstress"),
                                   **fix("active region work speed 1")))
wrong("active with xsph", dict(style("hyperbolic 1.2 spacing 1e-3 xsph 0.5"), **fix("active region work speed 1")), F,
      "active", "xsph")
wrong("active under a hybrid style",
      dict(fix("active region work speed 1"), pair_style="pair_style hybrid/overlay sph/tm hyperbolic 1.2 spacing 1e-3 zero 2e-3",
           pair_coeff="pair_coeff 1 1 sph/tm density 7830 elastic 200e9 0.29\npair_coeff 1 1 zero"), F, "active", "hybrid/overlay")
wrong("active with neigh_modify exclude", dict(fix("active region work speed 1"), more="neigh_modify exclude type 1 1"), F,
      "active", "exclude")
fine("active", fix("active region work speed 1"))
wrong("energy perhaps", fix("energy perhaps"), "perhaps")
wrong("unknown effect", fix("effects rupture on"), F, "rupture", "damage")
wrong("effect without value", fix("effects heat"), F, "effects", "2 values")
wrong("effect perhaps", fix("effects heat perhaps"), F, "effects heat must be on or off", "perhaps")
wrong("effect on and off", fix("effects heat on effects heat off"), F, "heat", "on and off")
wrong("conduction without heat", fix("effects conduction on"), F, "conduction", "heat is off")
wrong("correction forced on with form f14", dict(style("hyperbolic 1.2 spacing 1e-3 form f14"),
                                                 **fix("effects correction on")), F, "correction", "form f15")
wrong("balsara without viscosity",
      dict(style("hyperbolic 1.2 spacing 1e-3 viscosity 0 0"), **fix("effects balsara on")), F, "balsara", "viscosity")
wrong("heat on, but one type has no heat constants", dict(TWO, **dict(coeff(JC + HEAT), more="pair_coeff 2 2 " + GOOD)),
      F, "type 2", "heat k cp chi")
wrong("heat forced on without constants", fix("effects heat on"), F, "type 1", "heat k cp chi")
wrong("respa", {"more": "run_style respa 2 2 pair 2"}, F, "respa")
wrong("minimize", {"run": "minimize 0 1e-6 10 10"}, F, "minimize")
wrong("fix_modify temperature of an unknown group", {"more": "fix_modify body temperature hot 500"}, F, "hot")
wrong("fix_modify temperature without value", {"more": "fix_modify body temperature all"}, F, "temperature")
for bad in ("-5", "nan", "inf"):
    wrong("fix_modify temperature " + bad, dict(coeff(JC + HEAT), more="fix_modify body temperature all " + bad), F,
          "temperature", bad)
wrong("fix_modify unknown", {"more": "fix_modify body colour red"}, "fix_modify", "colour")

# --- particles ----------------------------------------------------------------------------------------------

wrong("two particles in one place",
      {"atoms": "create_atoms 1 region work\ncreate_atoms 1 single 2.5e-3 3.5e-3 0 units box"}, S,
      "same place", "delete_atoms overlap")
wrong("two particles almost in one place",
      {"atoms": "create_atoms 1 region work\ncreate_atoms 1 single 2.51e-3 3.5e-3 0 units box"},
      S, "apart", "delete_atoms overlap")
wrong("a velocity that is no number", {"more": "variable bad atom exp(1000)\nvelocity all set v_bad NULL NULL"}, F,
      "velocity", "particle")
wrong("mass of another material", {"more": "mass 1 5.0"}, S, "its mass is 5", "0.0027", "mass command")
wrong("atom style with masses of its own", {"atom_style": "atom_style sphere"}, S, "its mass", "0.0027",
      "set type 1 mass 0.0027")

# --- compute ------------------------------------------------------------------------------------------------

wrong("unknown attribute", {"compute": "compute p all sph/tm/atom strain"}, "sph/tm/atom", "strain", "pstrain")
wrong("no attribute", {"compute": "compute p all sph/tm/atom"}, "sph/tm/atom", "attribute", "pstrain")
wrong("compute without fix", {"pair_style": "pair_style zero 3e-3", "pair_coeff": "pair_coeff * *", "fix": "",
                              "more": "mass 1 1"}, "sph/tm/atom", "fix sph/tm")
wrong("vector of the fix without energy", {"thermo": "thermo 5\nthermo_style custom step f_body[2]"}, F, "energy yes")
wrong("vector of the fix out of range", {"thermo": "thermo 5\nthermo_style custom step f_body[16]"}, "out-of-range")

# --- warnings -----------------------------------------------------------------------------------------------

warned("Johnson-Cook with heat off", dict(coeff(JC + HEAT), **fix("effects heat off")), F, "heat is forced off",
       "softens")
warned("Johnson-Cook without heat constants", coeff(JC), F, "softening by temperature", "heat constants")
warned("plasticity forced off", fix("effects plasticity off"), F, "plasticity is forced off", "yields")
warned("damage forced off", dict(coeff(JC + HEAT + " damage strain 0.3"), **fix("effects damage off")), F,
       "damage is forced off", "damage law")
wrong("another integrator", {"more": "fix 2 all nve"}, "Fix 2 nve", "also integrates 64 particles", "group")
wrong("another integrator for some of them", {"more": "group some id 1:5\nfix 2 some nve/limit 0.1"}, "Fix 2 nve/limit",
      "5 particles")
wrong("fix dt/reset", {"more": "fix 2 all dt/reset 10 NULL NULL 1e-5"}, "Fix 2 dt/reset", "dt/max")
wrong("pair_modify compute no", {"more": "pair_modify compute no"}, F, "pair_modify compute yes")
wrong("a dynamic group", {"fix": "variable fast atom vx>0\ngroup quick dynamic all var fast\nfix body quick sph/tm"},
      F, "dynamic group")
warned("nve beside an empty group", {"fix": "group none empty\nfix body none sph/tm", "more": "fix 2 all nve"}, "Fix 2 nve",
       "64 particles", "outside of group none")
warned("degrees Celsius", dict(coeff(JC + HEAT), **fix("temperature 20")), F, "20 K", "kelvin")
warned("no particles", {"work": "region work block 1 2 1 2 INF INF units box"}, F, "no particles")
warned("an empty group", {"fix": "group nobody empty\nfix body nobody sph/tm"}, F, "group nobody is empty")
wrong("dt above what a contact of bodies allows",
      dict(TWO, **fix("dt 3e-8"), more="pair_coeff 2 2 %s\npair_coeff 1 2 contact penalty 100" % GOOD), F, "dt 3e-08",
      "contact stiffness")
wrong("temperature/max of 0", fix("temperature/max 0"), F, "temperature/max")
wrong("density/max of 1", fix("density/max 1"), F, "density/max", "above 1")
wrong("energy/drift of nothing", fix("energy/drift -1"), F, "energy/drift")
wrong("state of another kind", fix("state old"), F, "state", "keep", "new")
fine("effects forced on that have no use", fix("effects damage on effects surface on effects xsph on"))
fine("everything off",
     dict(style("hyperbolic 1.2 spacing 1e-3 viscosity 0 0 hourglass 0 correction no"), **fix("effects heat off")))

run_all()
