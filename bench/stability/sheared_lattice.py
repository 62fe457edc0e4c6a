#!/usr/bin/python3
"""Metal in shear whose particles lie on a lattice that is turned against the shear:

    eval "$(./sphtm env)"; bench/stability/sheared_lattice.py [--angles 0 9.5 18.4 26.6 45] [--hardening 0 500] [--rows 12 24]
    eval "$(./sphtm env)"; bench/stability/sheared_lattice.py --cut [--angles 0 20] [--spacings 8 16]

A layer that is periodic along the shear, 12 mm high, between two driven grips, flow stress 350 MPa plus hardening times the plastic strain. Printed: shear
stress over that of the flow curve at shears of 0.5, 1, 1.5, 2, 2.5 and 3; the largest pressure or tension across the layer over the shear flow stress at the same shears; the share of the
work that artificial terms have taken; particles of numerical fracture. With --cut the cut of the tutorial (examples/tutorial/in.2_cut) whose work piece is on a turned lattice: mean
cutting and feed force from 0.2 to 0.4 mm."""
import argparse
import math
import os
import sys

import numpy as np

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.join(ROOT, "unittest", "scenes"))
from sphtm_scene import run                                                            # noqa: E402

Y, SPEED, HEIGHT = 350e6, 20.0, 12e-3
AT = (0.5, 1.0, 1.5, 2.0, 2.5, 3.0)
SCENE = """
units           si
dimension       2
boundary        p f p
atom_style      atomic
newton          off
variable        dp equal {dp!r}
lattice         sq ${{dp}} origin 0.25 0.5 0 {orient}
region          box block 0 {width!r} -8e-3 20e-3 $(-0.5*v_dp) $(0.5*v_dp) units box
create_box      1 box
region          all block INF INF $(-4*v_dp) $(12e-3+4*v_dp) INF INF units box
create_atoms    1 region all
region          lower block INF INF INF 0 INF INF units box
region          upper block INF INF 12e-3 INF INF INF units box
group           lower region lower
group           upper region upper
group           between subtract all lower upper
pair_style      sph/tm hyperbolic 1.2 spacing ${{dp}}
pair_coeff      1 1 density 7850 elastic 210e9 0.3 strength plastic 350e6 {hardening!r}
fix             body all sph/tm energy yes energy/drift none effects shifting {shifting}
variable        v equal {speed}*((time<1e-5)*time/1e-5+(time>=1e-5))
variable        w equal -v_v
fix             down lower sph/tm/drive v_w 0 NULL
fix             up upper sph/tm/drive v_v 0 NULL
variable        shear equal 2*{speed}*(time-5e-6)/(12e-3+v_dp)
variable        stress equal (f_down[1]-f_up[1])/(2*{width!r})
variable        across equal (f_down[2]-f_up[2])/(2*{width!r})
thermo_style    custom step time v_shear f_body[7] f_body[8] f_body[15]
fix             mean all ave/time 5 20 100 v_shear v_stress v_across f_body[7] f_body[8] file shear.dat
variable        left equal {most}-v_shear
fix             stop all halt 100 v_left <= 0 error continue message no
thermo          100
run             10000000
"""
# multiples of the spacing along and across that make an angle
ANGLES = {0.0: (1, 0), 9.5: (6, 1), 18.4: (3, 1), 26.6: (2, 1), 45.0: (1, 1)}
CUTS = {0.0: (1, 0), 10.0: (17, 3), 20.0: (11, 4), -20.0: (11, -4), 45.0: (1, 1)}


def orient(turn):
    return "orient x %d %d 0 orient y %d %d 0" % (turn[0], turn[1], -turn[1], turn[0]) if turn[1] else ""


def sheared(angle, rows=12, hardening=0.0, shifting="on", most=3.05):
    """Of a layer: stress over that of the flow curve, and stress across over the shear flow stress, at AT; share of artificial terms; torn particles."""
    turn, dp = ANGLES[angle], HEIGHT / rows
    period = dp * math.hypot(*turn)
    width = period * max(round(12e-3 / period), 1)
    r = run(SCENE.format(dp=dp, orient=orient(turn), width=width, hardening=hardening, speed=SPEED, shifting=shifting, most=most))
    shear, stress, across, artificial, work = r.columns("shear.dat")[:, 1:].T
    at = [s for s in AT if s < most]
    due = (Y + hardening * shear / math.sqrt(3.0)) / math.sqrt(3.0)
    return np.interp(at, shear, stress / due), np.interp(at, shear, across / due), artificial[-1] / abs(work[-1]), r.thermo[-1]["f_body[15]"][-1]


def cut(angle, spacings=8, shifting="on", friction=0.3):
    """Mean cutting and feed force from 0.2 to 0.4 mm of the tutorial's cut, N per mm."""
    folder = os.path.join(ROOT, "examples", "tutorial")
    with open(os.path.join(folder, "in.2_cut")) as f:
        script = f.read()
    for old, new in (("origin 0.5 0.5 0", "origin 0.5 0.5 0 " + orient(CUTS[angle])), ("energy yes", "energy yes effects shifting " + shifting),
                     ("insert.stl", os.path.join(folder, "insert.stl"))):
        assert old in script, old
        script = script.replace(old, new, 1)
    if angle:    # the outermost particles of a turned lattice lie nearer to the tool
        assert "move 0.801e-3" in script
        script = script.replace("move 0.801e-3", "move 0.808e-3")
    t = run(script, {"dx": 0.1e-3 / spacings, "friction": friction, "length": 0.4e-3}, timeout=3000)
    data = t.columns("force.dat")
    late = data[:, 1] > 0.2e-3
    return data[late, 2].mean() * 1e-3, data[late, 3].mean() * 1e-3


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--angles", type=float, nargs="+")
    parser.add_argument("--rows", type=int, nargs="+", default=[12])
    parser.add_argument("--hardening", type=float, nargs="+", default=[0.0, 500.0], help="MPa")
    parser.add_argument("--shifting", default="on", choices=("on", "off"))
    parser.add_argument("--cut", action="store_true")
    parser.add_argument("--spacings", type=int, nargs="+", default=[8])
    parser.add_argument("--friction", type=float, nargs="+", default=[0.3])
    args = parser.parse_args()
    if args.cut:
        for n in args.spacings:
            for angle in args.angles or (0.0, 20.0):
                for friction in args.friction:
                    print("%d spacings, %g degrees, friction %g: %.1f, %.1f N/mm" % ((n, angle, friction) + cut(angle, n, args.shifting, friction)), flush=True)
        sys.exit()
    for rows in args.rows:
        for hardening in args.hardening:
            for angle in args.angles or ANGLES:
                stress, across, artificial, torn = sheared(angle, rows, 1e6 * hardening, args.shifting)
                print("%d rows, %g MPa, %g degrees: stress %s, across %s, artificial %.1f %%, torn %d" % (
                    rows, hardening, angle, np.round(stress, 3).tolist(), np.round(across, 2).tolist(), 100 * artificial, torn), flush=True)
