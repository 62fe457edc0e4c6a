"""Rows of fix adapt/neigh with a margin give the bits of LAMMPS's list.

Two blocks in contact, of which one oscillates, while a third piece flies by and makes LAMMPS renew its lists; a wide skin makes
rows of contact pairs longer than their room, more than once. A spinning, deforming block that flies from one rank to the other:
the last of its particles leaves a rank that has no ghosts any more. Positions, velocities and the energy sum are compared to the
last bit; with two ranks particles are numbered alike."""

import numpy as np
from sphtm_scene import Checks, run

HEAD = """
units si
dimension 2
boundary f f p
atom_style atomic
atom_modify map array
newton off
lattice sq 1e-3 origin 0.5 0.5 0
"""
END = """
thermo_style custom step time ke f_body[9]
thermo_modify format float %.17g norm no
thermo 500
run {steps}
write_dump all custom end.dump id x y vx vy modify sort id format float %.17g
"""
BLOCKS = HEAD + """
neighbor 5e-3 bin
region box block -20e-3 60e-3 -40e-3 60e-3 -0.5e-3 0.5e-3 units box
create_box 2 box
region b1 block 0 20e-3 0 10e-3 INF INF units box
region b2 block 0 20e-3 10e-3 20e-3 INF INF units box
region b3 block 30e-3 33e-3 0 3e-3 INF INF units box
create_atoms 1 region b1
create_atoms 2 region b2
create_atoms 1 region b3
group fly region b3
group low region b1
pair_style sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff * * density 7800 elastic 200e9 0.3
pair_coeff 1 2 contact
fix body all sph/tm energy yes
{lists}
variable vx atom 20*sin(PI*(x-10e-3)/20e-3)
velocity low set v_vx 0 NULL units box
velocity fly set 0 300 NULL units box
""" + END
CROSSES = HEAD + """
region box block -40e-3 80e-3 -40e-3 60e-3 -0.5e-3 0.5e-3 units box
create_box 1 box
region b block 10e-3 30e-3 10e-3 20e-3 INF INF units box
create_atoms 1 region b
pair_style sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff 1 1 density 7800 elastic 200e9 0.3 strength plastic 400e6 1e9
fix body all sph/tm energy yes
reset_atoms id sort yes
{lists}
variable vx atom 300+20*sin(PI*(x-20e-3)/20e-3)-500*(y-15e-3)
variable vy atom 210+500*(x-20e-3)
velocity all set v_vx v_vy 0 units box
""" + END


def end(script, lists, steps, ranks=1):
    r = run(script.format(lists=lists, steps=steps), ranks=ranks)
    state = r.dump("end.dump")[-1]
    return np.array([state[k] for k in ("x", "y", "vx", "vy")]), r.thermo[-1]["f_body[9]"][-1]


def same(checks, name, a, b):
    checks.true(name + ": the same bits", (a[0] == b[0]).all(), "apart by %.3g" % abs(a[0] - b[0]).max())
    checks.true("    the same energy sum", abs(a[1] / b[1] - 1) < 1e-13, "%.17g, %.17g" % (a[1], b[1]))


if __name__ == "__main__":
    checks = Checks()
    reference = end(BLOCKS, "", 1000)
    for margin in (0.05, 0.15, 0.3):
        same(checks, "two blocks in contact, margin %g" % margin,
             end(BLOCKS, "fix ad all adapt/neigh threshold 0 margin %g" % margin, 1000), reference)
    reference = end(CROSSES, "", 4000)
    same(checks, "a block that flies, one rank, margin 0.15", end(CROSSES, "fix ad all adapt/neigh threshold 0 margin 0.15", 4000), reference)
    for lists in ("", "fix ad all adapt/neigh threshold 0 margin 0.15", "fix ad all adapt/neigh threshold 0 margin 0.15 asph psi"):
        if "asph" in lists:
            reference = end(CROSSES, lists, 4000)
        same(checks, "two ranks, %s" % (lists[lists.find("threshold"):] if lists else "LAMMPS's list"), end(CROSSES, lists, 4000, 2), reference)
    checks.end()
