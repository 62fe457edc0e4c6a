"""The first step after something has changed is short enough for it: heat that begins to go through a surface, between two runs and within
one, a drive, a smaller dt/max; and a run that goes on with nothing changed has the bits of one that was not cut."""
import numpy as np

from sphtm_scene import Checks, run

checks = Checks()

PLATE = """
units           si
dimension       2
boundary        f p p
atom_style      atomic
newton          off
lattice         sq 2e-4 origin 0.5 0.5 0
region          box block -1e-3 61e-3 0 2e-4 -1e-4 1e-4 units box
create_box      1 box
region          bar block 0 20e-3 INF INF INF INF units box
create_atoms    1 region bar
pair_style      sph/tm hyperbolic 1.2 spacing 2e-4
pair_coeff      1 1 density 7870 body heat heat 50.7 486 0
fix             body all sph/tm temperature 1100 energy yes table no
compute         T all sph/tm/atom temperature
compute         hot all reduce max c_T
compute         cold all reduce min c_T
variable        coefficient equal (time>60)*2e4+25
fix             air all sph/tm/heat convection AIR 293
variable        left equal 60-time
fix             stop all halt 1 v_left <= 0 error continue message no
thermo_style    custom step time dt c_hot c_cold
thermo_modify   format float %.15g
thermo          1
run             100000
"""
SECOND = """
variable        t0 equal $(time)
variable        left equal ${t0}+2.0-time
thermo_style    custom step time dt c_hot c_cold f_water f_water[2]
thermo_modify   format float %.15g
thermo          1
run             3
thermo          1
run             100000
"""
QUENCH = PLATE.replace("AIR", "25") + "unfix air\nDTfix water all sph/tm/heat convection 2e4 293\n" + SECOND

# half a plate that is cooled on both sides, by Biot 2e4 * 0.01 / 50.7 = 3.9 and 2 s: series of the closed form, from an even temperature
def closed_form(T0, seconds, terms=60):
    L, k, rho, c, h = 0.01, 50.7, 7870.0, 486.0, 2e4
    bi, fo = h * L / k, k / (rho * c) * seconds / L**2
    lost = 0.0
    for n in range(terms):
        lo, hi = n * np.pi + 1e-12, n * np.pi + np.pi / 2 - 1e-12
        for _ in range(200):
            mid = 0.5 * (lo + hi)
            lo, hi = (mid, hi) if mid * np.tan(mid) < bi else (lo, mid)
        z = 0.5 * (lo + hi)
        lost += 4 * np.sin(z) / (2 * z + np.sin(2 * z)) * np.sin(z) / z * (1 - np.exp(-z * z * fo))
    return -rho * c * 2 * L * 2e-4 * (T0 - 293) * lost    # per thickness of 1 m


r = run(QUENCH.replace("DT", ""))
before = r.thermo[0]
after, last = r.thermo[1], r.thermo[-1]
taken = last["f_water[2]"][-1]
checks.above("quenched between two runs: coldest particle, K", min(after["c_cold"].min(), last["c_cold"].min()), 293.0)
checks.below("its first step, s", after["Dt"][1], 0.1)
checks.near("heat taken after 2 s against the closed form, J", taken, closed_form(before["c_hot"][-1], last["Time"][-1] - before["Time"][-1]), relative=0.02)

r = run(QUENCH.replace("DT", "fix_modify body dt/max 1e-3\n"))
checks.near("dt/max between two runs is that of the first step too", r.thermo[1]["Dt"][1], 1e-3, relative=1e-12)

r = run(PLATE.replace("AIR", "v_coefficient").replace("60-time", "62-time").replace("run             100000", "run 100000"))
T = r.thermo[-1]
checks.above("a coefficient that jumps within a run: coldest particle, K", T["c_cold"].min(), 293.0)
checks.true("it jumped in a long step", (np.diff(T["Time"])[(T["Time"][1:] > 60)][:1] > 0.1).all())

r = run(PLATE.replace("AIR", "25") + "variable left equal 70-time\nfix go all sph/tm/drive 2e-3 0 0\nthermo 1\nrun 3\n")
checks.below("a drive that begins between two runs: way of its first step over the spacing", r.thermo[1]["Dt"][1] * 2e-3 / 2e-4, 0.1 + 1e-9)

# cut in two where nothing changes: the same bits
SHORT = PLATE.replace("AIR", "25").replace("60-time", "600-time").replace("run             100000", "run 300")
END = "write_dump all custom end.dump id c_T modify sort id format float %.17g\n"
whole = run(SHORT + "run 300\n".replace("300", "400") + END).dump("end.dump")[-1]["c_T"]
parts = run(SHORT + "run 150\nrun 250\n" + END).dump("end.dump")[-1]["c_T"]
checks.true("a run that is cut where nothing changes has the same bits", np.array_equal(whole, parts), "largest difference %g" % np.abs(whole - parts).max())
strong = SHORT.replace("convection 25", "convection 2e4")
whole = run(strong + "run 400\n" + END).dump("end.dump")[-1]["c_T"]
parts = run(strong + "run 150\nrun 250\n" + END).dump("end.dump")[-1]["c_T"]
checks.true("so has one whose steps the flux sets", np.array_equal(whole, parts), "largest difference %g" % np.abs(whole - parts).max())
checks.end()
