"""The work of a bundle for a machine with a GPU:

    run test | sanitize | bench | profile [--gpus N] [--out FOLDER] [NAME...]

test      small versions of the scenes against results of the plain styles on a CPU, particle by particle, each run
          twice; what stops a run ('stops'); the physics headers by themselves on the device ('headers')
sanitize  the same under compute-sanitizer, memcheck and racecheck, a few steps each
bench     time per particle and step of large scenes, and copies between host and device in a step
profile   tables of kernels and of memory of a large scene; with counters of the hardware where there is ncu

Each writes summary.json into its folder. Names choose among the scenes or cases; --jobs runs that many tests at a time.
'./run reference', used where the bundle is made, writes the expected results."""
import argparse
import json
import os
import shutil
import subprocess
import sys

import cases
import scenes
import tests
from host import DEVICES, TOP, fresh, lammps


def bench(out, names, gpus):
    results, failed = [], 0
    print("%-28s %-9s %10s %6s %9s %9s   %s" % ("case", "precision", "particles", "neigh", "ns/p-step", "ms/step",
        "pair modify neigh comm other  copies/step  of particle data, bytes"))
    for name in names:
        result = cases.run(name, fresh(os.path.join(out, name)), TOP, lambda *a, **k: lammps(*a, gpus=gpus, **k))
        results.append(result)
        if "error" in result:
            failed += 1
            print("%-28s FAILED: %s" % (name, result["error"]), flush=True)
            continue
        data = result.get("particle_data")
        print("%-28s %-9s %10d %6.0f %9.3f %9.3f   %s  %s  %s" % (
            name, result["precision"], result["particles"], result["neighbors"], result["ns_per_particle_step"],
            result["ms_per_step"], " ".join("%4.0f%%" % result["share"].get(s, 0) for s in cases.SECTIONS),
            "%.2f" % result["copies_per_step"] if data else "-",
            "%(copies_per_step).2f, %(bytes_per_step).0f" % data if data else "-"), flush=True)
        if "runs" in result:
            print("  %(runs)d runs, %(jobs)d at once: %(seconds).1f s, %(times_alone).2f times one alone" % result, flush=True)
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
        for space, of in sorted(result["memory"].items(), key=lambda item: -item[1]["all"]):
            if of["all"] < 1e3 * result["particles"] / 8:
                continue
            print("bytes per particle in %s when it was fullest:" % space)
            for what, size in list(of.items())[:25]:
                print("%9.1f  %s" % (size / result["particles"], what))
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
    parser.add_argument("what", choices=("test", "sanitize", "bench", "profile", "reference"))
    parser.add_argument("names", nargs="*")
    parser.add_argument("--gpus", type=int, default=1)
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--out")
    options = parser.parse_intermixed_args()
    small = [tests.HEADERS, tests.STOPS] + list(scenes.SCENES)
    known = {"bench": list(cases.CASES) + list(cases.SEVERAL), "profile": list(cases.CASES)}.get(options.what, small)
    wrong = [name for name in options.names if name not in known]
    if wrong:
        sys.exit("no %s; there are: %s" % (" ".join(wrong), " ".join(known)))
    names = options.names or ([k for k in known if k not in cases.LARGE] if options.what != "profile" else ["3d_contact_1m"])
    out = os.path.abspath(options.out or os.path.join("out", options.what))
    os.makedirs(out, exist_ok=True)
    if options.what == "reference":
        return tests.reference(out, names)
    if options.what == "test":
        summary, failed = tests.test(out, names, options.gpus, options.jobs)
    elif options.what == "sanitize":
        summary, failed = tests.sanitize(out, names, options.jobs)
    else:
        summary, failed = {"bench": bench, "profile": profile}[options.what](out, names, options.gpus)
    with open(os.path.join(out, "summary.json"), "w") as f:
        json.dump(dict({"what": options.what, "machine": machine()}, **summary), f, indent=1)
        f.write("\n")
    print("written to " + os.path.join(out, "summary.json"))
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
