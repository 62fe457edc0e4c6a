"""The examples of the pages in doc/: every line of every 'code-block:: LAMMPS' is run in a small scene that suits it, and every
'code-block:: python' of a page, in order. What fails is named by page and line. Templates, lines that cannot be run as they stand, are
'code-block:: text' in the pages. A made-up page with wrong lines shows that they are found."""
import glob
import os
import re
import subprocess
import sys
import textwrap

from sphtm_scene import SKIPPED, SOURCE, Checks, new_folder, run

MOST_STEPS = 5

# --- scenes: what stands before a line

GROUPS = """
region          left block INF 2e-3 INF INF INF INF units box
region          right block 10e-3 INF INF INF INF INF units box
region          middle block 2e-3 10e-3 INF INF INF INF units box
region          low block INF INF INF 2e-3 INF INF units box
region          tip block 8e-3 INF INF INF INF INF units box
group           left region left
group           right region right
group           middle region middle
group           bottom region low
group           base region low
group           hot region right
group           wire region middle
group           work region middle
"""
BOX = """
units           si
dimension       2
boundary        f f p
atom_style      atomic
newton          off
variable        dx index 1e-3
lattice         sq 1e-3 origin 0.5 0.5 0
region          box block -5e-3 25e-3 -5e-3 15e-3 -5e-4 5e-4 units box
create_box      2 box
region          all block 0 12e-3 0 5e-3 INF INF units box
create_atoms    1 region all
""" + GROUPS
SPACE = BOX.replace("dimension       2", "dimension       3").replace("f f p", "f f f").replace("sq 1e-3", "sc 1e-3") \
    .replace("0.5 0.5 0", "0.5 0.5 0.5").replace("-5e-4 5e-4", "-5e-3 10e-3").replace("5e-3 INF INF", "5e-3 0 5e-3")
TWO_TYPES = BOX + "set group right type 2\n"
METAL = " density 2700 elastic 70e9 0.33 strength plastic 300e6 1e9 heat 200 900 0.9 emissivity 0.3\n"
STYLE = "pair_style sph/tm hyperbolic 1.2 spacing 1e-3\npair_coeff * *" + METAL
BODY = "fix body all sph/tm temperature 293\n"
OUTSIDE = " scale 1e-3 move 20e-3 6e-3 0\n"    # a tool beside the block
TOOL = "fix tool all contact/tri file insert.stl" + OUTSIDE
STATE = "compute p all sph/tm/atom temperature pstrain vonmises\n"
CUT = None    # the whole scene of the Howto, set below

SCENES = {
    "box": TWO_TYPES,
    "style": BOX + STYLE,
    "body": BOX + STYLE + BODY,
    "space": SPACE + STYLE + BODY,
    "tool": BOX + STYLE + BODY + TOOL,
    "state": BOX + STYLE + BODY + TOOL + STATE,
    "heat only": TWO_TYPES + "pair_style sph/tm hyperbolic 1.2 spacing 1e-3\n"
                 "pair_coeff * * density 2700 body heat heat 120 899 0\n" + BODY,
    "written": "",
    "none": "",
}
# page (or *), first command of a block or paragraph -> scene. The first row that matches counts.
SUITS = (
    ("*", r"units\b", "none"),
    ("Howto_clusters", r"newton\b", "written"),
    ("Howto_clusters", r"restart\b", "tool"),
    ("Howto_sph_tm", r"dump\b", "state"),
    ("dump_sph_tm_vtp", r"dump\b|variable\b", "state"),
    ("*", r"pair_style\s+sph/tm", "box"),
    ("fix_sph_tm", r"variable\s+left", "heat only"),
    ("fix_sph_tm", r"variable\s+way", "style"),
    ("*", r"fix\s+\S+\s+\S+\s+sph/tm(\s|$)", "style"),
    ("*", r"fix\s+.*refine\s+cube", "space"),
    ("*", r"fix\s+\S+\s+\S+\s+(sph/tm/|adapt/neigh|contact/tri)", "body"),
    ("*", r"variable\b", "body"),
    ("*", r"compute\s+\S+\s+\S+\s+cutting/force", "tool"),
    ("*", r"compute\s+\S+\s+\S+\s+sph/tm/atom", "body"),
)
# what the examples of the pages name and scenes of this size cannot have
INSTEAD = (
    (r"(file (?:insert|die|plane)\.stl)(?: scale \S+)?(?: move(?: \S+){3})?", r"\1" + OUTSIDE.rstrip()),    # beside the block
    (r"(spacing) (?:0\.2e-3|10e-6|1e-5|0\.8e-3)\b", r"\1 1e-3"),
    (r"^(restart\s+)\d+", r"\g<1>5"),
)


class Line:
    """A command of a page, with the lines that '&' continues."""

    def __init__(self, page, number, text):
        self.page, self.number, self.text = page, number, text
        self.whole = False    # part of a whole scene

    def place(self):
        return "%s:%d: %s" % (self.page, self.number, re.sub(r"\s*&\n\s*", " ", self.text))

    def ready(self):
        """The line as it is run."""
        text = self.text
        for old, new in () if self.whole else INSTEAD:
            text = re.sub(old, new, text)
        text = re.sub(r"^(\s*run\s+)(\d+)", lambda m: m.group(1) + str(min(int(m.group(2)), MOST_STEPS)), text)
        return re.sub(r"^(\s*dump\s+\S+\s+\S+\s+\S+\s+)\d+", r"\g<1>%d" % MOST_STEPS, text)


def blocks(path, language):
    """(number of the first line, lines) of every code-block in that language."""
    with open(path) as f:
        lines = f.read().split("\n")
    i = 0
    while i < len(lines):
        found = re.match(r"( *)\.\. code-block:: %s$" % language, lines[i])
        i += 1
        if not found:
            continue
        start = i
        while i < len(lines) and (not lines[i].strip() or lines[i].startswith(found.group(1) + " ")):
            i += 1
        yield start + 1, lines[start:i]


def paragraphs(path):
    """The commands of a page: lists of those between blank lines of a code-block."""
    page = os.path.splitext(os.path.basename(path))[0]
    for first, lines in blocks(path, "LAMMPS"):
        unit, text = [], ""
        for number, line in enumerate(lines, first):
            if not line.strip() or line.strip().startswith("#"):
                if not line.strip() and unit:
                    yield unit
                    unit = []
                continue
            start = start if text else number
            text += ("\n" if text else "") + line.split(" #")[0].rstrip()
            if text.endswith("&"):
                continue
            unit.append(Line(page, start, textwrap.dedent(text)))
            text = ""
        if unit:
            yield unit


def defines(line):
    """What a second line of the kind would replace: 'fix ID', ..., or None."""
    words = line.text.split()
    if words[0] in ("fix", "compute", "dump") and len(words) > 3:
        return words[0] + " " + words[1]
    return words[0] if words[0] in ("pair_style", "units") else None


def units_of(unit):
    """Alternatives, lines that define the same again, are runs of their own."""
    runs, known = [[]], set()
    for line in unit:
        what = defines(line)
        if what in known:
            runs.append([])
            known = set()
        known.add(what) if what else None
        runs[-1].append(line)
    return runs


def scene_of(lines):
    for page, pattern, scene in SUITS:
        if page in ("*", lines[0].page) and re.match(pattern, lines[0].text.strip()):
            return scene
    return None


def script(scene, lines):
    """The whole input: the scene, the lines, what they leave out, and a run where they have none."""
    text = "\n".join(line.ready() for line in lines) + "\n"
    body = re.search(r"^\s*fix\s+\S+\s+all\s+sph/tm(\s|$)", text, re.M)
    if scene == "box":    # materials that the page does not give: those of its type 1, or a metal
        given = re.search(r"^\s*pair_coeff 1 1((?:.*&\n)*.*\n)", text, re.M)
        more = "".join("pair_coeff %d %d%s" % (i, i, given.group(1) if given else METAL)
                       for i in (1, 2) if not re.search(r"^\s*pair_coeff\s+(%d|\*) " % i, text, re.M))
        text = text.replace("\n", "\n" + more, 1) if not body else \
            re.sub(r"^(?=\s*fix\s+\S+\s+all\s+sph/tm)", lambda _: more, text, count=1, flags=re.M)
        text += "" if body else BODY
    elif scene == "style" and not body:
        text = BODY + text
    return SCENES[scene] + text + ("" if re.search(r"^\s*run\s", text, re.M) else "run %d\n" % MOST_STEPS)


def error_of(scene, lines, folder):
    """LAMMPS's error message, or ''."""
    ran = run(script(scene, lines), folder=folder, expect_error=True, timeout=120, environment=ENVIRONMENT)
    return "" if ran.status == 0 else ran.errors() or ran.output[-400:]


def try_page(path):
    """Runs the examples of a page: how many lines, and what fails, as 'page:line: command: message'."""
    count, wrong = 0, []
    for unit in paragraphs(path):
        for lines in units_of(unit):
            count += len(lines)
            scene = scene_of(lines)
            if scene is None:
                wrong.append(lines[0].place() + ": no scene of this test suits it")
                continue
            if scene in ("none", "written"):
                for line in lines:
                    line.whole = True
            folder = prepared(scene)
            message = error_of(scene, lines, folder)
            if message:    # the first line with which it fails in this way
                first = message.splitlines()[0]
                guilty = next((k for k in range(1, len(lines)) if error_of(scene, lines[:k], prepared(scene)).startswith(first)),
                              len(lines))
                wrong.append("%s: %s" % (lines[guilty - 1].place(), first))
    return count, wrong


def prepared(scene):
    """A folder with the meshes that examples name, and for a restart with the file."""
    folder = new_folder()
    for name, words in MESHES.items():
        subprocess.run([sys.executable, os.path.join(SOURCE, "tools", "make_tool.py"), *words, "-o",
                        os.path.join(folder, name)], check=True, stdout=subprocess.DEVNULL)
    if scene == "written":
        lines = [line for line in CUT if not re.match(r"\s*(run|dump)\b", line.text)]
        run("\n".join(line.ready() for line in lines) + "\nrun 5\nwrite_restart cut.*.restart\n", folder=folder,
            environment=ENVIRONMENT)
    return folder


MESHES = {
    "insert.stl": "insert --rake 6 --clearance 7 --radius 5e-3 --segments 6 --height 0.7 --length 0.5 --width 10".split(),
    "die.stl": "block --size 2 2 10".split(),
    "plane.stl": "block --size 2 2 10".split(),
}
ENVIRONMENT = {"SPHTM_MATERIALS": os.path.join(SOURCE, "materials")}

WRONG = """
.. code-block:: LAMMPS

   fix body all sph/tm temperature 300
   fix body all sph/tm temprature 300

.. code-block:: LAMMPS

   compute p all sph/tm/atom pstrain
   compute q all sph/tm/atom strain &
           pressure
   compute r all sph/tm/atom pressure

   pair_style sph/tm hyperbolic 1.2 spacing 1e-3
   pair_coeff 1 1 density 2700 elastic 70e9 0.33 strength plastic 300e6
   pair_coeff 2 2 density 2700 elastic 70e9 0.33

   thermo 10
"""


def python_of(path):
    return "\n".join(textwrap.dedent("\n".join(lines)) for _, lines in blocks(path, "python"))


def run_python(code, folder):
    """Status and output of Python code that uses the module lammps."""
    host = os.path.dirname(os.environ["SPHTM_LMP"])
    with open(os.path.join(host, "source")) as f:
        module = os.path.join(f.read().strip(), "python")
    more = dict(ENVIRONMENT, PYTHONPATH=module, LD_LIBRARY_PATH=host, PYTHONDONTWRITEBYTECODE="1")
    done = subprocess.run([sys.executable, "-c", code], cwd=folder, env=dict(os.environ, **more), text=True, timeout=300,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.returncode, done.stdout


if __name__ == "__main__":
    checks = Checks()
    if not os.environ.get("SPHTM_LMP"):
        print("no SPHTM_LMP in the environment: skipped")
        sys.exit(SKIPPED)
    doc = os.path.join(SOURCE, "doc")
    wanted = sys.argv[1:]
    pages = sorted(glob.glob(os.path.join(doc, "*.rst")))
    CUT = next(u for u in paragraphs(os.path.join(doc, "Howto_sph_tm.rst")) if u[0].text.startswith("units"))
    for line in CUT:
        line.whole = True
    total = 0
    for path in pages:
        if wanted and os.path.basename(path)[:-4] not in wanted:
            continue
        count, wrong = try_page(path)
        total += count
        if count:
            checks.true(os.path.basename(path), not wrong, "%d lines%s" % (count, "".join("\n      " + w for w in wrong)))
    if not wanted:
        checks.true("all pages", total > 90, "%d lines" % total)

    # the reference pages have examples
    with open(os.path.join(doc, "index.rst")) as f:
        reference = re.search(r":caption: Reference\n\n((?:   .*\n)+)", f.read()).group(1).split()
    bare = [page for page in reference if not list(blocks(os.path.join(doc, page + ".rst"), "LAMMPS"))]
    checks.true("each page of the reference has examples", not bare, " ".join(bare))

    # Python
    for path in pages:
        code = python_of(path)
        if not code or wanted and os.path.basename(path)[:-4] not in wanted:
            continue
        if not os.path.exists(os.path.join(os.path.dirname(os.environ["SPHTM_LMP"]), "source")):
            checks.note("Python of " + os.path.basename(path), "not run: no LAMMPS source beside lmp")
            continue
        status, said = run_python(code, new_folder())
        checks.true("Python of " + os.path.basename(path), status == 0 and "MPa: force" in said, said.strip()[-1500:].replace("\n", "\n      "))
        status, said = run_python(code.replace('extract_fix("pull"', 'extract_fix("push"'), new_folder())
        checks.true("counter-case: a wrong fix ID in Python", status != 0, said.strip().splitlines()[-1] if said.strip() else "")

    # counter-cases
    folder = new_folder()
    with open(os.path.join(folder, "wrong.rst"), "w") as f:
        f.write(WRONG)
    count, wrong = try_page(os.path.join(folder, "wrong.rst"))
    found = [int(re.match(r"wrong:(\d+):", w).group(1)) for w in wrong]
    checks.true("counter-case: wrong lines are found, no others", count == 9 and found == [5, 10, 15, 18],
                "%d lines, found %s%s" % (count, found, "".join("\n      " + w for w in wrong)))
    with open(os.path.join(doc, "Howto_sph_tm.rst")) as f:
        old = f.read().replace("amap 300 1300 ca 0.0 3 min blue 800 yellow max red", "amap min max ca 0.0 3 min blue 0.5 yellow max red")
    with open(os.path.join(folder, "Howto_sph_tm.rst"), "w") as f:
        f.write(old)
    count, wrong = try_page(os.path.join(folder, "Howto_sph_tm.rst"))
    checks.true("counter-case: the amap line as it was", len(wrong) == 1 and "amap" in wrong[0], "; ".join(wrong))
    checks.end()
