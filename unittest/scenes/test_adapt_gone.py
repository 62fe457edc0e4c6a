"""Particles that go for good while others keep them as neighbors, fix adapt/neigh with threshold inf.

block    an elastic block flies through an open wall: column by column goes, those left fly on as if nothing had been.
         The warning counts the pairs, which the lattice tells
wheel    a turning, stretched body scrapes along the wall: forces of those left have no sum, 1 and 2 ranks give the same
         bits, and a restart in between does; with corrected gradients too
delete   delete_atoms between two runs needs no leave of thermo_modify
stops    a particle that is still there but beyond the ghosts, and one that is gone and may not
"""
import re

import numpy as np
from contact_scene import block, particles
from sphtm_scene import PLANE, Checks, run

DX = 1e-3
SCENE = PLANE + """processors * 1 1
read_data data.in
pair_style sph/tm hyperbolic 1.2 spacing 1e-3 correction {correction}
pair_coeff 1 1 density 2700 elastic 70e9 0.33
neighbor {skin} bin
neigh_modify {lists}
{velocity}
fix body all sph/tm lost ignore
fix lists all adapt/neigh threshold inf
thermo 1000
thermo_modify lost {lost}
{steps}
write_dump all custom end.dump id x y vx vy fx fy modify sort id format float %.17g
"""
FAST = "velocity all set 500 0 0 units box"
TURN = """variable vx atom 300+1e4*(x-10e-3)-4e4*(y-4e-3)
variable vy atom 4e4*(x-10e-3)
velocity all set v_vx v_vy 0 units box"""
DEFAULTS = dict(skin="3e-4", velocity=FAST, lost="ignore", steps="run 400", correction="no",
                lists="every 1 delay 0 check yes")
checks = Checks()


def scene(ranks=1, expect_error=False, half=None, box=(-2e-3, 21.2e-3), **more):
    text = SCENE.format(**dict(DEFAULTS, **more))
    if half:    # the run of which this is the second half
        text = "read_restart half.restart\n" + text[text.index("neighbor "):]
    data = particles(block((20, 8, 1), DX, (0, 0, -0.5 * DX)), (box, (-0.05, 0.05), (-0.5 * DX, 0.5 * DX)))
    return run(text, ranks=ranks, folder=half.folder if half else None, files={"data.in": data}, expect_error=expect_error)


def counted(result):
    found = re.findall(r"(\d+) total-Lagrangian pairs were dropped", result.output)
    return [int(n) for n in found]


def bits(result):
    with open(result.path("end.dump")) as f:
        return f.read().split("ITEM: ATOMS")[1].splitlines()[1:]


def pairs_of_columns(columns, gone):
    """Of a lattice of so many columns: pairs within reach in two of them, of which one goes."""
    x, y = np.meshgrid(np.arange(columns), np.arange(8), indexing="ij")
    x, y = x.ravel(), y.ravel()
    near = np.hypot(x[:, None] - x, y[:, None] - y) < 2.4
    first_gone = columns - gone
    return int(np.count_nonzero(near & (x[:, None] < x) & (x >= first_gone)))


flight = scene()
frame = flight.dump("end.dump")[-1]
gone = 20 - len(frame["x"]) // 8
checks.above("block: columns that went", gone, 5)
checks.near("block: pairs in the warning", sum(counted(flight)), pairs_of_columns(20, gone), absolute=0)
checks.true("block: one warning", len(counted(flight)) == 1)
checks.below("block: velocity, of 500", max(abs(frame["vx"] - 500).max(), abs(frame["vy"]).max()) / 500, 1e-12)
checks.true("block: the same bits on 2 ranks", bits(scene(ranks=2)) == bits(flight))

for correction in ("no", "yes"):
    wheel = dict(velocity=TURN, box=(-2e-3, 21.5e-3), correction=correction, steps="run 600")
    name = "wheel, correction %s: " % correction
    one = scene(**wheel)
    frame = one.dump("end.dump")[-1]
    checks.above(name + "pairs dropped", sum(counted(one)), 50)
    for f in ("fx", "fy"):
        checks.below(name + "sum of " + f + " over the largest", abs(frame[f].sum()) / abs(frame[f]).max(), 1e-10)
    checks.true(name + "the same bits on 2 ranks", bits(scene(ranks=2, **wheel)) == bits(one))
    # each run looks at its start and with new lists who has gone: the same steps in both, so that of a pair that goes the
    # same is the first
    wheel["lists"] = "every 5 delay 0 check no"
    both = scene(**dict(wheel, steps="run 300\nwrite_restart half.restart\nrun 300"))
    whole = scene(**dict(wheel, steps="run 600\nrun 0"))
    checks.true(name + "run in two parts: both warn", len(counted(both)) == 2 and sum(counted(both)) == sum(counted(whole)),
                "%s, in one %s" % (counted(both), counted(whole)))
    again = scene(half=both, **dict(wheel, velocity="", steps="run 300"))
    checks.true(name + "the same bits from a restart file", bits(again) == bits(both) and counted(again) == counted(both)[1:])

taken = scene(**dict(velocity="velocity all set 0 0 0", lost="error",
                     steps="run 10\nregion end block 19e-3 20e-3 INF INF INF INF units box\ngroup end region end\ndelete_atoms group end compress no\nrun 10"))
checks.near("delete: pairs in the warning", sum(counted(taken)), pairs_of_columns(20, 1), absolute=0)


def stops(name, ranks, *words, **more):
    result = scene(ranks=ranks, expect_error=True, **more)
    checks.true("stops: " + name, result.status != 0 and all(w in result.errors() for w in words), result.errors()[:200])


stops("gone, but may not", 1, "threshold inf", "is gone", "thermo_modify lost ignore", lost="error")
APART = "variable vx atom 3000*(x>10e-3)-1500\nvelocity all set v_vx 0 0 units box"
stops("beyond the ghosts", 2, "threshold inf", "beyond the ghosts", "neighbor skin", velocity=APART, box=(-0.03, 0.05))
checks.end()
