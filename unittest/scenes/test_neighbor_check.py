"""LAMMPS's look whether particles have moved is left out where none can have (src/HOST/neighbor_check.h): lists are renewed in
the same steps as with it, and results have the same bits. A fix that fix sph/tm does not know of leaves LAMMPS to look."""
import re

from sphtm_scene import Checks, lattice_block, run

BLOCK = lattice_block("0 20e-3 0 10e-3", "-30e-3 90e-3 -20e-3 30e-3") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 2700 elastic 70e9 0.33 strength plastic 200e6 1e9
region          left block INF 10e-3 INF INF INF INF units box
group           left region left
velocity        left set 200 0 0 units box
fix             body all sph/tm
{more}
thermo_style    custom step dt ke
thermo          100
run             300
{after}
write_dump      all custom end.dump id x y vx vy modify sort id format float %.17g
"""
LOOKS = "fix unknown all momentum 100000 angular"    # acts in no step of the run
checks = Checks()


def state(r):
    with open(r.path("end.dump")) as f:
        return f.read(), [int(n) for n in re.findall(r"Neighbor list builds = (\d+)", r.output)], \
            [int(n) for n in re.findall(r"Dangerous builds = (\d+)", r.output)]


def same(label, more="", after="", ranks=1, least=2):
    left_out, looked = (state(run(BLOCK.format(more=more + "\n" + m, after=after), ranks=ranks)) for m in ("", LOOKS))
    checks.true(label + ": lists are renewed as often", left_out[1] == looked[1] and sum(looked[1]) >= least, "%s %s" % (left_out[1], looked[1]))
    checks.true(label + ": the same bits", left_out[0] == looked[0])
    checks.true(label + ": none too late", not any(left_out[2]), str(left_out[2]))


same("two halves that collide")
same("two ranks", ranks=2)
same("a second run without set-up, faster", after="run 1 pre no\nvelocity all set 900 0 0 sum yes units box\nrun 200 pre no")
same("a wider skin, every second step", more="neighbor 0.6e-3 bin\nneigh_modify every 2 delay 4", least=1)
same("a constant time step", more="unfix body\nfix body all sph/tm dt 3e-8")
same("xsph", more="pair_style sph/tm hyperbolic 1.2 spacing 1e-3 xsph 0.1\n"
     "pair_coeff 1 1 density 2700 elastic 70e9 0.33 strength plastic 200e6 1e9")
checks.end()
