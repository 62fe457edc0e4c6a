"""The pages in doc/ against the plugin: every keyword, kernel, effect, constant and attribute that a style knows, as
its error message lists them, stands in the Syntax of its page, and the page has no others. README.md names every
example. Pages of the reference have LAMMPS's sections in its order, and pair_sph_tm names every card. The tables of doc/theory.rst have all equations of the papers; functions and files that they name exist, and each
C test calls a function of its row. The table of results is what doc/results gives. Functions of doc/one_time_step.rst and files that pages name exist."""
import glob
import os
import re
import subprocess
import sys

from sphtm_scene import SOURCE, Checks, lattice_block, run

STYLE = "pair_style sph/tm hyperbolic 1.2 spacing 1e-3\n"
COEFF = "pair_coeff 1 1 density 2700 elastic 70e9 0.33 heat 200 900 0.9\n"
READY = STYLE + COEFF + "fix body all sph/tm\n"
REFINE = "fix ad all adapt/neigh refine square epsilon 0.4 alpha 0.6 when neighbors above 1 "
checks = Checks()


def known(lines, after="known are|choose|known is"):
    """The words that an error message lists."""
    head = lattice_block("0 4e-3 0 4e-3", "-5e-3 9e-3 -5e-3 9e-3")
    error = (run(head + lines + "\nrun 0\n", expect_error=True).errors() or "none").splitlines()[0]
    words = re.split("(?:%s):? ?" % after, error)[-1]
    return set(re.sub(r", | or | and ", " ", re.sub(r"; .*|, got.*| \(src.*", "", words)).split())


def syntax(page):
    """The Syntax section of a page, without the lines that show a whole command."""
    with open(os.path.join(SOURCE, "doc", page + ".rst")) as f:
        text = f.read()
    return text[text.index("\nSyntax\n"):text.index("\nExamples\n")]


def keywords(text):
    """Words like *this* at the beginning of a line that are followed by values."""
    return set(re.findall(r"^ +\*([\w/]+)\* +values?\b", text, re.M))


def starred(text):
    return set(re.findall(r"\*([\w/-]+)\*", text))


def part(text, begin, end):
    """Lines from the one that begins with begin up to one that begins with end; nothing where there is none."""
    found = re.search(r"^ *(?:\* )?%s.*?(?=^ *(?:\* )?%s|\Z)" % (begin, end), text, re.M | re.S)
    return found.group(0) if found else ""


def same(name, code, doc):
    missing, wrong = (" ".join(sorted(s)) or "nothing" for s in (code - doc, doc - code))
    checks.true(name, code and code == doc, "%d words; not in doc: %s; only there: %s" % (len(code), missing, wrong))


pair = syntax("pair_sph_tm")
same("pair_style: kernels", known("pair_style sph/tm nonsense 1.2 spacing 1e-3"),
     starred(part(pair, "kernel =", "ratio")))
same("pair_style: keywords", known(STYLE.strip() + " nonsense 1"), keywords(pair) | {"spacing"})
groups = part(pair, "groups of material constants", r"\Z")
same("pair_coeff: groups", known(STYLE + COEFF.strip() + " nonsense") - {"set"},
     set(re.findall(r"\*(\w+)[^*\n]*\*", groups)) - {"table"})
for group in "eos", "strength", "damage", "body":
    same("pair_coeff: " + group, known(STYLE + "pair_coeff 1 1 %s nonsense" % group, "one of"),
         set(re.findall(r"\*%s ([\w/]+)\*" % group, groups)))
same("pair_coeff: constants of set", known(STYLE + COEFF.strip() + " set nonsense 1"),
     starred(part(pair, "constant =", "groups")))

fix = syntax("fix_sph_tm")
same("fix sph/tm: keywords", known(STYLE + COEFF + "fix body all sph/tm nonsense 1"), keywords(fix))
same("fix sph/tm: effects", known(STYLE + COEFF + "fix body all sph/tm effects nonsense on"),
     starred(part(fix, "effect =", r"\Z")))

heat = syntax("fix_sph_tm_heat")
modes = starred(re.sub(r"=.*", "", part(heat, "mode and values", "zero or more")))
same("fix sph/tm/heat: modes",
     known(READY + "fix h all sph/tm/heat nonsense", "a mode") - {"T", "q", "hc", "Tinf"}, modes)
same("fix sph/tm/heat: keywords", known(READY + "fix h all sph/tm/heat radiation 300 nonsense 1"), keywords(heat))

same("fix sph/tm/relax: keywords", known(READY + "fix r all sph/tm/relax nonsense 1"),
     keywords(syntax("fix_sph_tm_relax")))

tool = syntax("fix_contact_tri")
same("fix contact/tri: keywords", known(READY + "fix t all contact/tri nonsense 1"), keywords(tool) | {"file"})

adapt, refine = syntax("fix_adapt_neigh"), syntax("fix_adapt_neigh_refine")
inner = keywords(part(adapt, r"keyword = \*every", r"\Z"))
same("fix adapt/neigh: keywords", known(READY + "fix ad all adapt/neigh nonsense 1"),
     keywords(adapt) - inner | {"refine", "coarsen"})
same("fix adapt/neigh asph: options",
     known(READY + "fix ad all adapt/neigh asph psi nonsense 1", "options of asph are"), inner)
options = starred(part(refine, r"\*refine\* pattern", "pattern =") + part(refine, "options =", r"\*coarsen"))
same("fix adapt/neigh refine: options", known(READY + REFINE + "nonsense 1", "options of refine are"),
     options - {"refine", "parent", "linear"})
same("fix adapt/neigh refine: patterns", known(READY + REFINE.replace("square", "nonsense")),
     starred(part(refine, "pattern =", "E =")))

same("compute sph/tm/atom", known(READY + "compute p all sph/tm/atom nonsense"),
     starred(re.sub(r"=.*", "", part(syntax("compute_sph_tm_atom"), "one or more attributes", r"\Z"))))
same("compute cutting/force", known(READY + "compute f all cutting/force t nonsense"),
     keywords(syntax("compute_cutting_force")))

with open(os.path.join(SOURCE, "materials", "materials.sphtm")) as f:
    cards = set(re.findall(r"^material (\S+)", f.read(), re.M))
with open(os.path.join(SOURCE, "doc", "pair_sph_tm.rst")) as f:
    text = " ".join(f.read().split())
listed = re.search(r"with the cards(.*?), each constant with its source", text).group(1)
same("pair_sph_tm: cards", cards, starred(listed))
with open(os.path.join(SOURCE, "doc", "index.rst")) as f:
    reference = re.search(r":caption: Reference\n\n((?:   .*\n)+)", f.read()).group(1).split()
SECTIONS = ("Syntax", "Examples", "Description", "Restart.*|Mixing.*|Output info", "Accelerator variants", "Restrictions",
            "Related commands", "Default")
wrong = []
for page in reference:
    with open(os.path.join(SOURCE, "doc", page + ".rst")) as f:
        text = f.read()
    heads = re.findall(r'^(.+)\n"{5,}$', text, re.M)
    places = [[i for i, pattern in enumerate(SECTIONS) if re.fullmatch(pattern, head)] for head in heads]
    found = [p[0] for p in places if p]
    missing = set(range(len(SECTIONS))) - set(found) - {4}    # variants: mostly in one line below the title
    variant = re.search(r"^Accelerator variant: .*\n\n\.\. versionadded:: [\d.]+\n", text, re.M)
    if not all(places) or missing or found != sorted(found) or not variant or not text.startswith(".. index:: "):
        wrong.append("%s: %s" % (page, ", ".join(heads)))
checks.true("reference: sections of each page", len(reference) > 8 and not wrong,
            "%d pages; wrong: %s" % (len(reference), "; ".join(wrong) or "none"))


def rows_of_tables(page):
    """Rows of list-tables with four columns, each a list of texts, without the heads."""
    with open(os.path.join(SOURCE, "doc", page + ".rst")) as f:
        rows = re.findall(r"^   \* - (.*(?:\n     [ -] .*)*)", f.read(), re.M)
    rows = [[re.sub(r"\s+", " ", cell) for cell in re.split(r"\n     - ", row)] for row in rows]
    return [row for row in rows if len(row) == 4 and row[0] != "equation"]


def names(cell):
    return re.findall(r"``([^`]+)``", cell)


def has_word(word, *path):
    path = os.path.join(SOURCE, *path)
    if not os.path.isfile(path):
        return False
    with open(path) as f:
        return re.search(r"\b%s\b" % re.escape(word.split("::")[-1]), f.read()) is not None


def equations(paper, text):
    """Numbers like (2), (4) to (6) after the name of a paper."""
    found = set()
    for list_of_numbers in re.findall(paper + r"((?: ?(?:,|to|and)? ?\(\d+\))+)", text):
        for first, last in re.findall(r"\((\d+)\)(?: to \((\d+)\))?", list_of_numbers):
            found |= set(range(int(first), int(last or first) + 1))
    return found


theory = rows_of_tables("theory")
for paper, last in ("F15", 17), ("F14", 18), ("S13", 9):
    missing = set(range(1, last + 1)) - set().union(*(equations(paper, row[0]) for row in theory))
    checks.true("theory: equations of " + paper, not missing, "not there: %s" % (sorted(missing) or "none"))
wrong, c_tests = [], 0


def files_of(test):
    """A C test and what the tests have in common that it includes (ut_*.h)."""
    with open(os.path.join(SOURCE, "unittest", "c", test)) as f:
        return [test] + re.findall(r'#include "(ut_\w+\.h)"', f.read())


for equation, functions, headers, tests in theory:
    functions, headers = names(functions), names(headers)
    if not functions or not headers or not (names(tests) or tests == "none"):
        wrong.append(equation)
    wrong += ["%s in %s" % (f, " ".join(headers)) for f in functions if not any(has_word(f, "src", h) for h in headers)]
    wrong += ["%s of %s" % (h, equation) for h in headers if not any(has_word(f, "src", h) for f in functions)]
    for test in names(tests):
        if test.endswith(".py"):
            wrong += [] if os.path.isfile(os.path.join(SOURCE, "unittest", "scenes", test)) else [test]
            continue
        c_tests += 1
        if not any(has_word(f, "unittest", "c", file) for f in functions for file in files_of(test)):
            wrong.append("%s calls no %s" % (test, " ".join(functions)))
checks.true("theory: functions, headers, tests", len(theory) > 50 and c_tests > 50 and not wrong,
            "%d rows; wrong: %s" % (len(theory), "; ".join(wrong) or "none"))

source = {path: open(path).read() for path in glob.glob(os.path.join(SOURCE, "src", "**", "*.*"), recursive=True)}
with open(os.path.join(SOURCE, "doc", "one_time_step.rst")) as f:
    called = set(re.findall(r"``([\w:]+)\(\)``", f.read()))
wrong = [name for name in called if not any(re.search(r"\b%s\(" % name, text) for text in source.values())]
checks.true("one_time_step: functions", len(called) > 50 and not wrong,
            "%d functions; not in src: %s" % (len(called), " ".join(sorted(wrong)) or "none"))
wrong = []
for page in glob.glob(os.path.join(SOURCE, "doc", "*.rst")) + [os.path.join(SOURCE, "README.md")]:
    with open(page) as f:
        text = f.read()
    wrong += [path for path in re.findall(r"\b((?:src|unittest|tools)/[\w/.]+\.\w+)", text)
              if not os.path.exists(os.path.join(SOURCE, path))]
checks.true("pages: files that they name", not wrong, "not there: %s" % (" ".join(sorted(set(wrong))) or "none"))

done = subprocess.run([sys.executable, os.path.join(SOURCE, "bench", "results.py"), "check"], stdout=subprocess.PIPE, text=True)
checks.true("README: the table of results is that of doc/results", done.returncode == 0, done.stdout.strip())
with open(os.path.join(SOURCE, "README.md")) as f:
    told = set(re.findall(r"\]\(examples/(\w+)\)", f.read()))
pages = glob.glob(os.path.join(SOURCE, "examples", "*", "README.md"))
same("README: examples", {os.path.basename(os.path.dirname(p)) for p in pages}, told)
checks.end()
