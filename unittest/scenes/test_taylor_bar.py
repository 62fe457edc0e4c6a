"""Taylor bars of copper on a frictionless plane of triangles, four rings of particles over the radius, the first with six as
well.

  linear hardening, 227 m/s: length 21.48 mm, radius 7.36 mm, the limit of finite elements (examples/taylor_bar/finite_elements.py)
  OFHC, Johnson-Cook, measured: 210 m/s 14.80 and 8.40 mm (Wilkins and Guinan 1973), 225 m/s 22.25 and 8.02 mm

What is missed is held to what was found, within 2 %, so that it cannot get worse unseen: the radius at 210 m/s, and length and radius at 225 m/s,
apparently a harder copper. Reasons and finer bars: examples/taylor_bar/README.md."""
import os
import re
import subprocess
import sys

import numpy as np
from sphtm_scene import SOURCE, Checks, new_folder, run

sys.path.insert(0, os.path.join(SOURCE, "examples", "taylor_bar"))
from make_bar import make_bar
from measure import shape

SCRIPT = os.path.join(SOURCE, "examples", "taylor_bar", "in.taylor_bar")
OFHC = ("density 8960 elastic 124e9 0.34 strength johnson/cook 90e6 292e6 0.31 0.025 1.09 298 1356 1.0 "
        "heat 386 383 0.9")
LINEAR = (3.2e-3, 32.4e-3, 8930, {})
# name, rings, (radius, length in m, density, options), {quantity: (reference in mm, error allowed, or what is found in its
# place, mm)}
SHOTS = [("linear hardening, 4 rings", 4, LINEAR, {"length": (21.48, 0.03), "radius": (7.36, 0.03)}),
         ("linear hardening, 6 rings", 6, LINEAR, {"length": (21.48, 0.03), "radius": (7.36, 0.03)}),
         ("OFHC 210 m/s", 4, (3.81e-3, 23.47e-3, 8960, {"speed": 210, "end": 75e-6, "material": OFHC}),
          {"length": (14.80, 0.04), "radius": (8.40, "7.75")}),
         ("OFHC 225 m/s", 4, (3.9e-3, 34.5e-3, 8960, {"speed": 225, "end": 100e-6, "material": OFHC}),
          {"length": (22.25, "20.64"), "radius": (8.02, "8.76")})]


def plane(folder):
    subprocess.run([sys.executable, os.path.join(SOURCE, "tools", "make_tool.py"), "plane", "--size", "1", "1", "--cells", "2", "2",
                    "-o", os.path.join(folder, "plane.stl")], check=True, stdout=subprocess.DEVNULL)


def goes_on(checks):
    """The foot of a fast bar is drawn so flat that without shifting particles lie in a tenth of the spacing; a second run takes that."""
    folder = new_folder()
    plane(folder)
    dx = make_bar(4, *LINEAR[:3], os.path.join(folder, "bar.data"))
    with open(SCRIPT) as f:
        text = re.sub("(?m)^(fix +body all sph/tm.*)$", r"\1 effects shifting off", f.read()) + "\nrun 5\n"
    checks.true("300 m/s, particles are not shifted", "effects shifting off" in text)
    result = run(text, {"dx": dx, "speed": 300, "end": 30e-6}, folder=folder)
    end = result.dump("end.dump")[-1]
    x = np.column_stack([end[c] for c in "xyz"])
    nearest = min(np.sort(np.sum((x - p) ** 2, axis=1))[1] for p in x)**0.5 / dx
    checks.below("300 m/s: closest particles, spacings", nearest, 0.1)
    checks.true("300 m/s: a second run goes on", len(result.thermo) > 1 and not result.errors())


def kept(checks):
    """Pairs that are kept see shorter waves as the foot is pressed flat, and the time step follows: with a step of the spacing
    alone this bar stopped at a density below 0."""
    folder = new_folder()
    plane(folder)
    dx = make_bar(4, 3.81e-3, 23.47e-3, 8960, os.path.join(folder, "bar.data"))
    result = run(SCRIPT, {"dx": dx, "speed": 210, "end": 75e-6, "material": OFHC, "adapt": "threshold inf"}, folder=folder)
    table = result.thermo[-1]
    length, radius, least, largest = [1e3 * v for v in shape(result.dump("end.dump")[-1], dx)]
    checks.near("kept pairs, OFHC 210 m/s: length, mm", length, 14.80, relative=0.04)
    checks.note("its radius, mm", "%.2f" % radius)
    checks.below("the step at its smallest over that of the start", table["Dt"].min() / table["Dt"][0], 0.6)
    checks.below("energy sum, drift over kinetic energy", np.ptp(table["f_body[9]"]) / table["f_body[1]"][0], 0.01)
    checks.true("no numerical fracture", "numerical fracture: none" in result.output)


def main():
    checks = Checks()
    for name, rings, (r, l, rho, options), references in SHOTS:
        folder = new_folder()
        plane(folder)
        dx = make_bar(rings, r, l, rho, os.path.join(folder, "bar.data"))
        result = run(SCRIPT, dict(options, dx=dx), folder=folder)
        table = result.thermo[-1]
        length, radius, least, largest = [1e3 * v for v in shape(result.dump("end.dump")[-1], dx)]
        start, kinetic = abs(table["v_momentum"][0]), table["f_body[1]"][0]
        for what, found in (("length", length), ("radius", radius)):
            reference, allowed = references[what]
            if not isinstance(allowed, str):
                checks.near("%s: %s, mm" % (name, what), found, reference, relative=allowed)
            else:
                checks.note("%s: %s, mm, is missed" % (name, what),
                            "%.2f against %.2f: %+.1f %%" % (found, reference, 100 * (found / reference - 1)))
                checks.near("%s: %s, mm, as it was" % (name, what), found, float(allowed), relative=0.02)
        checks.below("unevenness of the rim over the radius", (largest - least) / radius, 0.02)
        checks.note("artificial work over kinetic energy", "%.3f" % (table["f_body[7]"][-1] / kinetic))
        checks.below("energy sum, drift over kinetic energy", np.ptp(table["f_body[9]"]) / kinetic, 1e-3)
        checks.below("momentum across the axis, over that of the shot",
                     max(np.max(np.abs(table[c])) for c in ("v_px", "v_py")) / start, 1e-9)
        checks.below("deepest penetration, spacings", np.max(table["f_wall[13]"]), 0.2)
    goes_on(checks)
    kept(checks)
    checks.end()


if __name__ == "__main__":
    main()
