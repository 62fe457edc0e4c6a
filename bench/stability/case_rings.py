"""Two rubber rings collide and rebound (Gray, Monaghan, Swift 2001)."""
import numpy as np

from frame import PLANE, Case, pieces


def judge(r):
    """Particles that are not in the largest piece of their ring, over all; 1 where the rings did not rebound."""
    e = r.end
    x = np.c_[e["x"], e["y"]]
    loose = sum(n - pieces(x[e["type"] == t], 1.5 * r.settings["dx"])[0] for t in (1, 2)
                for n in [int((e["type"] == t).sum())])
    return loose / len(x) if e["vx"][e["type"] == 1].mean() < 0 else 1.0


CASE = Case(
    title="rings",
    criterion="share of particles that came off their ring",
    counter="no hourglass control",
    setup=PLANE + """
lattice         sq {dx} origin 0.5 0.5 0
region          box block -0.16 0.16 -0.09 0.09 -0.5 0.5 units box
create_box      2 box
region          lo cylinder z -0.042 0 0.04 INF INF units box
region          li cylinder z -0.042 0 0.03 INF INF side out units box
region          ro cylinder z 0.042 0 0.04 INF INF units box
region          ri cylinder z 0.042 0 0.03 INF INF side out units box
region          left intersect 2 lo li
region          right intersect 2 ro ri
create_atoms    1 region left
create_atoms    2 region right
group           left type 1
group           right type 2
pair_style      sph/tm hyperbolic 1.2 spacing {dx} {options}
pair_coeff      * * materials.sphtm rubber
velocity        left set 6.65 0 0 units box
velocity        right set -6.65 0 0 units box
""",
    model="""
fix             body all sph/tm energy yes
thermo          500
thermo_style    custom step time dt f_body[1] f_body[2] f_body[7] f_body[9]
""",
    steps="steps", settings={"dx": 1e-3, "options": "", "steps": 5600}, bad={"options": "hourglass 0"}, judge=judge, limit=0.001)
