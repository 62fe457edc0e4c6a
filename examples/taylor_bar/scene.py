#!/usr/bin/python3
"""Taylor bars of several shots and spacings: length and radius of the foot. ./sphtm scenes taylor_bar
--size fine: 9 and 12 rings, for the order of convergence."""
import os
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "..", "bench")]
from measure import shape                                                              # noqa: E402
from shots import SHOTS, files_of                                                      # noqa: E402
from study import Study                                                                # noqa: E402

RINGS = {"linear": (4, 5, 6), "ofhc190": (4, 5, 7), "ofhc210": (4, 5, 7), "ofhc225": (4, 5)}
FINE = {"linear": (9, 12)}
WITHOUT = "viscosity 0.3 0.3 balsara yes hourglass 0"


def main():
    sizes = {"small": {"rings": 4}, "default": {}, "fine": {}, "no_hourglass": {"options": WITHOUT}}
    study = Study(__file__, sizes, __doc__)
    rows = {}
    rings_of = FINE if study.options.size == "fine" else RINGS
    for shot in rings_of:
        r, l, rho, variables, reference = SHOTS[shot]
        for rings in rings_of[shot]:
            row = "%s_%d" % (shot, rings)
            if not study.wants(row) or study.options.size == "small" and rings > 4:
                continue
            prepare, dx = files_of(r, l, rho, rings)
            result = study.run(row, dict(variables, dx=dx, options=study.size.get("options")), may_stop=True, prepare=prepare)
            if result.errors():
                rows[row] = {"stopped": result.errors()}
                continue
            t = result.thermo[-1]
            length, radius, least, largest = (1e3 * float(v) for v in shape(result.dump("end.dump")[-1], dx))
            rows[row] = {"length": length, "radius": radius, "least_radius": least, "largest_radius": largest,
                         "length_off": length / reference[0] - 1, "radius_off": radius / reference[1] - 1,
                         "energy_drift": float(np.ptp(t["f_body[9]"]) / t["f_body[1]"][0]),
                         "artificial": float(t["f_body[7]"][-1] / t["f_body[1]"][0]), "processor": result.processor}
    wanted = ["linear_6"] if study.options.size == "no_hourglass" else ["%s_%d" % (s, n) for s in rings_of for n in rings_of[s]]
    whole = all("length" in rows.get(row, {}) for row in wanted) and study.options.size != "small"
    name = "taylor_bar" + ("." + study.options.size if study.options.size in ("no_hourglass", "fine") else "")
    study.end({"rows": rows}, {name: {row: rows[row] for row in wanted}} if whole else None)


if __name__ == "__main__":
    main()
