"""A block under its weight on a floor that slides to and fro: friction that reverses with every half period."""
import numpy as np

from frame import Case, lattice_block


def judge(r):
    """Drift of the energy sum, or friction work that came back, over the friction work."""
    w = r.t["f_body[6]"]
    return max(abs(r.t["f_body[9]"] - r.t["f_body[9]"][0]).max(), -np.diff(w).min()) / w[-1]


CASE = Case(
    title="friction with reversing motion",
    criterion="drift of the energy sum, or friction work that came back, over the friction work",
    counter="contact 400 times as stiff, with the constant step of the sound speed",
    setup=lattice_block("-0.006 0.006 0 0.006", "-0.03 0.03 -0.012 0.02") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 1000 elastic 1e7 0.3
""",
    model="""
fix             body all sph/tm energy yes {dt}
fix             weight all gravity 1000 vector 0 -1 0
fix             floor all contact/tri file plate.stl move 0 -0.001 0 friction 0.3 penalty {penalty}
fix_modify      floor move wiggle 2e-3 0 0 2e-3
variable        vx equal vcm(all,x)
thermo          100
thermo_style    custom step time dt v_vx f_floor[1] f_floor[2] f_body[1] f_body[5] f_body[6] f_body[8] f_body[9]
""",
    steps="steps", meshes={"plate.stl": "block --size 0.05 0.002 0.02"},
    settings={"penalty": 1, "dt": "", "steps": 20000}, bad={"penalty": 400, "dt": "dt 3e-6"}, judge=judge, limit=0.01,
    stops="is not stable: the contact stiffness and damping .* allows")
