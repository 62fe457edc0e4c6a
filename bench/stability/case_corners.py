"""Two elastic bodies meet corner to corner at a twentieth of the speed of sound."""
import numpy as np

from frame import PLANE, Case


def judge(r):
    """Energy out of nothing over the kinetic energy at the start; 1 where one body is inside the other."""
    e = r.end
    a, b = (np.c_[e["x"], e["y"]][e["type"] == t] for t in (1, 2))
    nearest = np.sqrt(((a[:, None] - b[None]) ** 2).sum(axis=2).min())
    rise = abs(r.t["f_body[9]"] - r.t["f_body[9]"][0]).max() / r.t["f_body[1]"][0]
    return rise if nearest > 0.4 * 1e-3 else 1.0


CASE = Case(
    title="two bodies, corner to corner",
    criterion="change of the energy sum over the kinetic energy",
    counter="contact 400 times as stiff, with the constant step of the sound speed",
    setup=PLANE + """
lattice         sq 1e-3 orient x 1 1 0 orient y -1 1 0 origin 0.25 0.25 0
region          box block -0.08 0.08 -0.06 0.06 -0.1 0.1 units box
create_box      2 box
variable        p atom "abs(x+0.0152)+abs(y) < 0.0143"
variable        q atom "abs(x-0.0152)+abs(y-{aside}) < 0.0143"
create_atoms    1 box
group           p variable p
group           q variable q
set             group q type 2
group           work union p q
group           rest subtract all work
delete_atoms    group rest compress no
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 7850 elastic 210e9 0.3
pair_coeff      2 2 density 7850 elastic 210e9 0.3
pair_coeff      1 2 contact penalty {penalty}
velocity        p set 250 0 0 units box
velocity        q set -250 0 0 units box
""",
    model="""
fix             body all sph/tm energy yes {dt}
thermo          20
thermo_style    custom step time dt f_body[1] f_body[2] f_body[5] f_body[7] f_body[9]
""",
    steps="steps", settings={"penalty": 1, "dt": "", "aside": 0.0003, "steps": 1500},
    bad={"penalty": 400, "dt": "dt 5.8e-8"}, judge=judge, limit=0.02,
    stops="is not stable: the contact stiffness and damping allows")
