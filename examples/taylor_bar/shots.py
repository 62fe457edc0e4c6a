"""The shots that the Taylor bar is compared with, and the files of a shot."""
import os
import subprocess
import sys

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, HERE)
from make_bar import make_bar                                                          # noqa: E402

OFHC = ("density 8960 elastic 124e9 0.34 strength johnson/cook 90e6 292e6 0.31 0.025 1.09 298 1356 1.0 "
        "heat 386 383 0.9")
# radius, length (m), density, variables of the script; reference: length, radius (mm)
SHOTS = {"linear": (3.2e-3, 32.4e-3, 8930, {}, (21.48, 7.36)),
         "ofhc190": (3.81e-3, 25.4e-3, 8960, {"speed": 190, "end": 75e-6, "material": OFHC}, (17.36, 7.40)),
         "ofhc210": (3.81e-3, 23.47e-3, 8960, {"speed": 210, "end": 75e-6, "material": OFHC}, (14.80, 8.40)),
         "ofhc225": (3.9e-3, 34.5e-3, 8960, {"speed": 225, "end": 100e-6, "material": OFHC}, (22.25, 8.02))}


def files_of(r, l, rho, rings):
    """What makes bar.data and plane.stl for a bar of that radius, length and density, and the spacing."""
    area, layers = np.pi * r**2 / (1 + 3 * rings * (rings + 1)), 0
    layers = int(round(l / np.sqrt(area)))

    def prepare(folder):
        make_bar(rings, r, l, rho, os.path.join(folder, "bar.data"))
        subprocess.run([sys.executable, os.path.join(ROOT, "tools", "make_tool.py"), "plane", "--size", "1", "1", "--cells",
                        "2", "2", "-o", os.path.join(folder, "plane.stl")], check=True, stdout=subprocess.DEVNULL)

    return prepare, (area * l / layers)**(1 / 3)
