"""The plane cut of examples/orthogonal_cut_2d with tool speed, density and spacing to choose."""
import shutil

import numpy as np

from frame import changed, example

SPEED, DENSITY, CAPACITY = 8.33, 4430.0, 526.0    # m/s, and of the card ti6al4v
BLOCKS = 5                                        # of the mean, to tell how sure it is
START = 0.2                                       # share of the cut before the force counts


def mesh(folder, variables):
    shutil.copy(example("orthogonal_cut_2d", "insert.stl"), folder)


def script(variables):
    """Variables: speed and mass, factors; cut, m; dx. Mass scaling leaves the heat of a volume as it is."""
    speed, mass = SPEED * variables.pop("speed", 1), variables.pop("mass", 1)
    end = variables.pop("cut") / speed
    card = "materials.sphtm ti6al4v"
    scaled = card if mass == 1 else "%s set density %r set capacity %r" % (card, DENSITY * mass, CAPACITY / mass)
    return changed(example("orthogonal_cut_2d"), (card, scaled), ("linear -8.33", "linear -%.9g" % speed),
                   ("run             120000",
                    "variable left equal %.9g-time\nfix stop all halt 10 v_left < 0 error continue "
                    "message no\nrun 100000000" % end), ("dump            1", "#"), ("vtk 10000 tool.*.vtk", ""),
                   ("10 10 100 c_fc", "1 50 50 c_fc"))


def force(run):
    f = run.columns("force.dat")
    late = f[int(START * len(f)):]
    blocks = [b.mean() for b in np.array_split(late[:, 1], BLOCKS)]
    return {"value": late[:, 1].mean(), "value_uncertain": np.std(blocks, ddof=1) / np.sqrt(BLOCKS) / late[:, 1].mean(),
            "thrust": late[:, 2].mean(), "swing": late[:, 1].std() / late[:, 1].mean()}
