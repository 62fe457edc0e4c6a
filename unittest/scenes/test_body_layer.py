"""The half spacing between particles and the surface of their body strains where another body touches it (doc/pair_sph_tm.rst, contact):
blocks of perfectly plastic metal, plane strain and 3D, pressed between two anvils of particles, against the closed form; layer rigid beside it;
momentum and energy of an impact; restart, ranks, messages."""
import re

import numpy as np
from sphtm_scene import Checks, run

Y = 300e6
PRESS = """
units           si
dimension       ${dim}
boundary        f f ${bz}
atom_style      atomic
newton          off
atom_modify     map array
variable        dx equal v_height/v_rows
variable        w equal round(4e-3/v_dx)*v_dx
variable        far equal v_w+4*v_dx
variable        z equal v_dim-2
variable        deep equal v_z*v_w+(1-v_z)*0.5*v_dx
variable        zfar equal v_z*v_far+(1-v_z)*0.5*v_dx
lattice         ${lattice} ${dx} origin 0.5 0.5 $(0.5*v_z)
region          box block $(-2*v_far) $(2*v_far) -4e-3 7e-3 $(-(1+v_z)*v_zfar) $((1+v_z)*v_zfar) units box
create_box      3 box
region          work block $(-v_w) $(v_w) 0 ${height} $(-v_deep) $(v_deep) units box
region          low block $(-v_far) $(v_far) $(-4*v_dx) 0 $(-v_zfar) $(v_zfar) units box
region          high block $(-v_far) $(v_far) ${height} $(v_height+4*v_dx) $(-v_zfar) $(v_zfar) units box
create_atoms    1 region work
create_atoms    2 region low
create_atoms    3 region high
group           work type 1
group           low type 2
group           high type 3
pair_style      sph/tm hyperbolic 1.2 spacing ${dx}
pair_coeff      1 1 density 7850 elastic 200e9 0.3 strength plastic 300e6 0
pair_coeff      2 2 density 7850 elastic 200e9 0.3
pair_coeff      3 3 density 7850 elastic 200e9 0.3
pair_coeff      1 2*3 contact ${more}
pair_coeff      2 3 none
"""
MOVE = """
fix             body all sph/tm energy yes
variable        v equal ${speed}*((time<1e-5)*time/1e-5+(time>=1e-5))
variable        d equal -v_v
fix             dl low sph/tm/drive 0 v_v 0
fix             dh high sph/tm/drive 0 v_d 0
compute         p all sph/tm/atom pstrain
compute         ylo low reduce max y
compute         yhi high reduce min y
compute         wide work reduce sum x
variable        h equal c_yhi-c_ylo-v_dx
variable        force equal 0.5*(f_dh[2]-f_dl[2])
thermo          20
thermo_style    custom step time v_h v_force f_dl[2] f_dh[2] f_body[8] f_body[9] c_p[0]
thermo_modify   format float %.16g
"""
MOVE = MOVE.replace(" c_p[0]", "").replace("compute         wide work reduce sum x\n", "")
STOP = """
variable        left equal v_h-v_to*v_height
fix             stop all halt 20 v_left <= 0 error continue message no
run             100000
write_dump      all custom end.dump id type x y z c_p modify sort id format float %.16g
"""
checks = Checks()


def press(rows, more="", dim=2, to=0.9, speed=5.0, height=4e-3):
    script = PRESS + MOVE + STOP
    return run(script, {"rows": rows, "more": more, "dim": dim, "to": to, "speed": speed, "height": height, "bz": "p" if dim == 2 else "f", "lattice": "sq" if dim == 2 else "sc"})


def force_over_closed_form(r, dim, rows, height=4e-3):
    """Mean of the last fifth of the way, over the section of the block, whose volume stays."""
    t = r.thermo[-1]
    dx = height / rows
    half = round(4e-3 / dx) * dx
    h = t["v_h"]
    late = h < h[-1] + 0.2 * (height - h[-1])
    section = 2 * half * height / h if dim == 2 else 4 * half**2 * height / h
    due = section * Y * (2 / np.sqrt(3) if dim == 2 else 1.0)
    return (t["v_force"] / due)[late].mean()


# force over the closed form: with the layers that are the default of metal that flows, and without, as the page says
for dim, rows, more, due, within in ((2, 16, "", 1.0, 0.01), (2, 8, "", 1.0, 0.01), (3, 6, "", 1.0, 0.01), (2, 16, "layer rigid", 1.06, 0.02),
                                     (2, 8, "layer rigid", 1.15, 0.02), (3, 6, "layer rigid", 1.215, 0.02)):
    r = press(rows, more, dim)
    ratio, t = force_over_closed_form(r, dim, rows), r.thermo[-1]
    name = "%dD, %d rows%s: " % (dim, rows, ", " + more if more else "")
    checks.near(name + "force over the closed form", ratio, due, absolute=within)
    checks.below(name + "drift of the energy sum over the work", np.ptp(t["f_body[9]"]) / abs(t["f_body[8]"]).max(), 2e-5)
    end = r.dump("end.dump")[-1]
    mine = end["type"] == 1
    strain, y, x = end["c_p"][mine], end["y"][mine], end["x"][mine]
    middle = abs(x) < 1.5e-3
    outer = strain[middle & ((y < y.min() + 0.3 * 4e-3 / rows) | (y > y.max() - 0.3 * 4e-3 / rows))].mean()
    inner = strain[middle & (abs(y - y.mean()) < 0.25 * np.ptp(y))].mean()
    print(name + "plastic strain of the outermost row over that in the middle %.3f" % (outer / inner))
    if not more:
        checks.near(name + "plastic strain of the outermost row over that in the middle", outer / inner, 1.0, absolute=0.12)

# a free body in flight between others: momentum; a block that is hit by another of its metal
HIT = """
units           si
dimension       2
boundary        f f p
atom_style      atomic
newton          off
atom_modify     map array
lattice         sq 0.25e-3 origin 0.5 0.5 0
region          box block -8e-3 8e-3 -6e-3 6e-3 -1.25e-4 1.25e-4 units box
create_box      2 box
region          a block -4e-3 0 -2e-3 2e-3 INF INF units box
region          b block 0 3e-3 -1e-3 2.5e-3 INF INF units box
create_atoms    1 region a
create_atoms    2 region b
group           a type 1
group           b type 2
pair_style      sph/tm hyperbolic 1.2 spacing 0.25e-3
pair_coeff      1 1 density 7850 elastic 200e9 0.3 strength plastic 300e6 500e6 heat 40 480 0.9
pair_coeff      2 2 density 2700 elastic 70e9 0.33 strength plastic 200e6 100e6 heat 150 900 0.9
pair_coeff      1 2 contact friction 0.2 ${more}
velocity        a set 100 30 0 units box
"""
FLY = """
fix             body all sph/tm energy yes temperature 300
compute         p all sph/tm/atom pstrain temperature
variable        px equal mass(all)*vcm(all,x)
variable        py equal mass(all)*vcm(all,y)
thermo          10
thermo_style    custom step time v_px v_py f_body[5] f_body[7] f_body[8] f_body[9]
thermo_modify   format float %.16g
"""
END = "write_dump all custom {} id type x y vx vy c_p[*] modify sort id format float %.17g\n"
start = HIT.replace("${more}", "")
first = run(start + FLY + "run 200\nwrite_restart half\nrun 200\n" + END.format("whole.dump"))
t, t2 = first.thermo[0], first.thermo[1]
checks.below("impact: change of momentum", max(np.ptp(t["v_px"]), np.ptp(t2["v_px"]), np.ptp(t["v_py"]), np.ptp(t2["v_py"])) / abs(t["v_px"][0]), 1e-11)
a = first.dump("whole.dump")[-1]
checks.above("impact: plastic strain", a["c_p[1]"].max(), 0.1)
kinetic = 0.5 * 7850 * (16 * 16 * 0.25e-3**2) * (100.0**2 + 30.0**2)
checks.below("impact: drift of the energy sum over the energy of the motion", abs(t2["f_body[9]"] - t["f_body[9]"][0]).max() / kinetic, 2e-4)
second = run("\nread_restart half\n" + FLY + "run 200\n" + END.format("again.dump"), folder=first.folder)
b = second.dump("again.dump")[-1]
for k in "x", "y", "vx", "vy", "c_p[1]", "c_p[2]":
    checks.true("restart bit for bit: " + k, np.array_equal(a[k], b[k]), "%g" % abs(a[k] - b[k]).max())
two = run(start + FLY + "run 400\n" + END.format("two.dump"), ranks=2)
c = two.dump("two.dump")[-1]
for k, scale in ("x", 0.25e-3), ("vx", 100.0), ("c_p[1]", 1.0):
    checks.below("two ranks: " + k, abs(a[k] - c[k]).max() / scale, 1e-7)

# messages, and what turns the layers on
for words, expected in (("layer soft", "layer must be rigid or strains, got soft"), ("layers strains", "penalty, layer, damping")):
    result = run(HIT.replace("${more}", words) + FLY + "run 0\n", expect_error=True)
    checks.true("message for '%s'" % words, expected in result.errors(), result.errors()[:160])
on = run(HIT.replace("${more}", "") + FLY + "run 0\n").output
off = run(HIT.replace("${more}", "layer rigid") + FLY + "run 0\n").output
elastic = HIT.replace("strength plastic 300e6 500e6 ", "").replace("strength plastic 200e6 100e6 ", "").replace("${more}", "")
none = run(elastic + FLY.replace(" pstrain", "") + "run 0\n").output
is_on = [re.search("effect contact-layer +on", o) is not None for o in (on, off, none)]
checks.true("contact-layer is on where a body flows", is_on == [True, False, False], str(is_on))
checks.end()
