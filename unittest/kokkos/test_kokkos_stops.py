"""What stops a run says the same with Kokkos: a state that is no number, too fast, a lost particle, a negative
temperature, overlapping particles at the start, and wrong names."""
import re

from kokkos_scene import Checks, run_way

BASE = """
units si
dimension 2
boundary f f p
atom_style atomic
newton off
lattice sq 1e-3 origin 0.5 0.5 0
region box block {box} -0.5e-3 0.5e-3 units box
create_box 1 box
region work block 0 8e-3 0 8e-3 INF INF units box
create_atoms 1 region work
{more}
pair_style sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff 1 1 density 2700 elastic 70e9 0.33 strength johnson/cook 428e6 327e6 1.008 0.01 1.31 293 855 1.0 &
  heat 200 900 0.9
fix body all sph/tm
group one id 30
thermo 10
run 20
{lines}
run 80
"""
SMALL, LARGE = "-5e-3 13e-3 -5e-3 13e-3", "-1 1 -1 1"
CASES = {
    "infinite force": dict(lines="variable f equal exp(800*(step>25))\nfix push one addforce v_f 0 0"),
    "runaway": dict(lines="fix push one addforce 1e10 0 0"),
    "velocity set too high": dict(lines="velocity one set 1e6 0 0 units box"),
    "leaves the box": dict(box=SMALL, lines="group last id 32\nvelocity last set 8000 0 0 units box"),
    "heat taken out": dict(lines="fix sink one sph/tm/heat source -1e20"),
    "overlap at the start": dict(more="create_atoms 1 single 2.5e-3 2.5e-3 0 units box"),
}
checks = Checks()


def message(way, script):
    result = run_way(way, script, expect_error=True)
    text = " ".join(result.errors().split())
    return result.status, re.sub(r" \(\S*\.cpp:\d+\)", "", text)


for name, case in CASES.items():
    script = BASE.format(**dict(dict(box=LARGE, more="", lines=""), **case))
    for way, reference in ("threads", "plain"), ("device", "plain default"):
        one, two = message(way, script), message(reference, script)
        checks.true("%s: %s" % (name, way), one == two and one[0] != 0, "" if one == two else "%s\n   %s" % (one, two))

BOX = "units si\ndimension 2\nregion box block 0 1 0 1 -1 1\ncreate_box 1 box\n"
for line in "pair_style sph/tm/kk hyper", "fix tool all contact/tri/kk file x.stl", "compute p all sph/tm/atom/kk nonsense":
    errors = run_way("serial", BOX + line + "\n", expect_error=True).errors()
    checks.true("known with Kokkos: " + line, errors and "Unrecognized" not in errors, errors[:200])
checks.end()
