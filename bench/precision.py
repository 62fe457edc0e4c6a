"""What pair arithmetic in single costs in accuracy and gains in time: every scene test with a reference number, run
with 'precision double' and 'precision mixed', side by side, and the block of ./sphtm bench in both.

    eval "$(./sphtm env)"; python3 bench/precision.py [--out FOLDER] [--rounds N] [TEST...]

Writes precision.csv (one row for each comparison of a test: value and error in double and in mixed, the tolerance of
the test) and prints a table of the quantities that have a reference; TEST is the name of a test without test_ and
.py."""
import argparse
import csv
import os
import re
import statistics
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
TOP = os.path.dirname(HERE)
TESTS = ("oscillating_plate", "taylor_bar", "tensile_cylinder", "rings", "heat_two_layer", "heat_friction",
         "heat_contact",
         "contact_slope", "contact_books", "machining_small", "spinning_block", "time_order", "reference_rates")
CASES = ("elastic", "plastic", "thermo", "contact")
NEAR = re.compile(r"^(\S+) against (\S+), off by (\S+?)(?: \(.*?\))?, allowed (\S+)")
LIMIT = re.compile(r"^(\S+), (allowed|at least) (\S+)$")


def lines_of(test, precision):
    """What the test says: name -> (ok, value, reference, error, limit), text where it is no comparison."""
    done = subprocess.run([sys.executable, os.path.join(TOP, "unittest", "scenes", "test_%s.py" % test)], text=True,
                          env=dict(os.environ, SPHTM_PRECISION=precision), stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)
    found, seen = {}, {}
    for line in done.stdout.splitlines():
        m = re.match(r"^(ok   |FAIL |     ) (.*)$", line)
        if not m:
            continue
        name, text = m[2][:46].rstrip(), m[2][46:].strip()
        if m[2][45:46] not in ("", " "):    # a long name goes on to the first number
            cut = re.search(r" (?=[-+]?\d[\d.e+-]*(?:,| against))", m[2])
            if not cut:
                continue
            name, text = m[2][:cut.start()].rstrip(), m[2][cut.end():]
        seen[name] = seen.get(name, 0) + 1
        if seen[name] > 1:
            name += " #%d" % seen[name]
        near, limit = NEAR.match(text), LIMIT.match(text)
        if near:
            found[name] = (m[1].strip(), *near.groups())
        elif limit:
            found[name] = (m[1].strip(), limit[1], "", "", ("<= " if limit[2] == "allowed" else ">= ") + limit[3])
        else:
            found[name] = (m[1].strip(), text, "", "", "")
    return found, done.returncode


def accuracy(tests, out):
    rows = []
    for test in tests:
        (double, _), (mixed, status) = lines_of(test, "double"), lines_of(test, "mixed")
        for name in double:
            if name in mixed:
                d, m = double[name], mixed[name]
                rows.append([test, name, d[2], d[1], m[1], d[3], m[3], m[4], m[0]])
        missing = sorted(set(double) - set(mixed))
        if missing:
            rows.append([test, "comparisons that mixed did not reach", "", "", "", "", "", "", "FAIL"])
        print("%-20s %d comparisons, mixed %s" % (test, len(double), "holds" if status == 0 else "FAILS"), flush=True)
    with open(os.path.join(out, "precision.csv"), "w", newline="") as f:
        writer = csv.writer(f)
        writer.writerow(["test", "quantity", "reference", "double", "mixed", "error double", "error mixed", "allowed",
                         "mixed within"])
        writer.writerows(rows)
    print("\n%-18s %-50s %12s %14s %14s" % ("test", "quantity", "reference", "double", "mixed"))
    for r in rows:
        if r[2] or r[8] == "FAIL":
            print("%-18s %-50s %12s %14s %14s  %s" % (r[0], r[1][:50], r[2], r[3][:14], r[4][:14], r[8]))
    return rows


def block(case, precision, mesh):
    with open(os.path.join(HERE, "in.block")) as f:
        script = re.sub(r"^(pair_style .*?)( spacing)", r"\1 precision %s\2" % precision, f.read(), flags=re.M)
    done = subprocess.run([os.environ["SPHTM_LMP"], "-nocite", "-log", "none", "-var", "case", case, "-var", "mesh",
                           mesh],
                          input=script, text=True, stdout=subprocess.PIPE, env=dict(os.environ, OMP_NUM_THREADS="1"))
    loop = re.search(r"Loop time of (\S+) on \d+ procs for (\d+) steps with (\d+) atoms", done.stdout)
    if not loop:
        sys.exit(done.stdout[-3000:])
    usage = float(re.search(r"([\d.]+)% CPU use", done.stdout)[1]) / 100
    return float(loop[1]) * usage * 1e9 / int(loop[2]) / int(loop[3])


def speed(rounds, out):
    mesh = os.path.join(out, "tool.stl")
    subprocess.run([sys.executable, os.path.join(TOP, "tools", "make_tool.py"), "block", "--size", "40", "40", "10",
                    "--cells", "20", "20", "5", "--scale", "1e-3", "-o", mesh], check=True, stdout=subprocess.DEVNULL)
    times = {(c, p): [] for c in CASES for p in ("double", "mixed")}
    for _ in range(rounds):
        for c, p in times:
            times[c, p].append(block(c, p, mesh))
    print("\nprocessor time per particle and step, ns, medians of %d rounds\n%-10s %8s %8s"
          % (rounds, "block", "double", "mixed"))
    for c in CASES:
        d, m = (statistics.median(times[c, p]) for p in ("double", "mixed"))
        print("%-10s %8.0f %8.0f   %.2f" % (c, d, m, d / m))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("tests", nargs="*", metavar="TEST")
    parser.add_argument("--out", default=os.path.join(TOP, "out", "precision"))
    parser.add_argument("--rounds", type=int, default=5, help="of the block; 0: accuracy alone")
    options = parser.parse_args()
    os.makedirs(options.out, exist_ok=True)
    accuracy(options.tests or TESTS, options.out)
    if options.rounds:
        speed(options.rounds, options.out)


if __name__ == "__main__":
    main()
