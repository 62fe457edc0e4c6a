#!/usr/bin/python3
"""How far a strip of hardening metal can be drawn, in plane strain, by kind of list, number of rows and irregularity of its particles:

    eval "$(./sphtm env)"; bench/stability/drawn_strip.py [--rows 12 24] [--noise 0 0.02]

The metal of case_tension.py (Considere: it necks at 2.67 times its length), 20 by 6 mm between two grips, pulled at 100 m/s to 2.2 times its
length. Printed: the length, over that at the start, at which 99 % of the plastic work of the run was done: where the strip came apart, or nearly 2.2 where
it did not. Noise: positions between the grips moved at random by up to this times the spacing, each way."""
import argparse
import os
import sys

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(HERE)), "unittest", "scenes"))
from case_tension import METAL, PULL, STRIP                                            # noqa: E402
from sphtm_scene import run                                                            # noqa: E402

SCRIPT = STRIP + "group strip subtract all base head\n{noise}\npair_style sph/tm hyperbolic 1.2 spacing {dx}\n" + METAL + """
fix             body all sph/tm energy yes {effects}
{lists}
""" + PULL + """
variable        long equal (xcm(head,x)-xcm(base,x)-0.002)/0.020
fix             stop all halt 50 v_long > 2.2 error continue message no
thermo          50
thermo_style    custom step time v_long f_body[3] f_body[9] f_body[15]
run             1000000
"""
LISTS = {"default": ("", ""), "shifting off": ("", "effects shifting off"), "asph": ("fix ad all adapt/neigh asph psi every 2 limits 0.5 3", ""),
         "kept pairs": ("fix ad all adapt/neigh threshold inf rows 400", "")}


def drawn(lists, rows, noise):
    dx = 6e-3 / rows
    move = "displace_atoms strip random %r %r 0 777 units box" % (noise * dx, noise * dx) if noise else ""
    t = run(SCRIPT.format(dx=dx, noise=move, lists=LISTS[lists][0], effects=LISTS[lists][1])).thermo[0]
    work = t["f_body[3]"]
    return t["v_long"][(work > 0.99 * work[-1]).argmax()]


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--rows", type=int, nargs="+", default=[12, 24])
    parser.add_argument("--noise", type=float, nargs="+", default=[0.0, 0.02])
    parser.add_argument("--lists", nargs="+", choices=LISTS, default=list(LISTS))
    args = parser.parse_args()
    for lists in args.lists:
        for rows in args.rows:
            for noise in args.noise:
                print("%-14s %3d rows, noise %-5g came apart, or ended, at %.2f" % (lists, rows, noise, drawn(lists, rows, noise)), flush=True)
