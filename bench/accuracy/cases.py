"""Cases with a reference that several knobs use, as makers of sweeps: what varies is in the settings."""
import os
import subprocess
import sys

import numpy as np

from frame import CLOSED, ELEMENTS, ROOT, Sweep, changed, example, module

plate_test = module(os.path.join(ROOT, "unittest", "scenes", "test_oscillating_plate.py"))
rings_test = module(os.path.join(ROOT, "unittest", "scenes", "test_rings.py"))
make_bar = module(example("taylor_bar", "make_bar.py")).make_bar
bar_shape = module(example("taylor_bar", "measure.py")).shape
heat_error = module(example("two_layer_heat", "measure.py")).error
# Taylor bar: the limit of refined finite elements (examples/taylor_bar/finite_elements.py)
LENGTH, RADIUS = (1e-3 * x for x in module(example("taylor_bar", "shots.py")).SHOTS["linear"][4])


def plane(folder):
    subprocess.run([sys.executable, os.path.join(ROOT, "tools", "make_tool.py"), "plane", "--size", "1", "1", "--cells",
                    "2", "2", "-o", os.path.join(folder, "plane.stl")], check=True, stdout=subprocess.DEVNULL)


# --- clamped plate: half a swing of the first mode

def swing(run):
    tip, t = run.columns("tip.dat"), run.thermo[-1]
    try:
        period = plate_test.period(tip[:, 1], tip[:, 2] - tip[0, 2])
    except IndexError:
        return {"error": None, "note": "no return to the middle"}
    return {"error": abs(period / plate_test.FACES - 1), "period": period,
            "lost": abs(t["f_body[7]"][-1]) / t["f_body[1]"][0]}


def plate(settings, **more):
    """Variables: those of the script, which runs long enough for half a period of 0.32 s."""
    settings = {size: {label: dict({"end": 0.16}, **v) for label, v in s.items()} for size, s in settings.items()}
    return Sweep(name="plate", quantity="period of the clamped plate", reference="0.2621 s", kind=ELEMENTS,
                 script=example("oscillating_plate"), settings=settings, measure=swing, **more)


# --- Taylor bar

def bar(folder, variables):
    variables["dx"] = make_bar(variables.pop("rings"), 3.2e-3, 32.4e-3, 8930, os.path.join(folder, "bar.data"))
    plane(folder)


def bar_script(variables):
    return changed(example("taylor_bar"),
                   ("move 0 0 $(-0.05*v_dx)", "move 0 0 $(-0.05*v_dx) " + variables.pop("wall", "")))


def foot(run):
    length, radius, _, _ = bar_shape(run.dump("end.dump")[-1], run.variables["dx"])
    t = run.thermo[-1]
    return {"error": max(abs(length / LENGTH - 1), abs(radius / RADIUS - 1)), "length_mm": 1e3 * length,
            "radius_mm": 1e3 * radius,
            "penetration": t["f_wall[13]"].max(), "energy_drift": np.ptp(t["f_body[9]"]) / t["f_body[1]"][0]}


def taylor(settings, measure=foot, quantity="length and radius of the Taylor bar, the larger error",
           reference="%.4g and %.4g mm" % (1e3 * LENGTH, 1e3 * RADIUS), kind=ELEMENTS, **more):
    """Variables: rings, wall (options of the contact), and those of the script."""
    return Sweep(name="taylor", quantity=quantity, reference=reference, kind=kind, script=bar_script, settings=settings,
                 measure=measure, prepare=bar, **more)


# --- two layers of heat

def heat_script(variables):
    kernel, precision = variables.pop("kernel", "hyperbolic 1.2"), variables.pop("precision", "double")
    return changed(example("two_layer_heat"), ("hyperbolic 1.2", "%s precision %s" % (kernel, precision)))


def heat_off(run):
    t = run.thermo[-1]
    return {"error": heat_error(run.dump("temperature.dump")[-1], 10, t["Time"][-1]).max(),
            "heat_lost": abs(t["c_mean"] / t["c_mean"][0] - 1).max()}


def heat(settings, **more):
    """Variables: n, kernel, precision."""
    return Sweep(name="heat", quantity="temperature of two layers, largest error over the jump",
                 reference="error function",
                 kind=CLOSED, script=heat_script, settings=settings, measure=heat_off, **more)


# --- colliding rings

def rebound(run):
    """Work of the artificial terms over the kinetic energy: rings of an elastic material lose nothing."""
    t, end = run.thermo[-1], run.dump("end.dump")[-1]
    sizes, whole = rings_test.pieces(end), len(end["id"])
    answer = {"error": abs(t["f_body[7]"][-1]) / t["f_body[1]"][0], "speed_back": -t["v_pl"][-1] / t["v_pl"][0]}
    if len(sizes) > 2 or sum(sizes) != whole:
        answer.update(error=None, note="broken into %d pieces" % len(sizes))
    return answer


def rings(settings, **more):
    return Sweep(name="rings", quantity="net energy that artificial terms take from the colliding rings",
                 reference="elastic: nothing", kind=CLOSED, script=example("rings"), settings=settings, measure=rebound,
                 prepare=lambda folder, variables: rings_test.make_rings(os.path.join(folder, "rings.data")), **more)
