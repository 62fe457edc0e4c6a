"""What the cases share. A file case_NAME.py has

    TITLE, REFERENCE          in words
    SCRIPT                    path of an input script, or its text; FILES: paths of files beside it
    COMPARED                  quantity -> (unit, goal: relative error)
    ROWS                      row -> {"title", "variables", "reference": quantity -> (value, scatter)}
    SETTINGS, SAID            setting -> variables; setting -> words. BASE: variables of all
    MESH, SPACING             settings from coarse to fine, and their spacings in any unit; QUICK: the one for --quick
    measure(result, variables)    quantity -> (value, error of its mean); more than those compared are kept too

and may have SCALING (settings from slow to the base), only(setting) -> rows, cost(variables), prepare(folder, variables) ->
variables of the script; for ./sphtm identify CARD, CONSTANTS, FITTED, NUMERICAL (doc/Howto_studies); make(run, variables) -> list of results, where a value needs several runs: run(variables, below="a")."""
import importlib.util
import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))


def module(path):
    """A Python file by a name of its own: several are called measure."""
    folder, name = os.path.split(path)
    sys.path.insert(0, folder)
    try:
        spec = importlib.util.spec_from_file_location("%s_%s" % (os.path.basename(folder), name[:-3]), path)
        found = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(found)
    finally:
        sys.path.remove(folder)
    return found


def example(name, file="measure"):
    return module(os.path.join(ROOT, "examples", name, file + ".py"))


def script_of(name):
    return os.path.join(ROOT, "examples", name, "in." + name)


def exact(value):
    """A number without an error of its own."""
    return float(value), 0.0
