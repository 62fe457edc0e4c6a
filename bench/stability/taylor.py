"""A copper bar hits a rigid wall: the scene of examples/taylor_bar at four speeds."""
import os
import subprocess
import sys

from frame import ROOT, SPACE, Case


def prepare(folder, settings):
    subprocess.run([sys.executable, os.path.join(ROOT, "examples", "taylor_bar", "make_bar.py"), str(settings["rings"]),
                    "3.2e-3", "32.4e-3", "8930"], cwd=folder, check=True, stdout=subprocess.DEVNULL)


def judge(r):
    """Drift of the energy sum, or energy that the artificial terms made, over the kinetic energy of the shot."""
    kinetic = r.t["f_body[1]"][0]
    return max(abs(r.t["f_body[9]"] - r.t["f_body[9]"][0]).max(), -r.t["f_body[7]"].min()) / kinetic


def taylor(speed, steps, box=1):
    """box: by how much it is wider than that of the example, four radii on each side."""
    return Case(
        title="Taylor bar, %d m/s" % speed,
        criterion="drift of the energy sum, or energy made by artificial terms, over the kinetic energy",
        counter="artificial stress, which flow like this cannot have",
        setup=SPACE + """
read_data       bar.data
change_box      all x scale {box} y scale {box}
pair_style      sph/tm hyperbolic 1.2 spacing {dx} {options}
pair_coeff      1 1 density 8930 elastic 117e9 0.35 strength plastic 400e6 100e6
velocity        all set 0 0 -{speed} units box
""",
        model="""
fix             body all sph/tm temperature 298 courant 0.4 energy yes
fix             wall all contact/tri file plane.stl scale 0.05 move 0 0 $(-0.05*{dx})
thermo          50
thermo_style    custom step time dt f_wall[3] f_wall[13] f_body[1] f_body[2] f_body[3] f_body[4] f_body[7] f_body[9]
""",
        steps=steps, meshes={"plane.stl": "plane --size 1 1 --cells 2 2"}, prepare=prepare, judge=judge, limit=0.03,
        settings={"speed": speed, "box": box, "rings": 4, "dx": 0.000724131595, "options": ""},
        bad={"options": "viscosity 0.3 0.3 balsara yes artstress 0.3 4 correction yes"})
