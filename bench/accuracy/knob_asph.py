"""Smoothing length that follows the particles, in tension: how far a specimen stretches before it breaks by itself."""
from frame import CLOSED, Sweep, example, module

TITLE = "adaptive smoothing length in tension"
scene = module(example("flat_tensile_c45e", "scene.py"))
GOAL = 0.15    # strain that the plastic path reaches, Spreng 2013


def reached(run):
    """Share of the path that is not reached; stress on the way to it against the flow curve."""
    strain, stress, most = scene.curve(run)
    _, gone = scene.fracture(strain, stress)
    on_way = stress[(strain > 0.02) & (strain < 0.05)] / scene.flow(strain[(strain > 0.02) & (strain < 0.05)]) - 1
    return {"error": 0.0 if gone is None else max(0.0, 1 - gone / GOAL), "fracture_strain": gone,
            "stress_off": abs(on_way).max()}


def by(**more):
    """Settings of fix adapt/neigh with those of the scene's resistance, and constant h with other means, or with none."""
    resisted = dict(more, options=scene.RESISTED)
    rows = {label: dict(resisted, **variables) for label, variables in scene.LENGTHS.items()}
    rows["rows kept"] = dict(more, **scene.PATH)
    return dict(rows, bare=dict(more, options=scene.BARE), balanced=dict(more, options=scene.BALANCED))


def tension(settings):
    return Sweep(name="tension", quantity="strain reached by the flat specimen, shortfall",
                 reference="0.15, the plastic path of S13", kind="published SPH", measure=reached, settings=settings,
                 script=example("flat_tensile_c45e"),
                 also=[("stress", "engineering stress at strain 0.02 to 0.05", "flow curve of the material", CLOSED,
                        "stress_off")])


SWEEPS = [tension({"quick": by(rows=8, speed=20), "full": by(rows=14, speed=20), "large": by(rows=28, speed=20)})]
