"""Kernel, and correction of its gradient: patch test and plate."""
import os

from cases import plate
from frame import CLOSED, ROOT, Sweep, module

TITLE = "kernel and gradient correction"
forms = module(os.path.join(ROOT, "unittest", "scenes", "test_kernels_forms.py"))
BASE = "correction "


def patch_script(variables):
    """Three steps' worth of patch test; then more of them, which are timed."""
    kernel = variables.pop("kernel")
    correction, steps = variables.pop("correction"), variables.pop("steps")
    return forms.patch_script(3, kernel, "correction " + correction) + "run %d\n" % steps


def patch_off(run):
    worst, dropped = forms.patch_errors(3, run.dump("end.dump")[-1])
    return {"error": worst, "edges_dropped": dropped}


def each(more, make):
    return {"%s%s" % (k, " corrected" if c == "yes" else ""): dict(more, **make(k, c))
            for k in forms.KERNELS for c in ("no", "yes")}


def patches(steps):
    return each({"steps": steps}, lambda k, c: {"kernel": k, "correction": c})


def plates(rows):
    return each({"rows": rows, "end": 0.2},
                lambda k, c: {"kernel": "%s %g" % (k, forms.KERNELS[k]), "options": BASE + c})


SWEEPS = [
    Sweep(name="patch", quantity="rate of stress in a linear velocity on disordered particles",
          reference="linear field",
          kind=CLOSED, script=patch_script, settings={"quick": patches(3000), "full": patches(10000)},
          measure=patch_off, baseline="hyperbolic"),
    plate({"quick": plates(6), "full": plates(10)}, baseline="hyperbolic"),
]
