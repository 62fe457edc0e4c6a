"""Every kernel in 2D and 3D and in both forms: momentum, speed of sound in a bar, and with corrected gradients the
patch test; plane stress and plane strain against the closed forms."""
import numpy as np

from sphtm_scene import Checks, lattice_block, run

E, NU, RHO, DX = 70e9, 0.33, 2700.0, 1e-3
KERNELS = {"hyperbolic": 1.2, "cubic": 1.2, "quintic": 1.0, "wendland/c2": 1.5, "wendland/c4": 1.7}
STYLE = """
pair_style      sph/tm {kernel} {ratio} spacing 1e-3 form {form} {options}
pair_coeff      1 1 density 2700 elastic 70e9 0.33 strength elastic
"""
checks = Checks()


def head(dim, kernel, form, options="", length=40, width=6):
    work = " ".join("0 %g" % (n * DX) for n in (length, width, width)[:dim])
    return lattice_block(work, "-0.04 0.1 -0.03 0.04" + " -0.03 0.04" * (dim - 2), dim=dim) + STYLE.format(
        kernel=kernel, ratio=KERNELS[kernel], form=form, options=options)


# --- momentum of a disordered, tumbling lump: the sum of all against the sum of magnitudes
MOMENTUM = """
displace_atoms  all random 1e-4 1e-4 {dz} 4711 units box
fix             body all sph/tm
run             0
variable        u atom 20*sin(1234.5*x+777*y*id)
variable        w atom 20*cos(999.1*y*id+0.3)
velocity        all set v_u v_w {vz} units box
variable        px equal mass(all)*vcm(all,x)
variable        py equal mass(all)*vcm(all,y)
variable        pz equal mass(all)*vcm(all,z)
variable        a atom mass*sqrt(vx^2+vy^2+vz^2)
compute         a all reduce sum v_a
thermo_style    custom step c_a v_px v_py v_pz
thermo_modify   format float %.17g
thermo          20
run             60
"""


def momentum(dim, kernel, form, options=""):
    text = head(dim, kernel, form, options, 8, 8 if dim == 2 else 6)
    t = run(text + MOMENTUM.format(dz="1e-4" if dim == 3 else "0", vz="v_u" if dim == 3 else "NULL")).thermo[-1]
    return max(abs(t[p] - t[p][0]).max() for p in ("v_px", "v_py", "v_pz")[:dim]) / t["c_a"][0]


# --- standing wave of a bar with free ends, cos(pi x/L): the period of the modal velocity is 2L/c
BAR = """
fix             body all sph/tm courant 0.4
run             0
variable        s atom cos(PI*x/{length})
variable        u atom 0.01*v_s
velocity        all set v_u NULL NULL units box
variable        m atom vx*v_s
compute         m all reduce sum v_m
thermo_style    custom step time c_m
thermo_modify   format float %.12g
thermo          1
run             {steps}
"""


def wave_speed(dim, kernel, form, options):
    """Over that of the continuum, sqrt(E'/rho)."""
    n = 40
    modulus = E / (1 - NU**2) if dim == 2 else E
    c = np.sqrt(modulus / RHO)
    p_wave = np.sqrt(E * (1 - NU) / ((1 + NU) * (1 - 2 * NU)) / RHO)
    steps = int(1.3 * n * DX / c / (0.4 * KERNELS[kernel] * DX / p_wave))    # 0.65 periods
    alpha = "viscosity 0 0 artstress 0 4 "
    t = run(head(dim, kernel, form, alpha + options, n, 6 if dim == 2 else 4) +
            BAR.format(length=n * DX, steps=steps)).thermo[-1]
    m, time = t["c_m"], t["Time"]
    k = np.nonzero((m[:-1] > 0) & (m[1:] <= 0))[0]
    if not len(k):
        return 0.0
    quarter = time[k[0]] + (time[k[0] + 1] - time[k[0]]) * m[k[0]] / (m[k[0]] - m[k[0] + 1])
    return 2 * n * DX / (4 * quarter) / c


# --- patch test: a linear velocity on disordered particles; the strain rate of one short step is exact. In 3D the
# correction is dropped where the moment matrix has a determinant below 0.1, and that is at the edges of a block
# (0.07 to 0.09 on the lattice): there the strain rate is that of plain SPH, and a thin bar is too soft.
G = np.array([[700.0, 300.0, -200.0], [-400.0, -500.0, 600.0], [100.0, 250.0, 350.0]])
PATCH = """
displace_atoms  all random 1e-4 1e-4 {dz} 815 units box
fix             body all sph/tm dt 1e-10
run             0
variable        u atom {u}
variable        v atom {v}
variable        w atom {w}
velocity        all set v_u v_v {vz} units box
compute         p all sph/tm/atom density stress/xx stress/yy stress/zz stress/xy stress/xz stress/yz
run             1
write_dump      all custom end.dump id x y z c_p[*] modify format float %.17g
"""


def gradient(dim):
    g = G.copy()
    if dim == 2:
        g[2, :] = g[:, 2] = 0
    return g


def patch_script(dim, kernel, options=""):
    g = gradient(dim)
    line = ["+".join("(%r)*%s" % (float(g[r, c]), "xyz"[c]) for c in range(dim)) for r in range(3)]
    return (head(dim, kernel, "f15", "viscosity 0 0 " + options, 8, 8 if dim == 2 else 6) +
            PATCH.format(dz="1e-4" if dim == 3 else "0", u=line[0], v=line[1], w=line[2],
                         vz="v_w" if dim == 3 else "NULL"))


def patched(dim, kernel, options=""):
    return run(patch_script(dim, kernel, options)).dump("end.dump")[-1]


def patch_errors(dim, frame):
    """Errors of the stress increment over its largest entry: of the particles away from edges, and the share of the
    others that is off by more than 1e-3."""
    dt, L = 1e-10, gradient(dim)    # short: the step is of second order in dt times the rate, 1e-7
    D = 0.5 * (L + L.T)
    shear, bulk = E / (2 * (1 + NU)), E / (3 * (1 - 2 * NU))
    s = dt * (2 * shear * (D - np.trace(D) / 3 * np.eye(3)))
    rho = 1 - dt * np.trace(L)
    s += -bulk * (rho - 1) * np.eye(3)
    exact = np.array([s[0, 0], s[1, 1], s[2, 2], s[0, 1], s[0, 2], s[1, 2]])
    got = np.array([frame["c_p[%d]" % k] for k in range(2, 8)])
    error = abs(got - exact[:, None]).max(axis=0) / abs(exact).max()
    lengths = 8 * DX, (8 if dim == 2 else 6) * DX, 6 * DX
    faces = sum((frame[c] < DX).astype(int) + (frame[c] > lengths["xyz".index(c)] - DX) for c in "xyz"[:dim])
    edge = faces >= 2 if dim == 3 else np.zeros(len(faces), bool)
    return error[~edge].max(), (error[edge] > 1e-3).mean() if dim == 3 else 0.0


def table():
    for dim in (2, 3):
        for kernel in KERNELS:
            for form in ("f15", "f14"):
                name = "%dD %s %s" % (dim, kernel, form)
                checks.below(name + ": momentum", momentum(dim, kernel, form), 2e-14)
                plain = wave_speed(dim, kernel, form, "")
                text = "%+.1f %%" % (100 * (plain - 1))
                if form == "f15":
                    checks.below(name + " corrected: momentum", momentum(dim, kernel, form, "correction yes"), 2e-14)
                    corrected = wave_speed(dim, kernel, form, "correction yes")
                    # in 3D 12 of the 16 rows of particles of this bar are at faces, 4 of them at edges
                    checks.near(name + " corrected: speed of a bar", corrected, 1.0, relative=0.01 if dim == 2 else 0.1)
                    inside, dropped = patch_errors(dim, patched(dim, kernel, "correction yes"))
                    checks.below(name + " corrected: patch test", inside, 1e-6)
                    if dim == 3:
                        checks.note("   share of the edge particles without correction", "%.2f" % dropped)
                    text += ", patch test by %.2g" % patch_errors(dim, patched(dim, kernel))[0]
                checks.note(name + " plain: speed of a bar off by", text)


# --- a strip is pulled slowly and held: modulus from stress and strain of its middle, thickness. The strain is 1e-5:
# at 1e-3 and without artificial stress the tensile instability moves columns by a percent of the spacing meanwhile
PULL = """
fix             body all sph/tm
region          left block INF 0.002 INF INF INF INF units box
region          right block 0.030 INF INF INF INF INF units box
group           left region left
group           right region right
region          c1 block 0.008 0.009 INF INF INF INF units box
region          c2 block 0.022 0.023 INF INF INF INF units box
region          middle block 0.008 0.024 0.003 0.005 INF INF units box
group           c1 region c1
group           c2 region c2
group           middle region middle
run             0
fix             slow all viscous {gamma!r}
variable        v equal "0.005*(time<{ramp!r})*(1-cos(2*PI*time/{ramp!r}))"
fix             hold left sph/tm/drive 0 NULL NULL
fix             pull right sph/tm/drive v_v NULL NULL
compute         p all sph/tm/atom stress/xx stress/yy stress/zz thickness
compute         s middle reduce ave c_p[1] c_p[2] c_p[3] c_p[4]
variable        gauge equal xcm(c2,x)-xcm(c1,x)
thermo_style    custom step time v_gauge c_s[1] c_s[2] c_s[3] c_s[4] f_hold[1] f_pull[1]
thermo_modify   format float %.14g
thermo          200
run             {steps}
"""


def pull(plane, options):
    n, c = 32, np.sqrt(E / RHO)
    period = 2 * n * DX / c
    ramp = 6 * period
    gamma = RHO * DX**2 * 2 * np.pi / period
    steps = int(12 * period / (0.4 * 1.2 * DX / (np.sqrt(E * (1 - NU) / ((1 + NU) * (1 - 2 * NU)) / RHO) * 1.6)))
    t = run(head(2, "hyperbolic", "f15", "plane %s artstress 0 4 %s" % (plane, options), n, 8) +
            PULL.format(gamma=gamma, ramp=ramp, steps=steps)).thermo[-1]
    last = {k: v[-1] for k, v in t.items()}
    strain = np.log(last["v_gauge"] / t["v_gauge"][0])
    force = 0.5 * (last["f_hold[1]"] - last["f_pull[1]"]) / (8 * DX)
    return strain, last["c_s[1]"], last["c_s[2]"], last["c_s[3]"], last["c_s[4]"], force


def planes():
    for plane, modulus in (("stress", E), ("strain", E / (1 - NU**2))):
        for options in ("correction yes", ""):
            strain, xx, yy, zz, thickness, force = pull(plane, options)
            name = "plane %s %s" % (plane, options or "plain")
            checks.note(name + ": strain, stress across over along", "%.4g, %.2g" % (strain, yy / xx))
            if options:
                checks.near(name + ": modulus from the stress", xx / strain, modulus, relative=0.01)
                checks.near(name + ": modulus from the force", force / strain, modulus, relative=0.02)
                if plane == "stress":
                    checks.near(name + ": thinning over strain", (1 - thickness) / strain, NU, relative=0.01)
                    checks.below(name + ": stress through the thickness", abs(zz / xx), 1e-9)
                else:
                    checks.near(name + ": stress through the thickness", zz / xx, NU, relative=0.02)
            else:
                checks.note("   modulus from stress, from force", "%+.1f %%, %+.1f %%" %
                            (100 * (xx / strain / modulus - 1), 100 * (force / strain / modulus - 1)))


if __name__ == "__main__":
    planes()
    table()
    checks.end()
