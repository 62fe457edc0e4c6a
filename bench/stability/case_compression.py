"""A steel block between two plates, to a fifth of its height."""
from frame import Case, lattice_block

CASE = Case(
    title="compression to 20 % height",
    criterion="drift of the energy sum over the work of the plates",
    counter="courant 1 without viscosity",
    setup=lattice_block("-0.005 0.005 0 0.01", "-0.03 0.03 -0.002 0.012", "{dx}") + """
pair_style      sph/tm hyperbolic 1.2 spacing {dx} {options}
pair_coeff      1 1 density 7850 elastic 210e9 0.3 strength plastic 350e6 500e6
""",
    model="""
fix             body all sph/tm courant {courant} energy yes
fix             low all contact/tri file plate.stl move 0 -0.001 0
fix             top all contact/tri file plate.stl move 0 $(0.011+1e-6) 0
fix_modify      top move linear 0 -100 0 ramp 5e-6
thermo          100
thermo_style    custom step time dt f_top[8] f_top[13] f_low[13] f_body[3] f_body[8] f_body[9]
""",
    steps=4800, meshes={"plate.stl": "block --size 0.05 0.002 0.02"},
    settings={"dx": 5e-4, "options": "", "courant": 0.4},
    bad={"options": "viscosity 0 0", "courant": 1.0},
    judge=lambda r: 1.0 if r.t["f_top[8]"][-1] > 0.00302 else abs(r.t["f_body[9]"]).max() / abs(r.t["f_body[8]"][-1]),
    limit=0.02)
