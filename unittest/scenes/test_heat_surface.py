"""Free surface of a body, its cooling by convection and radiation against the lumped solution, and that of a slab against the series."""
import numpy as np

from sphtm_scene import Checks, run

checks = Checks()

BODY = """
units {units}
dimension {dim}
boundary {boundary}
atom_style atomic
newton off
variable dx equal {dx!r}
variable L equal {n}*v_dx
lattice {lattice} ${{dx}} origin 0.5 0.5 {origin}
region box block {box} units box
create_box 1 box
region body block {region} units box
create_atoms 1 region body
pair_style sph/tm {style} spacing ${{dx}}
pair_coeff 1 1 density {density} elastic 70e9 0.3 body {body} heat {k} {cp} 0 emissivity 0.5
fix body all sph/tm temperature {T0}
compute p all sph/tm/atom temperature
compute s all sph/tm/atom surface/area
compute T all reduce ave c_p
"""


def body(dim, n, more, dx=1e-3, slab=False, style="hyperbolic 1.2", kind="heat", units="si", density=2700.0, k=200.0,
         cp=900.0, T0=600.0):
    """A square or cube of n particles a side in free space; slab: periodic in all directions but x."""
    lo, hi = "$(-3*v_dx)", "$(v_L+3*v_dx)"
    other = "0 ${L}" if slab else lo + " " + hi
    z, flat = ("$(-v_dx) ${dx}", "$(-v_dx) ${dx}") if dim == 2 else (other, "0 ${L}")
    p = "p" if slab else "f"
    return BODY.format(units=units, dim=dim, dx=dx, n=n, lattice="sq" if dim == 2 else "sc",
                       origin=0 if dim == 2 else 0.5,
                       boundary="f %s %s" % (p, "p" if dim == 2 else p), box="%s %s %s %s" % (lo, hi, other, z),
                       region="0 ${L} 0 ${L} %s" % flat, style=style, density=density, body=kind, k=k, cp=cp,
                       T0=T0) + more + "thermo_modify format float %.15g\nrun 0\n"


AREA = """
fix h all sph/tm/heat convection 1000 300 {0}
thermo_style custom step time dt f_h f_h[1] f_h[2] f_h[3] c_T
dump d all custom 1 area.dump id x y z c_s
"""

# --- area
for dim in (2, 3):
    for kind in ("heat", "solid"):
        for style in ("hyperbolic 1.2", "quintic 1.2", "wendland/c2 1.9"):
            n = 12
            result = run(body(dim, n, AREA.format(""), slab=True, kind=kind, style=style))
            exact = 2 * (n * 1e-3) ** (dim - 1)
            checks.near("%dD, %s, %s: flat faces" % (dim, kind, style), result.thermo[0]["f_h[3]"][0], exact,
                        relative=1e-9)
            # half a spacing of the material in series with the surface
            checks.near("%dD, %s, %s: power" % (dim, kind, style), result.thermo[0]["f_h"][0],
                        -300 * exact / (1 / 1000 + 0.5e-3 / 200), relative=1e-9)
    # half of another density, bonded: no surface in between
    two = body(dim, 12, AREA.format(""), slab=True, kind="solid").replace("create_box 1", "create_box 2").replace(
        "pair_coeff 1 1 density 2700.0", "region half block 0 6e-3 INF INF INF INF units box\nset region half type 2\n"
        "pair_coeff 2 2 density 7800 elastic 200e9 0.3 heat 40 450 0 emissivity 0.5\npair_coeff 1 1 density 2700.0")
    checks.near("%dD: flat faces, bonded to another density" % dim, run(two).thermo[0]["f_h[3]"][0],
                2 * (12 * 1e-3) ** (dim - 1), relative=1e-9)
    for n in (10, 20):
        if dim == 3 and n == 20:
            n = 16
        result = run(body(dim, n, AREA.format("")))
        frame = result.dump("area.dump")[-1]
        L = n * 1e-3
        exact = 2 * dim * L ** (dim - 1)
        checks.near("%dD, %d a side: area" % (dim, n), result.thermo[0]["f_h[3]"][0], exact,
                    absolute=exact * (0.95, 1.8)[dim - 2] / n)
        checks.near("%dD, %d a side: the compute's area" % (dim, n), frame["c_s"].sum(), result.thermo[0]["f_h[3]"][0],
                    relative=1e-6)
        depth = np.min([np.minimum(frame[c], L - frame[c]) for c in "xyz"[:dim]], axis=0)
        checks.below("%dD, %d a side: area below the first layer" % (dim, n), frame["c_s"][depth > 1e-3].max(), 0)
        face = run(body(dim, n, AREA.format("facing -1 0 0"))).thermo[0]["f_h[3]"][0]
        checks.near("%dD, %d a side: one face" % (dim, n), face, L ** (dim - 1),
                    absolute=L ** (dim - 1) * 0.9 / n * (dim - 1))
        known = run(body(dim, n, AREA.format("area %g" % exact))).thermo[0]["f_h[3]"][0]
        checks.near("%dD, %d a side: area given" % (dim, n), known, exact, relative=1e-12)

# a lattice in disorder: no area inside
noisy = body(2, 24, AREA.format("").replace("fix h", "displace_atoms all random 1e-4 1e-4 0 4711 units box\nfix h"))
result = run(noisy)
frame = result.dump("area.dump")[-1]
inside = np.min([np.minimum(frame[c], 0.024 - frame[c]) for c in "xy"], axis=0) > 2e-3
checks.below("2D, moved by up to 0.1 spacings: area inside, share", frame["c_s"][inside].sum() / 0.096, 0.01)
checks.near("2D, moved by up to 0.1 spacings: area", result.thermo[0]["f_h[3]"][0], 0.096, relative=0.08)

# --- cooling; the body conducts so well that it is of one temperature (Biot number 0.01)
COOL = """
thermo_style custom step time dt f_h f_h[1] f_h[2] f_h[3] c_T
thermo 500
"""


def cooled(name, text, A, law, mcp, unit=1.0, tolerance=2e-3):
    """law(T): flux out of the body. Compared with the lumped body, integrated by fourth-order Runge-Kutta."""
    result = run(text)
    log = result.thermo[-1]
    T, times, worst = log["c_T"][0], log["Time"], 0.0
    for k in range(1, len(times)):
        h = (times[k] - times[k - 1]) / 100
        for _ in range(100):
            s = [0.0] * 4
            for j, c in enumerate((0, 0.5, 0.5, 1)):
                s[j] = -A / mcp * law(T + c * h * (s[j - 1] if j else 0.0))
            T += h / 6 * (s[0] + 2 * s[1] + 2 * s[2] + s[3])
        worst = max(worst, abs(T - log["c_T"][k]) / (log["c_T"][0] - T))
    checks.below(name + ": error over the fall, from %.4g to %.4g K" % (log["c_T"][0], T), worst, tolerance)
    checks.above(name + ": it cooled by", log["c_T"][0] - T, 100)
    checks.near(name + ": energy delivered", log["f_h[2]"][-1] * unit, mcp * (log["c_T"][-1] - log["c_T"][0]),
                relative=1e-9)


n, L = 6, 6e-3
volume, surface = L ** 3, 6 * L ** 2
mcp = 2700 * volume * 900
cooled("3D, convection", body(3, n, "fix h all sph/tm/heat convection 600 300 area %r\n" % surface + COOL).replace(
    "run 0", "run 5000"), surface, lambda T: 600 * (T - 300), mcp)
cooled("2D, convection", body(2, 10, "fix h all sph/tm/heat convection 200 300 area 0.04\n" + COOL).replace(
    "run 0", "run 10000"), 0.04, lambda T: 200 * (T - 300), 2700 * 1e-4 * 900)


def slab(n, L=20e-3, h=5000.0, k=50.0, rho=7850.0, cp=486.0):
    """Mean temperature of a slab of n particles that cools from 500 to 300 K at both faces, and that of the series; Biot number 1."""
    text = body(2, n, "fix h all sph/tm/heat convection %r 300\n" % h + COOL.replace("500", "1") + "variable left equal time<1.0\n"
                "fix stop all halt 1 v_left == 0 error continue message no\n", dx=L / n, slab=True, density=rho, k=k, cp=cp,
                T0=500.0).replace("run 0", "run 1000000")
    t = run(text).thermo[-1]
    biot, spread = h * 0.5 * L / k, k / (rho * cp) * t["Time"][-1] / (0.5 * L) ** 2
    mean = 300.0
    for j in range(60):    # roots of m tan m = Bi
        low, high = j * np.pi, (j + 0.5) * np.pi
        for _ in range(80):
            m = 0.5 * (low + high)
            low, high = (low, m) if m * np.tan(m) > biot else (m, high)
        mean += 200 * 4 * np.sin(m) ** 2 / (m * (2 * m + np.sin(2 * m))) * np.exp(-m * m * spread)
    return 500 - t["c_T"][-1], 500 - mean


for count, allowed in ((10, 0.015), (20, 0.0075), (40, 0.004)):
    found, due = slab(count)
    checks.near("slab that conducts (Biot number 1), %d particles: fall of its mean temperature" % count, found, due,
                relative=allowed)

SIGMA = 5.670374419e-8
cooled("3D, radiation, the material's emissivity", body(
    3, n, "fix h all sph/tm/heat radiation 300 area %r\n" % surface + COOL, T0=1500.0, cp=90.0, k=20.0).replace(
        "run 0", "run 8000"), surface, lambda T: SIGMA * 0.5 * (T ** 4 - 300 ** 4), mcp / 10, tolerance=4e-3)
# the same in the units micro: mass pg, length um, time us, so energy is pg um^2/us^2 = 1e-15 J
micro = body(3, n, "fix h all sph/tm/heat radiation 300 area %r emissivity 0.25\n" % (surface * 1e12) + COOL, T0=1500.0,
             units="micro", dx=1e3, density=2.7, k=20 * 1e15 / (1e6 * 1e6), cp=90e12 / 1e12).replace(
                 "run 0", "run 8000")
cooled("3D, radiation, units micro", micro.replace("70e9", "70e6"), surface / 1e6,
       lambda T: SIGMA * 0.25 * (T ** 4 - 300 ** 4), mcp / 10, unit=1e-15, tolerance=4e-3)

# heat of a source, on one particle in two
source = body(2, 4, """
variable q equal 1e9*(1-10*time)
fix h all sph/tm/heat source v_q
thermo_style custom step time dt f_h f_h[1] f_h[2] f_h[3] c_T
thermo 50
""").replace("run 0", "run 200")
log = run(source).thermo[0]
t = log["Time"]
checks.near("source from a variable: rise", log["c_T"][-1] - 600, 1e9 * (t[-1] - 5 * t[-1] ** 2) / (2700 * 900),
            relative=0.02)
checks.near("source: energy", log["f_h[2]"][-1], 16e-6 * 2700 * 900 * (log["c_T"][-1] - 600), relative=1e-11)
checks.near("source: power now", log["f_h"][-1], 16e-6 * 1e9 * (1 - 10 * t[-1]), relative=1e-9)

# --- messages
for words, expected in (
        ("", "needs a mode"), ("warmth 3", "needs a mode"), ("flux", "needs q"), ("temperature -1", "must be > 0"),
        ("convection 10", "needs Tinf"), ("flux v_none", "no variable none"),
        ("flux 1 colour 3", "known are facing, area, threshold"), ("flux 1 facing 0 0 1", "in the xy plane"),
        ("source 1 area 3", "known are none"), ("radiation 300 emissivity 2", "emissivity must be")):
    result = run(body(2, 4, "fix h all sph/tm/heat %s\n" % words), expect_error=True)
    checks.true("message for '%s'" % words, result.status != 0 and expected in result.errors(), result.errors()[:110])
result = run(body(2, 4, "fix h all sph/tm/heat flux 1\n").replace(
                 "temperature 600.0", "temperature 600.0 effects surface off"),
             expect_error=True)
checks.true("message for surface forced off", "needs the effect" in result.errors(), result.errors()[:110])
checks.end()
