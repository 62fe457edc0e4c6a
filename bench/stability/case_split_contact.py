"""An elastic block hits a rigid plate; while it is pressed against it, its foot is split."""
from frame import Case, lattice_block


def judge(r):
    """Change of the energy sum over the kinetic energy of the start, deepest penetration over the spacing; 1 where
    nothing was split or the block does not come back."""
    if r.t["f_ad[1]"][-1] < 20 or not r.end["vy"].mean() > 0:
        return 1.0
    drift = abs(r.t["f_body[9]"] - r.t["f_body[9]"][0]).max() / r.t["f_body[1]"][0]
    return max(drift, r.t["f_plate[13]"].max())


CASE = Case(
    title="split next to a contact",
    criterion="change of the energy sum over the kinetic energy, deepest penetration in spacings; the block comes back",
    counter="contact 400 times as stiff, with the constant step of the sound speed",
    setup=lattice_block("0 0.016 0 0.010", "-0.02 0.04 -0.01 0.05") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 2700 elastic 70e9 0.3
velocity        all set 0 -20 0 units box
""",
    model="""
fix             body all sph/tm energy yes {dt}
fix             plate all contact/tri file plate.stl move 0.008 -0.001 0 penalty {penalty}
variable        foot atom (step>{split})*(id<=48)
fix             ad all adapt/neigh refine square epsilon 0.41666667 alpha 0.5 when v_foot above 0.5 every 10
thermo          5
thermo_style    custom step atoms time dt f_plate[2] f_plate[12] f_plate[13] f_ad[1] &
                f_body[1] f_body[2] f_body[5] f_body[7] f_body[9]
thermo_modify   lost error norm no
""",
    steps="steps", meshes={"plate.stl": "block --size 0.05 0.002 0.02"},
    settings={"penalty": 1, "dt": "", "split": 40, "steps": 600},
    bad={"penalty": 400, "dt": "dt 4e-8"}, judge=judge, limit=0.05,
    stops="is not stable: the contact stiffness and damping .* allows")
