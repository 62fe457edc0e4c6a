"""The default stabilization beside artificial stress and hourglass control of constant stiffness: what each does to the
answer. The flat specimen is measured against the flow curve at the rate and with the heat of the run."""
import numpy as np

from cases import plate, rings, taylor
from frame import CLOSED, Sweep, example, module

TITLE = "stabilization"
scene = module(example("flat_tensile_c45e", "scene.py"))
SETS = {"default": "", "stabilize artstress": "stabilize artstress", "hourglass 0.02": "hourglass 0.02",
        "no correction": "correction no"}
GAUGE, SPEED = 0.05, 20.0                                                        # m, m/s
A, B, N, C, T0, MELT = 553.1e6, 600.8e6, 0.234, 0.0134, 293.15, 1733.0           # card c45e, Jaspers 1999
HEATING = 0.9 / (7870.0 * 486.0)                                                 # plastic work -> temperature


def flow(strain):
    """Engineering stress of a bar that stays even, heated by its plastic work."""
    true = np.linspace(0.0, np.log1p(strain.max()), 2000)
    rate = SPEED / GAUGE * np.exp(-true)
    stress, rise = np.zeros_like(true), 0.0
    for k, e in enumerate(true):
        stress[k] = (A + B * e**N) * (1 + C * np.log(rate[k])) * (1 - rise / (MELT - T0))
        rise += HEATING * stress[k] * (true[1] - true[0])
    return np.interp(np.log1p(strain), true, stress) / (1 + strain)


def drawn(run):
    strain, stress, _ = scene.curve(run)
    _, gone = scene.fracture(strain, stress)
    on = (strain > 0.02) & (strain < (0.1 if gone is None else min(0.1, gone)))
    off = stress[on] / flow(strain)[on] - 1
    return {"error": abs(off).max(), "mean_off": off.mean(), "parts_at": gone}


def specimen(settings):
    return Sweep(name="tension", quantity="engineering stress of the flat specimen, strain 0.02 to 0.1",
                 reference="flow curve with rate and heat", kind=CLOSED, script=example("flat_tensile_c45e"),
                 settings=settings, measure=drawn, order=lambda v: 1 / v["rows"])


def by(**more):
    return {label: dict(more, options=(more.get("before", "") + options).strip()) for label, options in SETS.items()}


def finer(key, values, options="", **more):
    return {"%s %d" % (key, n): dict(more, options=options, **{key: n}) for n in values}


KERNEL = {"kernel": "hyperbolic 1.2"}


def drawn_by(rows):
    return {label: dict(KERNEL, rows=rows, speed=SPEED, options="plane stress " + options)
            for label, options in SETS.items()}


SWEEPS = [
    plate({"quick": finer("rows", (6, 10), **KERNEL), "full": finer("rows", (6, 10, 20), **KERNEL),
           "large": finer("rows", (6, 10, 20, 40), **KERNEL)}, order=lambda v: 1 / v["rows"],
          also=[("decay", "net energy that artificial terms take from the oscillation", "elastic: nothing", CLOSED, "lost")]),
    taylor({"quick": finer("rings", (4, 6)), "full": finer("rings", (4, 6, 9)), "large": finer("rings", (4, 6, 9, 12))},
           order=lambda v: 1 / v["rings"]),
    taylor({size: by(rings=n) for size, n in (("quick", 4), ("full", 6), ("large", 9))}, baseline="default"),
    specimen({size: finer("rows", rows, options="plane stress", speed=SPEED, **KERNEL)
              for size, rows in (("quick", (8, 14)), ("full", (8, 14, 25)), ("large", (8, 14, 25, 50)))}),
    specimen({size: drawn_by(n) for size, n in (("quick", 8), ("full", 14), ("large", 25))}),
    rings({"quick": {label: {"options": o} for label, o in SETS.items()},
           "full": {"speed %g" % v: {"options": "", "speed": v} for v in (0.059, 0.12)}}),
]
