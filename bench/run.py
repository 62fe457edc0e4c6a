"""Time per particle and step, on one core: sph/tm with more and more effects, and LAMMPS's own smd/ulsph and
smd/tlsph on the same block. Prints a table and writes summary.json. Called by ./sphtm bench [options].

A round runs every case once; the figures are medians over the rounds, so that a busy spell hits all alike. Time is
the processor time of the run (LAMMPS's loop time times its CPU use), since wall time counts what other programs do
on the same cores; the wall time stands beside it. The speed-up of two ranks is one of wall times, within a round."""
import argparse
import json
import os
import re
import shlex
import shutil
import statistics
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
OUT = os.environ.get("SPHTM_OUT", os.path.join(os.path.dirname(HERE), "out", "bench"))
SECTIONS = ("Pair", "Neigh", "Comm", "Modify", "Other")
TITLES = {
    "elastic": "sph/tm elastic",
    "elastic linear": "sph/tm elastic, correction linear",
    "plastic": "sph/tm elastic-plastic, hardening",
    "thermo": "sph/tm Johnson-Cook, heat, conduction",
    "contact": "sph/tm the same, tool in contact",
    "machining": "sph/tm high speed machining, heat",
    "machining artstress": "sph/tm the same, former default",
    "plastic mixed": "sph/tm elastic-plastic, precision mixed",
    "plastic default": "sph/tm elastic-plastic, SSE2 loops",
    "plastic avx2": "sph/tm elastic-plastic, AVX2 loops",
    "plastic 2 ranks": "sph/tm elastic-plastic, two ranks",
    "ulsph": "smd/ulsph linear plastic",
    "tlsph": "smd/tlsph Johnson-Cook",
}
PEERS = ("ulsph", "tlsph")
# peer and the case it is held against, which has the effects of the peer and more. The host is compiled for any
# x86-64 (-O2), as LAMMPS is by default: the SSE2 loops are the comparison on equal instructions.
RATIOS = (("ulsph", "plastic"), ("ulsph", "plastic default"), ("tlsph", "thermo"), ("elastic", "elastic linear"),
          ("plastic", "plastic mixed"), ("machining", "machining artstress"))
OPTIONS = {"linear": "correction linear", "mixed": "precision mixed", "artstress": "stabilize artstress balsara yes"}    # of the pair style
MACHINING = os.path.join(os.path.dirname(HERE), "examples", "high_speed_machining")


def make_machining(steps):
    """The example, ten times as many steps as the other cases, from where the tool touches on; its script in OUT."""
    with open(os.path.join(MACHINING, "in.high_speed_machining")) as f:
        text = f.read()
    for wrong, right in (("start equal 7.02e-3", "start equal 7.0e-3"), ("run             100000", "run             %d" % (10 * steps))):
        if wrong not in text:
            sys.exit("bench: no '%s' in the example of high speed machining" % wrong)
        text = text.replace(wrong, right)
    with open(os.path.join(OUT, "in.machining"), "w") as f:
        f.write(re.sub(r"^(dump|dump_modify|write_dump) .*\n", "", text, flags=re.M))
    shutil.copy(os.path.join(MACHINING, "insert.stl"), OUT)



def command(case, mesh, steps, n):
    """Arguments and environment of one run."""
    environment = dict(os.environ, OMP_NUM_THREADS="1")
    ranks = shlex.split(os.environ.get("SPHTM_MPIRUN", "mpirun")) + ["-np", "2"] if "2 ranks" in case else []
    if case in PEERS:
        environment.pop("LAMMPS_PLUGIN_PATH", None)
        lmp, script, more = os.environ["SPHTM_LMP_MACHDYN"], "in.machdyn", ["-var", "case", case]
    else:
        words = case.split()
        lmp, script, more = os.environ["SPHTM_LMP"], "in.block", ["-var", "case", words[0], "-var", "mesh", mesh]
        if words[0] == "machining":
            script, more = os.path.join(OUT, "in.machining"), []
        if words[-1] in OPTIONS:
            more += ["-var", "options", OPTIONS[words[-1]]]
        if words[-1] in ("default", "avx2"):
            environment["SPHTM_ISA"] = words[-1]
    return ranks + [lmp, "-nocite", "-log", "none", "-in", os.path.join(HERE, script), "-var", "steps", str(steps),
                    "-var", "n", str(n)] + more, environment


def run(case, mesh, steps, n):
    arguments, environment = command(case, mesh, steps, n)
    done = subprocess.run(arguments, cwd=OUT, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                          stdin=subprocess.DEVNULL, text=True, timeout=1800)
    text = done.stdout
    loop = re.search(r"Loop time of (\S+) on \d+ procs for (\d+) steps with (\d+) atoms", text)
    if done.returncode or not loop:
        sys.exit("%s\n%s\nfailed: %s" % (text[-4000:], case, shlex.join(arguments)))
    seconds, done_steps, atoms = float(loop[1]), int(loop[2]), int(loop[3])
    usage = float(re.search(r"([\d.]+)% CPU use", text)[1]) / 100
    table = re.findall(r"^ +\d+ +\S.*$", text[:loop.start()], re.M)
    names = re.findall(r"^ +Step .*$", text, re.M)[-1].split()
    last = dict(zip(names, table[-1].split()))
    shares = {s: float(m[1]) for s in SECTIONS for m in [re.search(r"^%s +\|.*\| +([\d.]+)$" % s, text, re.M)] if m}
    builds = re.search(r"Neighbor list builds = (\d+)", text)
    loops = re.search(r"rate loops: (\w+)", text)
    neighbors = last.get("f_body[12]", last.get("c_mean", "nan"))
    return {"wall_ns": seconds * 1e9 / atoms / done_steps, "cpu_ns": seconds * usage * 1e9 / atoms / done_steps,
            "particles": atoms, "steps": done_steps, "neighbors": float(neighbors), "shares": shares,
            "contacts": float(last.get("f_tool[12]", 0)), "builds": int(builds[1]) if builds else None,
            "loops": loops[1] if loops else None}


def median_of(rounds):
    result = dict(rounds[-1])
    for key in "wall_ns", "cpu_ns":
        values = [r[key] for r in rounds]
        result[key] = statistics.median(values)
        result[key + "_all"] = [round(v, 1) for v in values]
    result["shares"] = {s: statistics.median(r["shares"].get(s, 0.0) for r in rounds) for s in rounds[0]["shares"]}
    return result


def processor():
    try:
        with open("/proc/cpuinfo") as f:
            return re.search(r"model name\s*: (.*)", f.read())[1]
    except (OSError, TypeError):
        return "unknown"


def progress(text):
    if sys.stderr.isatty():
        print("\r%-60s\r%s" % ("", text), end="", file=sys.stderr, flush=True)


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0],
                                      formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    options.add_argument("--rounds", type=int, default=5, help="runs of each case")
    options.add_argument("--steps", type=int, default=100, help="steps of a run")
    options.add_argument("--n", type=int, default=30, help="particles along an edge of the block")
    options.add_argument("--cases", nargs="+", choices=TITLES, default=list(TITLES), help="what to run", metavar="CASE")
    options = options.parse_args()
    if not os.environ.get("SPHTM_LMP"):
        sys.exit("bench: no SPHTM_LMP in the environment; run ./sphtm bench")
    cases = [c for c in TITLES if c in options.cases]
    if not os.environ.get("SPHTM_LMP_MACHDYN"):
        cases = [c for c in cases if c not in PEERS]
        print("no SPHTM_LMP_MACHDYN: without smd/ulsph and smd/tlsph")
    os.makedirs(OUT, exist_ok=True)
    mesh = os.path.join(OUT, "tool.stl")
    subprocess.run([sys.executable, os.path.join(os.path.dirname(HERE), "tools", "make_tool.py"), "block", "--size",
                    "40", "40", "10", "--cells", "20", "20", "5", "--scale", "1e-3", "-o", mesh], check=True,
                   stdout=subprocess.DEVNULL)

    make_machining(options.steps)
    load = [os.getloadavg()[0]]
    rounds = {c: [] for c in cases}
    for k in range(options.rounds):
        for c in cases:
            progress("round %d of %d: %s" % (k + 1, options.rounds, TITLES[c]))
            rounds[c].append(run(c, mesh, options.steps, options.n))
        load.append(os.getloadavg()[0])
    progress("")

    results = {c: median_of(rounds[c]) for c in cases}
    summary = {"processor": processor(), "cores": os.cpu_count(), "load_average": [round(x, 2) for x in load],
               "rounds": options.rounds, "cases": results, "ratios": {}}
    for peer, own in RATIOS:
        if peer in results and own in results:
            summary["ratios"]["%s / %s" % (peer, own)] = results[peer]["cpu_ns"] / results[own]["cpu_ns"]
    if "plastic" in results and "plastic 2 ranks" in results:
        summary["speed_up_2_ranks"] = statistics.median(
            a["wall_ns"] / b["wall_ns"] for a, b in zip(rounds["plastic"], rounds["plastic 2 ranks"]))
    with open(os.path.join(OUT, "summary.json"), "w") as f:
        json.dump(summary, f, indent=1)
        f.write("\n")
    report(summary)


def report(summary):
    results = summary["cases"]
    any_case = next(iter(results.values()))
    print("%s, %d cores; %d particles, %d steps, medians of %d rounds; load average %.1f to %.1f" %
          (summary["processor"], summary["cores"], any_case["particles"], any_case["steps"], summary["rounds"],
           min(summary["load_average"]), max(summary["load_average"])))
    print("%-38s %9s %9s %9s  %-7s %s" % ("ns per particle and step", "processor", "wall", "neighbors", "loops",
                                           "  ".join(SECTIONS) + " (%)"))
    for c, r in results.items():
        print("%-38s %9.0f %9.0f %9.2f  %-7s %s" % (
            TITLES[c], r["cpu_ns"], r["wall_ns"], r["neighbors"], r["loops"] or "-",
            "  ".join("%*.1f" % (len(s), r["shares"].get(s, 0.0)) for s in SECTIONS)))
    for name, ratio in summary["ratios"].items():
        print("%-38s %9.2f times the processor time" % (name, ratio))
    if "speed_up_2_ranks" in summary:
        print("%-38s %9.2f times as fast" % ("two ranks", summary["speed_up_2_ranks"]))
    if max(summary["load_average"]) > summary["cores"] + 1:
        print("The machine was busy with other work: wall times and the speed-up of two ranks say little.")
    print("written to", os.path.join(OUT, "summary.json"))


if __name__ == "__main__":
    main()
