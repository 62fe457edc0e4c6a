"""Scenes as tests: run lmp on an input script in a folder of its own, read what it wrote, compare.

    from sphtm_scene import Checks, run

    result = run(SCRIPT, {"dx": 1e-3})            # -var dx 0.001; the script uses ${dx}
    table = result.thermo[-1]                     # of the last run command: column name -> array
    frame = result.dump("final.dump")[-1]         # column name -> array, sorted by id; "step", "box"
    checks = Checks()
    checks.near("temperature", table["c_t"][-1], 284.33, relative=0.03)
    checks.end()                                  # prints a summary; the exit status says whether all hold
    lattice_block("0 8e-3 0 6e-3", "-0.02 0.02 -0.02 0.02")    # the head of a script with a block of particles

Environment: SPHTM_LMP, LAMMPS_PLUGIN_PATH, SPHTM_MPIRUN, SPHTM_SOURCE (see unittest/CMakeLists.txt or
'./sphtm env'). Without SPHTM_LMP a test is skipped. SPHTM_KEEP=1 keeps the folders of the runs. SPHTM_RECORD=FOLDER
makes every run print all digits and end with a dump of its particles, and keeps both there (tools/same-bits.sh).
"""
import atexit
import hashlib
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import threading

import numpy as np

SKIPPED = 77
np.set_printoptions(legacy="1.21")    # or from NumPy 2 on %r of a number is np.float64(...), which is no input
SOURCE = os.environ.get("SPHTM_SOURCE", os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))


# the head of a scene in SI units, in two and in three dimensions
PLANE = """
units           si
dimension       2
boundary        f f p
atom_style      atomic
newton          off
"""
SPACE = PLANE.replace("dimension       2", "dimension       3").replace("f f p", "f f f")


def lattice_block(work, box, dx="1e-3", dim=2, types=1, more=""):
    """A head, a box, and in region work particles of type 1, half a spacing within its surface. work, box: their lower
    and upper coordinates, in two dimensions x and y alone; they may be fields of str.format. more: commands that must
    stand before the box."""
    flat = dim == 2
    return (PLANE if flat else SPACE) + more + """\
lattice         %s %s origin 0.5 0.5 %s
region          box block %s units box
create_box      %d box
region          work block %s units box
create_atoms    1 region work
""" % ("sq" if flat else "sc", dx, "0" if flat else "0.5", box + " -5e-4 5e-4" * flat, types, work + " INF INF" * flat)


class Result:
    """What one run left behind."""

    def __init__(self, folder, output, status):
        self.folder, self.output, self.status = folder, output, status
        self.thermo = read_thermo(output)

    def path(self, name):
        return os.path.join(self.folder, name)

    def dump(self, name):
        return read_dump(self.path(name))

    def columns(self, name):
        """A file of numbers with '#' comments, as fix ave/time and fix print write it."""
        return np.loadtxt(self.path(name), comments="#", ndmin=2)

    def errors(self):
        """The text of LAMMPS's error message, or ''."""
        return "\n".join(re.findall(r"^ERROR.*", self.output, re.M))

    def warnings(self):
        return re.findall(r"^WARNING: (.*)", self.output, re.M)


def new_folder():
    folder = tempfile.mkdtemp(prefix="sphtm-")
    if os.environ.get("SPHTM_KEEP"):
        print("kept:", folder)
    else:
        atexit.register(shutil.rmtree, folder, ignore_errors=True)
    return folder


def run(script, variables=None, ranks=1, folder=None, files=None, expect_error=False, timeout=600, environment=None,
        arguments=()):
    """Runs lmp. script: text, or the path of an input script. variables: -var name value. files: name ->
    text, written to the run's folder first. A folder of an earlier run can be given, to read its restart
    files. environment: variables to add to this test's, SPHTM_LMP
    among them; arguments: more of lmp's. A run that fails ends the test with its output, unless
    expect_error."""
    environment = dict(os.environ, **(environment or {}))
    lmp = environment.get("SPHTM_LMP")
    if not lmp:
        print("no SPHTM_LMP in the environment: skipped")
        sys.exit(SKIPPED)
    if "\n" not in script:
        with open(script) as f:
            script = f.read()
    if environment.get("SPHTM_PRECISION"):    # of pairs, for bench/precision.py
        script = re.sub(r"^(pair_style\s+sph/tm\b.*?)(\s+spacing\b)",
                        r"\1 precision %s\2" % environment["SPHTM_PRECISION"], script, flags=re.M)
    if RECORD:
        script = all_digits(script, at_end=not expect_error)
    folder = folder or new_folder()
    for name, text in dict(files or {}, **{"in.scene": script}).items():
        with open(os.path.join(folder, name), "w") as f:
            f.write(text)
    command = shlex.split(os.environ.get("SPHTM_MPIRUN", "mpirun")) + ["-np", str(ranks)] if ranks > 1 else []
    command += [lmp, "-nocite", "-in", "in.scene", *arguments]
    for name, value in (variables or {}).items():
        command += ["-var", name] + [str(v) for v in (value if isinstance(value, (list, tuple)) else [value])]
    done = subprocess.run(command, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True,
                          timeout=timeout, stdin=subprocess.DEVNULL, env=environment)
    if RECORD:
        keep_record(folder, script, done.stdout)
    if done.returncode != 0 and not expect_error:
        print(done.stdout[-6000:])
        print("lmp ended with status", done.returncode, "of", shlex.join(command))
        sys.exit(1)
    return Result(folder, done.stdout, done.returncode)


# --- SPHTM_RECORD

RECORD = os.environ.get("SPHTM_RECORD")
RECORD_DUMP = "record.dump"
# columns of wall time, with those of fix sph/tm: its array, and the share that audits take
RECORD_TIMES = re.compile(r"S/CPU|T/CPU|CPU|CPULeft|Elapsed|v_eta|f_\w+\[\d+\]\[\d+\]|f_body\[29\]")
recorded = 0


def all_digits(script, at_end):
    """The script with every digit in its thermo tables, and at its end a dump of the particles."""
    digits = "thermo_modify format float %23.16e\n"
    script = re.sub(r"^([ \t]*)(run[ \t])", r"\1" + digits + r"\1\2", script, flags=re.M)
    if at_end and re.search(r"^[ \t]*run[ \t]", script, re.M):
        script += "\nwrite_dump all custom %s id type x y z vx vy vz fx fy fz modify sort id format float %%23.16e\n" % \
            RECORD_DUMP
    return script


def keep_record(folder, script, output):
    """RECORD/<test>-<number of the run>: the thermo tables, then the particles. Runs of a pool of threads end in any
    order: they go by their script."""
    global recorded
    recorded += 1
    number = "%03d" % recorded
    if threading.current_thread() is not threading.main_thread():
        number = hashlib.sha256(script.encode()).hexdigest()[:12]
    name = "%s-%s" % (os.path.splitext(os.path.basename(sys.argv[0]))[0], number)
    with open(os.path.join(RECORD, name), "w") as f:
        for table in read_thermo(output):
            names = [n for n in table if not RECORD_TIMES.fullmatch(n)]
            f.write(" ".join(names) + "\n")
            for row in zip(*(table[n] for n in names)):
                f.write(" ".join(v.hex() for v in row) + "\n")
        dump = os.path.join(folder, RECORD_DUMP)
        if os.path.exists(dump):
            with open(dump) as d:
                f.write(d.read())
            os.remove(dump)


def read_thermo(text):
    """The thermo tables of a log or of lmp's output, one per run command: list of name -> array."""
    tables, names, rows = [], None, []

    def close():
        if names and rows:
            tables.append(dict(zip(names, np.array(rows).T)))

    for line in text.splitlines():
        words = line.split()
        if words and words[0] == "Step":
            close()
            names, rows = words, []
        elif names and line.startswith("Loop time"):
            close()
            names = None
        elif names and len(words) == len(names):
            try:
                rows.append([float(w) for w in words])
            except ValueError:
                pass
    close()
    return tables


def read_dump(path):
    """The frames of a text dump of style custom: list of dicts with the columns, 'step' and 'box'."""
    frames = []
    with open(path) as f:
        line = f.readline()
        while line:
            if line.startswith("ITEM: TIMESTEP"):
                frame = {"step": int(f.readline())}
            elif line.startswith("ITEM: NUMBER"):
                n = int(f.readline())
            elif line.startswith("ITEM: BOX"):
                frame["box"] = np.array([[float(w) for w in f.readline().split()] for _ in range(3)])
            elif line.startswith("ITEM: ATOMS"):
                names = line.split()[2:]
                values = np.array([[float(w) for w in f.readline().split()] for _ in range(n)])
                values = values.reshape(n, len(names))
                if "id" in names:
                    values = values[np.argsort(values[:, names.index("id")])]
                frame.update(zip(names, values.T))
                frames.append(frame)
            line = f.readline()
    return frames


def order_of_convergence(spacings, errors):
    """Slope of log(error) over log(spacing), least squares."""
    return np.polyfit(np.log(np.asarray(spacings, float)), np.log(np.asarray(errors, float)), 1)[0]


class Checks:
    """Named comparisons; every line shows the value, what it is held against and the tolerance."""

    def __init__(self):
        self.failed = 0

    def say(self, ok, name, text):
        self.failed += not ok
        print("%-5s %-46s %s" % ("ok" if ok else "FAIL", name, text), flush=True)
        return ok

    def near(self, name, value, reference, relative=0.0, absolute=0.0):
        tolerance = max(relative * abs(reference), absolute)
        error = abs(value - reference)
        share = " (%.3g %%)" % (100 * error / abs(reference)) if reference else ""
        return self.say(error <= tolerance, name, "%.9g against %.9g, off by %.3g%s, allowed %.3g" %
                        (value, reference, error, share, tolerance))

    def below(self, name, value, limit):
        return self.say(value <= limit, name, "%.6g, allowed %.6g" % (value, limit))

    def above(self, name, value, limit):
        return self.say(value >= limit, name, "%.6g, at least %.6g" % (value, limit))

    def true(self, name, condition, text=""):
        return self.say(bool(condition), name, text)

    def note(self, name, text):
        """A number worth knowing that nothing is held against."""
        print("      %-46s %s" % (name, text), flush=True)

    def end(self):
        print("%d failed" % self.failed if self.failed else "all hold")
        sys.exit(1 if self.failed else 0)
