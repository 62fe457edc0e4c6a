"""LAMMPS's commands between two runs with fix adapt/neigh: particles that are deleted, made, moved or get other IDs.
Rows that are kept give what lists of every step give, on one rank and on two, and a warning says where they are
searched anew."""
from sphtm_scene import Checks, lattice_block, run

HEAD = lattice_block("0 8e-3 0 8e-3", "-5e-3 25e-3 -5e-3 15e-3") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 hourglass 0 correction no
pair_coeff      1 1 density 2700 elastic 70e9 0.33 strength plastic 300e6 1e9
region          corner block 0 2e-3 0 2e-3 INF INF units box
region          right block 5e-3 10e-3 INF INF INF INF units box
group           right region right
group           corner region corner
fix             body all sph/tm
fix             ad all adapt/neigh %s
velocity        all set 20 0 0
velocity        right set -20 0 0
thermo          4
thermo_style    custom step atoms pe ke
"""
REFINE = "refine square epsilon 0.4 alpha 0.6 when region corner every 5 coarsen when region right"
MORE = """more

9 atoms
1 atom types
-5e-3 25e-3 xlo xhi
-5e-3 15e-3 ylo yhi
-5e-4 5e-4 zlo zhi

Atoms # atomic

""" + "".join("%d 1 %g %g 0\n" % (k + 1, 12.5e-3 + 1e-3 * (k % 3), 0.5e-3 + 1e-3 * (k // 3)) for k in range(9))
NEW = "region new block 12e-3 15e-3 0 3e-3 INF INF units box\ncreate_atoms 1 region new"
# commands, and what the warning of kept rows says
BETWEEN = {
    "nothing": ("", ""),
    "delete_atoms": ("delete_atoms group corner", "other IDs"),
    "delete_atoms compress no": ("delete_atoms group corner compress no", ""),
    "reset_atoms id": ("delete_atoms group right compress no\nreset_atoms id", "other IDs"),
    "displace_atoms": ("displace_atoms corner move -1.01e-3 0 0 units box", "other places"),
    "displace_atoms, then a restart file": ("displace_atoms all rotate 4e-3 4e-3 0 0 0 1 30 units box\n"
                                            "write_restart any.restart", "other places"),
    "both": ("displace_atoms corner move -1.01e-3 0 0 units box\nreset_atoms id\ndelete_atoms group right\n"
             "balance 1.0 shift xy 5 1.0", "places and IDs"),
    "create_atoms": (NEW, ""),
    "read_data add": ("read_data more.data add append", ""),
    "change_box": ("change_box all x final -8e-3 30e-3 units box", ""),
    "set": ("set group corner vx 5", ""),
    "balance": ("balance 1.0 shift xy 5 1.0", ""),
    "all are deleted": ("delete_atoms group all", "")}
checks = Checks()


def ends(adapt, commands, ranks):
    r = run(HEAD % adapt + "run 12\n" + commands + "\nrun 12\nrun 3\n", files={"more.data": MORE}, ranks=ranks)
    return r, r.thermo[1]


for what, (commands, said) in BETWEEN.items():
    plain = ends("threshold 0", commands, 1)[1]
    for adapt in "threshold 1e-5", "threshold inf":
        for ranks in (1, 2) if "1e-5" in adapt else (1,):
            name = "%s, %s, %d rank%s" % (what, adapt, ranks, "s" * (ranks - 1))
            result, kept = ends(adapt, commands, ranks)
            warnings = "\n".join(w for w in result.warnings() if "updated-Lagrangian at first" in w)
            checks.say(said in warnings if said else not warnings, name + ": warning", warnings)
            checks.near(name + ": particles", kept["Atoms"][-1], plain["Atoms"][-1])
            # hourglass control would tell them apart: threshold inf is without
            checks.near(name + ": kinetic energy", kept["KinEng"][-1], plain["KinEng"][-1], 0.02)

# families go by IDs, levels are the fix's own
for what, commands, said in (("reset_atoms id", "reset_atoms id", "not merged any more"),
                             ("another refine", "unfix ad\nfix ad all adapt/neigh " + REFINE, "may be split again"),
                             ("nothing", "write_restart any.restart", "")):
    warnings = "\n".join(w for w in ends(REFINE, commands, 2)[0].warnings() if "split" in w)
    checks.say(said in warnings if said else not warnings, "refine, then %s: warning" % what, warnings)
checks.end()
