"""The frame of the stability cases. A file case_NAME.py makes one Case:

    CASE = Case(
        title=..., criterion=..., counter=...,   # in words
        setup=...,      # script up to the particles, pair style and velocities; {name} stands for settings
        model=...,      # fixes, computes, thermo: what is given again after a restart
        steps=...,      # or a setting's name
        settings={...}, # values of the names, for the run
        bad={...},      # and what the counter-run changes: stabiliser off, step too large
        judge=...,      # function(Run) -> value; the criterion holds when value <= limit
        limit=...,
        stops=...)      # of an error that the counter-run may be stopped with: regular expression

The frame runs it to its end, runs it again from a restart file written half way (the final states must agree in every
bit), and runs the counter-run, which must break the criterion or be stopped by the check that it is meant for: by default
one of fix sph/tm in a step; where a step that is too large is refused before the first, that message. A run that stops for
any other reason (a wrong script, a lost particle, a crash) does not count as failing."""
import importlib.util
import os
import re
import shlex
import subprocess
import sys
import time

import numpy as np

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
sys.path.insert(0, os.path.join(ROOT, "unittest", "scenes"))
from sphtm_scene import PLANE, SPACE, lattice_block, new_folder, run    # noqa: E402,F401

STOPS = r"Fix sph/tm\b.* stops at step [1-9]"    # by a state, the time step or the energies
END = "write_dump all custom {name}.dump id type x y z vx vy vz {values} modify sort id format float %.17g\n"


class Case:
    def __init__(self, title, criterion, counter, setup, model, steps, judge, limit, settings=None, bad=None,
                 meshes=None, values="", restart=True, quick=None, unit="", prepare=None, before="", stops=STOPS):
        self.title, self.criterion, self.counter, self.unit = title, criterion, counter, unit
        self.setup, self.model, self.steps, self.judge, self.limit = setup, model, steps, judge, limit
        self.settings, self.bad, self.quick = settings or {}, bad or {}, quick or {}
        self.meshes, self.values, self.restart, self.prepare = meshes or {}, values, restart, prepare
        self.stops = stops
        self.before = before    # between model and run, in the first run alone


class Run:
    """One run to its end: thermo table t, last frame end, settings; error if it was stopped."""

    def __init__(self, case, settings, result, seconds):
        self.settings, self.result, self.seconds = settings, result, seconds
        self.error = "" if result.status == 0 else (result.errors() or "status %d" % result.status).splitlines()[0]
        # of the runs of one script: a table; the first row of the second is the last of the first
        tables = result.thermo
        self.t = {}
        for k in tables[0] if tables else ():
            self.t[k] = np.concatenate([tables[0][k]] + [t[k][1:] for t in tables[1:]])
        self.output = result.output
        self.end = None if self.error else result.dump("end.dump")[-1]
        self.steps = int(self.t["Step"][-1]) if "Step" in self.t else 0


def make_meshes(case, folder, settings):
    for name, arguments in case.meshes.items():
        subprocess.run([sys.executable, os.path.join(ROOT, "tools", "make_tool.py")] +
                       shlex.split(arguments.format(**settings)) + ["-o", os.path.join(folder, name)], check=True,
                       stdout=subprocess.DEVNULL)
    if case.prepare:
        case.prepare(folder, settings)


def run_case(case, settings, half=False):
    """The run, from its start or (half) from the restart file in the folder of an earlier one."""
    folder = new_folder()
    make_meshes(case, folder, settings)
    steps = int(settings[case.steps] if isinstance(case.steps, str) else case.steps)
    text = case.setup.format(**settings) + case.model.format(**settings) + case.before.format(**settings)
    first = steps // 2
    end = END.format(name="end", values=case.values)
    text += "run %d\n" % steps if not half else "run %d\nwrite_restart half.restart\nrun %d\n" % (first, steps - first)
    began = time.time()
    one = Run(case, settings, run(text + end, folder=folder, expect_error=True, timeout=3000), time.time() - began)
    if not half:
        return one
    if one.error:
        return one, None
    with open(os.path.join(folder, "end.dump")) as f:
        whole = f.read()
    text = "read_restart half.restart\n" + case.model.format(**settings) + "run %d\n" % (steps - first)
    run(text + END.format(name="again", values=case.values), folder=folder, timeout=3000)
    with open(os.path.join(folder, "again.dump")) as f:
        return one, f.read() == whole


def measure(case, quick=False):
    settings = dict(case.settings, **(case.quick if quick else {}))
    answer = {"title": case.title, "criterion": case.criterion, "counter_run": case.counter, "limit": case.limit,
              "unit": case.unit}
    if case.restart:
        good, same = run_case(case, settings, half=True)
        answer["restart"] = "not reached" if good.error else "same bits" if same else "differs"
    else:
        good, answer["restart"] = run_case(case, settings), "not tried"
    answer.update(steps=good.steps, seconds=round(good.seconds, 1), error=good.error)
    answer["value"] = None if good.error else float(case.judge(good))
    answer["holds"] = bool(not good.error and answer["value"] <= case.limit)
    bad = run_case(case, dict(settings, **case.bad))
    answer["counter_value"] = None if bad.error else float(case.judge(bad))
    answer["counter_error"] = bad.error
    answer["counter_fails"] = bool(re.search(case.stops, bad.error) if bad.error else
                                   not answer["counter_value"] <= case.limit)
    if bad.error and not answer["counter_fails"]:
        answer["error"] = (answer["error"] + "; " if answer["error"] else "") + "counter-run: " + bad.error
    return answer


def answer(title, criterion, counter, limit, steps, began, value, counter_value, **more):
    """What measure() returns, of a case that runs by itself; a counter-run that was stopped has the value inf."""
    stopped = not np.isfinite(counter_value)
    return dict(title=title, criterion=criterion, counter_run=counter, limit=limit, unit="", restart="not tried",
                steps=steps, seconds=round(time.time() - began, 1), error="", value=value, holds=bool(value <= limit),
                counter_value=None if stopped else counter_value, counter_error="stopped" if stopped else "",
                counter_fails=bool(not counter_value <= limit), **more)


def load(name):
    spec = importlib.util.spec_from_file_location(name, os.path.join(HERE, "case_%s.py" % name))
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def pieces(x, reach):
    """Number of particles of each connected piece, links shorter than reach; the largest first."""
    x = np.asarray(x)
    left, sizes = np.ones(len(x), bool), []
    while left.any():
        front = [int(np.argmax(left))]
        left[front] = False
        size = 0
        while front:
            size += len(front)
            rest = np.nonzero(left)[0]
            if not len(rest):
                break
            near = ((x[rest, None, :] - x[None, front, :]) ** 2).sum(axis=2).min(axis=1) < reach * reach
            front = list(rest[near])
            left[front] = False
        sizes.append(size)
    return sorted(sizes, reverse=True)
