"""Large scenes for the bench and the profile on a GPU."""
import concurrent.futures
import csv
import os
import re
import shutil
import sys
import time

import scenes
from host import HERE, kokkos_arguments

sys.path.append(os.path.dirname(HERE))
from shared_gpu import shared_gpu                                                      # noqa: E402

SECTIONS = ("Pair", "Modify", "Neigh", "Comm", "Other")
# scenes whose scripts are used
BLOCK, CUT, MACHINING, TURNING = "contact", "orthogonal_cut_2d", "high_speed_machining", "turning"

# name: scene, variables, steps, (pattern, replacement) pairs for its script, whether copies are counted
WIDE = (r"hyperbolic 1\.2", "hyperbolic 1.7")          # 164 neighbors in 3D
WIDE_2D = (r"hyperbolic 1\.2", "hyperbolic 1.48")      # 27 in 2D
# the tool touches from the first step on
MACHINING_HERE = ((r"start equal 7\.02e-3", "start equal 7.0e-3"),)
# effects that no usual loop has
BALSARA = (r"(hyperbolic 1\.2 .*)", r"\1 balsara yes")
XSPH = (r"(hyperbolic 1\.2 .*)", r"\1 xsph 0.1")
# without second order at free faces
LINEAR = (r"(hyperbolic 1\.2 .*)", r"\1 correction linear")
AIR = (r"(fix +body .*\n)", r"\1fix air all sph/tm/heat convection 100 293\n")
CASES = {
    "3d_contact_1m": (BLOCK, {"case": "contact", "n": 100, "mesh": "tool.stl"}, 300, (), True),
    "3d_contact_8m": (BLOCK, {"case": "contact", "n": 200, "mesh": "tool.stl"}, 100, (), False),
    "3d_contact_1m_164": (BLOCK, {"case": "contact", "n": 102, "mesh": "tool.stl"}, 100, (WIDE,), False),
    "3d_thermo_1m": (BLOCK, {"case": "thermo", "n": 100}, 300, (), False),
    "3d_thermo_1m_balsara": (BLOCK, {"case": "thermo", "n": 100}, 300, (BALSARA,), False),
    "3d_thermo_1m_xsph": (BLOCK, {"case": "thermo", "n": 100}, 300, (XSPH,), False),
    "3d_thermo_1m_air": (BLOCK, {"case": "thermo", "n": 100}, 300, (AIR,), False),
    "3d_plastic_1m": (BLOCK, {"case": "plastic", "n": 100}, 300, (), False),
    "3d_elastic_1m": (BLOCK, {"case": "elastic", "n": 100}, 300, (), False),
    "3d_elastic_1m_linear": (BLOCK, {"case": "elastic", "n": 100}, 300, (LINEAR,), False),
    "2d_cut_1400k": (CUT, {"dx": 5.83e-7}, 300, (WIDE_2D,), True),
    "2d_cut_197k": (CUT, {"dx": 1.561e-6}, 1000, (WIDE_2D,), False),
    "2d_cut_7600": (CUT, {"dx": 7.95e-6}, 10000, (WIDE_2D,), True),
    "hsm_147k": (MACHINING, {"dp": 1e-4}, 1000, MACHINING_HERE, True),
    "hsm_1160k": (MACHINING, {"dp": 5e-5}, 300, MACHINING_HERE, False),
    "hsm_147k_mixed": (MACHINING, {"dp": 1e-4}, 1000, MACHINING_HERE, False),
    "3d_contact_1m_mixed": (BLOCK, {"case": "contact", "n": 100, "mesh": "tool.stl"}, 300, (), False),
    "3d_contact_1m_164_mixed": (BLOCK, {"case": "contact", "n": 102, "mesh": "tool.stl"}, 100, (WIDE,), False),
    "2d_cut_1400k_mixed": (CUT, {"dx": 5.83e-7}, 300, (WIDE_2D,), False),
    # what sleeps, and the same with all particles
    "turning_1900k": (TURNING, {"dx": 20e-6}, 300, (), True),
    "turning_1900k_all": (TURNING, {"dx": 20e-6, "active": "no"}, 300, (), False),
    "turning_30k": (TURNING, {}, 2000, (), False),
    "turning_30k_all": (TURNING, {"active": "no"}, 2000, (), False),
    "hsm_1160k_active": (MACHINING, {"dp": 5e-5, "body": "active near 1e-3 speed 5"}, 300, MACHINING_HERE, False),
    "lj_4m": (None, {}, 200, (), False),
}

# run only when named: what fits on a card
LARGE = {"3d_contact_%dm" % (n ** 3 // 1000000): (BLOCK, {"case": "contact", "n": n, "mesh": "tool.stl"}, 20, (), False)
         for n in (320, 340, 360, 380, 400, 420)}
CASES.update(LARGE)

# so many runs of a case, so many at once
SEVERAL = {"2d_cut_7600_x12": ("2d_cut_7600", 12, 12), "2d_cut_7600_x48": ("2d_cut_7600", 48, 16)}

LJ = """# LAMMPS's own lj/cut on as many neighbors, rebuilt every 20 steps: what the machine and the host can do
units           lj
atom_style      atomic
lattice         fcc 0.8442
region          box block 0 100 0 100 0 100
create_box      1 box
create_atoms    1 box
mass            1 1.0
velocity        all create 1.44 87287 loop geom
pair_style      lj/cut 2.5
pair_coeff      1 1 1.0 1.0 2.5
neighbor        0.3 bin
neigh_modify    every 20 delay 0 check no
fix             1 all nve
thermo          100
run             100
"""


def prepare(name, folder, top, steps):
    """The case's script with its runs of so many steps, and the files it reads, in the folder; its arguments."""
    scene, variables, _, changes, _ = CASES[name]
    text = LJ
    if scene:
        source = os.path.join(top, "scenes", scene)
        for entry in os.listdir(source):
            shutil.copy(os.path.join(source, entry), folder)
        script = [entry for entry in os.listdir(source) if entry.startswith("in.")][0]
        with open(os.path.join(source, script)) as f:
            text = f.read()
    for pattern, replacement in changes:
        text, count = re.subn(pattern, replacement, text)
        if not count:
            raise SystemExit("%s: nothing in %s matches %s" % (name, scene, pattern))
    if scenes.precision(name) == "mixed":
        text = scenes.in_mixed(text)
    text = re.sub(r"^(dump|dump_modify|write_dump)\b.*\n", "", text, flags=re.M)
    text = re.sub(r"^run(\s+)(?!0\b)\S+", lambda m: "run%s%d" % (m[1], steps), text, flags=re.M)
    with open(os.path.join(folder, "in.case"), "w") as f:
        f.write(text)
    return ["-in", "in.case"] + [word for key, value in variables.items() for word in ("-var", key, str(value))]


def figures(output):
    """What LAMMPS says about a run: time, particles, neighbors in its lists (with skin), share of each part."""
    loop = re.findall(r"Loop time of (\S+) on \d+ procs for (\d+) steps with (\d+) atoms", output)[-1]
    seconds, steps, particles = float(loop[0]), int(loop[1]), int(loop[2])
    neighbors = re.findall(r"Ave neighs/atom = (\S+)", output)
    share = {}
    for line in output[output.rindex("Loop time of"):].splitlines():
        words = [word.strip() for word in line.split("|")]
        if words[0] in SECTIONS and len(words) >= 6 and words[-1]:
            share[words[0]] = float(words[-1])
    builds = re.findall(r"Neighbor list builds = (\d+)", output)
    return {"particles": particles, "steps": steps, "neighbors": float(neighbors[-1]) if neighbors else None,
            "builds": int(builds[-1]) if builds else None, "ms_per_step": 1e3 * seconds / steps,
            "ns_per_particle_step": 1e9 * seconds / steps / particles, "share": share}


def read_table(path):
    """Rows of kernel_table.c: kind, name, calls, seconds, bytes."""
    with open(path) as f:
        rows = [line.rstrip("\n").split("\t") for line in f]
    return [(kind, name, int(calls), float(seconds), int(size)) for kind, name, calls, seconds, size in rows]


def tool_environment(folder, top):
    table = os.path.join(folder, "kernels.tsv")
    return {"KOKKOS_TOOLS_LIBS": os.path.join(top, "lib", "libkernel_table.so"), "SPHTM_KERNEL_TABLE": table}, table


def launches(name, folder, top, lammps, steps, particles):
    """What a run of so many steps launches and copies between memories: name -> (number, bytes); the copies of data of
    particles by step: how many of them -> (steps, bytes)."""
    environment, table = tool_environment(folder, top)
    environment.update(SPHTM_LARGE_COPY=str(particles), SPHTM_STEP_KERNEL="sph/tm rates")
    output, status = lammps(folder, prepare(name, folder, top, steps), environment=environment)
    if status != 0 or not os.path.isfile(table):
        return None
    counts = {"kernel": {}, "copy": {}, "data": {}, "step": {}}
    for kind, what, calls, _, size in read_table(table):
        if kind in ("fill", "memory"):
            continue
        if kind in ("kernel", "step") or len(set(what.split(":")[0].split(" <- "))) == 2:
            counts[kind][what] = (calls, size)
    return counts


def transfers(short, long, steps):
    """What a longer run has more than a shorter one belongs to its steps."""
    more = {kind: {k: (n[0] - short[kind].get(k, (0, 0))[0], n[1] - short[kind].get(k, (0, 0))[1])
                   for k, n in rows.items()}
            for kind, rows in long.items()}
    more = {kind: {k: n for k, n in rows.items() if n[0] > 0} for kind, rows in more.items()}

    def sum_of(kind, place):
        return sum(n[place] for n in more[kind].values())

    return {"launches_per_step": sum_of("kernel", 0) / steps,
            "copies_per_step": (sum_of("copy", 0) + sum_of("data", 0)) / steps,
            "copied_bytes_per_step": (sum_of("copy", 1) + sum_of("data", 1)) / steps,
            "particle_data": {"copies_per_step": sum_of("data", 0) / steps, "bytes_per_step": sum_of("data", 1) / steps,
                              "steps_by_copies": {k: n[0] for k, n in more["step"].items()},
                              "copies_of": {k: {"copies": n[0], "bytes": n[1]} for k, n in more["data"].items()}},
            "other_copies_of": {k: {"copies": n[0], "bytes": n[1]} for k, n in more["copy"].items()}}


def failure(output, status):
    """What a run that failed said."""
    said = re.findall(r"^(?:ERROR|.*\berror\b|.*\bwhat\(\)|.*\bnot found\b).*", output, re.M | re.I)
    return said[0] if said else "ended with %s: %s" % (status, " ".join(output.split()[-20:]))


def run_several(name, folder, top, lammps):
    """All runs of a study, and one alone, in wall time with start and end."""
    case, count, jobs = SEVERAL[name]
    steps = CASES[case][2]

    def one(k):
        place = os.path.join(folder, str(k))
        os.makedirs(place)
        began = time.time()
        output, status = lammps(place, prepare(case, place, top, steps))
        return output, status, time.time() - began

    output, status, alone = one("alone")
    began = time.time()
    with shared_gpu(jobs, " ".join(kokkos_arguments(1))) as service, concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        done = list(pool.map(one, range(count)))
    seconds = time.time() - began
    failed = [failure(o, s) for o, s, _ in done + [(output, status, alone)] if s != 0 or "Loop time of" not in o]
    if failed:
        return {"case": name, "error": failed[0]}
    result = dict({"case": name, "precision": "double"}, **figures(output))
    result.update(runs=count, jobs=jobs, service=service, seconds=seconds, seconds_alone=alone, times_alone=seconds / alone,
                  ms_per_step=1e3 * seconds / steps / count)
    result["ns_per_particle_step"] = 1e6 * result["ms_per_step"] / result["particles"]
    return result


def run(name, folder, top, lammps):
    if name in SEVERAL:
        return run_several(name, folder, top, lammps)
    steps = CASES[name][2]
    output, status = lammps(folder, prepare(name, folder, top, steps))
    with open(os.path.join(folder, "output"), "w") as f:
        f.write(output)
    if status != 0 or "Loop time of" not in output:
        return {"case": name, "error": failure(output, status)}
    result = dict({"case": name, "precision": scenes.precision(name)}, **figures(output))
    if CASES[name][4]:
        short, long = (launches(name, folder, top, lammps, n, result["particles"]) for n in (20, 120))
        if short and long:
            result.update(transfers(short, long, 100))
    return result


METRICS = ("gpu__time_duration.sum", "dram__bytes.sum.per_second", "lts__t_bytes.sum.per_second",
           "smsp__sass_thread_inst_executed_op_dadd_pred_on.sum", "smsp__sass_thread_inst_executed_op_dmul_pred_on.sum",
           "smsp__sass_thread_inst_executed_op_dfma_pred_on.sum", "launch__registers_per_thread", "launch__block_size",
           "sm__warps_active.avg.pct_of_peak_sustained_active")


def counters(name, folder, top, lammps):
    """Rows of ncu for the launches of some steps after the start: kernel, metric, unit, value."""
    ncu = shutil.which("ncu")
    if not ncu:
        return None, "no ncu here"
    path = os.path.join(folder, "counters.csv")
    before = [ncu, "--csv", "--log-file", path, "--clock-control", "none", "--target-processes", "all",
              "--launch-skip", "300", "--launch-count", "60",
              "--metrics", ",".join(METRICS)]
    output, status = lammps(folder, prepare(name, folder, top, 60), before=before)
    if status != 0 or not os.path.isfile(path):
        return None, "ncu: " + failure(output, status)
    with open(path, newline="") as f:
        lines = [line for line in f if not line.startswith("==")]
    kernels = {}
    for row in csv.DictReader(lines):
        try:
            value = float(row["Metric Value"].replace(",", ""))
        except (KeyError, ValueError):
            continue
        metric = row["Metric Name"] + " " + row["Metric Unit"]
        kernels.setdefault(row["Kernel Name"], {}).setdefault(metric, []).append(value)
    return [{"name": k, "metrics": {m: sum(v) / len(v) for m, v in metrics.items()}}
            for k, metrics in kernels.items()], ""


def memory_table(rows):
    """Bytes by what they are for, when the fullest memory was fullest; host and pinned memory apart from a GPU's."""
    spaces = {}
    for _, name, _, _, size in rows:
        space, what = name.split(": ", 1)
        if size:
            spaces.setdefault(space, {})[what] = size
    return {space: dict(sorted(of.items(), key=lambda item: -item[1])) for space, of in spaces.items()}


def profile(name, folder, top, lammps, steps=100):
    environment, table = tool_environment(folder, top)
    output, status = lammps(folder, prepare(name, folder, top, steps), environment=environment)
    with open(os.path.join(folder, "output"), "w") as f:
        f.write(output)
    if status != 0 or not os.path.isfile(table):
        return {"case": name, "error": failure(output, status)}
    rows = read_table(table)
    memory = memory_table([r for r in rows if r[0] == "memory"])
    rows = [r for r in rows if r[0] != "memory"]
    total = sum(r[3] for r in rows) or 1
    kernels = [{"name": n, "kind": kind, "launches": calls, "us": 1e6 * seconds / max(calls, 1),
                "share": 100 * seconds / total,
                "bytes": size} for kind, n, calls, seconds, size in sorted(rows, key=lambda r: -r[3])]
    result = dict({"case": name}, **figures(output), kernels=kernels, memory=memory)
    result["counters"], result["no_counters"] = counters(name, folder, top, lammps)
    return result
