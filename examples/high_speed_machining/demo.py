#!/usr/bin/python3
"""High speed machining of AL 6082-T6 with and without heat (Fraser et al. 2015, section 4).

  demo.py [--spacing MM] [--only-analyse]

Runs in.high_speed_machining twice, side by side, then measures, compares with the paper and draws. Results
go to $SPHTM_OUT (default out/demo): summary.json, forces.csv, *.png and one folder per run.
Environment: SPHTM_LMP, LAMMPS_PLUGIN_PATH and SPHTM_MPIRUN, as './sphtm env' prints them.
"""
import argparse
import json
import os
import shlex
import subprocess
import sys
import time

sys.dont_write_bytecode = True
HERE = os.path.dirname(os.path.abspath(__file__))
sys.path[:0] = [HERE, os.path.join(HERE, "..", "..", "bench")]
import measure as M                                                                    # noqa: E402
import pictures                                                                        # noqa: E402
from provenance import provenance                                                      # noqa: E402

VARIANTS = ("heat", "no_heat")
OUT = os.environ.get("SPHTM_OUT", os.path.join(os.path.dirname(os.path.dirname(HERE)), "out", "demo"))


def start(variant, ranks, dp):
    """Starts lmp on the scene in a folder of its own."""
    lmp = os.environ.get("SPHTM_LMP")
    if not lmp:
        sys.exit("demo.py: no SPHTM_LMP in the environment; run './sphtm demo', or first eval \"$(./sphtm env)\"")
    folder = os.path.join(OUT, variant)
    os.makedirs(folder, exist_ok=True)
    for name in os.listdir(folder):
        os.remove(os.path.join(folder, name))
    command = shlex.split(os.environ.get("SPHTM_MPIRUN", "mpirun")) + ["-np", str(ranks)] if ranks > 1 else []
    command += [lmp, "-nocite", "-in", "in.high_speed_machining", "-log", os.path.join(folder, "log.lammps"),
                "-screen", "none", "-var", "heat", "yes" if variant == "heat" else "no", "-var", "out", folder,
                "-var", "dp", "%.9g" % dp]
    errors = open(os.path.join(folder, "errors.txt"), "w")
    return subprocess.Popen(command, cwd=HERE, stdout=errors, stderr=errors, stdin=subprocess.DEVNULL)


def progress(variant, length):
    """Cut length so far (m), from the last row of the history file."""
    try:
        with open(os.path.join(OUT, variant, "history.dat")) as f:
            last = f.readlines()[-1].split()
        return min(float(last[M.COLUMNS.index("cut")]) / length, 1.0) if last[0] != "#" else 0.0
    except (OSError, IndexError, ValueError):
        return 0.0


def run_all(dp):
    ranks = max(1, len(os.sched_getaffinity(0)) // len(VARIANTS))
    length = M.script_variable("cut")
    print("running both variants side by side, %d rank%s each" % (ranks, "s" if ranks > 1 else ""), flush=True)
    t0, shown = time.time(), 0.0
    jobs = {v: start(v, ranks, dp) for v in VARIANTS}
    try:
        while any(j.poll() is None for j in jobs.values()):
            time.sleep(1.0)
            if time.time() - shown > 15.0 or all(j.poll() is not None for j in jobs.values()):
                shown = time.time()
                print("%5.0f s   " % (shown - t0) + "   ".join(
                    "%-8s %3.0f %%" % (v, 100 * progress(v, length)) for v in VARIANTS), flush=True)
            for v, j in jobs.items():
                if j.poll():
                    M.fail(OUT, v)
    finally:
        for j in jobs.values():
            if j.poll() is None:
                j.terminate()
    return time.time() - t0


def table(s):
    """Measured beside published, as text."""
    h, n = s["heat"], s["no_heat"]
    rows = [("particles", "%d", "particles"), ("steps", "%d", "steps"), ("wall time (s)", "%.0f", "wall_seconds"),
            ("cut length (mm)", "%.2f", "cut_mm"),
            ("normal force, mean (N)", "%.0f", "mean_normal_force_N"),
            ("  standard deviation (N)", "%.0f", "std_normal_force_N"),
            ("  up to tool position 1.75 mm (N)", "%.0f", "mean_normal_force_to_1.75_mm_N"),
            ("tangential force, mean (N)", "%.0f", "mean_tangential_force_N"),
            ("specific cutting force (N/mm^2)", "%.0f", "specific_cutting_force_N_per_mm2"),
            ("chip thickness (mm)", "%.2f", "chip_thickness_mm"),
            ("clusters (bond 1.5 dp)", "%d", "clusters"), ("particles lost", "%d", "particles_lost"),
            ("deepest penetration (dp)", "%.3f", "deepest_penetration_dp"),
            ("maximum interface temperature, mean (C)", "%.0f", "max_interface_temperature_C"),
            ("energy error / external work", "%.1e", "energy_error_fraction")]
    text = ["%-42s %10s %10s" % ("", "heat", "no heat")]
    for title, form, key in rows:
        text.append("%-42s %10s %10s" % (title, form % h[key], form % n[key]))
    compare = [("normal force, heat / no heat, 1 to 4 mm", "%.3f", "force_ratio_heat_over_no_heat", "0.854"),
               ("  the same up to tool position 1.75 mm", "%.3f", "force_ratio_to_1.75_mm", "0.854"),
               ("tangential force, heat - no heat (N)", "%+.0f", "tangential_force_heat_minus_no_heat_N", "> 0"),
               ("chip thickness, heat / no heat", "%.3f", "chip_thickness_ratio_heat_over_no_heat", "> 1"),
               ("maximum interface temperature, mean (C)", "%.0f", "max_interface_temperature_C", "376")]
    text += ["", "%-42s %10s %10s" % ("", "measured", "F15")]
    text += ["%-42s %10s %10s" % (title, form % s[key], f15) for title, form, key, f15 in compare]
    text += ["F15 does not print its geometry; ours is chosen beforehand, see README.md"]
    return "\n".join(text)


def main():
    p = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--only-analyse", action="store_true", help="measure and draw earlier runs again")
    p.add_argument("--spacing", type=float, metavar="MM",
                   help="of the particles, in place of 0.2; with 0.5 it takes seconds and shows no more than that it runs")
    a = p.parse_args()
    usual = M.script_variable("dp")
    dp = 1e-3 * a.spacing if a.spacing is not None else usual
    if not 0.05e-3 <= dp <= 0.5e-3:
        p.error("--spacing %g: from 0.05 to 0.5 mm" % a.spacing)
    os.makedirs(OUT, exist_ok=True)
    wall = None if a.only_analyse else run_all(dp)
    runs = {v: M.Run(os.path.join(OUT, v), dp) for v in VARIANTS}
    summary = M.summary(runs)
    if wall:
        summary["wall_seconds_both"] = round(wall, 1)
        summary.update(provenance("./sphtm demo" + (" --spacing %g" % a.spacing if dp != usual else "")))
    if wall and dp == usual:
        summary["results"] = {"high_speed_machining": {k: summary[k] for k in (
            "force_ratio_to_1.75_mm", "force_ratio_heat_over_no_heat", "max_interface_temperature_C", "energy_error_fraction")}}
    with open(os.path.join(OUT, "summary.json"), "w") as f:
        json.dump(summary, f, indent=2)
        f.write("\n")
    M.write_forces(os.path.join(OUT, "forces.csv"), runs)
    pictures.draw_all(OUT, runs, summary)
    print("\n" + table(summary) + "\n\nwritten to " + OUT)


if __name__ == "__main__":
    main()
