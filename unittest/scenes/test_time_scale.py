"""time/scale of fix sph/tm: a process run s times as fast, with density/s^2 and s^2 c_p, has the stresses, strains and
temperatures of the process: conduction, conductances, fluxes and strain rates are those of its time."""
import numpy as np
from heat_rod import RUN, Layer, rod
from sphtm_scene import Checks, lattice_block, run

checks = Checks()

# --- heat: layers with an interface, a flux, convection, radiation and k(T)


def heat(s, how="", scaled=None):
    text = rod([Layer(20, 7800.0, "table/2 300 40 600 60", 480.0, 400), Layer(20, 2700.0, 120.0, 900.0, 300)], 1e-4,
               """pair_coeff 1 2 heat conductance 2e4
fix q all sph/tm/heat flux 1e6 facing -1 0 0
fix c all sph/tm/heat convection 5e4 300
fix r all sph/tm/heat radiation 2000 emissivity 0.9
thermo_style custom step time dt f_q[2] f_c[2] f_r[2]
""" + RUN.format(0.2 / s), body="fix body all sph/tm time/scale %r %s" % (scaled or s, how))
    result = run(text)
    return result.dump("profile.dump")[-1]["c_T"], result.thermo[-1]


for how in ("", "conduction explicit"):
    (slow, log), (fast, log8) = heat(1, how), heat(8, how)
    name = "heat %s: " % how
    checks.near(name + "time of the run", 8 * log8["Time"][-1], log["Time"][-1], relative=1e-12)
    checks.below(name + "temperatures, K", abs(slow - fast).max(), 1e-7)
    for flux in "qcr":
        column = "f_%s[2]" % flux
        checks.near(name + "energy of fix " + flux, log8[column][-1], log[column][-1], relative=1e-9)
checks.above("heat: off without time/scale, K", abs(slow - heat(8, how, 1)[0]).max(), 10)

# --- a block of Johnson-Cook steel whose rate hardening is large, with conduction, that is drawn apart
BLOCK = lattice_block("-5e-3 5e-3 -5e-3 5e-3", "-0.02 0.02 -0.02 0.02") + """
pair_style sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff 1 1 density {rho} elastic 200e9 0.3 strength johnson/cook 300e6 300e6 0.3 0.1 1 293 1700 10 heat 5e4 {cp} 0.9
fix body all sph/tm temperature 293 time/scale {s}
variable vx atom {v}*x/5e-3
variable vy atom -0.3*{v}*y/5e-3
velocity all set v_vx v_vy 0 units box
compute p all sph/tm/atom temperature pstrain vonmises pstrain/rate
thermo_style custom step time dt
run 150
write_dump all custom end.dump id c_p[1] c_p[2] c_p[3] c_p[4] modify sort id format float %.15g
"""


def block(s, scaled=None):
    text = BLOCK.format(rho=7800.0 / s ** 2, cp=480.0 * s ** 2, v=100.0 * s, s=scaled or s)
    return run(text).dump("end.dump")[-1]


slow, fast, wrong = block(1), block(8), block(8, 1)
checks.above("block: largest plastic strain", slow["c_p[2]"].max(), 0.02)
for column, name, least in (("c_p[1]", "temperature", 293), ("c_p[2]", "plastic strain", 0), ("c_p[3]", "stress", 0)):
    size = (slow[column] - least).max()
    checks.below("block: %s, fast against slow" % name, abs(fast[column] - slow[column]).max() / size, 1e-9)
checks.below("block: rate", abs(fast["c_p[4]"] / 8 - slow["c_p[4]"]).max() / slow["c_p[4]"].max(), 1e-9)
off = abs(wrong["c_p[3]"] - slow["c_p[3]"]).max() / slow["c_p[3]"].max()
checks.above("block: stress without time/scale is off by", off, 0.03)
# --- a tool that rubs and conducts: conductance, effusivity, temperature of a lumped tool
PLATE = "solid p\n" + "".join(
    "facet normal 1 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % (0, y, z) for y, z in corners) +
    "endloop\nendfacet\n" for corners in (((-1, -1), (1, -1), (1, 1)), ((-1, -1), (1, 1), (-1, 1)))) + "endsolid p\n"
TOOL = """fix tool all contact/tri file plate.stl scale 0.02 move {at} 0 0 sides two friction 0.3 heat conductance 1e8 &
    effusivity 2e4 temperature 500 lumped 1e-2 {tool_cp} 500
fix_modify tool move linear {vt} {us} 0
thermo_style custom step time dt f_tool f_tool[1] f_tool[2]
thermo_modify format float %.15g
thermo 2
run 150
"""


def rub(s, scaled=None):
    text = BLOCK.replace("run 150\n", TOOL).replace("thermo_style custom step time dt\n", "")
    return run(text.format(rho=7800.0 / s ** 2, cp=480.0 * s ** 2, v=20.0 * s, s=scaled or s, at=-5e-3, vt=5.0 * s,
                           us=20.0 * s, tool_cp=480.0), files={"plate.stl": PLATE})


slow, fast, wrong = rub(1), rub(8), rub(8, 1)
a, b, c = (r.dump("end.dump")[-1]["c_p[1]"] for r in (slow, fast, wrong))
checks.above("rubbed block: hottest particle, K", a.max(), 294)
checks.below("rubbed block: temperature, fast against slow, K", abs(a - b).max(), 1e-6)
for k, name in (("f_tool[1]", "force"), ("f_tool[2]", "friction"), ("f_tool", "temperature of the tool")):
    f, g = fast.thermo[-1][k], slow.thermo[-1][k]
    checks.above("rubbed block: largest " + name, abs(g).max(), 1)
    checks.below("rubbed block: %s, fast against slow" % name, abs(f - g).max() / abs(g).max(), 1e-9)
checks.above("rubbed block: off without time/scale, K", abs(a - c).max(), 0.1)

bad = run(BLOCK.format(rho=7800, cp=480, v=1, s=0), expect_error=True)
checks.true("time/scale 0 is refused", "time/scale" in bad.errors(), bad.errors()[:120])
checks.end()
