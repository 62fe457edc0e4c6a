"""The work of a bundle for a machine with a GPU:  run test | bench | profile [--gpus N] [--out FOLDER] [NAME...]

test     small versions of the scenes against results of the plain styles on a CPU, particle by particle, each run twice
bench    time per particle and step of large scenes, and copies between host and device in a step
profile  table of kernels of a large scene; with counters of the hardware where there is ncu

Each writes summary.json into its folder. Names choose among the scenes or cases. './run reference', used where the
bundle is made, writes the expected results."""
import argparse
import gzip
import json
import math
import os
import shlex
import shutil
import subprocess
import sys
import time

import cases
import scenes

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.environ.get("SPHTM_BUNDLE", os.path.dirname(os.path.dirname(HERE)))
DEVICES = os.environ.get("SPHTM_DEVICES", "cuda")

# Another machine adds in another order, with or without fused multiply-add: each step differs by some 1e-16 of the sums of
# a row, and motion, contact and yield magnify that. On one CPU the loops for AVX-512 and those of any x86-64 come out at most
# 2.5e-11 apart after these steps (block_on_slope); a GPU is given forty times that.
BOUND = 1e-9


def kokkos_arguments(gpus):
    if DEVICES == "plain":
        return []
    return ["-k", "on", "g" if DEVICES == "cuda" else "t", str(gpus if DEVICES == "cuda" else 2), "-sf", "kk"]


def lammps(folder, arguments, gpus=1, environment=None, timeout=590, before=()):
    """Runs lmp in the folder; its output, and its status or 'timeout'."""
    ranks = shlex.split(os.environ.get("SPHTM_MPIRUN", "mpirun")) + ["-np", str(gpus)] if gpus > 1 else []
    command = list(before) + ranks + [os.environ["SPHTM_LMP"], "-nocite", "-log", "none"] + kokkos_arguments(gpus)
    try:
        done = subprocess.run(command + arguments, cwd=folder, env=dict(os.environ, **(environment or {})), timeout=timeout,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    except subprocess.TimeoutExpired as late:
        return (late.stdout or b"").decode(errors="replace"), "timeout"
    return done.stdout, done.returncode


def fresh(folder):
    shutil.rmtree(folder, ignore_errors=True)
    os.makedirs(folder)
    return folder


def run_scene(name, folder, gpus):
    """One small scene in a fresh folder with the files beside its script; seconds and what went wrong, or ''."""
    script, _, steps = scenes.SCENES[name]
    source = os.path.join(TOP, "scenes", name)
    fresh(folder)
    for entry in os.listdir(source):
        shutil.copy(os.path.join(source, entry), folder)
    with open(os.path.join(folder, os.path.basename(script))) as f:
        text = scenes.small_script(f.read(), steps)
    with open(os.path.join(folder, "in.small"), "w") as f:
        f.write(text)
    start = time.time()
    output, status = lammps(folder, ["-in", "in.small"] + scenes.variables(name, folder), gpus)
    with open(os.path.join(folder, "output"), "w") as f:
        f.write(output)
    return time.time() - start, "" if status == 0 else cases.failure(output, status)


def reference(out, names):
    """Expected results, beside the scenes."""
    os.makedirs(os.path.join(TOP, "expected"), exist_ok=True)
    for name in names:
        seconds, error = run_scene(name, os.path.join(out, name), 1)
        if error:
            sys.exit("%s: %s" % (name, error))
        with open(os.path.join(out, name, scenes.STATE), "rb") as f, \
                gzip.open(os.path.join(TOP, "expected", name + ".gz"), "wb") as g:
            g.write(f.read())
        print("%-22s %6.1f s" % (name, seconds), flush=True)


def test(out, names, gpus):
    results, failed = [], 0
    for name in names:
        folder = os.path.join(out, name)
        seconds, error = run_scene(name, folder, gpus)
        result = {"scene": name, "steps": scenes.SCENES[name][2], "seconds": round(seconds, 2)}
        if not error:
            rows = scenes.read_state(os.path.join(folder, scenes.STATE))
            worst = scenes.differences(rows, scenes.read_state(os.path.join(TOP, "expected", name + ".gz")))
            result.update(particles=len(rows), differences=worst)
            if worst is None:
                error = "other particles than expected"
            elif not all(d <= BOUND for d in worst.values()):    # NaN is no <= either
                error = "differs by %.1e, allowed %.0e" % (max(worst.values(), key=lambda d: math.inf if d != d else d), BOUND)
            _, trouble = run_scene(name, folder + ".again", gpus)
            with open(os.path.join(folder, scenes.STATE), "rb") as f:
                first = f.read()
            again = os.path.join(folder + ".again", scenes.STATE)
            result["same_again"] = not trouble and open(again, "rb").read() == first
            if not result["same_again"]:
                error += ("; " if error else "") + "a second run is not the same bit for bit"
        result["error"] = error
        failed += bool(error)
        results.append(result)
        worst = result.get("differences")
        print("%-6s %-22s %6.1f s  %s" % ("FAILED" if error else "ok", name, seconds, error or
              "largest difference %.1e, twice the same" % max(worst.values())), flush=True)
    print("%d passed, %d failed" % (len(names) - failed, failed))
    return {"bound": BOUND, "passed": len(names) - failed, "failed": failed, "scenes": results}, failed


def bench(out, names, gpus):
    results, failed = [], 0
    print("%-28s %10s %6s %9s %9s   %s" % ("case", "particles", "neigh", "ns/p-step", "ms/step", "pair modify neigh comm other  copies/step"))
    for name in names:
        result = cases.run(name, fresh(os.path.join(out, name)), TOP, lambda *a, **k: lammps(*a, gpus=gpus, **k))
        results.append(result)
        if "error" in result:
            failed += 1
            print("%-28s FAILED: %s" % (name, result["error"]), flush=True)
            continue
        print("%-28s %10d %6.0f %9.3f %9.3f   %s  %s" % (
            name, result["particles"], result["neighbors"], result["ns_per_particle_step"], result["ms_per_step"],
            " ".join("%4.0f%%" % result["share"].get(s, 0) for s in cases.SECTIONS),
            "%.2f" % result["copies_per_step"] if result.get("copies_per_step") is not None else "-"), flush=True)
    return {"gpus": gpus, "cases": results}, failed


def profile(out, names, gpus):
    results = []
    for name in names:
        result = cases.profile(name, fresh(os.path.join(out, name)), TOP, lambda *a, **k: lammps(*a, gpus=gpus, **k))
        results.append(result)
        if "error" in result:
            print("%s FAILED: %s" % (name, result["error"]))
            continue
        print("\n%s: %d particles, %d steps\n%8s %10s %10s  %s" % (name, result["particles"], result["steps"],
                                                                  "share", "launches", "us each", "kernel"))
        for k in result["kernels"][:25]:
            print("%7.1f%% %10d %10.2f  %s" % (k["share"], k["launches"], k["us"], k["name"][:110]))
        print("counters: %s" % (result.get("counters") or result.get("no_counters")), flush=True)
    return {"gpus": gpus, "cases": results}, sum("error" in r for r in results)


def machine():
    """What the figures were measured on."""
    answer = {"devices": DEVICES, "cores": os.cpu_count()}
    if shutil.which("nvidia-smi"):
        done = subprocess.run(["nvidia-smi", "--query-gpu=name,driver_version,memory.total", "--format=csv,noheader"],
                              stdout=subprocess.PIPE, text=True)
        answer["gpus"] = done.stdout.split("\n")[:-1]
    built = os.path.join(TOP, "version")
    if os.path.isfile(built):
        with open(built) as f:
            answer["built_from"] = f.read().strip()
    return answer


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=("test", "bench", "profile", "reference"))
    parser.add_argument("names", nargs="*")
    parser.add_argument("--gpus", type=int, default=1)
    parser.add_argument("--out")
    options = parser.parse_intermixed_args()
    known = {"test": list(scenes.SCENES), "reference": list(scenes.SCENES), "bench": list(cases.CASES),
             "profile": list(cases.CASES)}[options.what]
    wrong = [name for name in options.names if name not in known]
    if wrong:
        sys.exit("no %s; there are: %s" % (" ".join(wrong), " ".join(known)))
    names = options.names or (known if options.what != "profile" else ["3d_contact_1m"])
    out = os.path.abspath(options.out or os.path.join("out", options.what))
    os.makedirs(out, exist_ok=True)
    if options.what == "reference":
        return reference(out, names)
    summary, failed = {"test": test, "bench": bench, "profile": profile}[options.what](out, names, options.gpus)
    with open(os.path.join(out, "summary.json"), "w") as f:
        json.dump(dict({"what": options.what, "machine": machine()}, **summary), f, indent=1)
        f.write("\n")
    print("written to " + os.path.join(out, "summary.json"))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
