"""The frame of the accuracy sweeps. A file knob_NAME.py has TITLE and SWEEPS, a list of

    Sweep(name=..., quantity=..., reference=...,   # of the error, in words
          kind=...,       # of the reference: "closed form", "finite elements", "finer run" (of the same code), ...
          script=...,     # path of a script, or function(variables) -> its text; what it takes out of them is no -var
          settings={"quick": {label: variables, ...}, "full": ..., "large": ...},    # large: for a GPU; may be absent
          measure=...,    # function(Run) -> {"error": relative error, or None where the run broke, more numbers}
          baseline=...,   # label of the setting whose time is 1; without it the first
          against=...,    # label of the setting that is the reference; measure then gives "value" instead of "error"
          order=...,      # function(variables) -> spacing or step, to fit the order of convergence over
          prepare=...,    # function(folder, variables): files of the run
          also=...)       # further errors of these runs: list of (name, quantity, reference, kind, its name in measure)

Every setting runs N times, round by round, so that a busy spell of the machine hits all alike; times are medians, and
ratios to the baseline of the same sweep in the same call."""
import importlib.util
import os
import shlex
import shutil
import statistics
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path[:0] = [os.path.join(ROOT, "bench"), os.path.join(ROOT, "unittest", "scenes")]
from sphtm_scene import Result, new_folder, order_of_convergence, run    # noqa: E402
from study import last_loop, loop_times                                # noqa: E402

SIZES = ("quick", "full", "large")
CLOSED, ELEMENTS, SAME = "closed form", "finite elements", "finer run of the same code"


class Sweep:
    def __init__(self, name, quantity, reference, kind, script, settings, measure, baseline=None, against=None,
                 order=None, prepare=None, also=()):
        self.name, self.quantity, self.reference, self.kind, self.script = name, quantity, reference, kind, script
        self.settings, self.measure, self.baseline, self.against = settings, measure, baseline, against
        self.order, self.prepare, self.also = order, prepare, also


class Run(Result):
    """Of one setting, as sphtm_scene has it, with its variables."""

    def __init__(self, result, variables):
        self.__dict__.update(result.__dict__, variables=variables)


def example(name, *more):
    return os.path.join(ROOT, "examples", name, *(more or ("in." + name,)))


def module(path):
    """A file of Python as a module of its own; several scenes have a measure.py."""
    sys.path.insert(0, os.path.dirname(path))
    try:
        name = os.path.relpath(path, ROOT)[:-3].replace(os.sep, "_")
        spec = importlib.util.spec_from_file_location(name, path)
        answer = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(answer)
        return answer
    finally:
        sys.path.remove(os.path.dirname(path))    # a scene may have put more before it


def changed(path, *changes):
    """Text of a script with pieces replaced; every one must be there."""
    with open(path) as f:
        text = f.read()
    for old, new in changes:
        if old not in text:
            sys.exit("%s: no '%s' to replace" % (path, old))
        text = text.replace(old, new)
    return text


def one_run(sweep, variables, lmp, measured):
    """Times of one run and, if asked for, what was measured."""
    variables, folder = dict(variables), new_folder()
    more = dict(variables)
    if sweep.prepare:
        sweep.prepare(folder, more)
    script = sweep.script(more) if callable(sweep.script) else sweep.script
    result = run(script, {k: v for k, v in more.items() if v is not None}, folder=folder, timeout=100000,
                 arguments=shlex.split(lmp), expect_error=True)
    wall, processor = loop_times(result.output)
    steps, particles = last_loop(result.output)
    point = {"wall": wall, "processor": processor, "particles": particles, "steps": steps, "note": ""}
    if result.status:
        point.update(error=None, note=(result.errors() or result.output[-300:]).splitlines()[0][:160])
    elif measured:
        point.update(sweep.measure(Run(result, dict(variables, **more))))
    if not os.environ.get("SPHTM_KEEP"):
        shutil.rmtree(folder)
    return point


def front(points, clock):
    """Marks the points that no other beats in both time and error."""
    good = [p for p in points if p["error"] is not None]
    for p in points:
        p["front"] = p in good and not any(
            q["error"] <= p["error"] and q[clock] <= p[clock] and (q["error"] < p["error"] or q[clock] < p[clock])
            for q in good)


def measure(sweep, size, repeats, clock, lmp="", say=print):
    """All settings of a sweep; a list of points."""
    settings, points = sweep.settings[size], {}
    for repeat in range(repeats):
        for label, variables in settings.items():
            if repeat and points[label][0].get("error", 0) is None:
                continue    # it broke, and will again
            points.setdefault(label, []).append(one_run(sweep, variables, lmp, repeat == 0))
    answer = []
    for label, runs in points.items():
        p = dict(runs[0], setting=label)
        for kind in ("wall", "processor"):
            p[kind] = statistics.median(r[kind] for r in runs)
        answer.append(p)
    if sweep.against:
        value = next(p["value"] for p in answer if p["setting"] == sweep.against)
        for p in answer:
            p["error"] = None if p.get("value") is None else abs(p["value"] / value - 1)
            if p["setting"] == sweep.against:
                p.update(error=None, note="the reference")
    base = next(p for p in answer if p["setting"] == (sweep.baseline or next(iter(settings))))
    if not base["wall"] > 0:
        sys.exit("sphtm accuracy: '%s' of %s, to which times are relative, stopped: %s" % (base["setting"], sweep.name, base.get("note", "")))
    for p in answer:
        p["relative_time"], p["relative_processor"] = p["wall"] / base["wall"], p["processor"] / base["processor"]
    finish(answer, clock, say)
    return answer


def measured_too(points, key, clock, say=print):
    """The points with another error of the same runs."""
    answer = [dict(p, error=None if p["error"] is None else p.get(key)) for p in points]
    finish(answer, clock, say)
    return answer


def finish(points, clock, say):
    front(points, clock)
    for p in points:
        say("  %-34s %s error %-9s time %6.2f  processor %6.2f  (%.2f s, %.2f) %s" % (
            p["setting"], "*" if p["front"] else " ", number(p["error"]), p["relative_time"], p["relative_processor"],
            p["wall"], p["processor"], p["note"]))


def order(sweep, size, points):
    """Slope of log error over log spacing (or step), of the points that have an error."""
    if not sweep.order:
        return None
    good = [p for p in points if p["error"]]
    if len(good) < 2:
        return None
    return order_of_convergence([sweep.order(sweep.settings[size][p["setting"]]) for p in good],
                                [p["error"] for p in good])


def number(x):
    return "-" if x is None else "%.3g" % x
