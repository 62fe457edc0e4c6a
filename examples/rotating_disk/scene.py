#!/usr/bin/python3
"""The rotating disk with every kind of list: what spin and radius are after five turns. ./sphtm scenes rotating_disk"""
import os
import sys

import numpy as np

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "..", "bench"))
from study import Study                                                                # noqa: E402

ROWS = {"skin": None, "every_step": "threshold 0", "1e-5": "threshold 1e-5", "once": "threshold inf"}


def measure(result):
    """Relative changes of the angular momentum and of the radius of gyration over the run, largest and last."""
    t = result.thermo[-1]
    spin, radius = t["c_sum"] / t["c_sum"][0] - 1, t["c_r"] / t["c_r"][0] - 1
    energy = t["f_body[9]"] / t["f_body[9]"][0] - 1
    return {"turns": t["v_angle"][-1], "spin": np.abs(spin).max(), "spin_last": spin[-1], "radius": np.abs(radius).max(),
            "radius_last": radius[-1], "energy": np.abs(energy).max()}


def main():
    study = Study(__file__, {"small": {"n": 6, "rim": 0.04}, "default": {"n": 15, "rim": 0.04}, "large": {"n": 100}}, __doc__)
    rows = {}
    for row, adapt in ROWS.items():
        if study.wants(row):
            result = study.run(row, dict(study.size, adapt=adapt))
            rows[row] = dict(measure(result), processor=result.processor, wall=result.wall)
    study.end({"rows": rows})


if __name__ == "__main__":
    main()
