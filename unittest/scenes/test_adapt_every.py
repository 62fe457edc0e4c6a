"""fix adapt/neigh threshold 0: rows of its own cell search in every step, or with a margin where particles
have moved. The same bits as LAMMPS's list rebuilt in every step and as its skin list, on 1, 2 and 4 ranks, bodies that conduct
and touch, periodic boundaries; and its errors."""
import numpy as np
from contact_scene import block, particles
from sphtm_scene import Checks, run

DX = 1e-3
SCRIPT = """
units si
dimension {dim}
boundary {boundary}
atom_style atomic
newton off
processors {grid}
read_data data.two
pair_style sph/tm {style} spacing 1e-3
neighbor 3e-4 bin
neigh_modify every 1 delay 0 check {check}
pair_coeff 1 1 {material}
pair_coeff 2 2 {material}
{meet}
fix body all sph/tm temperature 300
{lists}
compute p all sph/tm/atom density pressure vonmises pstrain temperature neighbors
thermo 20
run {steps}
dump d all custom 1 out.dump id type x y z vx vy vz fx fy fz c_p[*]
dump_modify d sort id format float %.17g
run 0 post no
"""
STEEL = ("density 7850 elastic 200e9 0.29 strength johnson/cook 350e6 275e6 0.36 0.022 1.0 293 1793 1.0 "
         "heat 40 480 0.9")
CASES = {
    "3D": dict(dim=3, style="hyperbolic 1.2", boundary="f f f", meet="", material=STEEL, steps=50),
    "2D, friction and heat": dict(dim=2, style="quintic 1.1", boundary="f f p", steps=100, material=STEEL,
                                  meet="pair_coeff 1 2 contact friction 0.3 conductance 1e5"),
    "2D, periodic": dict(dim=2, style="wendland/c4 1.7", boundary="p p p", meet="", material=STEEL, steps=60),
}
MARGIN = dict(check="yes", lists="fix lists all adapt/neigh threshold 0 margin 0.2")
EVERY, OWN = dict(check="no", lists=""), dict(check="yes", lists="fix lists all adapt/neigh threshold 0")


def bars(c):
    """Two lattices with some noise that run into each other, numbered in no order of space."""
    draw = np.random.default_rng(3)
    dim = c["dim"]
    x = block((18, 12, 5 if dim == 3 else 1), DX, (0, 0, 0 if dim == 3 else -0.5 * DX))
    types = np.where(x[:, 0] < 9 * DX, 1, 2)
    v = np.where(types[:, None] == 1, [150.0, 20, 0], [-150.0, 0, 0])
    x[:, :dim] += draw.uniform(-0.04, 0.04, (len(x), dim)) * DX
    order = draw.permutation(len(x))
    box = [(-6 * DX, 26 * DX), (-6 * DX, 18 * DX), (-3 * DX, 8 * DX) if dim == 3 else (-0.5 * DX, 0.5 * DX)]
    if "p p" in c["boundary"]:
        box[0] = (0, 18 * DX)
        box[1] = (0, 12 * DX)
    return particles(x[order], box, v[order], types[order])


def last(case, how, ranks=1, grid="* * 1"):
    c = dict(CASES[case], **how)
    r = run(SCRIPT.format(grid=grid, **c), ranks=ranks, files={"data.two": bars(c)})
    with open(r.path("out.dump")) as f:
        return f.read().split("ITEM: ATOMS", 1)[1].splitlines()[1:]


def main():
    checks = Checks()
    for case in CASES:
        every = last(case, EVERY)
        values = np.array([line.split() for line in every], float)
        checks.true(case + ": finite", np.isfinite(values).all(), "%d particles" % len(every))
        checks.above(case + ": it yields", values[:, 14].max(), 1e-4)
        checks.true(case + ": same bits", last(case, OWN) == every)
        checks.true(case + ": same bits on 2 ranks", last(case, OWN, 2, "2 1 1") == every)
        checks.true(case + ": rows with a margin, same bits", last(case, MARGIN) == every)
        checks.true(case + ": rows with a margin, same bits on 2 ranks", last(case, MARGIN, 2, "2 1 1") == every)
    checks.true("3D: same bits on 4 ranks", last("3D", OWN, 4, "2 2 1") == last("3D", EVERY))

    def error(words):
        c = dict(CASES["3D"], check="yes", lists="fix lists all adapt/neigh " + words, steps=2)
        return run(SCRIPT.format(grid="* * *", **c), files={"data.two": bars(c)}, expect_error=True).errors()

    for words, parts in {"threshold": ("threshold", "1 value"), "threshold -1": ("threshold", "-1"),
                         "threshold 0 rows 0": ("rows", "0"), "threshold nan": ("threshold", "nan"),
                         "threshold 0 margin 1.5": ("margin", "1.5"),
                         "threshold 0 rows 16": ("row has room for 16", "rows"),
                         "thresh 0": ("thresh", "known are", "threshold")}.items():
        said = error(words)
        checks.true("error: " + words, said and all(p in said for p in parts), said)
    checks.end()


if __name__ == "__main__":
    main()
