"""Conduction in stages (RKL2) in steps beyond the limit of one evaluation: the result and the number of steps of the
scheme with one evaluation a step, heat kept to round-off, second order in time, with mechanics, interfaces,
prescribed temperatures and tools of particles."""
import os
import sys

import numpy as np
from heat_rod import RUN, Layer, rod
from sphtm_scene import SOURCE, Checks, order_of_convergence, run

EXAMPLE = os.path.join(SOURCE, "examples", "two_layer_heat")
sys.path.insert(0, EXAMPLE)
from measure import error as error_of                                                  # noqa: E402

checks = Checks()
with open(os.path.join(EXAMPLE, "in.two_layer_heat")) as f:
    SCRIPT = f.read().replace("%.10g", "%.17g")
BODY = "fix             body all sph/tm temperature 300"


def layers(n, ratio, left, t, how="", ranks=1):
    text = SCRIPT.replace(BODY, BODY + " " + how)
    result = run(text, dict(n=n, ratio=ratio, left=left, t_end=t), ranks=ranks)
    frame, log = result.dump("temperature.dump")[-1], result.thermo[-1]
    time = log["Time"][-1]
    return error_of(frame, ratio, time), len(log["Time"]) - 1, log, frame


# --- two layers: as near to the closed form as one evaluation a step
for n, ratio, left, t in ((200, 10, 0.3, 1e-3), (200, 100, 0.2, 1e-4)):
    few, steps, log, frame = layers(n, ratio, left, t)
    many, all_steps, _, _ = layers(n, ratio, left, t, "conduction explicit")
    name = "ratio %d: " % ratio
    checks.note(name + "steps with stages, without", "%d %d" % (steps, all_steps))
    checks.below(name + "steps with stages over those without", steps / all_steps, 0.25)
    checks.near(name + "largest error over the jump", few.max(), many.max(), relative=0.1)
    checks.below(name + "heat lost over the heat", abs(log["c_mean"] - log["c_mean"][0]).max() / 300, 1e-13)
    checks.above(name + "coldest", frame["c_T"].min(), 300 - 1e-3)
    checks.below(name + "hottest", frame["c_T"].max(), 400 + 1e-3)

# --- 800 particles: 500 times fewer steps
error, steps, log, _ = layers(800, 100, 0.2, 1e-4)
checks.note("800 particles: steps", steps)
checks.below("800 particles: error over the jump", error.max(), 2e-3)
checks.below("800 particles: steps", steps, 400)

# --- conductivities 1 : 1000. With plain harmonic means two errors of opposite sign meet at the interface; once the
# cold layer is resolved the one of first order is left
errors = [layers(n, 1000, 0.2, 3e-5)[0].max() for n in (100, 200, 400, 800, 1600, 3200)]
checks.note("ratio 1000: errors at 100 to 3200", " ".join("%.2e" % e for e in errors))
checks.above("ratio 1000: order of convergence", order_of_convergence([32, 16, 8, 4, 2, 1], errors), 1.2)
checks.above("ratio 1000: order of the last halving", np.log2(errors[-2] / errors[-1]), 0.85)

# --- constant steps far beyond the limit: second order in time. A cosine decays by exp(-a k^2 t)
K, RHO, CP, n, dx = 50.0, 7800.0, 480.0, 64, 1e-4


def decay(dt, how=""):
    text = rod([Layer(n, RHO, K, CP, 300)], dx, """variable shape atom 300
variable T0 atom 300+100*cos(PI*(x+%r)/%r)
thermo_style custom step time dt
""" % (n * dx, n * dx), body="fix body all sph/tm dt %r %s" % (dt, how))
    # every particle its own group: temperatures follow the cosine
    sets = "".join("group p id %d\nfix_modify body temperature p %.17g\nrun 0 post no\ngroup p delete\n"
                   % (i + 1, 300 + 100 * np.cos(np.pi * (i + 0.5) / n)) for i in range(n))
    result = run(text.replace("thermo 1000000\n", "thermo 1000000\n" + sets) + RUN.format(repr(0.4 * 0.999)))
    return result.dump("profile.dump")[-1]["c_T"]


exact = decay(1e-4)
errors = [abs(decay(dt) - exact).max() for dt in (0.1, 0.05, 0.025)]
checks.note("cosine: errors of steps of 0.1, 0.05, 0.025 s (of 100 K)", "%.2e %.2e %.2e" % tuple(errors))
checks.above("cosine: order in time", order_of_convergence([4, 2, 1], errors), 1.8)
checks.below("cosine: error of the longest step, K", errors[0], 1.0)

# --- prescribed temperatures at both ends, one of them rising, and an interface: the same as without stages
more = """pair_coeff 1 2 heat conductance 1e5
region hot block INF $(-57*v_dx) INF INF INF INF units box
region cold block $(57*v_dx) INF INF INF INF INF units box
group hot region hot
group cold region cold
variable ramp equal 300+200*time
fix hot hot sph/tm/heat temperature v_ramp
fix cold cold sph/tm/heat temperature 300
fix side all sph/tm/heat source 1e8
compute sum1 l1 reduce sum c_T
compute sum2 l2 reduce sum c_T
variable heat equal %r*(c_sum1+c_sum2)
thermo_style custom step time dt f_hot[2] f_cold[2] f_side[2] v_heat f_body[4] f_body[9]
""" % (RHO * CP * dx * dx)
profiles = {}
for how in ("explicit", "rkl2"):
    text = rod([Layer(60, RHO, K, CP, 300), Layer(60, RHO, 10 * K, CP, 300)], dx, more + RUN.format(1.0),
               body="fix body all sph/tm energy yes dt/max 0.02 conduction " + how)
    result = run(text)
    log = result.thermo[-1]
    profiles[how] = result.dump("profile.dump")[-1]["c_T"], log
    given = log["f_hot[2]"][-1] + log["f_cold[2]"][-1] + log["f_side[2]"][-1]
    checks.near(how + ": heat of the rod", log["v_heat"][-1] - log["v_heat"][0], given, relative=1e-10)
    checks.below(how + ": drift of the energy sum", abs(log["f_body[9]"] - log["f_body[9]"][0]).max() / abs(given), 1e-10)
late = profiles["rkl2"][1]["Time"][-1] - profiles["explicit"][1]["Time"][-1]
checks.note("ends held: steps without stages, with", "%d %d" % tuple(len(p[1]["Time"]) - 1 for p in profiles.values()))
checks.below("ends held: difference of the profiles, K", abs(profiles["rkl2"][0] - profiles["explicit"][0]).max(),
             1.0 + 300 * late)

# --- with mechanics: a block that conducts a thousand times as well as copper keeps the step of its sound speed
block = [Layer(30, 8960.0, 4e5, 385.0, 300, "solid"), Layer(30, 8960.0, 4e5, 385.0, 400, "solid")]
profiles = {}
for how in ("explicit", "rkl2"):
    text = rod(block, 1e-6, "thermo_style custom step time dt f_body[4] f_body[11]\n" + RUN.format(3e-9),
               body="fix body all sph/tm energy yes conduction " + how).replace("elastic 1 0.3", "elastic 120e9 0.3")
    result = run(text)
    profiles[how] = result.dump("profile.dump")[-1]["c_T"], result.thermo[-1]
    log = result.thermo[-1]
    checks.below("solids, %s: heat made over the heat of the hot layer" % how,
                 abs(log["f_body[4]"]).max() / (8960 * 385 * 30e-12 * 100), 1e-12)
dts = [profiles[how][1]["Dt"][-1] for how in ("explicit", "rkl2")]
checks.note("solids: steps (s)", "%.3g %.3g" % tuple(dts))
checks.above("solids: step with stages over the one without", dts[1] / dts[0], 5)
checks.near("solids: limited by the sound speed", profiles["rkl2"][1]["f_body[11]"][-1], 0, absolute=0)
checks.below("solids: difference of the profiles over the jump",
             abs(profiles["rkl2"][0] - profiles["explicit"][0]).max() / 100, 0.01)

# --- two ranks give the same bits
one, two = layers(100, 10, 0.3, 1e-4)[3], layers(100, 10, 0.3, 1e-4, ranks=2)[3]
checks.below("two ranks: difference", abs(one["c_T"] - two["c_T"]).max(), 0)

# --- a run that is read from a restart file goes on bit for bit
head = SCRIPT[:SCRIPT.index("# the step grows")]
END = "run 40\nwrite_dump all custom temperature.dump id x c_T modify format float %.17g\n"
whole = run(head + "run 40\nwrite_restart half.restart\n" + END, dict(n=100, left=0.3))
all_at_once = whole.dump("temperature.dump")[-1]["c_T"]
second = run("""newton off
read_restart half.restart
pair_coeff 1 1 density 1 body heat heat 1 1 0
pair_coeff 2 2 density 1 body heat heat 10 1 0
fix body all sph/tm temperature 300
compute T all sph/tm/atom temperature
""" + END, folder=whole.folder)
checks.below("restart: difference", abs(second.dump("temperature.dump")[-1]["c_T"] - all_at_once).max(), 0)

# --- what is not understood
bad = run(SCRIPT.replace(BODY, BODY + " conduction implicit"), dict(n=20), expect_error=True)
checks.true("conduction implicit is refused", "conduction" in bad.errors() and "rkl2" in bad.errors(), bad.errors()[:150])
bad = run(SCRIPT.replace(BODY, BODY + " conduction rkl2 -1"), dict(n=20), expect_error=True)
checks.true("a negative tolerance is refused", "conduction" in bad.errors(), bad.errors()[:150])
checks.end()
