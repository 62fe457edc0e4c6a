"""How a bundle runs its LAMMPS."""
import os
import shlex
import shutil
import subprocess

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.environ.get("SPHTM_BUNDLE", os.path.dirname(os.path.dirname(HERE)))
DEVICES = os.environ.get("SPHTM_DEVICES", "cuda")


def kokkos_arguments(gpus):
    if DEVICES == "plain":
        return []
    words = ["-k", "on", "g" if DEVICES == "cuda" else "t", str(gpus if DEVICES == "cuda" else 2), "-sf", "kk"]
    # lib/libdevice_mpi.so takes messages from device memory
    return words + ["-pk", "kokkos", "gpu/aware", "on"] if DEVICES == "cuda" and gpus > 1 else words


def lammps(folder, arguments, gpus=1, environment=None, timeout=590, before=()):
    """Runs lmp in the folder; its output, and its status or 'timeout'."""
    ranks = shlex.split(os.environ.get("SPHTM_MPIRUN", "mpirun")) + ["-np", str(gpus)] if gpus > 1 else []
    command = list(before) + ranks + [os.environ["SPHTM_LMP"], "-nocite", "-log", "none"] + kokkos_arguments(gpus)
    try:
        done = subprocess.run(command + list(arguments), cwd=folder, env=dict(os.environ, **(environment or {})),
                              timeout=timeout,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    except subprocess.TimeoutExpired as late:
        return (late.stdout or b"").decode(errors="replace"), "timeout"
    return done.stdout, done.returncode


def fresh(folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    return folder


def write(path, text):
    with open(path, "w") as f:
        f.write(text)
