"""Heat on and off in a cut: a narrow slice of examples/high_speed_machining."""
import shutil

from frame import SAME, Sweep, changed, example, module

TITLE = "heat in cutting"
columns = module(example("high_speed_machining", "measure.py")).COLUMNS


def mesh(folder, variables):
    shutil.copy(example("high_speed_machining", "insert.stl"), folder)


def script(variables):
    return changed(example("high_speed_machining"), ("effects heat ${heat}", "effects " + variables.pop("effects")))


def force(run):
    """Mean of the normal force over the second half of the cut."""
    h = dict(zip(columns, run.columns("history.dat").T))
    late = h["cut"] > 0.5 * h["cut"][-1]
    return {"value": h["fx"][late].mean(), "hottest_K": h["T_max"][-1]}


def by(**more):
    return {"heat and conduction": dict(more, effects="heat on"),
            "heat without conduction": dict(more, effects="heat on effects conduction off"),
            "no heat": dict(more, effects="heat off")}


SWEEPS = [
    Sweep(name="cut", quantity="mean cutting force", reference="the cut with heat and conduction", kind=SAME,
          script=script, prepare=mesh, measure=force, against="heat and conduction",
          settings={"quick": by(width=0.6e-3, cut=1.2e-3), "full": by(width=0.8e-3, cut=4e-3),
                    "large": by(width=2e-3, cut=2e-3, dp=0.1e-3)}),
]
