#!/usr/bin/python3
"""Taylor bars of several shots and spacings: length and radius of the foot. ./sphtm scenes taylor_bar
--size fine: 9 and 12 rings, for the order of convergence."""
import os
import subprocess
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "..", "bench")]
from make_bar import make_bar                                                          # noqa: E402
from measure import shape                                                              # noqa: E402
from study import ROOT, Study                                                          # noqa: E402

OFHC = ("density 8960 elastic 124e9 0.34 strength johnson/cook 90e6 292e6 0.31 0.025 1.09 298 1356 1.0 "
        "heat 386 383 0.9")
# radius, length (m), density, variables of the script; reference: length, radius (mm)
SHOTS = {"linear": (3.2e-3, 32.4e-3, 8930, {}, (21.4, 7.22)),
         "ofhc190": (3.81e-3, 25.4e-3, 8960, {"speed": 190, "end": 75e-6, "material": OFHC}, (17.40, 7.28)),
         "ofhc210": (3.81e-3, 23.47e-3, 8960, {"speed": 210, "end": 75e-6, "material": OFHC}, (14.80, 8.40)),
         "ofhc225": (3.9e-3, 34.5e-3, 8960, {"speed": 225, "end": 100e-6, "material": OFHC}, (22.25, 8.02))}
RINGS = {"linear": (4, 5, 6), "ofhc190": (4, 5, 7), "ofhc210": (4, 5, 7), "ofhc225": (4, 5)}
FINE = {"linear": (9, 12)}
WITHOUT = "viscosity 0.3 0.3 balsara yes hourglass 0"


def files_of(shot, rings):
    """What makes bar.data and plane.stl, and the spacing."""
    r, l, rho = SHOTS[shot][:3]
    area, layers = np.pi * r**2 / (1 + 3 * rings * (rings + 1)), 0
    layers = int(round(l / np.sqrt(area)))

    def prepare(folder):
        make_bar(rings, r, l, rho, os.path.join(folder, "bar.data"))
        subprocess.run([sys.executable, os.path.join(ROOT, "tools", "make_tool.py"), "plane", "--size", "1", "1", "--cells",
                        "2", "2", "-o", os.path.join(folder, "plane.stl")], check=True, stdout=subprocess.DEVNULL)

    return prepare, (area * l / layers)**(1 / 3)


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
            prepare, dx = files_of(shot, rings)
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
