"""Malformed scripts: restart files and other hosts. See bad_input.py."""
import os
import re

from bad_input import fine, run_all, wrong
from sphtm_scene import new_folder

S = "sph/tm"
FIRST = {"run": "run 5\nwrite_restart state.restart"}
MADE = "units dimension boundary atom_style newton lattice box create_box work atoms pair_style pair_coeff"
READ = dict({k: "" for k in MADE.split()}, units="read_restart state.restart")


def foreign_plugin():
    """The variable that names a plugin as if built for a LAMMPS of another date: a copy with that version string."""
    with open(os.path.join(os.environ["LAMMPS_PLUGIN_PATH"], "sphtmplugin.so"), "rb") as f:
        code = f.read()
    found = re.search(rb"(\d{1,2} (?:Jan|Feb|Mar|Apr|May|Jun|Jul|Aug|Sep|Oct|Nov|Dec) 20\d\d)\x00", code)
    assert found, "no LAMMPS version in the plugin"
    folder = new_folder()
    with open(os.path.join(folder, "sphtmplugin.so"), "wb") as f:
        f.write(code.replace(found.group(1), found.group(1)[:-1] + b"0"))
    return {"LAMMPS_PLUGIN_PATH": folder}


fine("restart", READ, first=FIRST)
wrong("restart without the fix", dict(READ, fix="", compute=""), S, "fix body all sph/tm", first=FIRST)
wrong("restart with another ID of the fix", dict(READ, fix="fix other all sph/tm"), S, "other", "body",
      first=FIRST)
wrong("restart truncated", dict(READ, units="read_restart short.restart"), "corrupted", "restart", first=FIRST)
wrong("restart from a missing file", dict(READ, units="read_restart nowhere.restart"), "nowhere.restart")
wrong("plugin of another LAMMPS version", {}, "SPH-TM was built for LAMMPS", "is not loaded into LAMMPS",
      "LAMMPS_SOURCE_DIR", environment=foreign_plugin)

run_all()
