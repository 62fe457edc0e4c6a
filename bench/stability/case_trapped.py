"""Four particles, each alone, between two plates that close to a tenth of the spacing."""
from frame import PLANE, Case


def judge(r):
    """Fastest particle over the speed of the plates, and how far from the middle, in spacings."""
    e = {k: r.end[k][r.end["type"] == 1] for k in ("y", "vx", "vy")}
    return max(max(abs(e["vx"]).max(), abs(e["vy"]).max()) / 4.0, abs(e["y"]).max() / 1e-3)


CASE = Case(
    title="particles trapped between two closing tools",
    criterion="speed over that of the plates, or distance from the middle in spacings",
    counter="contact 200 times as stiff, with the constant step of the sound speed",
    setup=PLANE + """
lattice         sq 5e-3 origin 0 0 0
region          box block -0.03 0.03 -0.012 0.012 -0.1 0.1 units box
create_box      2 box
region          work block -0.0101 0.0051 -0.001 0.001 INF INF units box
create_atoms    1 region work
# a body elsewhere, as a scene without neighbors is refused
lattice         sq 1e-3
region          body block 0.0265 0.0285 -0.001 0.001 INF INF units box
create_atoms    2 region body
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      * * density 7850 elastic 210e9 0.3
pair_coeff      1 2 none
group           work type 1
displace_atoms  work random 0 1e-5 0 4711 units box
""",
    model="""
fix             body all sph/tm energy yes {dt}
fix             low all contact/tri file plate.stl move 0 -0.00151 0 penalty {penalty}
fix             top all contact/tri file plate.stl move 0 0.00151 0 penalty {penalty}
fix_modify      top move linear 0 -4 0 ramp 1e-5
fix_modify      low move linear 0 4 0 ramp 1e-5
thermo          50
thermo_style    custom step time dt f_top[2] f_low[2] f_top[8] f_top[13] &
                f_body[1] f_body[2] f_body[5] f_body[6] f_body[7] f_body[8] f_body[9]
""",
    steps=2900, meshes={"plate.stl": "block --size 0.05 0.002 0.02"}, settings={"penalty": 1, "dt": ""},
    bad={"penalty": 200, "dt": "dt 4e-8"}, judge=judge, limit=1.5,
    stops="is not stable: the contact stiffness and damping .* allows")
