"""The energy balance of fix sph/tm, energy yes: the elastic energy is what the stress stores, a function of the state of
the particles; what the stress has done and is neither stored nor dissipated stands apart.

stored    f_body[2] against the sum over a dump of s:s/(4 G rho) and the integral of p/rho^2, of all particles that have
          not failed: two bars that meet, elastic, plastic and failing by strain
shares    of the sum that drifts, f_body[13] is the part of the stress; what failed is f_body[14], and part of f_body[3]
restart   goes on with the same numbers
"""
import numpy as np

from sphtm_scene import Checks, lattice_block, run

E, NU, RHO0, DX = 70e9, 0.33, 2700.0, 1e-3
G, K = E / 2 / (1 + NU), E / 3 / (1 - 2 * NU)
SCENE = lattice_block("0 24e-3 0 8e-3", "-0.05 0.09 -0.05 0.06") + """
pair_style      sph/tm hyperbolic 1.2 spacing lattice {style}
pair_coeff      1 1 density 2700 elastic 70e9 0.33 {material}
fix             body all sph/tm courant {courant} energy yes energy/drift none effects fracture off
variable        vx atom {speed}*(2*(x<12e-3)-1)
velocity        all set v_vx 0 0 units box
compute         p all sph/tm/atom density pressure stress/xx stress/yy stress/zz stress/xy failed pstrain
compute         most all reduce max c_p[8]
compute         torn all reduce sum c_p[7]
thermo          {every}
thermo_style    custom step time f_body[*9] f_body[13] f_body[14] c_most c_torn ke
thermo_modify   format float %.15g
"""
DUMP = """dump            d all custom 1 out.dump id x y z c_p[*]
dump_modify     d sort id format float %.17g
run             0 post no
"""
checks = Checks()


def scene(material, speed, courant=0.4, style="", steps=600, more="", **arguments):
    return run(SCENE.format(material=material, speed=speed, courant=courant, style=style, every=steps // 10) + more +
               "run %d\n" % steps + DUMP, **arguments)


def stored(frame):
    """Of all particles, by the closed form of the linear equation of state."""
    c = [frame["c_p[%d]" % k] for k in range(1, 8)]
    rho, p, failed, mass = c[0], c[1], c[6] > 0.5, RHO0 * DX * DX
    s = np.array(c[2:6]) + np.array([p, p, p, 0 * p])
    x = rho / RHO0
    shape = (s[0]**2 + s[1]**2 + s[2]**2 + 2 * s[3]**2) / (4 * G * rho)
    pressure = K / RHO0 * (np.log(x) + 1 / x - 1)
    return mass * np.sum(np.where(failed, np.where(x > 1, pressure, 0), shape + pressure))


left_over = {}
# name, material, speed, step, number of steps, largest unexplained share of what went in
for name, material, speed, courant, steps, most in (
        ("elastic", "", 20.0, 0.2, 1200, 5e-4),
        ("elastic, half the step", "", 20.0, 0.1, 2400, 1e-4),
        ("plastic", "strength plastic 100e6 1e9", 60.0, 0.4, 600, 1e-3),
        ("fails", "strength plastic 100e6 1e9 damage strain 0.08", 200.0, 0.4, 600, 1e-3)):
    r = scene(material, speed, courant, steps=steps, more="restart 300 half.*.restart\n" if name == "fails" else "")
    t = r.thermo[0]
    given = t["f_body[1]"][0]
    checks.near(name + ": f_body[2] is what the state stores", t["f_body[2]"][-1], stored(r.dump("out.dump")[-1]),
                relative=1e-6)
    total = sum(t["f_body[%d]" % k] for k in range(1, 9))
    checks.below(name + ": f_body[9] is the sum of 1 to 8", abs(total - t["f_body[9]"]).max() / given, 1e-12)
    unexplained, drift = t["f_body[13]"] / given, (t["f_body[9]"] - given) / given
    checks.below(name + ": work of the stress neither stored nor dissipated", abs(unexplained).max(), most)
    left_over[name] = abs(unexplained).max()
    checks.below(name + ": drift of the sum but for that", abs(drift + unexplained).max(), 2e-3)
    checks.note(name + ": strain, failed, drift, unexplained, stored, failure",
                "%.3f %d %+.2e %+.2e %.4f %.4f" % (t["c_most"][-1], t["c_torn"][-1], drift[-1], unexplained[-1],
                                                   t["f_body[2]"][-1] / given, t["f_body[14]"][-1] / given))
    checks.true(name + ": failure", (t["f_body[14]"][-1] > 0) == (name == "fails") and
                np.all(np.diff(t["f_body[14]"]) >= 0))
    if name == "fails":
        checks.above("fails: many do", t["c_torn"][-1], 20)
        # what a book of stress work less plastic work calls elastic
        old = t["f_body[2]"] + t["f_body[13]"] + t["f_body[14]"]
        checks.above("fails: stress work less plastic work is more than what is stored", old[-1] / t["f_body[2]"][-1], 1.05)
        again = run("read_restart half.300.restart\nfix body all sph/tm energy yes energy/drift none effects fracture off\n"
                    + SCENE.split("units box\n")[-1].format(every=60) + "run 300\n", folder=r.folder)
        for k in (2, 9, 13, 14):
            checks.near("restart: f_body[%d]" % k, again.thermo[0]["f_body[%d]" % k][-1], t["f_body[%d]" % k][-1],
                        relative=1e-9, absolute=1e-9 * given)
checks.above("elastic: order of what is left over in the time step",
             np.log2(left_over["elastic"] / left_over["elastic, half the step"]), 2.0)
checks.end()
