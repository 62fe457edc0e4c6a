"""A block lies on a floor under its weight for 1e6 steps."""
from frame import Case, lattice_block


def judge(r):
    """Drift of the centre after the first tenth of the run, in spacings, and speed over that of falling a spacing."""
    n = len(r.t["Step"]) // 10
    drift = max(abs(r.t[k][n:] - r.t[k][n]).max() for k in ("v_x", "v_y")) / 1e-3
    return max(drift, (r.t["f_body[1]"][n:].max() / 0.5 / r.settings["mass"] / (2 * 1000 * 1e-3)) ** 0.5)


CASE = Case(
    title="at rest under gravity, 1e6 steps",
    criterion="drift in spacings, or speed over that of a fall by one spacing",
    counter="no contact force while separating (approach yes)",
    setup=lattice_block("-0.003 0.003 0 0.004", "-0.02 0.02 -0.012 0.02") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 1000 elastic 1e7 0.3
""",
    model="""
fix             body all sph/tm energy yes
fix             weight all gravity 1000 vector 0 -1 0
fix             floor all contact/tri file plate.stl move 0 -0.001 0 friction 0.3 approach {approach}
variable        x equal xcm(all,x)
variable        y equal xcm(all,y)
thermo          1000
thermo_style    custom step time dt v_x v_y f_floor[2] f_floor[12] f_body[1] f_body[5] f_body[9]
thermo_modify   format float %.12g
""",
    steps="steps", meshes={"plate.stl": "block --size 0.05 0.002 0.02"},
    settings={"approach": "no", "steps": 1000000, "mass": 0.024}, quick={"steps": 100000}, bad={"approach": "yes"},
    judge=judge, limit=1e-3)
