"""A block hits another; one particle is moved by 1e-12 spacings. How the difference grows must not depend on how the
run is done: one rank, two ranks, and with Kokkos (where SPHTM_LMP_KK and LAMMPS_PLUGIN_PATH_KK say where it is) threads
and the loops of a GPU."""
import os
import re
import time

import numpy as np

from frame import PLANE, STOPS, answer, run

MOVED = 1e-12
LIMIT = 100
TITLE = "growth of a perturbation of 1e-12 spacings"
CRITERION = ("difference after 1500 steps over the one at the start, largest of one rank, two ranks and, where there "
             "is one, Kokkos")
COUNTER = "courant 1 without viscosity"
SCENE = PLANE + """
atom_modify     map array
lattice         sq 1e-3 origin 0.5 0.5 0
region          box block -0.02 0.04 -0.02 0.03 -0.001 0.001 units box
create_box      1 box
region          left block 0 0.01 0 0.01 INF INF units box
region          right block 0.01 0.02 0 0.01 INF INF units box
create_atoms    1 region left
create_atoms    1 region right
group           right region right
group           one id 45
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 {options}
pair_coeff      1 1 density 7830 elastic 200e9 0.29 strength plastic 400e6 500e6
velocity        right set -100 0 0 units box
displace_atoms  one move {moved} 0 0 units box
fix             body all sph/tm courant {courant}
run             1500
write_dump      all custom end.dump id x y modify sort id format float %.17g
"""


def grown(options, courant, **how):
    ends = []
    for moved in (0.0, MOVED * 1e-3):
        r = run(SCENE.format(options=options, courant=courant, moved=repr(moved)), expect_error=True, **how)
        if r.status and not re.search(STOPS, r.errors()):
            raise SystemExit("perturbation: " + (r.errors() or r.output[-500:]))
        if r.status:
            return float("inf")
        e = r.dump("end.dump")[-1]
        ends.append(np.c_[e["x"], e["y"]])
    return abs(ends[1] - ends[0]).max() / (MOVED * 1e-3)


def measure(quick):
    began = time.time()
    ways = {"one rank": {}, "two ranks": {"ranks": 2}}
    if os.environ.get("SPHTM_LMP_KK"):
        there = {"SPHTM_LMP": os.environ["SPHTM_LMP_KK"], "LAMMPS_PLUGIN_PATH": os.environ["LAMMPS_PLUGIN_PATH_KK"],
                 "OMP_PROC_BIND": "false"}
        kk = ["-k", "on", "t", "2", "-sf", "kk"]
        ways["Kokkos, threads"] = {"environment": there, "arguments": kk}
        ways["Kokkos, loops of a GPU"] = {"environment": dict(there, SPHTM_KOKKOS_LOOPS="device"), "arguments": kk}
    factors = {name: grown("", 0.4, **how) for name, how in ways.items()}
    return answer(TITLE, CRITERION, COUNTER, LIMIT, 1500, began, max(factors.values()), grown("viscosity 0 0", 1.0),
                  factors=factors)
