"""A wedge whose edge has no radius is pressed into a block."""
from frame import Case, lattice_block

CASE = Case(
    title="tool edge sharper than the particles",
    criterion="deepest penetration of a particle, in spacings",
    counter="penalty a thousandth of the default",
    setup=lattice_block("-0.02 0.02 0 0.02", "-0.06 0.06 -0.02 0.08") + """
region          base block INF INF 0 0.002 INF INF units box
group           base region base
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 7850 elastic 210e9 0.3 strength plastic 350e6 500e6
""",
    model="""
fix             body all sph/tm energy yes
fix             hold base sph/tm/drive 0 0 0
fix             tool all contact/tri file wedge.stl penalty {penalty} friction 0.2 &
                rotate axis 0 0 1 angle 67.5 move -0.005112 0.033666 0
fix_modify      tool move linear 0 -60 0 ramp 1e-5
thermo          20
thermo_style    custom step time dt f_tool[2] f_tool[8] f_tool[12] f_tool[13] f_body[3] f_body[8] f_body[9]
""",
    steps="steps", meshes={"wedge.stl": "wedge --size 0.02 0.02 0.02"},
    settings={"penalty": 1, "steps": 3000}, bad={"penalty": 0.001},
    judge=lambda r: r.t["f_tool[13]"].max() if r.t["f_tool[12]"][-1] > 0 else 1.0, limit=0.5)
