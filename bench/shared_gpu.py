"""Several runs at once on one GPU. Without help their processes take turns of some milliseconds, and a step of a small scene has
several turns to wait for; with NVIDIA's Multi-Process Service (MPS) their kernels run side by side.

    with shared_gpu(jobs, "-k on g 1 -sf kk"): ...       starts the service for these runs, where it is there and none runs"""
import contextlib
import os
import shutil
import subprocess
import sys
import tempfile

PIPES, LOGS, VISIBLE = "CUDA_MPS_PIPE_DIRECTORY", "CUDA_MPS_LOG_DIRECTORY", "CUDA_VISIBLE_DEVICES"


def uses_gpu(arguments):
    words = arguments.split()
    return any(w in ("-k", "-kokkos") for w in words) and any(w in ("g", "gpus") for w in words)


@contextlib.contextmanager
def shared_gpu(jobs, arguments):
    """Yields whether a service of its own runs."""
    control = shutil.which("nvidia-cuda-mps-control")
    if jobs < 2 or not uses_gpu(arguments) or os.environ.get(PIPES):
        yield False
        return
    if not control:
        print("no nvidia-cuda-mps-control here: %d runs at once on one GPU wait for each other; one at a time is faster" % jobs, file=sys.stderr)
        yield False
        return
    folder = tempfile.mkdtemp(prefix="sphtm-mps-")
    os.environ.update({PIPES: folder, LOGS: folder})
    started = subprocess.run([control, "-d"], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    visible = os.environ.get(VISIBLE)
    try:
        if started.returncode:
            print("%s did not start: %s" % (control, started.stdout.strip()), file=sys.stderr)
            for name in (PIPES, LOGS):
                del os.environ[name]
        elif visible and all(word.strip().isdigit() for word in visible.split(",")):
            # the service has these GPUs alone, and to its clients they count from 0
            os.environ[VISIBLE] = ",".join(str(k) for k in range(len(visible.split(","))))
        yield not started.returncode
    finally:
        if visible is not None:
            os.environ[VISIBLE] = visible
        if not started.returncode:
            subprocess.run([control], input="quit\n", text=True, stdout=subprocess.DEVNULL, timeout=60)
            for name in (PIPES, LOGS):
                del os.environ[name]
        shutil.rmtree(folder, ignore_errors=True)
