"""Malformed scripts: fix sph/tm/heat and fix sph/tm/drive. See bad_input.py."""
from bad_input import HEAT, JC, coeff, fine, fix, run_all, warned, wrong

H = "sph/tm/heat"
HOT = coeff(JC + HEAT)


def heat_fix(text):
    return dict(HOT, more="fix h all sph/tm/heat " + text)


fine("heat fix", heat_fix("convection 100 400"))
wrong("heat fix without mode", heat_fix(""), H, "mode", "flux")
wrong("heat fix with a wrong mode", heat_fix("conduction 5"), H, "conduction", "convection")
wrong("heat fix without value", heat_fix("flux"), H, "flux", "number or v_name")
for bad in ("nan", "inf", "hot"):
    wrong("flux " + bad, heat_fix("flux " + bad), H, "flux", bad)
wrong("heat fix temperature -5", heat_fix("temperature -5"), H, "temperature", "-5")
wrong("convection with one value", heat_fix("convection 100"), H, "convection", "Tinf")
wrong("radiation emissivity 2", heat_fix("radiation 400 emissivity 2"), H, "emissivity", "2")
wrong("heat fix unknown keyword", heat_fix("flux 100 colour red"), H, "colour", "facing")
wrong("emissivity without radiation", heat_fix("flux 100 emissivity 0.5"), H + " flux", "emissivity", "facing")
wrong("source with a keyword", heat_fix("source 100 area 1"), H + " source", "area", "none")
for key, count in (("area", "1 value"), ("threshold", "1 value"), ("facing", "3 values")):
    wrong("heat fix without the values of " + key, heat_fix("flux 100 " + key), H + " flux", key, count)
for bad in ("-0.1", "1", "nan"):
    wrong("heat fix threshold " + bad, heat_fix("flux 100 threshold " + bad), H + " flux threshold", bad)
INNER = "group inner id 28\nfix h inner sph/tm/heat flux 100 "
wrong("heat fix area without a surface", dict(HOT, more=INNER + "area 1e-3"), H + " flux", "group inner has no free surface", "area 0.001")
warned("heat fix without a surface", dict(HOT, more=INNER), H + " flux", "group inner has no free surface")
warned("heat fix area in mm", heat_fix("flux 100 facing 1 0 0 area 8"), H + " flux", "area 8", "times", "units")
fine("heat fix area", heat_fix("flux 100 facing 1 0 0 area 8e-3"))
wrong("heat fix facing nowhere", heat_fix("flux 100 facing 0 0 0"), H + " flux facing", "outward direction", "0 0 0")
wrong("heat fix facing out of the plane", heat_fix("flux 100 facing 0 0 1"), H + " flux facing", "xy plane")
wrong("heat fix facing nan", heat_fix("flux 100 facing 1 nan 0"), H + " flux facing", "nan")
wrong("convection of a negative coefficient", heat_fix("convection -5 300"), H + " convection hc", "-5")
wrong("radiation to a negative temperature", heat_fix("radiation -5"), H + " radiation Tinf", "-5")
wrong("heat fix area -1", heat_fix("flux 100 area -1"), H, "area", "-1")
wrong("heat fix area nan", heat_fix("flux 100 area nan"), H, "area", "nan")
wrong("heat fix without heat", dict(heat_fix("flux 100"), **fix("effects heat off")), H, "heat", "effects")
wrong("heat fix without constants", {"more": "fix h all sph/tm/heat flux 100"}, "heat is on", "type 1", "heat k cp chi")
wrong("heat fix by no variable", heat_fix("flux v_q"), H, "q")
wrong("heat fix before the state", dict(HOT, fix="fix h all sph/tm/heat flux 1\nfix body all sph/tm"), H,
      "after fix sph/tm")
wrong("drive with two velocities", {"more": "fix d all sph/tm/drive 1 0"}, "sph/tm/drive", "vx vy vz")
wrong("drive without any", {"more": "fix d all sph/tm/drive NULL NULL NULL"}, "sph/tm/drive", "NULL")
wrong("drive with nan", {"more": "fix d all sph/tm/drive nan 0 0"}, "sph/tm/drive", "vx", "nan")
wrong("drive of particles that nobody moves", {"fix": "group some id 1:10\nfix body some sph/tm",
                                              "more": "fix d all sph/tm/drive 1 0 0"}, "sph/tm/drive", "group",
                                              "not in")

run_all()
