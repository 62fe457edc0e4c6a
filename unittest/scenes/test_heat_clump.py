"""Two particles that lie close together swap heat, but no more than evens them out.

An elastic block whose outer layers move apart, with the hyperbolic kernel and nothing against the tensile instability.
One particle starts at 0.11 spacings from its neighbor, is moved to 1e-3 spacings from it and held there. Elastic material
makes no heat and no temperature acts on it: what begins between 300 and 305 K stays there, and so does the mean."""
import numpy as np

from sphtm_scene import Checks, run

SCENE = """
units si
dimension 3
boundary f f f
atom_style atomic
newton off
lattice sc 1e-5 origin 0.5 0.5 0.5
region box block -1e-4 1e-4 -1e-4 1e-4 -1e-4 1e-4 units box
create_box 1 box
region body block -5e-5 5e-5 -5e-5 5e-5 -5e-5 5e-5 units box
create_atoms 1 region body
region one block 0 1e-5 0 1e-5 0 1e-5 units box
group one region one
region two block 0 2e-5 0 1e-5 0 1e-5 units box
group two region two
region inner block -3e-5 3e-5 -3e-5 3e-5 -3e-5 3e-5 units box
group inner region inner
group outer subtract all inner
pair_style sph/tm hyperbolic 1.2 spacing 1e-5 viscosity 1 1 artstress 0 4 hourglass 0 correction no
pair_coeff 1 1 density 44.3e6 elastic 113.8e9 0.34 eos linear strength elastic heat 6.3 0.0531 0.9
fix body all sph/tm temperature 300 effects artificial-heat off
fix_modify body temperature one 305
displace_atoms one move 0.89e-5 0 0 units box
variable vx atom 300*x
variable vy atom 300*y
variable vz atom 300*z
velocity all set v_vx v_vy v_vz units box
fix hold outer setforce 0 0 0
group other subtract two one
variable gap equal xcm(other,x)-xcm(one,x)-1e-8
variable v equal 0.1*(v_gap>0)
fix near one sph/tm/drive v_v 0 0
fix rest other sph/tm/drive 0 0 0
compute T all sph/tm/atom temperature
compute lo all reduce min c_T
compute hi all reduce max c_T
compute mean all reduce ave c_T
thermo_style custom step time dt c_lo c_hi c_mean
thermo_modify format float %.15g
thermo 100
dump 1 two custom 20 two.dump id x y z
dump_modify 1 sort id format float %.17g
run 1700
"""
checks = Checks()

result = run(SCENE)
log = result.thermo[0]
apart = [np.sqrt(sum((f[k][1] - f[k][0])**2 for k in "xyz")) / 1e-5 for f in result.dump("two.dump")]
checks.below("closest that the two come (spacings)", min(apart), 2e-3)
checks.above("coldest particle (K)", log["c_lo"].min(), 300 - 1e-6)
checks.below("hottest particle (K)", log["c_hi"].max(), 305 + 1e-6)
checks.below("   at the end", log["c_hi"][-1], 301)
checks.near("mean temperature at the end (K)", log["c_mean"][-1], log["c_mean"][0], relative=1e-12)
checks.end()
