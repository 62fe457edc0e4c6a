"""Heat through a jump of the conductivity by 1e4, with the longest step that conduction allows."""
from frame import PLANE, Case


def judge(r):
    """Beyond the temperatures at the start, or heat lost, over the jump."""
    hot, cold = 400.0, 300.0
    mean = r.t["c_mean"]
    return max(r.t["c_hi"].max() - hot, cold - r.t["c_lo"].min(), abs(mean - mean[0]).max()) / (hot - cold)


CASE = Case(
    title="conductivities 1 to 1e4, at the thermal limit of the step",
    criterion="temperature out of bounds, or heat lost, over the jump",
    counter="a step 1.5 times the limit",
    setup=PLANE + """
lattice         sq 1e-2 origin 0.5 0.5 0
region          box block 0 1 0 0.08 -0.5 0.5 units box
create_box      2 box
region          a block 0 0.5 INF INF INF INF units box
region          b block 0.5 1 INF INF INF INF units box
create_atoms    1 region a
create_atoms    2 region b
group           b type 2
pair_style      sph/tm hyperbolic 1.2 spacing 1e-2
pair_coeff      1 1 density 1 elastic 1 0.3 heat 1 1 0 body heat
pair_coeff      2 2 density 1 elastic 1 0.3 heat 1e4 1 0 body heat
pair_coeff      1 2 heat
mass            * 1e-4
""",
    model="""
fix             body all sph/tm temperature 300 conduction explicit dt {dt}
compute         T all sph/tm/atom temperature
compute         hi all reduce max c_T
compute         lo all reduce min c_T
compute         mean all reduce ave c_T
thermo          1
thermo_style    custom step time dt c_hi c_lo c_mean
""",
    before="fix_modify body temperature b 400\n",
    steps=10000, settings={"dt": 1.6e-9}, bad={"dt": 2.4e-9}, judge=judge, limit=1e-9,
    stops="is not stable: heat conduction allows")
