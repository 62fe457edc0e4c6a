"""The same scene on 1, 2 and 4 ranks gives the same bits: rows are sorted by tag and sums do not depend on
where a particle sits. Also with another skin, without sorting in memory, and with the rates of those without ghosts for neighbors
before the exchange. Two bars hit each other."""
import numpy as np
from contact_scene import block, particles
from sphtm_scene import Checks, run

SCRIPT = """
units si
dimension {dim}
boundary f f {bz}
atom_style atomic
atom_modify map array sort {sort}
newton off
processors {grid}
read_data data.bars
pair_style sph/tm {style} spacing 1e-3 {keywords}
neighbor {skin} bin
neigh_modify every 1 delay 0 check yes
pair_coeff 1 1 {material}
pair_coeff 2 2 {material}
fix body all sph/tm temperature 300
compute p all sph/tm/atom {values}
thermo 20
thermo_style custom step time dt
run {steps}
dump d all custom 1 out.dump id type x y z vx vy vz fx fy fz c_p[*]
dump_modify d sort id format float %.17g
run 0 post no
"""

DX = 1e-3
STEEL = ("density 7850 elastic 200e9 0.29 strength johnson/cook 350e6 275e6 0.36 0.022 1.0 293 1793 1.0 "
         "heat 40 480 0.9")
PLASTIC = "density 2700 elastic 70e9 0.33 strength plastic 100e6 1e9"
CASES = {
    "3D plastic": dict(dim=3, style="hyperbolic 1.2", keywords="", material=PLASTIC, steps=60),
    "2D thermo-mechanical": dict(dim=2, style="cubic 1.3", keywords="xsph 0.2", material=STEEL, steps=120),
    "3D artificial stress": dict(dim=3, style="wendland/c2 1.4", keywords="stabilize artstress correction yes balsara yes",
                                 material=STEEL, steps=40),
}


def bars(dim):
    """Data file: lattices with some noise, numbered in no order of space."""
    draw = np.random.default_rng(7)
    x = block((18, 12, 6 if dim == 3 else 1), DX, (0, 0, 0 if dim == 3 else -0.5 * DX))
    types = np.where(x[:, 0] < 9 * DX, 1, 2)
    v = np.zeros_like(x)
    v[types == 1] = 150, 20, 0
    v[types == 2] = -150, 0, 0
    x[:, :dim] += draw.uniform(-0.04, 0.04, (len(x), dim)) * DX
    order = draw.permutation(len(x))
    box = [(-6 * DX, 26 * DX), (-6 * DX, 18 * DX), (-3 * DX, 9 * DX) if dim == 3 else (-0.5 * DX, 0.5 * DX)]
    return particles(x[order], box, v[order], types[order])


def run_case(case, ranks=1, grid="* * 1", skin="3e-4", sort="1000 0.0", **environment):
    c = CASES[case]
    script = SCRIPT.format(grid=grid, skin=skin, sort=sort, bz="f" if c["dim"] == 3 else "p",
                           values="density pressure vonmises stress/xx stress/xy pstrain" +
                                  (" temperature" if "heat" in c["material"] else ""), **c)
    return run(script, ranks=ranks, files={"data.bars": bars(c["dim"])},
               environment=environment)


def state(result):
    """The lines of the dump, as text: the comparison is of every digit."""
    with open(result.path("out.dump")) as f:
        lines = f.read().split("ITEM: ATOMS", 1)[1].splitlines()
    return lines[1:]


checks = Checks()
for case in CASES:
    one = state(run_case(case))
    values = np.array([line.split() for line in one], float)
    checks.true(case + ": finite", np.isfinite(values).all(), "%d particles" % len(one))
    checks.above(case + ": it yields", values[:, 16].max(), 1e-4)
    variants = [("2 ranks", 2, dict(grid="2 1 1")), ("2 ranks in y", 2, dict(grid="1 2 1")),
                ("4 ranks", 4, dict(grid="2 2 1")),
                ("another skin", 1, dict(skin="8e-4")), ("no sorting in memory", 1, dict(sort="0 0.0")),
                ("4 ranks, another skin", 4, dict(grid="4 1 1", skin="5e-4")),
                ("2 ranks, the interior first", 2, dict(grid="2 1 1", SPHTM_OVERLAP="1"))]
    for name, ranks, change in variants:
        other = state(run_case(case, ranks, **change))
        different = sum(a != b for a, b in zip(one, other)) + abs(len(one) - len(other))
        checks.true(case + ", " + name, different == 0, "%d of %d particles differ" % (different, len(one)))
for isa in "default", "avx2":    # what the processor lacks falls back to less
    one, other = (state(run_case("3D plastic", ranks, grid, SPHTM_ISA=isa)) for ranks, grid in ((1, "1 1 1"), (4, "2 2 1")))
    checks.true("instruction set %s, 4 ranks" % isa, one == other, "%d particles" % len(one))
checks.end()
