#!/usr/bin/python3
"""Metal in tension whose particles lie on a lattice that is turned against the pull, so that its faces have steps of a spacing:

    eval "$(./sphtm env)"; bench/stability/turned_strip.py [--angles 0 2.9 14 26.6 45] [--rows 8 16] [--kept]

A strip of hardening metal, 30 by 4 mm in plane stress, is pulled at both ends with 50 m/s from a velocity that is linear already. Flow stress 300 MPa + 1 GPa
times the plastic strain, so by Considere it necks from a strain of 0.7 on. Printed: force over flow stress times the section of a body of the same volume,
at strains of 0.06, 0.1, 0.15, 0.2 and 0.25, which an even lattice has within 1.5 %; the share of the work that artificial terms have taken; particles of numerical fracture. Then a ring of the same
metal, 2 mm thick at a radius of 20 mm, cut from a square lattice and thrown outward with 200 m/s: its mean plastic strain when it has come to rest, 0.142 of a thin ring."""
import argparse
import math
import os
import sys

import numpy as np

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(HERE)), "unittest", "scenes"))
from sphtm_scene import run                                                            # noqa: E402

AT = (0.06, 0.1, 0.15, 0.2, 0.25)
HEAD = """
units si
dimension 2
boundary f f p
atom_style atomic
newton off
lattice sq {dp} origin 0.5 0.5 0 {orient}
region box block -0.04 0.04 -0.04 0.04 -{dp} {dp} units box
create_box 1 box
"""
METAL = """
pair_style sph/tm hyperbolic 1.2 spacing {dp} plane stress
pair_coeff 1 1 density 2700 elastic 70e9 0.3 strength plastic 300e6 1e9
{lists}
fix body all sph/tm energy yes
"""
STRIP = HEAD + """
region strip block -0.015 0.015 -0.002 0.002 INF INF units box
create_atoms 1 region strip
region left block INF -0.014 INF INF INF INF units box
region right block 0.014 INF INF INF INF INF units box
group left region left
group right region right
""" + METAL + """
variable v atom 50*x/0.015
velocity all set v_v 0 0 units box
fix left left sph/tm/drive -50 NULL NULL
fix right right sph/tm/drive 50 NULL NULL
variable strain equal ln(1+100*time/0.029)
variable over equal time-8.3e-5
fix stop all halt 10 v_over > 0 error continue message no
thermo 20
thermo_style custom step time v_strain f_right[1] f_body[7] f_body[8] f_body[9] f_body[15]
run 100000
"""
RING = HEAD + """
region outer cylinder z 0 0 0.021 INF INF units box
region inner cylinder z 0 0 0.019 INF INF side out units box
region ring intersect 2 outer inner
create_atoms 1 region ring
""" + METAL + """
variable vx atom 200*x/sqrt(x*x+y*y)
variable vy atom 200*y/sqrt(x*x+y*y)
velocity all set v_vx v_vy 0 units box
compute p all sph/tm/atom pstrain
compute mean all reduce ave c_p
compute most all reduce max c_p
variable over equal time-40e-6
fix stop all halt 10 v_over > 0 error continue message no
thermo 20
thermo_style custom step time c_mean c_most f_body[1] f_body[7] f_body[8] f_body[9] f_body[15]
run 100000
"""
# multiples of the spacing along and across that make an angle
ANGLES = {0.0: None, 2.9: (20, 1), 5.7: (10, 1), 14.0: (4, 1), 26.6: (2, 1), 45.0: (1, 1)}
KEPT = "fix lists all adapt/neigh threshold inf"


def share_of_artificial(t):
    """Of what went in and what was there at the start."""
    return t["f_body[7]"][-1] / (t["f_body[9]"][0] + abs(t["f_body[8]"][-1]))


def strip(angle, rows, lists=""):
    """Force over that of the flow curve at AT, share of artificial terms, particles of numerical fracture."""
    turn = ANGLES[angle]
    orient = "orient x %d %d 0 orient y %d %d 0" % (turn[0], turn[1], -turn[1], turn[0]) if turn else ""
    t = run(STRIP.format(dp=4e-3 / rows, orient=orient, lists=lists)).thermo[-1]
    force = -np.interp(AT, t["v_strain"], t["f_right[1]"])
    return [f / (4e-3 * (300e6 + 1e9 * e) * math.exp(-e)) for f, e in zip(force, AT)], share_of_artificial(t), t["f_body[15]"][-1]


def ring(rows, lists=""):
    """Mean and largest plastic strain at the end, share of artificial terms, particles of numerical fracture."""
    t = run(RING.format(dp=2e-3 / rows, orient="", lists=lists)).thermo[-1]
    return t["c_mean"][-1], t["c_most"][-1], share_of_artificial(t), t["f_body[15]"][-1]


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--angles", type=float, nargs="+", choices=ANGLES, default=list(ANGLES))
    parser.add_argument("--rows", type=int, nargs="+", default=[8])
    parser.add_argument("--kept", action="store_true", help="with pairs that are kept")
    args = parser.parse_args()
    kept = KEPT if args.kept else ""
    for rows in args.rows:
        for angle in args.angles:
            forces, artificial, torn = strip(angle, rows, kept)
            print("%4.1f degrees, %d rows: %s; artificial %.1f %%, torn %d" % (
                angle, rows, " ".join("%.3f" % f for f in forces), 100 * artificial, torn), flush=True)
    for rows in (4, 8):
        mean, most, artificial, torn = ring(rows, kept)
        print("ring, %d rows: plastic strain %.4f, at most %.3f; artificial %.1f %%, torn %d" % (rows, mean, most, 100 * artificial, torn), flush=True)
