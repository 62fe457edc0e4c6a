"""The file of a tool: what is no regular file, too long, missing or another one on some of the ranks. Every such file
ends at once with an error that names it, on all ranks, or is read by the first rank for all."""
import os
import shutil
import socket
import stat
import subprocess
import time

from sphtm_scene import SOURCE, Checks, lattice_block, new_folder, run

SCENE = lattice_block("0 5e-3 0 5e-3 0 5e-3", "-5e-3 15e-3 -5e-3 15e-3 -5e-3 15e-3", dim=3) + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 2700 elastic 70e9 0.33
fix             body all sph/tm
fix             tool all contact/tri file {file} scale 2e-3 move 5.006e-3 1.5e-3 1.5e-3 {more}
fix_modify      tool move linear -100 0 0
thermo          20
thermo_style    custom step f_tool[1] f_tool[12]
thermo_modify   format float %.17g
run             60
"""
MESHES = os.path.join(SOURCE, "unittest", "meshes")
WEDGE = os.path.join(MESHES, "ascii.stl")
# the rank that AWAY names works in the folder "other"
WRAPPER = """#!/bin/sh
[ "${OMPI_COMM_WORLD_RANK:-$PMI_RANK}" = "$AWAY" ] && cd other
exec "$TRUE_LMP" "$@"
"""
checks = Checks()


def attempt(file, folder, more="", ranks=1, **options):
    """The run, or None where it hangs, and its seconds."""
    begin = time.time()
    try:
        result = run(SCENE.format(file=file, more=more), folder=folder, ranks=ranks, expect_error=True, timeout=60,
                     **options)
    except subprocess.TimeoutExpired:
        result = None
    return result, time.time() - begin


def refused(name, file, *fragments, folder=None, **options):
    result, seconds = attempt(file, folder or new_folder(), **options)
    said = result.errors() if result else "it hangs"
    missing = [f for f in ("contact/tri tool", file) + fragments if f not in said]
    checks.true(name, result and result.status and not missing, (said.splitlines() or ["it ran"])[0][:150] +
                "".join("; not said: " + m for m in missing))
    checks.below("    seconds", seconds, 20)


def passes(name, file, folder, **options):
    result, seconds = attempt(file, folder, **options)
    fine = result and result.status == 0
    checks.true(name, fine, "" if fine else result.errors() if result else "it hangs")
    return result.thermo[-1] if fine else None


def same(name, a, b):
    checks.true(name, a and b and all((a[k] == b[k]).all() for k in a) and b["f_tool[1]"][-1] != 0.0,
                "force %.9g, %.9g" % (a["f_tool[1]"][-1], b["f_tool[1]"][-1]) if a and b else "")


def kinds_of_files():
    folder = new_folder()
    os.mkfifo(os.path.join(folder, "pipe.stl"))
    os.symlink("pipe.stl", os.path.join(folder, "link_to_pipe.stl"))
    os.mkdir(os.path.join(folder, "folder.stl"))
    there = os.getcwd()
    os.chdir(folder)    # the name of a socket is limited to some 100 bytes
    with socket.socket(socket.AF_UNIX) as s:
        s.bind("socket.stl")
    os.chdir(there)
    refused("named pipe", "pipe.stl", "named pipe", "regular file", folder=folder)
    refused("link to a named pipe", "link_to_pipe.stl", "named pipe", folder=folder)
    refused("directory", "folder.stl", "directory", folder=folder)
    refused("socket", "socket.stl", "socket", folder=folder)
    refused("device without end", "/dev/zero", "device")
    refused("device without content", "/dev/null", "device")
    refused("missing", "nowhere.stl", "cannot open", "No such file")
    refused("file that is longer than its size", "/proc/version", "its size is 0 bytes")
    os.symlink(WEDGE, os.path.join(folder, "link.stl"))
    passes("link to a file", "link.stl", folder)


def sizes():
    folder = new_folder()
    big = os.path.join(folder, "big.stl")
    open(big, "w").close()
    os.truncate(big, 5 * 10**9)
    refused("5 GB, sparse", "big.stl", "5000000000 bytes", "512 MB", "maxsize", folder=folder)
    refused("5 GB, sparse, two ranks", "big.stl", "5000000000 bytes", folder=folder, ranks=2)
    with open(WEDGE) as f, open(os.path.join(folder, "long.stl"), "w") as g:
        text = f.read()
        g.write(text + "\n" * (1000001 - len(text)))
    refused("one byte more than maxsize", "long.stl", "1000001 bytes", "1 MB", folder=folder, more="maxsize 1")
    os.truncate(os.path.join(folder, "long.stl"), 1000000)
    passes("as many bytes as maxsize", "long.stl", folder, more="maxsize 1")
    passes("more bytes than an earlier maxsize", "long.stl", folder, more="maxsize 2")


def ranks():
    folder = new_folder()
    other = os.path.join(folder, "other")
    os.mkdir(other)
    os.symlink("../in.scene", os.path.join(other, "in.scene"))
    wrapper = os.path.join(folder, "lmp.sh")
    with open(wrapper, "w") as f:
        f.write(WRAPPER)
    os.chmod(wrapper, stat.S_IRWXU)
    shutil.copy(WEDGE, os.path.join(folder, "tool.stl"))
    use = dict(folder=folder, ranks=2)

    def away(rank):
        return {"SPHTM_LMP": wrapper, "TRUE_LMP": os.environ.get("SPHTM_LMP", ""), "AWAY": str(rank)}

    here = passes("two ranks", "tool.stl", **use)
    same("missing on rank 1: as if it were there", here, passes("missing on rank 1", "tool.stl", environment=away(1),
                                                                **use))
    refused("missing on rank 0", "tool.stl", "cannot open", environment=away(0), **use)
    shutil.copy(os.path.join(MESHES, "binary_plate.stl"), os.path.join(other, "tool.stl"))
    same("another file on rank 1: that of rank 0", here, passes("another file on rank 1", "tool.stl",
                                                                environment=away(1), **use))
    shutil.copy(os.path.join(MESHES, "ascii_cut_facet.stl"), os.path.join(folder, "tool.stl"))
    refused("broken on both", "tool.stl", "line", **use)
    refused("broken on rank 0", "tool.stl", "line", environment=away(1), **use)


if __name__ == "__main__":
    kinds_of_files()
    sizes()
    ranks()
    checks.end()
