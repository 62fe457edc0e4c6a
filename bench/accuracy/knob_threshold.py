"""Threshold of adaptive lists: a bullet through a plate."""
from frame import SAME, Sweep, example, module

TITLE = "threshold of adaptive lists"
scene = module(example("bullet_plate", "scene.py"))
EVERY = "every step"
ROWS = dict({row: scene.ROWS[row] for row in (EVERY, "1e-6", "1e-5", "1e-4", "skin list")},
            **{"1e-3": {"adapt": "threshold 1e-3"}})


def by(**more):
    return {label: dict(more, **v) for label, v in ROWS.items()}


def residual(run):
    m = scene.measure(run)
    return dict(m, value=m["residual"])


SWEEPS = [
    Sweep(name="bullet", quantity="residual velocity of the bullet", reference="lists anew in every step", kind=SAME,
          script=example("bullet_plate"), measure=residual, against=EVERY,
          settings={"quick": by(n=3, thick=9e-3, end=1.5e-4, width=72e-3), "full": by(n=4, end=2.5e-4),
                    "large": by(n=6, end=1e-4)}),
]
