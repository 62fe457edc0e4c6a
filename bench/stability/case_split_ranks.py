"""Two bars meet and yield; what has yielded is split, across the border of two ranks. Every rank must do its part of
the same split: the run on two and on four ranks ends with the bits of the run on one."""
import time

import numpy as np

from frame import PLANE, answer, run
from contact_scene import block, particles    # in the folder that frame adds

DX = 2.0**-10    # so that coordinates have the same bits on any rank
TITLE = "split across a rank boundary"
CRITERION = "particles whose position, velocity or plastic strain differs on two or four ranks from one, over all"
COUNTER = "the criteria are looked at every 20 steps instead of 10"
SCENE = PLANE + """
processors      {grid} 1
read_data       data.in
pair_style      sph/tm hyperbolic 1.2 spacing {dx!r}
pair_coeff      1 1 density 7850 elastic 200e9 0.29 strength plastic 350e6 500e6
fix             body all sph/tm energy yes
fix             ad all adapt/neigh refine square epsilon 0.41666667 alpha 0.5 when pstrain above 0.01 every {every}
compute         p all sph/tm/atom pstrain level
thermo          20
thermo_style    custom step atoms time f_ad[1] f_body[9]
thermo_modify   lost error norm no
run             {steps}
write_dump      all custom end.dump id x y vx vy c_p[*] modify sort id format float %.17g
"""


def ended(ranks=1, grid="* *", every=10, steps=400):
    x = block((24, 16, 1), DX, (0, 0, -0.5 * DX))
    v = np.where(x[:, :1] < 12 * DX, [75.0, 0, 0], [-75.0, 0, 0])
    box = [(-8 * DX, 32 * DX), (-8 * DX, 24 * DX), (-0.5 * DX, 0.5 * DX)]
    r = run(SCENE.format(grid=grid, every=every, steps=steps, dx=DX), ranks=ranks,
            files={"data.in": particles(x, box, v)})
    return r.dump("end.dump")[-1], int(r.thermo[-1]["f_ad[1]"][-1])


def different(a, b):
    if len(a["id"]) != len(b["id"]):
        return 1.0
    return float(np.mean(np.any([a[k] != b[k] for k in ("id", "x", "y", "vx", "vy", "c_p[1]", "c_p[2]")], axis=0)))


def measure(quick):
    began = time.time()
    one, splits = ended()
    spread = max(different(one, ended(ranks, grid)[0]) for ranks, grid in ((2, "2 1"), (4, "2 2")))
    value = 1.0 if splits < 50 else spread
    return answer(TITLE, CRITERION, COUNTER, 0.0, 400, began, value, different(one, ended(every=20)[0]), splits=splits)
