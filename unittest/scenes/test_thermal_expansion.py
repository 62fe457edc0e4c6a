"""Thermal expansion against closed forms: free bar, held bars, bimetal strip, thick tube with a hot bore, free surfaces
corrected; heat at constant pressure; and the same body without the effect."""
import numpy as np

from sphtm_scene import PLANE, SPACE, Checks, run

E, NU, ALPHA, RHO, CP, T0, DT = 70e9, 0.33, 2.3e-5, 2700.0, 900.0, 300.0, 100.0
METAL = "density 2700 elastic 70e9 0.33 strength elastic heat {k} 900 0.9 expansion {alpha} {more}"
HEAD = """
lattice         {lattice} {dx} origin 0.5 0.5 {z}
region          box block {box} units box
create_box      {types} box
{body}
pair_style      sph/tm cubic 1.3 spacing {dx} viscosity 0.2 0 artstress 0 4 correction yes {style}
{coeff}
fix             body all sph/tm temperature 300 energy yes {fix}
compute         p all sph/tm/atom stress/xx stress/yy stress/xy temperature
compute         mean all reduce ave c_p[1] c_p[2] c_p[4]
variable        ramp equal (time<{t})*0.5*(1-cos(PI*time/{t}))+(time>={t})
variable        now equal time
{heat}
fix             stop all halt 1 v_now > {end} error continue
{more}
thermo          {steps}
thermo_style    custom step time c_mean[1] c_mean[2] c_mean[3] f_body[2] f_body[4] f_body[8] f_body[9] f_body[1]
thermo_modify   format float %.12g
dump            1 all custom {steps} all.dump id type x y z c_p[*]
dump_modify     1 sort id format float %.12g
run             100000
write_dump      all custom end.dump id type x y z c_p[*] modify sort id format float %.12g
"""
WARM = "variable        warm equal 300+100*v_ramp\nfix             hot all sph/tm/heat temperature v_warm"
checks = Checks()


def scene(plane=True, dx="1e-3", types=1, k=0.0, alpha=ALPHA, more="", coeff=None, heat=WARM, style="", fix="", t=3e-5, end=6e-5,
          boundary="f f p", box="", body="", steps=50, commands="", expect_error=False):
    space = PLANE if plane else SPACE
    head = space.replace(space.split("boundary")[1].split("\n")[0].strip(), boundary)
    text = head + HEAD.format(lattice="sq" if plane else "sc", dx=dx, z="0" if plane else "0.5", box=box, types=types, body=body,
                              style=style, coeff=coeff or "pair_coeff 1 1 " + METAL.format(k=k, alpha=alpha, more=more),
                              heat=heat, t=t, end=end, fix=fix, steps=steps, more=commands)
    return run(text, expect_error=expect_error)


def block(x, y, z="INF INF", types=1):
    return "region work%d block %s %s %s units box\ncreate_atoms %d region work%d" % (types, x, y, z, types, types)


def late(result, column, last=0.4):
    """Mean over the last part of the run."""
    log = result.thermo[-1]
    return log[column][log["Time"] > (1 - last) * log["Time"][-1]].mean()


# --- free bar in three dimensions, heated by a power: length, and the temperature that c_p gives
power = RHO * CP * DT / 3e-5
free = dict(plane=False, boundary="f f f", box="-5e-3 25e-3 -5e-3 9e-3 -5e-3 9e-3", body=block("0 20e-3", "0 4e-3", "0 4e-3"),
            heat="variable q equal %g*(1-cos(2*PI*time/3e-5))*(time<3e-5)\nfix hot all sph/tm/heat source v_q" % power)
result = scene(**free)
frames = result.dump("all.dump")


def strain(frame, start, axis="x"):
    return np.polyfit(start[axis], frame[axis], 1)[0] - 1.0


lengths = np.mean([strain(f, frames[0]) for f in frames[len(frames) * 6 // 10:]])
checks.near("free bar: strain", lengths, ALPHA * DT, relative=0.01)
# the source is per volume as it is: half of the volume strain more
checks.near("free bar: rise of the temperature, heated by rho cp dT", late(result, "c_mean[3]") - T0,
            DT * (1 + 1.5 * ALPHA * DT), relative=0.001)
log = result.thermo[-1]
checks.below("free bar: drift of the sum of energies over the heat", np.ptp(log["f_body[9]"]) / abs(log["f_body[4]"]).max(), 0.001)
cold = scene(fix="effects expansion off", **free)
frames = cold.dump("all.dump")
checks.below("free bar without the effect: strain", abs(strain(frames[-1], frames[0])), 1e-5)

# --- a table of alpha, from 2e-5 at 300 K to 3e-5 at 400 K
frames = scene(alpha="table/2 300 2e-5 400 3e-5", **free).dump("all.dump")
lengths = np.mean([strain(f, frames[0]) for f in frames[len(frames) * 6 // 10:]])
checks.near("free bar with a table: strain", lengths, 2.5e-3, relative=0.01)

# --- held in one direction: three dimensions and plane stress -E alpha dT, plane strain -E alpha dT/(1 - nu)
held = {"three dimensions": (scene(plane=False, boundary="p f f", box="0 8e-3 -5e-3 13e-3 -5e-3 13e-3",
                                   body=block("0 8e-3", "0 8e-3", "0 8e-3")), 1.0),
        "plane stress": (scene(style="plane stress", boundary="p f p", box="0 10e-3 -5e-3 15e-3 -5e-4 5e-4",
                               body=block("0 10e-3", "0 10e-3")), 1.0),
        "plane strain": (scene(boundary="p f p", box="0 10e-3 -5e-3 15e-3 -5e-4 5e-4", body=block("0 10e-3", "0 10e-3")),
                         1.0 / (1.0 - NU))}
for name, (result, factor) in held.items():
    checks.near("held bar, %s: stress (MPa)" % name, late(result, "c_mean[1]") * 1e-6, -E * ALPHA * DT * factor * 1e-6, relative=0.01)
    checks.below("held bar, %s: cross stress over it" % name, abs(late(result, "c_mean[2]") / (E * ALPHA * DT)), 0.01)

# --- bimetal strip in plane stress: curvature 3 (a1 - a2) dT/(2 t), Timoshenko 1925
def strip(rows, a1=2.3e-5, a2=1.1e-5):
    t, dx = 12e-3, 12e-3 / rows
    L = 4 * t
    coeff = "\n".join("pair_coeff %d %d %s" % (i, i, METAL.format(k=0, alpha=a, more="")) for i, a in ((1, a1), (2, a2)))
    body = "\n".join(block("0 %g" % L, "%g %g" % y, types=i) for i, y in ((1, (0, t / 2)), (2, (t / 2, t))))
    result = scene(dx="%g" % dx, types=2, coeff=coeff + "\npair_coeff 1 2 bond", body=body, style="plane stress",
                   box="-0.02 0.068 -0.02 0.032 -5e-4 5e-4", t=5.4e-5, end=10.8e-5)
    frames = result.dump("all.dump")
    start, late = frames[0], frames[len(frames) * 13 // 24:]
    middle = abs(start["x"] - L / 2) < L / 4
    bend = []
    for f in late:
        x, y = f["x"][middle], f["y"][middle]
        layer = start["y"][middle]
        # y = y0(layer) + slope x + curvature/2 x^2
        A = np.column_stack([np.ones_like(x), layer, x, x * x])
        bend.append(2 * np.linalg.lstsq(A, y, rcond=None)[0][3])
    return np.mean(bend) / (3 * (a1 - a2) * DT / (2 * t))


coarse, fine = strip(12), strip(24)
checks.near("bimetal strip, 24 rows: curvature over Timoshenko's", fine, 1.0, relative=0.01)
checks.above("bimetal strip: error with 12 rows over that with 24", (coarse - 1) / abs(fine - 1), 2.0)

# --- long thick tube with a hot bore, temperature by conduction: hoop stress
def tube(a, b):
    k = 1e7    # so that conduction is as fast as sound
    body = "region out cylinder z 0 0 %g INF INF units box\nregion in cylinder z 0 0 %g INF INF side out units box\n" % (b, a)
    body += "region ring intersect 2 out in\ncreate_atoms 1 region ring\n"
    body += "region bore cylinder z 0 0 %g INF INF units box\nregion rim cylinder z 0 0 %g INF INF side out units box\n" % (
        a + 1e-3, b - 1e-3)
    body += "group bore region bore\ngroup rim region rim"
    heat = "variable warm equal 300+100*v_ramp\nfix hot bore sph/tm/heat temperature v_warm\nfix cold rim sph/tm/heat temperature 300"
    w = 1.2 * b
    result = scene(box="%g %g %g %g -5e-4 5e-4" % (-w, w, -w, w), body=body, heat=heat, k=k, t=10e-5, end=16e-5)
    frames = result.dump("all.dump")
    late = frames[len(frames) * 10 // 16:]
    x, y = frames[0]["x"], frames[0]["y"]
    r = np.hypot(x, y)
    s = np.mean([(f["c_p[1]"] * y * y + f["c_p[2]"] * x * x - 2 * f["c_p[3]"] * x * y) / r ** 2 for f in late], axis=0)
    T = np.mean([f["c_p[4]"] for f in late], axis=0)
    # temperature as it is between the layers that are held, by its slope over ln r
    slope, at = np.polyfit(np.log(r), T, 1)
    dT = -slope * np.log(b / a)
    ln = np.log(b / a)
    exact = E * ALPHA * dT / (2 * (1 - NU) * ln) * (1 - np.log(b / r) - a * a / (b * b - a * a) * (1 + b * b / r ** 2) * ln)
    bore = E * ALPHA * dT / (2 * (1 - NU) * ln) * (1 - 2 * b * b / (b * b - a * a) * ln)
    # the surfaces are steps of the lattice: within 3 spacings the stress follows those
    inside = (r > a + 3e-3) & (r < b - 3e-3)
    s, exact = s[inside], exact[inside]
    return np.sqrt(np.mean((s - exact) ** 2)) / abs(bore), (s @ exact) / (exact @ exact), dT


scatter, factor, dT = tube(20e-3, 45e-3)
checks.note("tube: temperature from bore to rim", "%.2f K" % dT)
checks.below("tube: hoop stress, root mean square of the error over that at the bore", scatter, 0.01)
checks.near("tube: hoop stress over the closed form, by least squares", factor, 1.0, relative=0.01)

# --- what cannot be
bad = scene(coeff="pair_coeff 1 1 density 2700 elastic 70e9 0.33 expansion 2e-5", box="0 1e-2 0 1e-2 -5e-4 5e-4",
            body=block("2e-3 6e-3", "2e-3 6e-3"), heat="", expect_error=True)
checks.true("expansion without heat constants is refused", "expansion needs 'heat k cp chi'" in bad.errors(), bad.errors()[:200])
warned = scene(more="eos shock 5240 1.4 1.97", alpha=9e-5, box="0 1e-2 0 1e-2 -5e-4 5e-4", body=block("2e-3 6e-3", "2e-3 6e-3"),
               heat="", t=1e-7, end=1e-7)
checks.true("expansion beside a shock equation of state: a warning", any("is not read" in w for w in warned.warnings()), "")
checks.end()
