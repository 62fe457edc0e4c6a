"""Small scenes that between them have every effect, field, kernel family and fix."""
import os
import subprocess
import sys

from kokkos_scene import PLANE, SOURCE, lattice_block

DUMP = """
compute         p all sph/tm/atom {values}
compute         s all stress/atom NULL
compute         e all pe/atom
thermo          {steps}
thermo_modify   format float %.15g
dump            d all custom {steps} end.dump id type x y z vx vy vz fx fy fz c_p[*] c_s[*] c_e
dump_modify     d format float %.17g
run             {steps}
"""
VALUES = ("density temperature pstrain pstrain/rate flowstress vonmises pressure stress/xy damage failed energy "
          "thickness soundspeed neighbors")


def end(steps, values=VALUES):
    return DUMP.format(values=values, steps=steps)


BAR = lattice_block("0 0.016 0 0.01 0 0.01", "-0.01 0.02 -0.01 0.02 -0.01 0.02", dim=3) + """
region          left block INF 0.004 INF INF INF INF units box
group           left region left
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 {style}
pair_coeff      1 1 density 2700 elastic 70e9 0.33 {material}
velocity        left set 80 5 0 units box
fix             body all sph/tm temperature 293 {fix}
"""

CUT = lattice_block("0 0.016 -0.008 0 0 0.008", "-0.02 0.03 -0.02 0.02 -0.02 0.02", dim=3) + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 balsara yes xsph 0.1 correction yes hourglass 0.02
pair_coeff      1 1 materials.sphtm c45e damage johnson/cook 0.5 1.0 -3.0 0.01 1.0
region          base block INF INF INF -0.006 INF INF units box
group           base region base
fix             body all sph/tm temperature 300 energy yes
fix             hold base setforce 0 0 0
fix             tool all contact/tri file tool.stl scale 1e-3 move 0.01601 -0.0015 0 friction 0.3 &
                heat conductance 1e5 temperature 350 effusivity 3000
fix_modify      tool move linear -150 0 0
compute         fc all cutting/force tool
thermo_style    custom step time dt c_fc[1] c_fc[2] f_tool[10] f_tool[12] f_body[*9]
"""

# a bar of which only what is in a window that passes, or near the tool, is awake; the window is faster than any tool
ASLEEP = lattice_block("0 0.03 -0.006 0 0 0.006", "-0.01 0.04 -0.02 0.02 -0.01 0.02", dim=3) + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 {style}
pair_coeff      1 1 materials.sphtm c45e
region          base block INF INF INF -0.005 INF INF units box
group           base region base
variable        way equal -2000*time
region          win block 0.024 0.034 INF INF INF INF units box move v_way NULL NULL
region          bar cylinder z 0.027 -0.002 0.003 INF INF units box move v_way NULL NULL
region          both union 2 win bar
fix             body all sph/tm temperature 300 {fix}
fix             hold base setforce 0 0 0
fix             tool all contact/tri file tool.stl scale 1e-3 move 0.03001 -0.0015 0 friction 0.3 &
                heat conductance 1e5 temperature 350 effusivity 3000
fix_modify      tool move linear -150 0 0
compute         fc all cutting/force tool
thermo_style    custom step time dt c_fc[1] c_fc[2] f_tool[10] f_tool[12] {sums}
"""
LEDGER = "f_body[*9]"

# plane stress, two bodies that rub and conduct, heat that leaves through the free surface, a driven end
BODIES = PLANE + """
lattice         sq 4e-4 origin 0.5 0.5 0
region          box block -0.02 0.04 -0.02 0.02 -0.5e-3 0.5e-3 units box
create_box      2 box
region          low block 0 0.02 -0.006 0 INF INF units box
region          high block 0.004 0.014 0 0.006 INF INF units box
create_atoms    1 region low
create_atoms    2 region high
pair_style      sph/tm wendland/c2 1.3 spacing 4e-4 plane stress
pair_coeff      1 1 density 7800 elastic 200e9 0.3 strength plastic 300e6 1e9 heat 50 480 0.9 emissivity 0.3
pair_coeff      2 2 density 2700 elastic 70e9 0.33 strength plastic 200e6 1e9 heat 150 900 0.9 emissivity 0.3
pair_coeff      1 2 contact friction 0.2 conductance 2e4
group           high type 2
group           low type 1
velocity        high set 30 -10 0 units box
region          end block INF 2e-3 INF INF INF INF units box
group           end region end
fix             body all sph/tm temperature 293 energy yes
fix_modify      body temperature high 400
fix             air all sph/tm/heat convection 1e4 300
fix             sun high sph/tm/heat radiation 900
fix             pull end sph/tm/drive 5 0 NULL
thermo_style    custom step time dt f_body[*9] f_air f_sun f_pull
"""

# a tool whose inside is made of particles that conduct
TOOL_OF_PARTICLES = PLANE + """
lattice         sq 4e-4 origin 0.5 0.5 0
region          box block -0.02 0.04 -0.02 0.02 -0.5e-3 0.5e-3 units box
create_box      2 box
region          work block 0 0.02 -0.006 0 INF INF units box
region          tool block 0.004 0.014 0.0004 0.008 INF INF units box
create_atoms    1 region work
create_atoms    2 region tool
pair_style      sph/tm cubic 1.3 spacing 4e-4
pair_coeff      1 1 density 2700 elastic 70e9 0.33 strength plastic 200e6 1e9 heat 150 900 0.9
pair_coeff      2 2 density 7800 elastic 200e9 0.3 heat 50 480 0.9 body heat
fix             body all sph/tm temperature 293 energy yes
fix             tool all contact/tri file box.stl friction 0.4 particles 2
fix_modify      tool move linear 20 -60 0
thermo_style    custom step time dt f_tool[2] f_tool[10] f_tool[11] f_body[*9]
"""


def insert(folder):
    words = ["insert", "--rake", "10", "--clearance", "7", "--width", "20", "--height", "12", "--length", "8",
             "--radius", "0"]
    subprocess.run([sys.executable, os.path.join(SOURCE, "tools", "make_tool.py"), *words, "-o",
                    os.path.join(folder, "tool.stl")], check=True, stdout=subprocess.DEVNULL)


def box_stl(lo, hi):
    """A box of twelve triangles, normals outward."""
    c = [[(lo, hi)[n >> d & 1][d] for d in range(3)] for n in range(8)]
    quads = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]
    text = "solid box\n"
    for a, b, d, e in quads:
        for t in ((a, b, d), (a, d, e)):
            corners = "".join("vertex %r %r %r\n" % tuple(c[n]) for n in t)
            text += "facet normal 0 0 0\nouter loop\n" + corners + "endloop\nendfacet\n"
    return text + "endsolid box\n"


PLASTIC = "strength plastic 300e6 1e9"
JOHNSON_COOK = "strength johnson/cook 324e6 114e6 0.42 0.002 1.34 293 855 1.0 heat 167 896 0.9"
# a thermo column that must have become other than 0, of the scenes with contact
TOUCHING = {"cut": "f_tool[12]", "asleep, window": "f_tool[12]", "bodies, heat fixes, drive": "f_body[5]", "tool of particles": "f_tool[11]"}
# name, script; more than one block of particles (backend.h) each, so that threads share them
SCENES = {
    "elastic": BAR.format(style="", material="", fix="") + end(60),
    "plastic, hardening": BAR.format(style="", material=PLASTIC, fix="") + end(60),
    "Johnson-Cook, conduction": BAR.format(style="", material=JOHNSON_COOK, fix="energy yes") + end(60),
    "corrected, shock, quintic": BAR.format(style="correction yes artstress 0 4", fix="", material=PLASTIC +
                                            " eos shock 5300 1.34 2.0").replace("hyperbolic 1.2", "quintic 1.0")
                                            + end(40),
    "form f14, tait, artstress by component": BAR.format(style="form f14 artstress 0.3 4 component viscosity 0.5 0.5",
                                                         material=PLASTIC + " eos tait 7", fix="") + end(60),
    "smoothing length that follows": BAR.format(style="", material=JOHNSON_COOK, fix="energy yes\n"
                                                "fix lists all adapt/neigh asph psi every 2") + end(60, VALUES + " h"),
    "lists with a margin": BAR.format(style="", material=JOHNSON_COOK,
                                      fix="\nfix lists all adapt/neigh threshold 0 margin 0.2") + end(60),
    "lists that are kept": BAR.format(style="", material=JOHNSON_COOK,
                                      fix="\nfix lists all adapt/neigh threshold 1e-3") + end(220),
    "lists that are kept, corrected": BAR.format(style="correction yes", material=JOHNSON_COOK,
                                                 fix="\nfix lists all adapt/neigh threshold 1e-3") + end(220),
    "rows by the reach of each": BAR.format(style="", material=JOHNSON_COOK, fix="\nfix lists all adapt/neigh asph psi "
                                            "every 2 threshold 0 margin 0.1") + end(40, VALUES + " h"),
    "without artificial terms": BAR.format(style="viscosity 0 0 artstress 0 4", material="",
                                           fix="courant 0.2") + end(60),
    "cut": CUT + end(80),
    "bodies, heat fixes, drive": BODIES + end(150, VALUES + " surface/area"),
    "tool of particles": TOOL_OF_PARTICLES + end(150),
    # 'active' is the first column of the values
    "asleep, window": ASLEEP.format(style="", fix="energy yes active region win speed 5 every 5", sums=LEDGER)
                      + end(120, "active " + VALUES),
    "asleep, window of several regions": ASLEEP.format(style="", fix="conduction explicit active region both speed 5 "
                                                       "every 7\nfix air all sph/tm/heat convection 1e4 280",
                                                       sums="f_body[1]")
                                         + end(120, "active " + VALUES + " surface/area"),
    "asleep, near the tool": ASLEEP.format(style="stabilize artstress", fix="active near 3e-3 speed 5 every 5",
                                           sums="f_body[1]")
                             + end(120, "active " + VALUES),
    "asleep, in stages": ASLEEP.format(style="", fix="energy yes active region win speed 5 every 5", sums=LEDGER).replace(
        "c45e", "c45e set conductivity 5e6") + end(60, "active " + VALUES),
    # they conduct so well that a step takes stages
    "conduction in stages": BAR.format(style="", material=JOHNSON_COOK.replace("heat 167", "heat 3.3e7"),
                                       fix="energy yes") + end(60),
    "conduction in stages, lists": BAR.format(style="", material=JOHNSON_COOK.replace("heat 167", "heat 3.3e7"),
                                              fix="\nfix lists all adapt/neigh asph psi every 2 threshold 0 margin 0.1")
                                              + end(40, VALUES + " h"),
    "tool of particles, conduction in stages": TOOL_OF_PARTICLES.replace("heat 150", "heat 1.5e8").replace(
        "heat 50", "heat 5e7") + end(150),
}
FILES = {"box.stl": box_stl((0.004, 1e-5, -0.01), (0.014, 0.0085, 0.01))}
