"""./sphtm doctor, and the installed command, with programs that stand in for LAMMPS, mpirun, Python and dpkg: what is there is
named, what is missing comes with the command that mends it, and the status says whether a run can start."""
import os
import shutil

from driver_case import SOURCE, Case, end, say

BUILT = "4 Feb 2025, smallbig, Open MPI 4.1.4, without Kokkos"
HELP = """
Large-scale Atomic/Molecular Massively Parallel Simulator - {version}

MPI v3.1: {mpi}, package: some, ident: 1
Accelerator configuration:
{kokkos}
Active compile time flags:
-DLAMMPS_{sizes}
sizeof(bigint):   64-bit
* Command styles
plate           {plugin}
"""


def lmp(path, version="4 Feb 2025", sizes="SMALLBIG", mpi="Open MPI v4.1.4", kokkos="", plugin="plugin", loads=True):
    """A LAMMPS that answers -h, and 'plugin list' when it takes the plugin."""
    os.makedirs(os.path.dirname(path), exist_ok=True)
    listed = "   1: pair style plugin sph/tm" if loads else "Open of file sphtmplugin.so failed: undefined symbol: x"
    with open(path, "w") as f:
        f.write("#!/bin/sh\ncase $1 in -h) cat <<'END'\n" + HELP.format(**locals()) +
                "END\n;; *) cat > /dev/null; echo '%s' ;; esac\n" % listed)
    os.chmod(path, 0o755)
    return path


def plugin(case, *folder, built=BUILT):
    whole = case.write(*folder, "sphtmplugin.so", text="\0built for LAMMPS %s\0" % built)
    case.write(os.path.dirname(whole), "sphtm_styles.so")
    return os.path.dirname(whole)


def fresh(built=True, there=True):
    """A Debian with all packages, a plugin in build/ and its LAMMPS in the cache."""
    c = Case()
    c.stub("dpkg-query", "echo 'ii '")
    c.stub("apt-get", "exit 1")    # it is never called
    c.stub("mpirun", "echo 'mpirun (Open MPI) 4.1.4'")
    c.stub("nvidia-smi", "exit 1")
    for name in "LAMMPS_PLUGIN_PATH", "SPHTM_OUT":
        c.environment.pop(name, None)
    # nothing of this machine's LAMMPS
    c.stub("lmp", "exit 1")
    os.remove(os.path.join(c.stubs, "lmp"))
    if built:
        plugin(c, c.checkout, "build", "plain-1")
    if there:
        lmp(os.path.join(c.cache, "host-plain-1", "lmp"))
    return c


def says(name, answer, status, *fragments, never=()):
    out, got = answer
    missing = [f for f in fragments if f not in " ".join(out.split())] + ["not: " + f for f in never if f in out]
    say(got == status and not missing, name, "%s; status %d; missing: %s" % (out[-3000:], got, missing))


def untouched(case):
    return not os.path.exists(os.path.join(case.checkout, "out"))


c = fresh()
says("all is there", c.sphtm("doctor"), 0, "plain-1: for LAMMPS " + BUILT, "it loads", "ok MPI", "none GPU",
     "A run can start: ./sphtm lmp", never=["missing  packages", "No run"])
say(untouched(c), "doctor makes nothing")
says("nothing there", fresh(built=False, there=False).sphtm("doctor"), 1, "missing plugin", "missing LAMMPS", "./sphtm build",
     "No run can start")
says("a plugin without LAMMPS", fresh(there=False).sphtm("doctor"), 1, "ok plugin", "missing LAMMPS", "./sphtm build")
says("LAMMPS without a plugin", fresh(built=False).sphtm("doctor"), 1, "missing plugin not built yet ./sphtm build", "ok LAMMPS")
c = fresh()
os.remove(os.path.join(c.checkout, "build", "plain-1", "sphtm_styles.so"))
says("half a plugin", c.sphtm("doctor"), 1, "broken plugin", "sphtm_styles.so")

for name, change, why in (
        ("another version", {"version": "29 Aug 2024"}, "is LAMMPS 29 Aug 2024, the plugin is for 4 Feb 2025"),
        ("other integers", {"sizes": "BIGBIG"}, "has bigbig integers, the plugin is for smallbig"),
        ("another MPI", {"mpi": "MPICH Version: 4.0"}, "is built with MPICH Version: 4.0, the plugin with Open MPI 4.1.4"),
        ("no MPI", {"mpi": "LAMMPS MPI STUBS for LAMMPS version 4 Feb 2025"}, "is built with no MPI"),
        ("no plugins", {"plugin": "plugh"}, "has no plugin command"),
        ("a plugin that does not load", {"loads": False}, "undefined symbol: x")):
    c = fresh(there=False)
    lmp(os.path.join(c.cache, "host-plain-1", "lmp"), **change)
    says("LAMMPS with " + name, c.sphtm("doctor"), 1, "unfit LAMMPS", why, "./sphtm build", "No run can start")

c = fresh(built=False, there=False)
plugin(c, c.checkout, "build", "cuda-1", built=BUILT.replace("without", "with"))
lmp(os.path.join(c.cache, "host-cuda-1", "lmp"))
says("a plugin for Kokkos, LAMMPS without", c.sphtm("doctor"), 1, "has no Kokkos")
lmp(os.path.join(c.cache, "host-cuda-1", "lmp"), kokkos="KOKKOS package API: CUDA")
says("both with Kokkos", c.sphtm("doctor"), 0, "ok Kokkos")

c = fresh()
mine = lmp(os.path.join(c.top, "mine", "lmp"), version="2 Apr 2025 - Update 1")
says("SPHTM_LMP that does not fit", c.sphtm("doctor", SPHTM_LMP=mine), 0, mine + " is LAMMPS 2 Apr 2025, the plugin", "can start")
says("SPHTM_LMP that is not there", c.sphtm("doctor", SPHTM_LMP="/nowhere/lmp"), 0, "SPHTM_LMP=/nowhere/lmp: not there")
c = fresh(there=False)
mine = lmp(os.path.join(c.stubs, "lmp"))
says("a LAMMPS on PATH", c.sphtm("doctor"), 0, "ok LAMMPS " + mine, "A run can start: LAMMPS_PLUGIN_PATH=")
c = fresh()
c.stub("lmp", "echo 'lmp: error while loading shared libraries: libx.so.1: cannot open shared object file' >&2; exit 127")
says("a LAMMPS that does not start", c.sphtm("doctor"), 0, "cannot start: error while loading shared libraries: libx.so.1", "ldd " + c.stubs)
c = fresh(there=False)
lmp(os.path.join(c.cache, "host-plain-1", "lmp"))
with open(os.path.join(c.cache, "host-plain-1", "lmp"), "w") as f:
    f.write("#!/bin/sh\necho '*** An error occurred in MPI_Init'; exit 1\n")
os.remove(os.path.join(c.stubs, "mpirun"))
says("a LAMMPS whose MPI does not start", c.sphtm("doctor"), 1, "broken LAMMPS", "openmpi-bin", "No run", never=["fits a plugin"])

c = fresh()
c.stub("mpirun", "echo 'HYDRA build details:'")
says("mpirun of another MPI", c.sphtm("doctor"), 0, "unfit MPI", "PATH=")
c = fresh()
c.stub("dpkg-query", 'case "$*" in *ninja-build*) exit 1 ;; esac\necho "ii "')
says("a package is missing", c.sphtm("doctor"), 0, "missing packages", "apt-get install ninja-build")
c = fresh()
c.stub("nvidia-smi", "echo 'NVIDIA H200, 570.1'")
says("a GPU", c.sphtm("doctor"), 0, "ok GPU NVIDIA H200, 570.1", "./sphtm host-cuda")
says("no HOME", fresh(built=False, there=False).sphtm("doctor", HOME="", SPHTM_CACHE=""), 1, "./sphtm build")


# --- installed: the same folders as cmake --install makes, in one with a space in its name

def installed():
    c = fresh(built=False, there=False)
    prefix = os.path.join(c.top, "a prefix")
    data = os.path.join(prefix, "share", "sphtm")
    shutil.copytree(os.path.join(SOURCE, "tools"), os.path.join(data, "tools"))
    for name in "materials", os.path.join("examples", "rings"):
        shutil.copytree(os.path.join(SOURCE, name), os.path.join(data, name))
    with open(os.path.join(SOURCE, "tools", "sphtm-installed.in")) as f:
        text = f.read()
    for name, value in (("BIN_TO_DATA", "../share/sphtm"), ("BIN_TO_PLUGIN", "../lib/lammps/plugins"),
                        ("BIN_TO_HOST", "../lib/sphtm")):
        text = text.replace("@SPHTM_%s@" % name, value)
    c.command = c.write(prefix, "bin", "sphtm", text=text)
    os.chmod(c.command, 0o755)
    c.plugins = plugin(c, prefix, "lib", "lammps", "plugins")
    c.host = os.path.join(prefix, "lib", "sphtm", "lmp")
    return c


c = installed()
says("installed without a LAMMPS", c.run(c.command, "doctor"), 1, "missing LAMMPS", "SPHTM_LMP=<lmp> sphtm doctor")
says("lmp without a LAMMPS", c.run(c.command, "lmp"), 1, "no LAMMPS " + BUILT + " found", "SPHTM_LMP", "sphtm doctor")
lmp(c.host)
says("installed with its LAMMPS", c.run(c.command, "doctor"), 0, "A run can start: sphtm lmp", never=["./sphtm build"])
says("lmp loads the plugin", c.run(c.command, "lmp", "-in", "x"), 0, "pair style plugin sph/tm")
link = os.path.join(c.stubs, "sphtm")
os.symlink(c.command, link)
says("by a link", c.run("sphtm", "env"), 0, "export SPHTM_LMP='%s'" % c.host, "LAMMPS_PLUGIN_PATH='%s'" % c.plugins)
mine = lmp(os.path.join(c.top, "mine", "lmp"), sizes="BIGBIG")
says("SPHTM_LMP that does not fit stops", c.run(c.command, "lmp", SPHTM_LMP=mine), 1, mine, "has bigbig integers", "doctor")
os.remove(c.host)
lmp(os.path.join(c.stubs, "lmp"), version="6 Jan 2022")
says("the LAMMPS on PATH is of another version", c.run(c.command, "doctor"), 1, "is LAMMPS 6 Jan 2022",
     "cmake -S . -B build/own", "cmake --build build/own")
for word in "test", "build", "gpu-bundle", "clean":
    says("%s needs the source" % word, c.run(c.command, word), 1, "needs its source tree", "./sphtm " + word)
says("no such command", c.run(c.command, "nonsense"), 2, "no command 'nonsense'")
says("help", c.run(c.command, "help"), 0, "doctor", os.path.join(c.top, "a prefix", "share", "sphtm"))
c.stub("python3", "exit 1")
out, status = c.run(c.command, "tool", "--help")
say(status == 1, "tool is Python's", out)
os.remove(os.path.join(c.stubs, "python3"))
says("a mesh of a tool", c.run(c.command, "tool", "plane", "--size", "1", "1", "--cells", "1", "1", "-o",
                               os.path.join(c.top, "plane.stl")), 0)
os.remove(os.path.join(c.plugins, "sphtmplugin.so"))
says("the plugin is gone", c.run(c.command, "doctor"), 1, "install SPH-TM again")
says("lmp without a plugin", c.run(c.command, "lmp"), 1, "install SPH-TM again")
end()
