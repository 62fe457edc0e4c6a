"""A plate flies apart: its particles fail one after the other, and their smoothing lengths grow after neighbors that go
away for good."""
from frame import Case, lattice_block


def judge(r):
    """Largest h over the one of the start, or 100 times the change of the energy sum over the kinetic energy of the
    start; 10 where nothing failed."""
    if r.end["c_p"].mean() < 0.5:
        return 10.0
    drift = 100 * abs(r.t["f_body[9]"] - r.t["f_body[9]"][0]).max() / r.t["f_body[1]"][0]
    return max(r.t["f_ad[2]"].max() / r.t["f_ad[2]"][0], drift)


CASE = Case(
    title="h-growth at free surfaces",
    criterion="largest h over that of the start, or 100 times the change of the energy sum over the kinetic energy",
    counter="no limit: h up to 50 times that of the start",
    setup=lattice_block("0 0.012 0 0.012", "-0.05 0.062 -0.05 0.062") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 2700 elastic 70e9 0.33 strength plastic 100e6 1e9 damage strain 0.1
variable        vx atom 1e5*(x-0.006)
variable        vy atom 1e5*(y-0.006)
velocity        all set v_vx v_vy NULL
""",
    model="""
fix             body all sph/tm courant 0.4 energy yes
fix             ad all adapt/neigh asph psi every 5 limits 0.5 {most}
compute         p all sph/tm/atom damage
thermo          20
thermo_style    custom step time dt f_ad[1] f_ad[2] f_ad[3] f_body[1] f_body[3] f_body[7] f_body[9] f_body[12]
""",
    steps="steps", settings={"most": 2, "steps": 1200}, bad={"most": 50}, judge=judge, limit=2.001, values="c_p")
