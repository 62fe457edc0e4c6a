"""A strip of hardening metal, pulled to three times its length, with smoothing lengths that follow it."""
import numpy as np

from frame import Case, lattice_block


def judge(r):
    """1 minus the least cross section of the gauge over its mean; 1 where the strip came apart."""
    e, dx = r.end, r.settings["dx"]
    lo, hi = e["x"].min() + 6 * dx, e["x"].max() - 6 * dx
    inside = (e["x"] > lo) & (e["x"] < hi)
    bins = np.histogram(e["x"][inside], bins=int((hi - lo) / (4 * dx)))[0]
    return 1 - bins.min() / bins.mean()


STRIP = lattice_block("-0.012 0.012 -0.003 0.003", "-0.03 0.06 -0.01 0.01", "{dx}") + """
region          base block INF -0.010 INF INF INF INF units box
region          head block 0.010 INF INF INF INF INF units box
group           base region base
group           head region head
"""
METAL = "pair_coeff      1 1 density 8930 elastic 117e9 0.35 strength plastic 100e6 5e9\n"
PULL = """
variable        v equal 100*((time<2e-5)*time/2e-5+(time>=2e-5))
fix             hold base sph/tm/drive 0 0 0
fix             pull head sph/tm/drive v_v 0 0
"""
CASE = Case(
    title="tension to 200 %",
    criterion="1 - least cross section over the mean one, in the gauge",
    counter="no hourglass control",
    setup=STRIP + "pair_style      sph/tm hyperbolic 1.5 spacing {dx} {options}\n" + METAL,
    model="""
fix             body all sph/tm courant 0.4 energy yes
fix             lists all adapt/neigh asph psi every 2 limits 0.5 3
""" + PULL + """
thermo          500
variable        long equal (xcm(head,x)-xcm(base,x))/0.022
thermo_style    custom step time dt v_long f_pull[1] f_body[3] f_body[7] f_body[9]
""",
    steps="steps", settings={"dx": 5e-4, "options": "", "steps": 15000}, bad={"options": "hourglass 0"}, judge=judge, limit=0.5)
