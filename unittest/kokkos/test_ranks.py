"""Particles that cross from rank to rank keep every value: two blocks fly diagonally through a periodic box, past each
other and across all borders, turn and are deformed on the way. One, two and four ranks give the same bits, whether
particles are exchanged and sorted by LAMMPS's host code or where the loops run, in their own memory or the host's. The
same with rows of neighbors that are kept, also for ever, and with walls that let particles go for ever."""
import numpy as np
from kokkos_scene import Checks, run_way, same_bits

SCENE = """
units           si
dimension       3
boundary        {boundary}
atom_style      atomic
newton          off
atom_modify     sort 7 2e-3
lattice         sc 1e-3 origin 0.5 0.5 0.5
region          box block 0 0.024 0 0.024 0 0.024 units box
create_box      1 box
region          a block 0.002 0.008 0.002 0.008 0.002 0.008 units box
region          b block 0.014 0.020 0.014 0.020 0.002 0.008 units box
create_atoms    1 region a
create_atoms    1 region b
group           a region a
group           b region b
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 {style}
pair_coeff      1 1 materials.sphtm c45e damage johnson/cook 0.5 1.0 -3.0 0.01 1.0
velocity        a set 300 270 240 units box
velocity        b set -280 210 -260 units box
variable        wx atom -6e4*(x-5e-3)-3e4*(y-5e-3)
variable        wy atom 3e4*(x-5e-3)
velocity        a set v_wx v_wy NULL sum yes units box
fix             body all sph/tm temperature 300 energy yes lost ignore
{fix}
compute         p all sph/tm/atom density temperature pstrain pstrain/rate flowstress vonmises pressure &
                stress/xy damage failed soundspeed
thermo          200
thermo_modify   lost ignore
run             600
write_dump      all custom end.dump id x y z vx vy vz fx fy fz ix iy iz c_p[*] modify format float %.17g
"""

ON_DEVICE = "-pk kokkos comm device sort device"
HOST_CODE = "classic", "legacy"    # what versions of LAMMPS call it in the warning that they go back to it
checks = Checks()


def fly(name, scene, all_ranks, open_box=False):
    plain = run_way("plain", scene)
    frame = plain.dump("end.dump")[-1]
    gone = 432 - len(frame["x"])
    through = np.count_nonzero(abs(frame["ix"]) + abs(frame["iy"]) + abs(frame["iz"]))
    checks.above(name + ": particles that went through a face of the box", gone if open_box else through,
                 10 if open_box else 100)
    checks.true(name + ": none went for ever but through an open wall", (gone > 0) == open_box, "%d did" % gone)
    checks.above(name + ": largest plastic strain", frame["c_p[3]"].max(), 1e-3)
    default = run_way("plain default", scene)
    for ranks in all_ranks:
        what = "%s, %d ranks" % (name, ranks)
        same_bits(checks, what, run_way("serial", scene, ranks=ranks), plain)
        result = run_way("serial", scene, ranks=ranks, options=ON_DEVICE)
        same_bits(checks, what + ", exchanged where the loops run", result, plain)
        went_back = [w for w in result.warnings() if any(word in w for word in HOST_CODE)]
        checks.true(what + ": without LAMMPS's host code", not went_back, " ".join(result.warnings()))
        same_bits(checks, what + ", device loops", run_way("device", scene, ranks=ranks, options=ON_DEVICE), default)
        same_bits(checks, what + ", device loops, rates of the interior while records travel",
                  run_way("interior first", scene, ranks=ranks, options=ON_DEVICE), default)


RARE = "balsara yes xsph 0.05 correction yes hourglass 0.02"
KEPT, ONCE = ("fix lists all adapt/neigh threshold " + t for t in ("1e-3", "inf"))
fly("lists of LAMMPS", SCENE.format(boundary="p p p", style=RARE, fix=""), (1, 2, 4))
fly("kept rows", SCENE.format(boundary="p p p", style="", fix=KEPT), (1, 2))
fly("walls", SCENE.format(boundary="f f f", style=RARE, fix=""), (1,), open_box=True)
fly("walls, kept rows", SCENE.format(boundary="f f f", style="", fix=KEPT), (1,), open_box=True)
fly("walls, rows searched once", SCENE.format(boundary="f f f", style="", fix=ONCE), (2,), open_box=True)
checks.end()
