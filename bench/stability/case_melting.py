"""A block is sheared, heated beyond its melting temperature, and cooled until it is solid again."""
import numpy as np

from frame import Case, lattice_block


def judge(r):
    """Mean stress while molten over the mean stress before; 1 where it has not come back after cooling."""
    T, vm = r.t["c_T"], r.t["c_mises"]
    molten = T > 1800
    before = vm[(T < 400) & (np.arange(len(T)) < len(T) // 3)].max()
    return vm[molten].min() / before if vm[-1] > 0.3 * before else 1.0


CASE = Case(
    title="melting and solidification",
    criterion="stress while molten over the stress before; back after cooling",
    counter="a strength that knows no temperature",
    setup=lattice_block("-0.01 0.01 0 0.01", "-0.03 0.03 -0.002 0.02") + """
region          base block INF INF INF 0.002 INF INF units box
region          head block INF INF 0.008 INF INF INF units box
group           base region base
group           head region head
group           middle subtract all base head
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 7830 elastic 200e9 0.29 strength {strength} heat 38 477 0.9
""",
    model="""
fix             body all sph/tm temperature 300 energy yes
variable        T equal "300+1600*(time>1e-5)*((time<3e-5)*(time-1e-5)/2e-5 + (time>=3e-5)*(time<5e-5) + &
                (time>=5e-5)*(time<7e-5)*(7e-5-time)/2e-5)"
fix             warm all sph/tm/heat temperature v_T
variable        v equal 20*((time<5e-6)*time/5e-6+(time>=5e-6))
fix             hold base sph/tm/drive 0 0 0
fix             pull head sph/tm/drive v_v 0 0
compute         p all sph/tm/atom vonmises temperature
compute         mises middle reduce ave c_p[1]
compute         T middle reduce ave c_p[2]
thermo          50
thermo_style    custom step time dt c_T c_mises f_body[1] f_body[3] f_body[9]
""",
    steps=2600, settings={"strength": "johnson/cook 792e6 510e6 0.26 0.014 1.03 298 1793 1"},
    bad={"strength": "plastic 792e6 510e6"}, judge=judge, limit=0.05)
