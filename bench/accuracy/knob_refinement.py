"""Refinement where stress is high against uniform particles: a notched specimen."""
from frame import ELEMENTS, Sweep, example, module

TITLE = "refinement against uniform"
scene = module(example("notched_specimen", "scene.py"))


def off(run):
    x, s, _, frame = scene.profile(run, int(run.variables["columns"]))
    inner, rms, whole = scene.errors(x, s)
    return {"error": rms, "largest": inner, "whole": whole, "particles_end": len(frame["x"])}


def by(uniform, refined):
    rows = {"uniform %d" % c: {"columns": c} for c in uniform}
    return dict(rows, **{"refined %d" % c: {"columns": c, "adapt": scene.REFINE % scene.WIDE} for c in refined})


SWEEPS = [
    Sweep(name="notch", quantity="von Mises stress along the ligament of a notched specimen, rms error", reference="CalculiX",
          kind=ELEMENTS, also=[("largest", "the same, largest error", "CalculiX", ELEMENTS, "largest")],
          script=example("notched_specimen"), measure=off,
          settings={"quick": by((16, 23, 30, 45), (16, 23)), "full": by((23, 30, 45, 64, 86), (23, 30, 45)),
                    "large": by((45, 86, 172), (45, 86))}),
]
