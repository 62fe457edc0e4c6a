"""A floor of 1e5 triangles."""
import subprocess
import sys

from floors import floor, stl
from frame import ROOT


def prepare(folder, settings):
    subprocess.run([sys.executable, ROOT + "/tools/make_tool.py", "plane", "--size", "0.04", "0.04", "--cells", "224",
                    "224", "-o", stl(folder)], check=True, stdout=subprocess.DEVNULL)


CASE = floor("tool of 1e5 triangles", "penalty 1e-5 of the default", prepare, {"penalty": 1e-5})
