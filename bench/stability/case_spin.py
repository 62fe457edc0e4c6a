"""A free elastic body turns about its middle axis, and so tumbles, for a hundred turns."""
from frame import SPACE, Case


def judge(r):
    lost = [abs(r.t["v_l" + d] - r.t["v_l" + d][0]).max() for d in "xyz"]
    return max(lost) / abs(r.t["v_lz"][0]) if r.t["v_turn"][-1] > 0.99 * r.settings["turns"] else 1.0


CASE = Case(
    title="spinning and tumbling elastic body, 100 turns",
    criterion="largest change of the angular momentum",
    counter="plain gradients and artificial stress instead of corrected ones and hourglass control",
    setup=SPACE + """
lattice         sc 0.01 origin 0.5 0.5 0.5
region          box block -0.1 0.1 -0.1 0.1 -0.1 0.1 units box
create_box      1 box
region          body block -0.02 0.02 -0.03 0.03 -0.02 0.02 units box
region          half block -0.01 0.01 -0.03 0.03 -0.02 0.02 units box
create_atoms    1 region half
pair_style      sph/tm hyperbolic 1.2 spacing 0.01 {options}
pair_coeff      * * materials.sphtm rubber
variable        vx atom {omega}*(0.001*z-y)
variable        vy atom {omega}*x
variable        vz atom -{omega}*0.001*x
velocity        all set v_vx v_vy v_vz
""",
    model="""
fix             body all sph/tm courant 0.6 energy yes
variable        turn equal {omega}*time/(2*PI)
variable        lx equal angmom(all,x)
variable        ly equal angmom(all,y)
variable        lz equal angmom(all,z)
thermo          500
thermo_style    custom step time dt v_turn v_lx v_ly v_lz f_body[1] f_body[7] f_body[9]
""",
    steps="steps", settings={"omega": 300.0, "options": "", "steps": 86000, "turns": 100},
    bad={"options": "stabilize artstress"}, quick={"steps": 8700, "turns": 10}, judge=judge, limit=0.01)
