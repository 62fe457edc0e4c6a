"""What comes, goes or moves between runs, and what is asked for there: taken into account, or refused in words."""
import os

import numpy as np
from sphtm_scene import SOURCE, Checks, lattice_block, run

TOOL = os.path.join(SOURCE, "unittest", "harness", "yaml", "tool.stl")
HEAD = lattice_block("0 8e-3 0 8e-3", "-5e-3 17e-3 -5e-3 17e-3", types=2, more="atom_modify     map array\n")
BODY = """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      * * density 2700 elastic 70e9 0.33 strength plastic 100e6 1e9 heat 200 900 0.9
fix             body all sph/tm temperature 310 energy yes
compute         p all sph/tm/atom density pstrain temperature
thermo          10
"""
MOVING = "variable vx atom 100*sin(400*y)\nvelocity all set v_vx 0 0 units box\n"
SCENE = HEAD + BODY + MOVING
checks = Checks()


def refused(name, lines, *fragments, **options):
    r = run(SCENE + lines, expect_error=True, **options)
    missing = [f for f in fragments if f not in r.errors()]
    checks.true(name, 0 < r.status < 128 and r.errors() and not missing,
                "status %d, not said: %s <- %s" % (r.status, missing, r.errors()[:300]) if missing or r.status < 1 else "")


def goes(name, lines, warned=None, **options):
    r = run(SCENE + lines, expect_error=True, **options)
    said = [w for w in r.warnings() if warned is None or warned in w]
    checks.true(name, r.status == 0 and (len(said) > 0) == (warned is not None), "%d %s %s" %
                (r.status, r.errors()[:300], r.warnings()))
    return r


# --- particles that come
SINGLE = "run 10\ncreate_atoms 1 single %s 0 units box\nrun 10\n"
OTHER = "run 10\nlattice sq 1e-3 origin 0.5 %s 0\nregion other block %s INF INF units box\ncreate_atoms %d region other\nrun 10\n"
for ranks in 1, 2:
    refused("a particle in the place of another, %d ranks" % ranks, SINGLE % "2.5e-3 2.5e-3", "of the spacing apart",
            "delete_atoms overlap", ranks=ranks)
    refused("a body half a spacing from another, %d ranks" % ranks, OTHER % ("0", "0 8e-3 8e-3 12e-3", 1),
            "too close together", ranks=ranks)
refused("a lattice half as wide", "run 10\nlattice sq 0.5e-3 origin 0.5 0.5 0\nregion other block 10e-3 13e-3 0 3e-3 INF INF "
        "units box\ncreate_atoms 2 region other\nrun 10\n", "times the mass around it")
goes("a body one spacing from another", OTHER % ("0.5", "0 8e-3 8e-3 12e-3", 1))
goes("a body that is read", "write_data more.data nocoeff\ndelete_atoms group all compress no\n"
     "read_data more.data add append\nrun 10\nread_data more.data add append shift 0 8e-3 0\nrun 10\n", "image flags")

# --- a tool that comes
NEW = "run 10\nfix new all contact/tri file %s scale 1e-3 move 20e-3 0 0\nrun 10%%s\n" % TOOL
goes("a tool that is made before 'run pre no'", NEW % " pre no", "goes on without it")
refused("a tool that is made inside of the body before a run", NEW.replace("20e-3", "4e-3") % "", "overlaps particles")

# --- particles that go or move
goes("delete_atoms", "run 10\ngroup some id 1:8\ndelete_atoms group some compress no\nrun 10\n")
goes("displace_atoms, all", "run 10\ndisplace_atoms all move 1e-3 0 0 units box\nrun 10\n")
PART = "run 10\nregion right block 4e-3 INF INF INF INF INF units box\ngroup right region right\n"
refused("displace_atoms, one half into the other", PART + "displace_atoms right move -0.5e-3 0 0 units box\nrun 10\n",
        "moved against each other")
refused("change_box with remap", "run 10\nchange_box all x scale 0.5 remap\nrun 10\n", "moved against each other")
for axis in "x", "y":    # a strain that hardly shows in the distance of the nearest
    goes("change_box with remap by 4 % along " + axis, "run 10\nchange_box all %s scale 1.04 remap\nrun 10\n" % axis,
         "moved against each other")
goes("displace_atoms ramp: a shear", "run 10\ndisplace_atoms all ramp y 0 1e-3 x 2e-3 8e-3 units box\nrun 10\n", "moved against each other")
goes("displace_atoms of a half along its face", PART + "displace_atoms right move 0 0.3e-3 0 units box\nrun 10\n", "moved against each other")
for ranks in 1, 2:
    goes("displace_atoms rotate, all, %d ranks" % ranks, "run 10\ndisplace_atoms all rotate 4e-3 4e-3 0 0 0 1 30 units box\nrun 10\n", "were turned", ranks=ranks)
goes("displace_atoms rotate before the first run", "displace_atoms all rotate 4e-3 4e-3 0 0 0 1 30 units box\nrun 10\nrun 10\n")
goes("turned and back", "run 10\ndisplace_atoms all rotate 4e-3 4e-3 0 0 0 1 30 units box\n"
     "displace_atoms all rotate 4e-3 4e-3 0 0 0 1 -30 units box\nrun 10\n")
for factor in "0.75", "1.5":
    refused("displace_atoms that strains by " + factor, "run 10\nvariable d atom (%s-1)*x\ndisplace_atoms all move v_d 0 0 "
            "units box\nrun 10\n" % factor, "moved against each other", "know nothing of it")
refused("another mass", "run 10\nmass 1 1e-5\nrun 10\n", "mass of the particles changed")
refused("another density", "run 10\npair_coeff 1 1 density 5000 elastic 70e9 0.33\nrun 10\n", "density of type 1",
        "2700 to 5000")
goes("other elastic moduli", "run 10\npair_coeff 1 1 density 2700 elastic 35e9 0.33 strength plastic 100e6 1e9 heat 200 900 0.9\nrun 10\n",
     "elastic moduli")
refused("another spacing", "run 10\npair_style sph/tm hyperbolic 1.2 spacing 0.5e-3\nrun 10\n", "spacing changed",
        "after a run")
goes("fix deform", "fix d all deform 1 x erate 1e-3\nrun 10\n", "changes the box")
refused("a particle set onto another", "run 10\nset atom 5 x 0.5e-3 y 0.5e-3\nrun 10\n", "apart", "delete_atoms overlap")
refused("particles moved into a tool", "fix tool all contact/tri file %s scale 1e-3 move 4e-3 9.2e-3 0\nrun 10\n"
        "displace_atoms all move 0 1.5e-3 0 units box\nrun 10\n" % TOOL, "overlaps particles")
refused("a velocity that is no number", "run 10\nvariable n atom exp(1000)\nvelocity all set v_n NULL NULL\nrun 10\n",
        "velocity", "not a finite number")
refused("another type", PART + "set group right type 2\nrun 10\n", "became type 2", "another material")
refused("another type of a particle on two ranks", "run 10\nset atom 5 type 2\nrun 10\n", "1 particles became type 2", ranks=2)

# --- the fix
AGAIN = "fix body all sph/tm temperature 310 courant 0.2\nrun 10\n"
refused("the fix again after a run", "run 10\n" + AGAIN, "state of the particles", "fix_modify", "state new")
refused("the fix removed and written after a run", "run 10\nunfix body\n" + AGAIN, "state of the particles", "state new")
goes("the fix again before a run", AGAIN)
goes("the fix again after run 0", "run 0\n" + AGAIN)
fresh = goes("state new", "run 10\nfix body all sph/tm temperature 310 state new\nrun 0\n"
             "write_dump all custom new.dump id c_p[2]\n")
checks.true("state new: no strain", fresh.status == 0 and np.all(fresh.dump("new.dump")[-1]["c_p[2]"] == 0))
t = goes("fix_modify courant", "run 10\nfix_modify body courant 0.1\nrun 10\n").thermo
r = run(SCENE + "thermo_style custom step dt\nrun 10\nfix_modify body courant 0.1\nrun 10\n").thermo
checks.near("fix_modify courant: the step", r[1]["Dt"][-1], 0.25 * r[0]["Dt"][-1], relative=0.02)
refused("fix_modify of something else", "fix_modify body colour 1\nrun 10\n", "fix_modify")
refused("fix_modify with a wrong value", "fix_modify body courant 2\nrun 10\n", "Fix_modify of fix sph/tm", "courant", "2")

# --- rerun, data files
refused("rerun", "dump d all custom 10 all.dump id type x y vx vy\nrun 20\nrerun all.dump dump x y vx vy\n",
        "does not work with rerun", "state")
goes("write_data before the first run", "write_data a.data nocoeff\nrun 10\n")
TYPES = "set atom 1*32 type 1\nset atom 33*64 type 2\ngroup one type 1\ngroup two type 2\nrun 10\n"
refused("types that change places", TYPES + "set group one type 2\nset group two type 1\nrun 10\n", "became type", "belongs to another material")
refused("a type that gains particles", TYPES + "set group one type 2\nrun 10\n", "32 particles became type 2")
goes("types as they were, in other words", TYPES + "set group one type 1\nset group two type 2\nrun 10\n")
goes("other tags", TYPES + "reset_atoms id\nrun 10\n")
r = goes("write_data after a run", "run 10\nwrite_data a.data nocoeff\nwrite_data b.data nocoeff\nrun 10\n",
         "write_restart writes all")
checks.true("write_data warns once", len(r.warnings()) == 1)
r = run(SCENE + "run 20\nwrite_data a.data nocoeff\nclear\n" + HEAD[:HEAD.index("lattice")] + "read_data a.data\n" + BODY + "run 10\n")
checks.true("a scene from a data file says how it starts",
            r.output.count("64 particles begin without stress and strain, at 310 K") == 2)

# --- temperatures that are set before a restart file is written, or between runs
for more, due in ((" expansion 1.2e-5", True), ("", False)):    # elastic: heat, and so expansion, is off until now
    r = run(HEAD + BODY.replace("strength plastic 100e6 1e9 heat 200 900 0.9", "heat 200 900 0.9" + more) +
            "run 10\ngroup low id 1:20\nfix_modify body temperature low 500\nrun 10\n")
    said = any("makes no thermal strain" in x for x in r.warnings())
    checks.true("an elastic body%s whose temperature is set is %swarned of" % (more, "" if due else "not "), said == due, str(r.warnings()))
GIVEN = "group low id 1:20\nfix_modify body temperature low 500\n"
TOLD = "compute T all reduce max c_p[3]\nthermo_style custom step c_T\nrun 10\n"
for name, lines in ("before the first run", ""), ("between runs", "run 10\n"):
    r = run(SCENE + lines + GIVEN + "write_restart given.restart\n" + TOLD)
    again = run("\n".join(HEAD.split("\n")[:0]) + "read_restart given.restart\n" + "\n".join(BODY.split("\n")[3:]) + TOLD, folder=r.folder)
    hottest = [t.thermo[-1]["c_T"] for t in (r, again)]
    checks.near("set %s, kept by a restart file: at the start" % name, hottest[1][0], 500.0, relative=1e-9)
    checks.near("set %s, kept by a restart file: after 10 steps" % name, hottest[1][-1], hottest[0][-1], relative=1e-12)
    later = run("read_restart given.restart\n" + "\n".join(BODY.split("\n")[3:]) + "fix_modify body temperature low 400\n" + TOLD, folder=r.folder)
    checks.near("set %s, and again behind it: the last counts" % name, later.thermo[-1]["c_T"][0], 400.0, relative=1e-9)

# --- a fix that sets velocities, with an energy balance
refused("fix momentum", "velocity all set 300 0 0 sum yes\nfix still all momentum 10 linear 1 1 0\nrun 2000\n", "fix still momentum, which sets velocities",
        "energy yes")

# --- values between runs
for name, lines in {"before a run": "", "after unfix": "run 10\nunfix body\n", "after pair_style none": "run 10\npair_style none\n",
                    "after plugin unload pair": "run 10\nplugin unload pair sph/tm\n",
                    "after plugin unload fix": "run 10\nplugin unload fix sph/tm\n",
                    "after pair_style again": "run 10\npair_style none\n" + "\n".join(BODY.split("\n")[:3]) + "\n"}.items():
    for value in "f_body", "f_body[1]", "f_body[12]":
        r = run(SCENE + lines + 'print "$(%s)"\n' % value, expect_error=True)
        checks.true("%s %s" % (value, name), 0 < r.status < 128 and r.errors(), "%d %s" % (r.status, r.errors()[:200]))
    r = run(SCENE + lines + "info memory\nwrite_restart any.restart\n", expect_error=True)
    checks.true("info memory " + name, r.status < 128 and r.status >= 0, "%d %s" % (r.status, r.output[-200:]))
r = goes("a variable of the fix in a run", "variable e equal f_body[1]\nthermo_style custom step v_e\nrun 10\n")

# --- ranks without particles, bodies that only conduct, no particles: nothing falls there
SIDE = HEAD.replace("-5e-3 17e-3 -5e-3 17e-3", "-5e-3 90e-3 -5e-3 17e-3") + BODY
for ranks in 1, 2:
    r = run(SIDE + "set group all type 2\nset atom 1*32 type 1\npair_coeff 1 2 contact penalty 30\nrun 10\n",
            ranks=ranks, expect_error=True, timeout=60)
    checks.true("an empty rank where contact limits the step, %d ranks" % ranks, r.status == 0 and "contact stiffness" in
                r.output, r.errors()[:200])
CONDUCTS = HEAD.replace("-5e-3 17e-3 -5e-3 17e-3", "-1 1 -1 1") + BODY.replace("density 2700 elastic 70e9 0.33 strength plastic 100e6 1e9", "density 2700 body heat")
r = run(CONDUCTS + "fix d all sph/tm/drive 20 0 0\nrun 20\n", expect_error=True)
checks.true("a conductor that moves", r.status == 0 and not r.warnings(), r.errors()[:200])
checks.end()
