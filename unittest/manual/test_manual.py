"""./sphtm manual: no warning of Sphinx; every internal link, picture and script of the HTML is there; nothing is loaded from the
web; formulas, search and index are there. Counter-cases: pages with a broken reference, a page in no table of contents, a
picture that is missing, and a command that is none stop the build; the search for broken links finds one."""
import glob
import html.parser
import os
import re
import shutil
import subprocess
import sys
import tempfile
import urllib.parse

SOURCE = os.environ.get("SPHTM_SOURCE", os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__)))))
DOC = os.path.join(SOURCE, "doc")
SKIPPED = 77
failed = 0


def say(ok, name, text=""):
    global failed
    failed += not ok
    print("%-5s %-60s %s" % ("ok" if ok else "FAIL", name, text), flush=True)


class Page(html.parser.HTMLParser):
    """What a page names: its anchors, the places that it links to and those that it loads."""

    def __init__(self, path):
        super().__init__()
        self.anchors, self.links, self.loads = set(), [], []
        with open(path, encoding="utf-8") as f:
            self.feed(f.read())

    def handle_starttag(self, tag, attributes):
        values = dict(attributes)
        for name in "id", "name":
            if values.get(name):
                self.anchors.add(values[name])
        if tag == "a" and values.get("href"):
            self.links.append(values["href"])
        elif tag == "link" and values.get("rel") not in ("canonical", "search", "index", "next", "prev"):
            self.loads.append(values.get("href", ""))
        elif tag in ("script", "img", "iframe") and values.get("src"):
            self.loads.append(values["src"])


def broken_links(folder):
    """(page, link) that lead nowhere, and (page, address) of what is loaded from the web."""
    pages = {path: Page(path) for path in glob.glob(os.path.join(folder, "*.html"))}
    broken, foreign, count = [], [], 0
    for path, page in pages.items():
        for link in page.links + page.loads:
            url = urllib.parse.urlsplit(link)
            if url.scheme or url.netloc:
                if link in page.loads:
                    foreign.append((os.path.basename(path), link))
                continue
            count += 1
            target = os.path.normpath(os.path.join(folder, urllib.parse.unquote(url.path))) if url.path else path
            anchor = urllib.parse.unquote(url.fragment)
            if not os.path.exists(target) or anchor and target in pages and anchor not in pages[target].anchors:
                broken.append((os.path.basename(path), link))
    return broken, foreign, count


def sphinx(doc, out):
    """Status and output of Sphinx as tools/run-manual.sh calls it."""
    with open(os.path.join(SOURCE, "tools", "run-manual.sh")) as f:
        options = re.search(r"-m sphinx (.*?) -d ", f.read()).group(1).split()
    done = subprocess.run([sys.executable, "-m", "sphinx", *options, "-d", out + ".doctrees", doc, out], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    return done.returncode, done.stdout


if subprocess.run([sys.executable, "-c", "import sphinx, sphinx_rtd_theme"], stderr=subprocess.DEVNULL).returncode:
    print("no Sphinx with its theme: skipped")
    sys.exit(SKIPPED)
top = tempfile.mkdtemp(prefix="sphtm-")
try:
    manual = os.path.join(top, "manual")
    done = subprocess.run([os.path.join(SOURCE, "tools", "run-manual.sh"), manual], text=True, stdout=subprocess.PIPE,
                          stderr=subprocess.STDOUT)
    say(done.returncode == 0, "run-manual.sh builds without a warning", "" if done.returncode == 0 else done.stdout[-4000:])

    sources = {os.path.basename(path)[:-4] for path in glob.glob(os.path.join(DOC, "*.rst"))}
    made = {os.path.basename(path)[:-5] for path in glob.glob(os.path.join(manual, "*.html"))}
    say(sources and sources <= made, "each page of doc/ is there", "%d pages; missing: %s" % (len(sources), sources - made or "none"))
    broken, foreign, count = broken_links(manual)
    say(count > 500 and not broken, "internal links", "%d; broken: %s" % (count, broken[:20] or "none"))
    say(not foreign, "nothing is loaded from the web", str(foreign[:10] or ""))
    for name in "search.html", "searchindex.js", "genindex.html", "objects.inv":
        say(os.path.exists(os.path.join(manual, name)), name)
    with open(os.path.join(manual, "genindex.html"), encoding="utf-8") as f:
        index = f.read()
    with open(os.path.join(DOC, "index.rst")) as f:
        reference = re.search(r":caption: Reference\n\n((?:   .*\n)+)", f.read()).group(1).split()
    commands = []
    for page in reference:
        with open(os.path.join(DOC, page + ".rst")) as f:
            commands.append(re.search(r"^\.\. index:: (.*)", f.read(), re.M).group(1))
    absent = [c for c in commands if c not in index]
    say(len(commands) > 8 and not absent, "the index has the commands", "missing: %s" % (absent or "none"))
    math = [page for page in made if page in sources and
            'class="math' in open(os.path.join(manual, page + ".html"), encoding="utf-8").read()]
    say(len(math) > 2 and os.path.exists(os.path.join(manual, "_static", "mathjax", "MathJax.js")), "formulas, and what draws them",
        " ".join(sorted(math)))
    say(len(glob.glob(os.path.join(manual, "_images", "*.png"))) >= 3, "pictures")

    # counter-cases
    def with_page(name, text, listed=True):
        """Status and output with a page more, in a copy of what the build reads."""
        copy = os.path.join(top, name)
        shutil.copytree(DOC, os.path.join(copy, "doc"))
        shutil.copy(os.path.join(SOURCE, "CMakeLists.txt"), copy)
        os.symlink(os.path.join(SOURCE, "examples"), os.path.join(copy, "examples"))
        with open(os.path.join(copy, "doc", "extra.rst"), "w") as f:
            f.write("Extra\n=====\n\n" + text + "\n")
        if listed:
            with open(os.path.join(copy, "doc", "index.rst"), "a") as f:
                f.write("\n.. toctree::\n\n   extra\n")
        return sphinx(os.path.join(copy, "doc"), os.path.join(copy, "html"))

    status, text = with_page("good", "See :doc:`fix <fix>` and :doc:`pair_sph_tm`.")
    say(status == 0, "a good page passes", text[-1000:])
    for name, text, listed in (("page", "See :doc:`none <no_such_page>`.", True), ("label", "See :ref:`none <nosuchlabel>`.", True),
                               ("orphan", "In no table of contents.", False), ("picture", ".. image:: none.png", True),
                               ("lexer", ".. code-block:: NOLANGUAGE\n\n   a", True)):
        status, said = with_page(name, text, listed)
        say(status != 0 and "extra" in said, "stopped by a broken " + name, " ".join(l for l in said.splitlines() if "extra" in l)[-200:])
    page = os.path.join(manual, "index.html")
    with open(page, "a") as f:
        f.write('<a href="pair_sph_tm.html#no-such-anchor">x</a><a href="none.html">y</a><img src="https://example.org/a.png">')
    broken, foreign, count = broken_links(manual)
    say(len(broken) == 2 and len(foreign) == 1, "broken links are found", "%s %s" % (broken, foreign))
finally:
    shutil.rmtree(top, ignore_errors=True)
print("%d failed" % failed if failed else "all hold")
sys.exit(1 if failed else 0)
