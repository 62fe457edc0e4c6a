"""Two builds of the plugin in turn on the block of in.block, on one core: the median of the ratios of their loop times.

    SPHTM_LMP=<lmp> python3 pairs.py OLD NEW [ROUNDS]      folders of the two sphtmplugin.so; 11 rounds"""
import os
import re
import statistics
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
N, STEPS = 24, 150


def seconds(plugin, case, instructions):
    environment = dict(os.environ, LAMMPS_PLUGIN_PATH=plugin, OMP_NUM_THREADS="1", SPHTM_ISA=instructions)
    command = ["taskset", "-c", "0", os.environ["SPHTM_LMP"], "-nocite", "-log", "none", "-in", os.path.join(HERE, "in.block"),
               "-var", "case", case, "-var", "n", str(N), "-var", "steps", str(STEPS)]
    output = subprocess.run(command, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True).stdout
    loop = re.search(r"Loop time of (\S+) on", output)
    if not loop:
        sys.exit(output[-2000:] + "\nfailed: " + " ".join(command))
    return float(loop[1])


def main():
    if len(sys.argv) < 3 or "SPHTM_LMP" not in os.environ:
        sys.exit(__doc__)
    old, new = (os.path.abspath(p) for p in sys.argv[1:3])
    rounds = int(sys.argv[3]) if len(sys.argv) > 3 else 11
    for instructions in ("avx512", "avx2"):
        for case in ("elastic", "plastic", "thermo"):
            times = [(seconds(old, case, instructions), seconds(new, case, instructions)) for _ in range(rounds)]
            ratio = [b / a for a, b in times]
            print("%-8s %-8s %5.0f -> %5.0f ns per particle-step, ratio %.3f, from %.3f to %.3f" % (
                instructions, case, *(1e9 * statistics.median(t) / (N ** 3 * STEPS) for t in zip(*times)),
                statistics.median(ratio), min(ratio), max(ratio)), flush=True)


main()
