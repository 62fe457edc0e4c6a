"""Two equal elastic bars collide end on and exchange their velocities: closed form of a wave that runs to the free end and back.

Bars of Poisson's ratio 0 have one wave speed, c = sqrt(E/rho), in plane strain too: contact lasts 2 L/c, and every particle leaves with the speed of
the other bar. What was chosen: the law of contact between bodies with its defaults, 0.002 c each; the end of contact is when the force falls below a
tenth of its plateau; L is 5 thicknesses."""
import numpy as np

import case

TITLE = "two bars collide"
REFERENCE = "closed form"
SCRIPT = """
variable        n index 10                     # particles over the thickness
variable        options index ""
variable        dx equal 0.02/v_n
variable        c equal sqrt(1e9/1000)
units           si
dimension       2
boundary        f f p
atom_style      atomic
newton          off
lattice         sq ${dx} origin 0.5 0.5 0
region          box block -0.12 0.12 -0.02 0.02 -0.5 0.5 units box
create_box      2 box
region          left block -0.1 0 -0.01 0.01 INF INF units box
region          right block 0 0.1 -0.01 0.01 INF INF units box
create_atoms    1 region left
create_atoms    2 region right
group           left type 1
group           right type 2
pair_style      sph/tm hyperbolic 1.2 spacing ${dx} ${options}
pair_coeff      * * density 1000 elastic 1e9 0
pair_coeff      1 2 contact
fix             body all sph/tm energy yes
velocity        left set $(0.002*v_c) 0 0 units box
velocity        right set $(-0.002*v_c) 0 0 units box
compute         vl left reduce ave vx
compute         vr right reduce ave vx
thermo_style    custom step time dt c_vl c_vr f_body[1] f_body[7] f_body[9]
thermo_modify   norm no format float %.12g
thermo          5
variable        left equal 4*0.1/v_c-time
fix             end all halt 5 v_left < 0 error continue message no
run             100000
"""
BASE = {"n": 10}
COMPARED = {"speed back over that of approach": ("", 0.03), "contact time": ("2 L/c", 0.05), "1 + momentum over that of a bar": ("", 1e-9)}
ROWS = {"bars": {"variables": {}, "title": "bars", "reference": {q: (1.0, 0.0) for q in COMPARED}}}
SETTINGS = {"n_5": {"n": 5}, "n_10": {}, "n_20": {"n": 20}, "artstress": {"options": "stabilize artstress"}}
SAID = {"n_5": "5 rows", "n_10": "10", "n_20": "20", "artstress": "10, *stabilize artstress*"}
MESH, QUICK = ("n_5", "n_10", "n_20"), "n_5"
SPACING = {"n_5": 4, "n_10": 2, "n_20": 1}


def cost(variables):
    return float(variables["n"]) ** 3


def measure(result, variables):
    t, c, L = result.thermo[-1], (1e9 / 1000) ** 0.5, 0.1
    v, time = t["c_vl"], t["Time"]
    rate = -np.gradient(v, time)      # force of contact over the mass of a bar
    plateau = np.median(rate[(time > 0.5 * L / c) & (time < 1.5 * L / c)])
    touch = time[rate > 0.1 * plateau]
    back = (t["c_vr"][-1] - t["c_vl"][-1]) / (v[0] - t["c_vr"][0])
    return {"speed back over that of approach": case.exact(back), "contact time": case.exact((touch[-1] - touch[0]) / (2 * L / c)),
            "1 + momentum over that of a bar": case.exact(1 + (t["c_vl"][-1] + t["c_vr"][-1]) / v[0]),
            "drift of the energy sum": case.exact(abs(t["f_body[9]"] - t["f_body[9]"][0]).max() / t["f_body[1]"][0]),
            "artificial share": case.exact(t["f_body[7]"][-1] / t["f_body[1]"][0])}
