"""A plate with a hole in its mesh: particles over the hole fall through, the others bounce."""
import os

from floors import strips, write_stl
from frame import SPACE, Case

HALF = 2.0e-3    # of the square hole; particles stand on a grid of 1.5 mm: 9 of 49 are over it, none near its rim


def prepare(folder, settings):
    left, right = strips([-0.02, -HALF]), strips([HALF, 0.02])
    def across(a, b):
        return [((-HALF, a, 0), (HALF, a, 0), (HALF, b, 0)), ((-HALF, a, 0), (HALF, b, 0), (-HALF, b, 0))]
    middle = across(-0.02, -HALF) + across(HALF, 0.02) + ([] if settings["hole"] else across(-HALF, HALF))
    write_stl(os.path.join(folder, "floor.stl"), left + right + middle)


def judge(r):
    e = {k: r.end[k][r.end["type"] == 1] for k in "xyz"}
    over = (abs(e["x"]) < HALF) & (abs(e["y"]) < HALF)
    return float((over != (e["z"] < 0)).sum() + (49 - len(over)))


CASE = Case(
    title="mesh with a hole",
    criterion="particles on the wrong side",
    counter="no hole",
    setup=SPACE + """
lattice         sc 1.5e-3
region          box block -0.012 0.012 -0.012 0.012 -0.012 0.012 units box
create_box      2 box
region          work block -4.6e-3 4.6e-3 -4.6e-3 4.6e-3 1.4e-3 1.6e-3 units box
create_atoms    1 region work
# a body elsewhere, as a scene without neighbors is refused
lattice         sc 5e-4
region          body block 9e-3 10e-3 9e-3 10e-3 6e-3 7e-3 units box
create_atoms    2 region body
pair_style      sph/tm hyperbolic 1.2 spacing 5e-4
pair_coeff      * * density 7850 elastic 210e9 0.3
pair_coeff      1 2 none
velocity        all set 0 0 -50 units box
""",
    model="""
fix             body all sph/tm energy yes
fix             floor all contact/tri file floor.stl
thermo          50
thermo_style    custom step time dt f_floor[3] f_floor[13] f_body[1] f_body[9]
""",
    steps=2000, prepare=prepare, settings={"hole": 1}, bad={"hole": 0}, judge=judge, limit=0)
