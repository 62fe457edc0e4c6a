"""Bulk viscosity in shocks (pair_style sph/tm shock): behind a shock between two plates of hardening aluminum or copper stress, deviator and
plastic strain are those of the jump conditions (bench/validate/case_plate_impact.py), and the energies add up; slow flow has none of it: a block that is pressed at 20 m/s has the same forces, and no more work of artificial terms."""
import os
import sys

from sphtm_scene import SOURCE, Checks, run

sys.path.insert(0, os.path.join(SOURCE, "bench", "validate"))
import case_plate_impact as impact                                                        # noqa: E402

checks = Checks()


def behind(options, metal="aluminum", speed=400, body="", linear=False):
    coefficients = impact.coefficients(metal, linear)
    r = run(impact.SCRIPT, {"dx": 1e-4, "options": options, "metal": coefficients, "speed": speed, "body": body})
    found, t = impact.measure(r, {"speed": speed}), r.thermo[-1]
    errors = [found[q][0] / k - 1 for q, k in zip(impact.COMPARED, impact.behind(metal, speed, linear))]
    drift = abs(t["f_body[9]"] - t["f_body[9]"][0]).max() / t["f_body[1]"][0]
    print("%-9s %4g m/s, %-24s longitudinal stress %+.2f %%, von Mises stress %+.1f %%, plastic strain %+.1f %%, work of artificial terms %.4f, energy %.1e"
          % (metal, speed, (options or body or "default") + linear * ", eos linear", *(100 * e for e in errors), found["artificial share"][0], drift))
    checks.below("%s %g %s%s: drift of the sum of the energies" % (metal, speed, options or body, linear * " linear"), drift, 2e-4)
    return errors


for metal, speed, limits in (("aluminum", 400, (0.002, 0.03, 0.01)), ("copper", 400, (0.002, 0.04, 0.02)), ("copper", 1500, (0.002, 0.06, 0.03))):
    for name, e, most in zip(impact.COMPARED, behind("shock 1", metal, speed), limits):
        checks.below("%s, %d m/s, shock 1: %s" % (metal, speed, name), abs(e), most)
whole, half = behind("shock 1"), behind("")
checks.true("0.5 is the default", behind("shock 0.5") == half == behind("shock auto"), str(half))
for name, e, most in zip(impact.COMPARED, half, (0.002, 0.07, 0.02)):
    checks.below("aluminum, 400 m/s, default: " + name, abs(e), most)
without = behind("shock 0")
for name, e, least in zip(impact.COMPARED, without, (0.01, 0.6, 0.15)):
    checks.above("fails without: " + name, abs(e), least)
for metal, speed, mises in (("aluminum", 400, 0.07), ("copper", 100, 0.08), ("copper", 400, 0.1)):    # with a linear equation of state it is on, too
    half_linear, without_linear = behind("", metal, speed, linear=True), behind("shock 0", metal, speed, linear=True)
    for name, e, most in zip(impact.COMPARED, half_linear, (0.002, mises, 0.02)):
        checks.below("%s, %d m/s, eos linear, default: %s" % (metal, speed, name), abs(e), most)
    for name, e, least in zip(list(impact.COMPARED)[1:], without_linear[1:], (0.2, 0.05)):
        checks.above("%s, %d m/s, eos linear, fails without: %s" % (metal, speed, name), abs(e), least)
checks.true("half of it is between", abs(whole[2]) < half[2] < without[2] and abs(whole[1]) < abs(half[1]) < abs(without[1]), str(half))
checks.below("courant 0.6, which bears 0.57: von Mises stress", abs(behind("shock 1", body="courant 0.6")[1]), 0.06)

# compression at 20 m/s over 10 mm of the same metal, by a tenth
PRESS = """
units           si
dimension       2
boundary        f f p
atom_style      atomic
newton          off
lattice         sq 2.5e-4 origin 0.5 0.5 0
region          box block -2e-3 12e-3 -2e-3 7e-3 $(-0.5*2.5e-4) $(0.5*2.5e-4) units box
create_box      1 box
region          work block 0 10e-3 0 5e-3 INF INF units box
create_atoms    1 region work
pair_style      sph/tm hyperbolic 1.2 spacing 2.5e-4 ${options}
pair_coeff      * * density 2703 elastic 69e9 0.33 strength plastic 276e6 645e6
fix             body all sph/tm energy yes
region          left block INF 1e-3 INF INF INF INF units box
region          right block 9e-3 INF INF INF INF INF units box
group           left region left
group           right region right
variable        v equal 10*(1-exp(-time/5e-6))
variable        w equal -v_v
fix             l left sph/tm/drive v_v NULL NULL
fix             r right sph/tm/drive v_w NULL NULL
thermo_style    custom step time f_body[1] f_body[7] f_body[8] f_body[9]
thermo          100
variable        over equal time-5e-5
fix             end all halt 1 v_over >= 0 error continue message no
run             100000
"""


def pressed(options):
    t = run(PRESS, {"options": options}).thermo[-1]
    return t["f_body[7]"][-1] / t["f_body[8]"][-1], t["f_body[8]"][-1]


checks.true("0.5 is the default here, too", pressed("") == pressed("shock 0.5"))
(on, work), (off, same) = pressed("shock 1"), pressed("shock 0")
print("pressed by a tenth at 20 m/s: artificial share %.5f, without %.5f; work %.6g, %.6g" % (on, off, work, same))
checks.near("pressed: work", work, same, relative=0.002)
checks.below("pressed: artificial share above that without", on - off, 0.001)
checks.end()
