"""An elastic block flies and turns freely, and one half of it is split in flight."""
import numpy as np

from frame import Case, lattice_block


def judge(r):
    """Largest change of momentum, angular momentum and energy sum over those of the start; 1 where nothing was
    split."""
    if r.t["f_ad[1]"][-1] < 50:
        return 1.0
    px, py = r.t["v_px"], r.t["v_py"]
    p = np.hypot(px - px[0], py - py[0]).max() / np.hypot(px[0], py[0])
    spin = abs(r.t["v_lz"] / r.t["v_lz"][0] - 1).max()
    return max(p, spin, abs(r.t["f_body[9]"] / r.t["f_body[9]"][0] - 1).max())


CASE = Case(
    title="split in free flight",
    criterion="change of momentum, angular momentum and energy sum over those of the start, in two turns",
    counter="plain gradients and artificial stress instead of corrected ones and hourglass control",
    setup=lattice_block("0 0.016 0 0.010", "-0.03 0.05 -0.03 0.05") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 {options}
pair_coeff      * * materials.sphtm rubber
variable        vx atom 2-{omega}*(y-0.005)
variable        vy atom 1+{omega}*(x-0.008)
velocity        all set v_vx v_vy NULL
group           half region work
""",
    model="""
fix             body all sph/tm courant 0.4 energy yes
variable        half atom (step>{split})*(id>80)*(id<=240)
fix             ad all adapt/neigh refine square epsilon 0.41666667 alpha 0.5 when v_half above 0.5 every 100
variable        m atom mass
compute         u all property/atom xu yu
variable        ax atom mass*vx
variable        ay atom mass*vy
variable        az atom mass*(c_u[1]*vy-c_u[2]*vx)
compute         sum all reduce sum v_ax v_ay v_az
variable        px equal c_sum[1]
variable        py equal c_sum[2]
variable        lz equal c_sum[3]
thermo          100
thermo_style    custom step atoms time dt v_px v_py v_lz f_ad[1] f_body[1] f_body[2] f_body[7] f_body[9]
thermo_modify   lost error norm no
""",
    steps="steps", settings={"options": "", "omega": 1500, "split": 450, "steps": 12000},
    bad={"options": "stabilize artstress"}, judge=judge, limit=0.01)
