"""Settings of the manual, for Sphinx: ./sphtm manual builds it.

Pages of LAMMPS's own manual are linked by their names, :doc:`fix <fix>`: those in LAMMPS_PAGES are looked for on the
web. Any other page that is not there is a warning, and warnings fail the build. Formulas are drawn by the MathJax that
Debian packages; what it needs goes along, as SVG, which a browser shows from a plain file too. Other MathJaxes: the
environment variable SPHTM_MATHJAX."""
import os
import re
import shutil

from docutils import nodes
from pygments.lexer import RegexLexer, bygroups
from pygments.token import Comment, Keyword, Name, Number, Punctuation, String, Text
from sphinx.errors import ConfigError

HERE = os.path.dirname(os.path.abspath(__file__))
with open(os.path.join(HERE, os.pardir, "CMakeLists.txt")) as f:
    release = re.search(r"project\(sphtm VERSION ([\d.]+)", f.read()).group(1)

project = "SPH-TM"
author = "SPH-TM developers"
copyright = "2026 SPH-TM developers"
extensions = ["sphinx.ext.mathjax"]
exclude_patterns = ["results"]
html_theme = "sphinx_rtd_theme"
html_theme_options = {"navigation_depth": 2, "collapse_navigation": True}
html_title = "SPH-TM " + release
html_static_path = ["_static"]
html_css_files = ["manual.css"]
html_copy_source = False
html_show_sphinx = False
smartquotes = False
pygments_style = "default"
highlight_language = "text"

# --- pages of LAMMPS

LAMMPS_MANUAL = "https://docs.lammps.org/"
LAMMPS_PAGES = set("""
    Build_package Howto_library Python_head Python_module Python_install Speed_kokkos atom_style compute compute_reduce
    delete_atoms displace_atoms dump dump_image fix fix_ave_time fix_dt_reset fix_gravity fix_halt fix_modify fix_move
    fix_property_atom fix_setforce fix_viscous lattice minimize neigh_modify neighbor newton package plugin processors
    read_restart rerun reset_atoms restart run suffix thermo_modify timestep units variable write_data
    write_restart""".split())


def lammps_page(app, env, node, text):
    """A link to a page of LAMMPS's manual."""
    target = node.get("reftarget", "").lstrip("/")
    if node.get("reftype") != "doc" or target not in LAMMPS_PAGES:
        return None
    return nodes.reference("", "", text, internal=False, refuri=LAMMPS_MANUAL + target + ".html",
                           reftitle="in the LAMMPS manual")


# --- input scripts of LAMMPS

class LammpsLexer(RegexLexer):
    """Comments, commands, variables, strings and numbers; no more than that."""
    name = "LAMMPS"
    aliases = ["LAMMPS", "lammps"]
    tokens = {
        "root": [
            (r"\s+", Text),
            (r"#.*", Comment.Single),
            (r"[A-Za-z_]\w*", Keyword, "line"),
            (r".", Text),
        ],
        "line": [
            (r"&[ \t]*\n", Punctuation),
            (r"\n", Text, "#pop"),
            (r"[ \t]+", Text),
            (r"#.*", Comment.Single),
            (r'"[^"\n]*"', String),
            (r"\$\{[^}\n]*\}", Name.Variable),
            (r"\$\([^)\n]*\)", Name.Variable),
            (r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?=\s|$)", Number),
            (r"([cfv]_\w+)(\[[^\]\n]*\])?", bygroups(Name.Variable, Name.Variable)),
            (r"\S+?(?=[\s\"$]|$)|\S", Text),
        ],
    }


# --- formulas

MATHJAX = os.environ.get("SPHTM_MATHJAX", "/usr/share/javascript/mathjax")
MATHJAX_PARTS = ("MathJax.js", "config/TeX-AMS_SVG.js", "extensions", "jax/element", "jax/input/TeX", "jax/output/SVG/autoload",
                 "jax/output/SVG/config.js", "jax/output/SVG/jax.js", "jax/output/SVG/fonts/TeX", "LICENSE")
mathjax_path = "mathjax/MathJax.js?config=TeX-AMS_SVG"
mathjax2_config = {"showMathMenu": False, "messageStyle": "none", "SVG": {"font": "TeX"}}


def bring_mathjax(app, failure):
    if failure or app.builder.format != "html":
        return
    if not os.path.exists(os.path.join(MATHJAX, "MathJax.js")):
        raise ConfigError("no MathJax 2 in %s: install libjs-mathjax, or set SPHTM_MATHJAX" % MATHJAX)
    for part in MATHJAX_PARTS:
        source, target = os.path.join(MATHJAX, part), os.path.join(app.outdir, "_static", "mathjax", part)
        if os.path.isdir(source):
            shutil.copytree(source, target, dirs_exist_ok=True)
        elif os.path.exists(source):
            os.makedirs(os.path.dirname(target), exist_ok=True)
            shutil.copyfile(source, target)


def setup(app):
    app.connect("missing-reference", lammps_page)
    app.connect("build-finished", bring_mathjax)
    app.add_lexer("LAMMPS", LammpsLexer)
    return {"parallel_read_safe": True, "parallel_write_safe": True}
