"""What a LAMMPS user does with any style works with these too: info, plugin, thermo, compute reduce, dumps and
pictures, averages, variables, fix_modify, run in parts, atoms deleted, created, moved and renamed between runs, groups,
clear, data files, per-atom virial, hybrid, balance, memory."""
import os
import re
import sys

import numpy as np
from sphtm_scene import SOURCE, Checks, lattice_block, run

WORK, BOX = "0 8e-3 0 8e-3", "-5e-3 17e-3 -5e-3 17e-3"
HEAD = lattice_block(WORK, BOX, types=2, more="atom_modify     map array\n")
STYLE = """
pair_style sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff * * density 2700 elastic 70e9 0.33 strength plastic 100e6 1e9 heat 200 900 0.9
fix body all sph/tm temperature 310 energy yes
"""
MOVING = """
variable vx atom 200*sin(400*y)
variable vy atom 100*cos(300*x)
velocity all set v_vx v_vy NULL units box
"""
COMPUTE = "compute p all sph/tm/atom density pstrain temperature stress/xx stress/yy stress/xy vonmises\n"
FORCES = "run 0\nwrite_dump all custom f.dump id fx fy modify format float %.17g\n"
DUMP = "write_dump all custom {} id type x y vx vy c_p[*] modify format float %.17g\n"
BLOCK = HEAD + STYLE + MOVING + COMPUTE + "thermo 10\n"
checks = Checks()
TESTS = []


def test(function):
    TESTS.append(function)
    return function


def same(a, b, names=("x", "y", "vx", "vy", "c_p[1]", "c_p[2]", "c_p[3]", "c_p[4]")):
    return all(np.array_equal(a[n], b[n]) for n in names)


@test
def styles_are_listed():
    r = run(HEAD + "info styles pair\ninfo styles fix\ninfo styles compute\nplugin list\n")
    for word in ("sph/tm", "sph/tm/atom", "contact/tri", "cutting/force", "sph/tm/heat", "sph/tm/drive"):
        checks.true("info styles: " + word, re.search(r"(^|\s)%s(\s|$)" % word, r.output))
    listed = re.findall(r"(pair|fix|compute) style plugin (\S+)", r.output)
    checks.true("plugin list",
                ("pair", "sph/tm") in listed and ("fix", "contact/tri") in listed
                and ("compute", "sph/tm/atom") in listed, str(listed))


@test
def output():
    tool = os.path.join(SOURCE, "unittest", "harness", "yaml", "tool.stl")
    r = run(BLOCK + "fix tool all contact/tri file %s scale 1e-3 move 0 8.3e-3 0 friction 0.2\n" % tool + """
compute m all reduce max c_p[2] c_p[7]
compute a all reduce ave c_p[1]
compute s all stress/atom NULL virial
compute e all pe/atom
compute se all reduce sum c_e
compute ss all reduce sum c_s[1]
compute pr all pressure NULL virial
variable ke equal f_body[1]
variable twice atom 2*c_p[2]
compute t all reduce max v_twice
variable both equal f_body[9]/f_body[1]
fix mean all ave/time 2 5 10 c_m[1] f_body[10] v_ke file mean.dat
fix atoms all ave/atom 1 10 10 c_p[2]
compute rows all chunk/atom bin/1d y lower 2e-3 units box
fix profile all ave/chunk 1 10 10 rows c_p[3] file profile.dat
fix say all print 10 "strain $(c_m[1])" file said.dat screen no
fix_modify tool move linear 0 -5 0
dump 1 all custom 10 a.*.dump id type x y c_p[*] f_atoms v_twice c_s[1] c_s[2] c_s[4] c_e
dump_modify 1 format float %.17g sort id
dump 2 all custom 20 few.*.dump id c_p[2]
dump_modify 2 thresh c_p[2] > 0.01
dump 3 all image 20 picture.*.ppm c_p[2] type adiam 1e-3 size 128 128 fix tool type 3e-4 0
dump_modify 3 amap min max cf 0 2 min blue max red
thermo_style custom step time dt temp ke pe etotal press v_ke f_body f_body[1] f_body[2] f_body[9] f_body[10] &
  f_body[12]   c_m[1] c_m[2] c_a c_t c_se c_ss c_pr v_both f_tool f_tool[2] f_tool[12]
thermo_modify norm yes
run 20
write_data end.data
""")
    t, d = r.thermo[-1], r.dump("a.20.dump")[-1]
    checks.near("thermo: f_body[1] is ke", t["f_body[1]"][-1], 64 * t["KinEng"][-1], relative=1e-7)
    checks.near("thermo: pe is the elastic energy of the particles", 64 * t["PotEng"][-1], d["c_e"].sum(),
                relative=1e-7)
    checks.near("thermo: f_body is the sum", t["f_body"][-1], t["f_body[9]"][-1], relative=1e-9)
    checks.near("thermo: f_body[10] is dt", t["f_body[10]"][-1], t["Dt"][-1], relative=1e-7)
    checks.near("compute reduce max against the dump", t["c_m[1]"][-1], d["c_p[2]"].max(), relative=1e-7)
    checks.near("compute reduce ave against the dump", t["c_a"][-1], d["c_p[1]"].mean(), relative=1e-7)
    checks.near("atom-style variable of a column", t["c_t"][-1], 2 * t["c_m[1]"][-1], relative=1e-7)
    volume = 2700e-6 / d["c_p[1]"]    # mass 2.7e-3 of a plate one metre thick
    for k, (mine, theirs) in enumerate((("c_p[4]", "c_s[1]"), ("c_p[5]", "c_s[2]"), ("c_p[6]", "c_s[4]"))):
        scale = np.abs(d[mine]).max()
        # the virial is of the force point, half a step before the state
        checks.below("compute stress/atom is volume times " + ("xx", "yy", "xy")[k],
                     np.abs(d[theirs] / volume - d[mine]).max() / scale, 0.2)
    checks.near("per-atom virial adds up to the pressure", t["c_pr"][-1] * 22e-3 * 22e-3 * 2,
                -sum(d[n].sum() for n in ("c_s[1]", "c_s[2]")), relative=1e-5)
    mean = r.columns("mean.dat")
    checks.true("fix ave/time", mean.shape == (2, 4) and mean[1, 1] > 0, str(mean))
    checks.true("fix ave/atom", 0 < d["f_atoms"].max() <= d["c_p[2]"].max())
    with open(r.path("profile.dat")) as f:
        rows = [w for w in map(str.split, f) if len(w) == 4 and w[0] != "#"]
    checks.true("fix ave/chunk", any(float(w[3]) > 310 for w in rows), str(rows)[:200])
    with open(r.path("said.dat")) as f:
        said = [w for w in f.read().split() if re.match(r"[\d.]+(e-?\d+)?$", w)]
    checks.near("fix print of an immediate variable", float(said[-1]), t["c_m[1]"][-1], relative=1e-5)
    few = r.dump("few.20.dump")[-1]
    checks.true("dump_modify thresh", 0 < len(few["id"]) < 64 and len(few["id"]) == (d["c_p[2]"] > 0.01).sum())
    with open(r.path("picture.20.ppm"), "rb") as f:
        picture = f.read()
    pixels = np.frombuffer(picture[-128 * 128 * 3:], np.uint8).reshape(-1, 3)
    checks.true("dump image: coloured by strain, with the tool",
                picture[:2] == b"P6" and len(np.unique(pixels, axis=0)) > 20)
    with open(r.path("end.data")) as f:
        text = f.read()
    checks.true("write_data", "64 atoms" in text and "Velocities" in text and re.search(r"^1 0\.0027", text, re.M))
    # without the tool the picture has fewer colours of its kind: the tool is what differs
    bare = run(BLOCK + "dump 3 all image 20 picture.*.ppm c_p[2] type adiam 1e-3 size 128 128\nrun 0\n",
               expect_error=True)
    checks.true("dump image without tool", bare.status == 0)


@test
def runs_in_parts():
    whole = run(BLOCK + "run 40\n" + DUMP.format("end.dump")).dump("end.dump")[-1]
    parts = {"run 0 in between": "run 20\nrun 0\nrun 0\nrun 20\n", "run pre no": "run 20\nrun 20 pre no\n",
             "run upto": "run 20\nrun 40 upto\n", "run every": "run 40 every 10 'print here'\n",
             "run post no": "run 20 post no\nrun 20\n", "write_dump and write_data in between":
             "run 20\nwrite_dump all custom x.dump id c_p[1]\nwrite_data x.data\nwrite_restart x.restart\nrun 20\n",
             "reset_timestep in between": "run 20\nreset_timestep 0\nrun 20\n",
             "timestep has no effect": "timestep 1e-3\nrun 20\ntimestep 1e-12\nrun 20\n",
             "neigh_modify": "neigh_modify every 1 delay 0 check yes\nrun 20\nneigh_modify every 2 delay 4\nrun 20\n",
             "thermo of every step": "thermo 1\nrun 40\n", "sorting": "atom_modify sort 1 1.5e-3\nrun 40\n",
             "other neighbor skin": "neighbor 0.6e-3 bin\nrun 40\n",
             "processors and a tiled grid": "comm_style tiled\nrun 40\n"}
    for name, lines in parts.items():
        end = run(BLOCK + lines + DUMP.format("end.dump")).dump("end.dump")[-1]
        checks.true("the same bits: " + name, same(end, whole))
    start = run(HEAD + STYLE + "write_data start.data\n").path("start.data")
    from_file = BLOCK.replace(HEAD[HEAD.index("lattice"):], "read_data %s\n" % start)
    whole = run(from_file + "run 40\n" + DUMP.format("end.dump")).dump("end.dump")[-1]
    balanced = run(from_file + "comm_style tiled\nfix even all balance 5 1.0 rcb\nrun 40\n" + DUMP.format("end.dump"),
                   ranks=2)
    end = balanced.dump("end.dump")[-1]
    worst = max(np.abs(end[n] - whole[n]).max() / (np.abs(whole[n]).max() or 1)
                for n in whole if n.startswith(("x", "y", "v", "c_p")))
    checks.below("two ranks with fix balance, deviation", worst, 1e-12)


@test
def values_between_runs():
    r = run(BLOCK + """
thermo_style custom step ke f_body[1] f_body[12] atoms
run 10
velocity all scale 0.0
run 0
velocity all set 3 4 NULL units box
run 0
group gone id 1:32
delete_atoms group gone compress no
run 0
""")
    for k, (name, ke) in enumerate((("velocity 0", 0.0), ("velocity set", 64 * 0.5 * 2.7e-3 * 25),
                                    ("delete_atoms", 32 * 0.5 * 2.7e-3 * 25))):
        t = r.thermo[k + 1]
        checks.near("f_body[1] after " + name, t["f_body[1]"][-1], ke, relative=1e-6, absolute=1e-12)
    checks.below("f_body[12] after delete_atoms, less neighbors", r.thermo[3]["f_body[12]"][-1],
                 0.99 * r.thermo[2]["f_body[12]"][-1])


@test
def atoms_come_and_go():
    r = run(BLOCK + "run 20\n" + DUMP.format("before.dump") + """
group gone id 1:20
delete_atoms group gone compress no
run 0
""" + DUMP.format("less.dump") + """
region more block 9e-3 13e-3 0 4e-3 INF INF units box
create_atoms 2 region more
write_dump all custom new.dump id c_p[*]
run 0
""" + DUMP.format("more.dump") + "run 20\n" + DUMP.format("end.dump"))
    before, less, more, end = (r.dump(n + ".dump")[-1] for n in ("before", "less", "more", "end"))
    kept = before["id"] > 20
    for n in ("x", "c_p[1]", "c_p[2]", "c_p[3]", "c_p[7]"):
        checks.true("delete_atoms keeps the others' " + n, np.array_equal(before[n][kept], less[n]))
    new = more["type"] == 2
    checks.true("create_atoms: new particles", new.sum() == 16 and len(more["id"]) == 60)
    checks.true("create_atoms: they have density, temperature and no strain",
                np.all(more["c_p[1]"][new] == 2700) and np.all(more["c_p[3]"][new] == 310)
                and np.all(more["c_p[2]"][new] == 0))
    order = np.argsort(more["id"][~new])
    checks.true("create_atoms keeps the others", np.array_equal(more["c_p[2]"][~new][order], less["c_p[2]"]))
    checks.true("a run goes on", np.all(np.isfinite(end["x"])) and end["c_p[2]"].max() >= more["c_p[2]"].max())


@test
def groups():
    free = BLOCK.replace("fix body all", "region low block INF INF -1e-3 2e-3 INF INF units box\n"
                         "group held region low\ngroup free subtract all held\nvelocity held set 0 0 0\nfix body free")
    r = run(free + "velocity held set 0 0 0\nrun 20\n" + DUMP.format("a.dump") +
            "group held clear\ngroup free union all\nrun 20\n" + DUMP.format("b.dump"))
    a, b = r.dump("a.dump")[-1], r.dump("b.dump")[-1]
    held = np.arange(64) < 16
    lattice = (np.arange(64) // 8 + 0.5) * 1e-3
    checks.true("particles outside the group stay", np.array_equal(a["y"][held], lattice[held].astype(a["y"].dtype)) or
                np.abs(a["y"][held] - lattice[held]).max() < 1e-18)
    checks.above("but they have a state", np.abs(a["c_p[4]"][held]).max(), 1e5)
    checks.above("a group that grows lets them go", np.abs(b["y"][held] - lattice[held]).max(), 1e-9)
    dyn = run(BLOCK.replace("fix body all",
                            "variable fast atom vx>0\ngroup quick dynamic all var fast every 5\nfix body all")
              + "compute q quick sph/tm/atom pstrain\ncompute qm quick reduce max c_q\n"
                "thermo_style custom step c_qm\nrun 10\n")
    checks.above("compute of a dynamic group", dyn.thermo[-1]["c_qm"][-1], 0.0)


@test
def moved():
    still = run(BLOCK + "run 20\n" + FORCES).dump("f.dump")[-1]
    for name, lines in {"displace_atoms": "displace_atoms all move 1e-3 2e-3 0 units box",
                        "change_box": "change_box all x final -8e-3 20e-3 y final -6e-3 18e-3 units box",
                        "change_box boundary": "change_box all boundary m s p"}.items():
        f = run(BLOCK + "run 20\n" + lines + "\n" + FORCES).dump("f.dump")[-1]
        worst = max(np.abs(f[n] - still[n]).max() / np.abs(still[n]).max() for n in ("fx", "fy"))
        checks.below("forces after " + name, worst, 1e-9)
    tilted = BLOCK.replace("box block", "box prism").replace(BOX + " -5e-4 5e-4", BOX + " -5e-4 5e-4 1e-3 0 0")
    tri = run(tilted + "run 20\n" + FORCES).dump("f.dump")[-1]
    worst = max(np.abs(tri[n] - still[n]).max() / np.abs(still[n]).max() for n in ("fx", "fy"))
    checks.below("forces in a triclinic box", worst, 1e-9)


@test
def types():
    two = HEAD + "region right block 4e-3 INF INF INF INF INF units box\nset region right type 2\n"
    style = STYLE.replace("pair_coeff * *", "pair_coeff 1 1")
    style += "pair_coeff 2 2 density 8960 elastic 124e9 0.34 heat 386 383 0.9\n"
    r = run(two + style + COMPUTE + "run 0\n" + DUMP.format("a.dump")).dump("a.dump")[-1]
    checks.true("set type before the first run",
                set(r["c_p[1]"]) == {2700.0, 8960.0} and np.all((r["type"] == 2) == (r["c_p[1]"] == 8960)))


@test
def temperatures():
    r = run(BLOCK + "group hot id 1:8\nfix_modify body temperature hot 500\nrun 0\n" + DUMP.format("a.dump") +
            "run 10\nfix_modify body temperature hot 400\nrun 0\n" + DUMP.format("b.dump"))
    a, b = r.dump("a.dump")[-1], r.dump("b.dump")[-1]
    checks.true("fix_modify temperature", np.all(a["c_p[3]"][:8] == 500) and np.all(a["c_p[3]"][8:] == 310))
    checks.true("fix_modify temperature between runs",
                np.all(b["c_p[3]"][:8] == 400) and np.all(b["c_p[3]"][8:] >= 310))


@test
def clear_and_again():
    once = run(BLOCK + "run 20\n" + DUMP.format("end.dump")).dump("end.dump")[-1]
    twice = run(BLOCK + "run 7\nclear\n" + BLOCK + "run 20\n" + DUMP.format("end.dump")).dump("end.dump")[-1]
    checks.true("clear and again", same(once, twice))
    other = MOVING.replace("variable vx", "variable ux").replace("variable vy", "variable uy")
    other = other.replace("v_vx v_vy", "v_ux v_uy")
    again = run(BLOCK + "run 7\nunfix body\nuncompute p\n" + other + STYLE.replace("energy yes", "energy yes state new") +
                COMPUTE + "run 0\n" +
                DUMP.format("end.dump")).dump("end.dump")[-1]
    lost = run(BLOCK + "run 7\nfix body all sph/tm courant 0.1\nrun 1\n", expect_error=True)
    checks.true("the fix again: refused", "state of the particles" in lost.errors() and "state new" in lost.errors(),
                lost.errors()[:200])
    checks.true("unfix and fix again: a fresh state", np.all(again["c_p[2]"] == 0) and np.all(again["c_p[1]"] == 2700))
    gone = run(BLOCK + "compute q all sph/tm/atom pressure neighbors surface/area\nrun 5\nunfix body\n"
               "write_dump all custom x.dump id c_q[1]\n", expect_error=True)
    checks.true("compute after unfix", 0 < gone.status < 128 and "fix sph/tm" in gone.errors(),
                "%d %s" % (gone.status, gone.errors()[:200]))
    early = run(BLOCK + "write_dump all custom x.dump id c_p[1]\n", expect_error=True)
    checks.true("compute before a run", 0 < early.status < 128 and early.errors(),
                "%d %s" % (early.status, early.errors()[:200]))
    for what in ("pair", "fix", "compute"):
        unloaded = run(HEAD + "plugin unload %s sph/tm%s\n" % (what, "/atom" if what == "compute" else "") + STYLE
                       + COMPUTE + "run 0\n", expect_error=True)
        checks.true("plugin unload " + what, 0 < unloaded.status < 128 and "Unrecognized" in unloaded.errors(),
                    unloaded.errors()[:200])


@test
def hybrid():
    """Supported: every type has a material of sph/tm; other styles may act as well, or instead between two types."""
    alone = run(BLOCK + "run 20\n" + DUMP.format("end.dump")).dump("end.dump")[-1]
    coeff = "sph/tm density 2700 elastic 70e9 0.33 strength plastic 100e6 1e9 heat 200 900 0.9"
    rest = "fix body all sph/tm temperature 310 energy yes\n" + MOVING + COMPUTE
    r = run(HEAD + "pair_style hybrid/overlay sph/tm hyperbolic 1.2 spacing 1e-3 zero 2e-3\npair_coeff * * %s\n"
            "pair_coeff * * zero\n" % coeff + rest + "run 20\n" + DUMP.format("end.dump"))
    checks.true("pair_style hybrid/overlay", same(r.dump("end.dump")[-1], alone))
    two = HEAD + "region right block 4e-3 INF INF INF INF INF units box\nset region right type 2\n"
    none = run(two + STYLE.replace("fix body", "pair_coeff 1 2 none\nfix body") + MOVING + COMPUTE + "run 20\n" +
               DUMP.format("end.dump")).dump("end.dump")[-1]
    mixed = "pair_style hybrid sph/tm hyperbolic 1.2 spacing 1e-3 zero 2e-3\npair_coeff 1 1 %s\n" % coeff
    r = run(two + mixed + "pair_coeff 2 2 %s\npair_coeff 1 2 zero\n" % coeff + rest + "run 20\n"
            + DUMP.format("end.dump"))
    checks.true("pair_style hybrid between two types", same(r.dump("end.dump")[-1], none))
    r = run(HEAD + mixed + "pair_coeff * 2 zero\nmass 2 1\n" + rest + "run 0\n", expect_error=True)
    checks.true("pair_style hybrid with a type that has no material",
                0 < r.status < 128 and "pair_coeff 2 2 sph/tm" in r.errors(), r.errors()[:300])


@test
def surface_area():
    r = run(BLOCK + "compute q all sph/tm/atom surface/area neighbors\ncompute s all reduce sum c_q[1]\n"
            "thermo_style custom step c_s\nrun 0\nwrite_dump all custom a.dump id c_q[*]\n"
            "create_atoms 2 single 12e-3 12e-3 0 units box\n"
            "write_dump all custom b.dump id c_q[*]\n")
    checks.true("compute surface/area turns its effect on", re.search(r"surface +on .*compute q", r.output))
    checks.near("the area of a square plate", r.thermo[-1]["c_s"][-1], 32e-3, relative=0.15)    # corners count less
    checks.true("a new particle has none yet", r.dump("b.dump")[-1]["c_q[1]"][-1] == 0)


@test
def memory():
    big = lattice_block("0 100e-3 0 100e-3", "-5e-3 105e-3 -5e-3 105e-3", types=2, more="atom_modify     map array\n")
    elastic = "pair_coeff * * density 2700 elastic 70e9 0.33"
    plain = " correction no hourglass 0"
    cases = {"elastic": (plain, elastic), "plastic": (plain, elastic + " strength plastic 1e8 1e9"),
             "plastic, with heat": (plain, elastic + " strength plastic 1e8 1e9 heat 200 900 0.9"),
             "plastic, with heat and correction": (" correction yes hourglass 0",
                                                   elastic + " strength plastic 1e8 1e9 heat 200 900 0.9")}
    columns = {"elastic": 0, "plastic": 3, "plastic, with heat": 3 + 2 + 1, "plastic, with heat and correction": 9 * 2}
    last = None
    for name, (style, coeff) in cases.items():
        r = run(big + "pair_style sph/tm hyperbolic 1.2 spacing 1e-3%s\n%s\n" % (style, coeff) +
                "fix body all sph/tm\nrun 0\n")
        used = float(re.search(r"memory allocation.*= ([\d.]+)", r.output).group(1))
        if last is not None:
            checks.above("memory: " + name, used - last, 0.9 * columns[name] * 1e4 * 8 / 1024 ** 2)
        last = used


for t in TESTS:
    if len(sys.argv) < 2 or any(w in t.__name__ for w in sys.argv[1:]):
        t()
checks.end()
