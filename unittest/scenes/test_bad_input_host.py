"""Malformed scripts: restart files and other hosts. See bad_input.py."""
import os
import re

from bad_input import fine, run_all, wrong
from sphtm_scene import new_folder

S = "sph/tm"
FIRST = {"run": "run 5\nwrite_restart state.restart"}
MADE = "units dimension boundary atom_style newton lattice box create_box work atoms pair_style pair_coeff"
READ = dict({k: "" for k in MADE.split()}, units="read_restart state.restart")


def foreign_plugin(old=rb"built", new=b"built"):
    """The variable that names a plugin as if built for another LAMMPS, alone, without styles that could be loaded: a copy where
    the line that it compares has one text in place of another of its length."""
    def environment():
        with open(os.path.join(os.environ["LAMMPS_PLUGIN_PATH"], "sphtmplugin.so"), "rb") as f:
            code = f.read()
        line = re.search(rb"built for LAMMPS [ -~]*", code).group(0)
        changed = re.sub(old, new, line)
        assert len(changed) == len(line), changed
        folder = new_folder()
        with open(os.path.join(folder, "sphtmplugin.so"), "wb") as f:
            f.write(code.replace(line, changed))
        return {"LAMMPS_PLUGIN_PATH": folder}
    return environment


HERE = "is not loaded into LAMMPS", "smallbig", "cmake -S . -B build/own -D LAMMPS_SOURCE_DIR=", "-D LAMMPS_BUILD_DIR="
fine("restart", READ, first=FIRST)
wrong("restart without the fix", dict(READ, fix="", compute=""), S, "fix body all sph/tm", first=FIRST)
wrong("restart with another ID of the fix", dict(READ, fix="fix other all sph/tm"), S, "other", "body",
      first=FIRST)
wrong("restart truncated", dict(READ, units="read_restart short.restart"), "corrupted", "restart", first=FIRST)
wrong("restart from a missing file", dict(READ, units="read_restart nowhere.restart"), "nowhere.restart")
wrong("plugin of another LAMMPS version", {}, "SPH-TM was built for LAMMPS", "1999, smallbig", *HERE,
      environment=foreign_plugin(rb"20\d\d,", b"1999,"))
wrong("plugin for other integers", {}, "built for", "bigbig,", *HERE, environment=foreign_plugin(rb", smallbig", b",   bigbig"))
wrong("plugin for another MPI", {}, "MPICH", *HERE, environment=foreign_plugin(rb"Open MPI", b"MPICH 4."))
wrong("plugin for Kokkos", {}, "with Kokkos", "without Kokkos", *HERE,
      environment=foreign_plugin(rb"without Kokkos", b"with Kokkos..."))
wrong("plugin without its styles", {}, "SPH-TM's styles are not loaded", "sphtm_styles.so: cannot open",
      "-D LAMMPS_BUILD_DIR=", environment=foreign_plugin())

run_all()
