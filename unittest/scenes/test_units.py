"""One scene in every style of units: a block of a material card is pressed and rubbed by a hot tool, with plasticity,
heat, friction, conductance, a lumped tool, convection and radiation. The same numbers in SI must come out, and the same
automatic time step. test_reference_rates.py holds the rates themselves in all styles; here it is the card, the tools,
the heat fixes, the output and what limits the step.

The difference allowed is round-off, grown by 300 steps of plastic contact (1e-9; of the step 2^-29, since it is cut off to 30 bits in the
units of the run), and where a unit is not a power of
ten that of the constants in LAMMPS's tables, of eight digits, grown too (2e-6). Units lj are taken as made of 1 mg, 0.3
mm and 0.7 us, the constants given inline, and without radiation."""
import os

import numpy as np
from contact_scene import HEADER, block, mesh, particles, read_vtk
from sphtm_scene import Checks, new_folder, run
from unit_styles import UNITS

DX = 1e-4
CARD = "materials.sphtm al6082-t6"
INLINE = ("density {rho} elastic {E} 0.33 strength johnson/cook {A} {B} 1.008 0.00747 1.31 293 855 {rate0} "
          "heat {k} {cp} 0.9 expansion 2.34e-5")
SCRIPT = """
pair_coeff 1 1 {material} emissivity 0.7
region base block INF INF INF {base} INF INF units box
group base region base
fix body all sph/tm temperature 300 energy yes
fix hold base setforce 0 0 0
fix air all sph/tm/heat convection {h} 900
{radiation}
fix tool all contact/tri file plane.stl scale {scale} rotate axis 1 0 0 angle 90 move 0 {top} 0 friction 0.3 &
    heat conductance {hc} lumped {mass} {cp} 400 material {tk} {trho} {cp} vtk 300 tool.*.vtk
fix_modify tool move linear {slide} {press} 0 ramp {ramp}
compute p all sph/tm/atom temperature pstrain vonmises density pressure
dump d all custom 300 out.dump id x y z vx vy vz c_p[*]
dump_modify d format float %.15g
thermo_style custom step time dt f_tool f_tool[*] f_body[*9] f_air[*] pe ke {sun}
thermo_modify norm no lost ignore format float %.15g
thermo 100
run 300
"""
DIMENSIONS = {
    "time": "Time Dt", "length": "x y z f_tool[7] f_tool[8] f_tool[9]", "speed": "vx vy vz", "density": "c_p[4]",
    "pressure": "c_p[3] c_p[5]", "force": "f_tool[1] f_tool[2] f_tool[3]", "area": "f_air[3]",
    "energy": "PotEng KinEng f_tool[4] f_tool[5] f_tool[6] f_air[2] f_sun[2]",
    "stress": "normal_stress_average shear_stress_average", "power": "f_tool[10] f_tool[11] f_air[1]"}
RADIATION = "fix sun all sph/tm/heat radiation 3000"


def dimension(name):
    """Of a column of the output: which of the scales below."""
    for unit, columns in DIMENSIONS.items():
        if name in columns.split() or unit == "energy" and name.startswith("f_body"):
            return unit
    return "one"


def scales(style, dim):
    mass, length, time, energy, force, pressure, density = UNITS[style]
    if style == "lj":
        mass, length, time = 1e-6, 3e-4, 0.7e-6
        energy, force, pressure, density = (mass * length ** 2 / time ** 2, mass * length / time ** 2,
                                            mass / length / time ** 2, mass / length ** 3)
    thick = length if dim == 2 else 1.0       # in 2D: a plate one unit thick
    return {"mass": mass, "length": length, "time": time, "pressure": pressure, "stress": pressure, "density": density,
            "speed": length / time,
            "energy": energy / thick, "force": force / thick, "power": energy / time / thick,
            "area": length ** 2 / thick,
            "one": 1.0, "conductance": energy / (time * length ** 2), "conductivity": energy / (time * length),
            "capacity": energy / mass, "thick": thick}


def press(style, dim, radiation):
    u = scales(style, dim)
    folder = new_folder()
    mesh(folder, "plane.stl", "plane --size 8 8 --cells 7 5 --format ascii")
    n = (10, 6, 5) if dim == 3 else (10, 6, 1)
    x = block(n, DX, (0, 0, 0 if dim == 3 else -0.5 * DX)) / u["length"]
    lo, hi = np.array([-5, -5, -5]) * DX, np.array([15, 11, 10]) * DX
    if dim == 2:
        lo[2], hi[2] = -0.5 * DX, 0.5 * DX
    box = np.array([lo, hi]).T / u["length"]
    # SI over the unit; a tool of 0.5 mg, in 2D of 5 g/m
    number = dict(base=(1.9 * DX, "length"), h=(1e5, "conductance"), hc=(1e6, "conductance"), scale=(5 * DX, "length"),
                  top=(6.001 * DX, "length"), slide=(50.0, "speed"), press=(-10.0, "speed"), ramp=(2e-7, "time"),
                  tk=(80.0, "conductivity"), trho=(15000.0, "density"), mass=(5e-7 if dim == 3 else 5e-3, "mass"), cp=(450.0, "capacity"))
    words = {k: repr(float(v / u[unit])) for k, (v, unit) in number.items()}
    if dim == 2:
        words["mass"] = repr(5e-3 / u["mass"] * u["thick"])
    material = CARD
    if style == "lj":
        material = INLINE.format(rho=2690 / u["density"], E=68.9e9 / u["pressure"], A=428e6 / u["pressure"],
                                 B=327e6 / u["pressure"], rate0=u["time"], k=200 / u["conductivity"],
                                 cp=900 / u["capacity"])
    script = HEADER.replace("units si", "units " + style).format(
        dim=dim, boundary="f f f" if dim == 3 else "f f p", data="data.scene", dx=float(DX / u["length"]),
        style="balsara yes") + SCRIPT.format(material=material, radiation=RADIATION if radiation else "",
                                          sun="f_sun[2]" if radiation else "", **words)
    result = run(script, files={"data.scene": particles(x, box)}, folder=folder)
    table, frame = result.thermo[-1], dict(result.dump("out.dump")[-1])
    written = read_vtk(os.path.join(folder, "tool.300.vtk"))
    frame.update((k, np.array(written[k])) for k in ("normal_stress_average", "shear_stress_average"))
    return {k: v * u[dimension(k)] for k, v in list(table.items()) + list(frame.items())
            if k not in ("step", "box", "id", "Step")}


def hold(checks, title, got, due, allowed):
    worst, where, step = 0.0, "", abs(got["Dt"] / due["Dt"] - 1).max()
    groups = (("f_tool[1]", "f_tool[2]", "f_tool[3]"), ("f_tool[4]", "f_tool[5]", "f_tool[6]"), ("vx", "vy", "vz"),
              ("x", "y", "z", "f_tool[7]", "f_tool[8]", "f_tool[9]"), [k for k in due if k.startswith("f_body")])
    for k in due.keys() - {"Dt"}:
        like = next((g for g in groups if k in g), (k,))
        scale = max(abs(due[g]).max() for g in like)
        if scale and abs(got[k] - due[k]).max() / scale > worst:
            worst, where = abs(got[k] - due[k]).max() / scale, k
    checks.below("%s: largest difference, of %s" % (title, where), worst, allowed)
    checks.below("    of the time step", step, max(allowed, 2.0 ** -29 + 1e-12))


if __name__ == "__main__":
    checks = Checks()
    for dim in (2, 3):
        reference = press("si", dim, True)
        checks.above("%dd: plastic strain" % dim, reference["c_p[2]"].max(), 0.02)
        checks.above("    heating, K", reference["c_p[1]"].max() - 300, 15)
        checks.above("    rise of the tool's temperature, K", abs(reference["f_tool"][-1] - 400), 0.1)
        checks.above("    contacts", reference["f_tool[12]"][-1], 10 if dim == 2 else 40)
        for style in UNITS:
            if style == "lj":
                hold(checks, "%dd lj" % dim, press(style, dim, False), press("si", dim, False), 1e-9)
            elif style != "si":
                powers_of_ten = style in ("cgs", "micro", "nano")
                hold(checks, "%dd %s" % (dim, style), press(style, dim, True), reference,
                     1e-9 if powers_of_ten else 2e-6)
    checks.end()
