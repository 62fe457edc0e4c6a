"""The plugin in programs that are no LAMMPS it was built for: none of LAMMPS's C++ is there, only functions of its C interface.
It loads, says what it was built for and what loads it, and registers nothing; where the interface is missing too, the same."""
import ctypes
import datetime
import os
import re
import shutil
import subprocess
import sys

from sphtm_scene import Checks, new_folder

PLUGIN = os.path.join(os.environ["LAMMPS_PLUGIN_PATH"], "sphtmplugin.so")
HOST = r"""
#include <stdio.h>
#include <string.h>
int lammps_version(void *h) { (void) h; return VERSION; }
int lammps_extract_setting(void *h, const char *name)
{
  (void) h;
  if (!strcmp(name, "world_rank")) return RANK;
  return strcmp(name, "bigint") ? TAGINT : 8;
}
int lammps_config_has_mpi_support(void) { return MPI; }
int lammps_config_has_package(const char *name) { (void) name; return 0; }
int MPI_Get_library_version(char *text, int *n) { strcpy(text, "MPICH Version:\t4.0.2\nMore"); *n = 26; return 0; }
void lammps_error(void *h, int kind, const char *text) { (void) h; printf("kind %d: %s\n", kind, text); fflush(stdout); }
"""


def load(library):
    """In a process of its own: the host's functions for all, then the plugin as LAMMPS loads it."""
    if library:
        ctypes.CDLL(library, ctypes.RTLD_GLOBAL)
    plugin = ctypes.CDLL(PLUGIN, os.RTLD_NOW | os.RTLD_GLOBAL)
    plugin.lammpsplugin_init(None, None, None)    # to register a style it would call the last


def said(**values):
    library = os.path.join(new_folder(), "host.so") if values else ""
    if values:
        subprocess.run(["cc", "-shared", "-fPIC", "-x", "c", "-", "-o", library] +
                       ["-D%s=%d" % v for v in values.items()], input=HOST, text=True, check=True)
    done = subprocess.run([sys.executable, os.path.abspath(__file__), "load", library], stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT, text=True)
    return done.stdout + ("" if done.returncode == 0 else "status %d" % done.returncode)


if sys.argv[1:2] == ["load"]:
    load(sys.argv[2])
    sys.exit()
if not shutil.which("cc"):
    print("skipped: no cc here")
    sys.exit(77)
checks = Checks()
with open(PLUGIN, "rb") as f:
    version, sizes = re.search(rb"built for LAMMPS ([^,]*), (\w+), ", f.read()).groups()
version, sizes = version.decode(), sizes.decode()
this = int(datetime.datetime.strptime(version, "%d %b %Y").strftime("%Y%m%d"))
same, other, name_of_other = (4, 8, "bigbig") if sizes == "smallbig" else (8, 4, "smallbig")
BUILT = "SPH-TM was built for LAMMPS %s, %s, " % (version, sizes)
for name, values, words in (
        ("another version", dict(VERSION=19991231, RANK=0, TAGINT=same, MPI=1), "31 Dec 1999, %s, MPICH Version: 4.0.2, w" % sizes),
        ("another version and integers", dict(VERSION=20240829, RANK=0, TAGINT=other, MPI=1), "29 Aug 2024, " + name_of_other),
        ("other integers", dict(VERSION=this, RANK=0, TAGINT=other, MPI=1), "%s, %s, MPICH" % (version, name_of_other)),
        ("no MPI", dict(VERSION=this, RANK=0, TAGINT=same, MPI=0), "%s, %s, no MPI, without Kokkos" % (version, sizes)),
        ("another MPI", dict(VERSION=this, RANK=0, TAGINT=same, MPI=1), "%s, %s, MPICH Version: 4.0.2, w" % (version, sizes)),
        ("no interface", {}, "of an unknown version, unknown sizes, ")):
    text = said(**values)
    lines = text.splitlines()
    checks.true(name, len(lines) == 1 and BUILT in text and "not loaded into LAMMPS " + words in text and "cmake --build" in text, text)
checks.true("rank 1 is silent", said(VERSION=20240829, RANK=1, TAGINT=4, MPI=1) == "", "")
checks.end()
