"""What bodies in contact, and joints of unlike metals, do not have right, held against the numbers of doc/pair_sph_tm.rst (two types):
stress and plastic strain in the rows at a face of contact, stress of rows at a bonded joint, heat across a gap. What is right there, too: the force,
and the rows further in. Two blocks of 20 rows are pressed together in uniaxial strain by driven ends; two of 10 rows exchange heat by a conductance."""
import numpy as np
from sphtm_scene import Checks, run

DX = 1e-4
PRESS = """
units           si
dimension       2
boundary        f p p
atom_style      atomic
newton          off
lattice         sq ${dx} origin 0.5 0.5 0
region          box block -6e-3 6e-3 0 $(6*v_dx) $(-v_dx) ${dx} units box
create_box      2 box
region          a block -2e-3 0 INF INF INF INF units box
region          b block 0 2e-3 INF INF INF INF units box
create_atoms    1 region a
create_atoms    2 region b
region          l block -2e-3 -1.7e-3 INF INF INF INF units box
region          r block 1.7e-3 2e-3 INF INF INF INF units box
group           l region l
group           r region r
pair_style      sph/tm hyperbolic 1.2 spacing ${dx}
pair_coeff      1 1 ${first}
pair_coeff      2 2 ${second}
pair_coeff      1 2 ${meet}
fix             body all sph/tm energy yes
fix             rest all sph/tm/relax
variable        v equal ${speed}*(time<5e-6)
variable        w equal -v_v
fix             dl l sph/tm/drive v_v 0 NULL
fix             dr r sph/tm/drive v_w 0 NULL
compute         p all sph/tm/atom stress/xx pstrain
thermo          500
thermo_style    custom step time f_dl[1] f_dr[1]
variable        left equal 30e-6-time
fix             stop all halt 10 v_left <= 0 error continue message no
run             100000
write_dump      all custom end.dump id type x c_p[*] modify sort id format float %.9g
"""
STEEL, ALUMINUM = "density 7850 elastic 200e9 0.3", "density 2700 elastic 70e9 0.33"
YIELDS = ALUMINUM + " strength plastic 300e6 200e6"
HEAT = """
units           si
dimension       2
boundary        p f p
atom_style      atomic
newton          off
lattice         sq 1e-3 origin 0.5 0.5 0
region          box block 0 4e-3 -5e-3 25e-3 -5e-4 5e-4 units box
create_box      2 box
region          b block 0 4e-3 0 10e-3 INF INF units box
region          c block 0 4e-3 10e-3 20e-3 INF INF units box
create_atoms    1 region b
create_atoms    2 region c
group           one type 1
group           two type 2
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      * * density 7870 elastic 205e9 0.29 strength plastic 300e6 0 heat 5000 486 0.9
pair_coeff      1 2 contact conductance 1e4
fix             body all sph/tm temperature 300 time/scale 1e4
fix_modify      body temperature two 900
displace_atoms  two move 0 $(v_gap*1e-3) 0 units box
compute         T all sph/tm/atom temperature
compute         a one reduce ave c_T
compute         b two reduce ave c_T
thermo          200
thermo_style    custom step time c_a c_b
variable        left equal 1e-4-time
fix             stop all halt 1 v_left <= 0 error continue message no
run             100000
"""
checks = Checks()


def rows(first, second, meet, speed, dx=DX):
    """Stress over force per area of the rows, from the joint outward, on both sides; and their plastic strain."""
    r = run(PRESS, {"first": first, "second": second, "meet": meet, "speed": speed, "dx": dx})
    end = r.dump("end.dump")[-1]
    stress, strain = -end["c_p[1]"], end["c_p[2]"]
    force = 0.5 * (abs(r.thermo[-1]["f_dl[1]"][-1]) + abs(r.thermo[-1]["f_dr[1]"][-1])) / (6 * dx)
    sides = []
    for side in 1, 2:
        mine = end["type"] == side
        place = np.round(abs(end["x"]) / dx - 0.5).astype(int)
        sides.append([(stress[mine & (place == k)].mean() / force, strain[mine & (place == k)].mean()) for k in range(10)])
    return np.array(sides), force


def inside(name, s):
    checks.near(name + ": stress from the fourth to the tenth row over force per area", s[:, 3:, 0].mean(), 1.0, absolute=0.04)


for name, dx in (("", DX), (", half the spacing", DX / 2)):
    s, force = rows(STEEL, ALUMINUM, "contact", 2.0, dx)
    print("steel on aluminum%s, %.0f MPa: %s" % (name, 1e-6 * force, np.round(s[:, :4, 0], 2).tolist()))
    inside("elastic contact" + name, s)
    checks.near("elastic contact%s: the outermost row, as the page says" % name, s[:, 0, 0].mean(), 0.56, absolute=0.03)
    checks.near("elastic contact%s: the second row" % name, s[:, 1, 0].mean(), 0.9, absolute=0.03)
s, force = rows(YIELDS, YIELDS, "contact", 6.0)
print("metal that yields, %.0f MPa: stress %s, plastic strain %s" % (1e-6 * force, np.round(s[:, :4, 0], 2).tolist(), np.round(s[:, :4, 1], 4).tolist()))
inside("contact of metal that yields", s)
checks.near("contact of metal that yields: plastic strain of the outermost row over that inside", s[:, 0, 1].mean() / s[:, 4:8, 1].mean(), 1.0, absolute=0.1)
checks.below("contact of metal that yields: stress of the outermost two rows, largest difference", abs(s[:, :2, 0] - 1.0).max(), 0.07)
s, force = rows(YIELDS, YIELDS, "contact layer rigid", 6.0)
print("layer rigid, %.0f MPa: stress %s, plastic strain %s" % (1e-6 * force, np.round(s[:, :4, 0], 2).tolist(), np.round(s[:, :4, 1], 4).tolist()))
checks.near("layer rigid: plastic strain of the outermost row over that inside", s[:, 0, 1].mean() / s[:, 4:8, 1].mean(), 0.25, absolute=0.05)
s, force = rows(YIELDS, YIELDS, "bond", 6.0)
checks.below("one metal, bonded: stress of the two rows at the joint, largest difference", abs(s[:, :2, 0] - 1.0).max(), 0.02)
s, force = rows(STEEL, ALUMINUM, "bond", 2.0)
print("steel bonded to aluminum, %.0f MPa: %s" % (1e-6 * force, np.round(s[:, :4, 0], 2).tolist()))
checks.near("steel bonded to aluminum: least of the two rows at the joint", s[:, :2, 0].min(), 0.71, absolute=0.05)
checks.near("steel bonded to aluminum: largest of them", s[:, :2, 0].max(), 1.43, absolute=0.05)

LENGTH, K, RHO_CP, H = 10e-3, 5000.0, 7870.0 * 486.0, 1e4
for gap, due in ((0.0, 1.0), (0.1, 0.82), (0.3, 0.55), (0.5, 0.35), (1.0, 0.05)):
    t = run(HEAT, {"gap": gap}).thermo[-1]
    process = 1e4 * t["Time"][-1]
    whole = -np.log((t["c_b"][-1] - t["c_a"][-1]) / 600.0) * RHO_CP * LENGTH / (2.0 * process)    # of two bodies of even temperature
    checks.near("gap of %.1f spacings: conductance over that given" % gap, 1.0 / (1.0 / whole - 2.0 * LENGTH / (3.0 * K)) / H, due, absolute=0.03)
checks.end()
