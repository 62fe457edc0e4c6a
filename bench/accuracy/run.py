"""What accuracy costs: for each knob sweeps of its settings on cases with a reference, error against time. Writes
<knob>.csv, <knob>.png, overview.png, table.rst, points.rst and summary.json. Called by ./sphtm accuracy [knob ...]
[options]."""
import argparse
import csv
import json
import os
import sys
import time

sys.dont_write_bytecode = True
sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import frame    # noqa: E402

OUT = os.environ.get("SPHTM_OUT", os.path.join(frame.ROOT, "out", "accuracy"))
NAMES = sorted(f[5:-3] for f in os.listdir(frame.HERE) if f.startswith("knob_") and f.endswith(".py"))
COLUMNS = ("setting", "error", "relative_time", "relative_processor", "wall", "processor", "particles", "steps",
           "front", "note")
TARGETS = (0.01, 0.05, 0.1)


def arguments():
    options = argparse.ArgumentParser(prog="sphtm accuracy", description=__doc__.split(". ")[0])
    options.add_argument("knobs", nargs="*", metavar="knob", help="some of: " + " ".join(NAMES))
    options.add_argument("--quick", action="store_true", help="the same as --size quick: less than 20 minutes")
    options.add_argument("--size", choices=frame.SIZES, default="full", help="large: for a GPU")
    options.add_argument("--repeats", type=int, default=3, help="runs of each setting; times are their medians")
    options.add_argument("--clock", choices=("wall", "processor"), default="wall",
                         help="the time of fronts and pictures; processor: on a machine that others use too")
    options.add_argument("--sweep", action="append", default=[], help="only sweeps of this name")
    options.add_argument("--lmp", default="", help="more arguments of lmp, for example '-k on g 1 -sf kk'")
    options.add_argument("--look", action="store_true", help="only tables and pictures of what earlier calls left")
    options = options.parse_args()
    wrong = [k for k in options.knobs if k not in NAMES]
    if wrong:
        sys.exit("sphtm accuracy: no knob '%s'; there are: %s" % ("', '".join(wrong), " ".join(NAMES)))
    if options.repeats < 1:
        sys.exit("sphtm accuracy: --repeats %d must be 1 or more" % options.repeats)
    options.size = "quick" if options.quick else options.size
    options.knobs = options.knobs or NAMES
    return options


def say(text):
    print(text, flush=True)


def load(options):
    """Modules of the knobs asked for."""
    modules = {name: frame.module(os.path.join(frame.HERE, "knob_%s.py" % name)) for name in options.knobs}
    known = sorted({s.name for m in modules.values() for s in m.SWEEPS})
    for s in options.sweep:
        if s not in known:
            sys.exit("sphtm accuracy: no sweep '%s'; there are: %s" % (s, " ".join(known)))
    return modules


def knob(name, found, options):
    sweeps = [s for s in found.SWEEPS if options.size in s.settings and (not options.sweep or s.name in options.sweep)]
    answer = {"title": found.TITLE, "size": options.size, "repeats": options.repeats, "lmp": options.lmp, "sweeps": {}}
    for s in sweeps:
        runs = None
        for label, quantity, reference, kind, key in [(s.name, s.quantity, s.reference, s.kind, "error"), *s.also]:
            say("%s: %s, %s against %s (%s)" % (name, label, quantity, reference, kind))
            points = (frame.measured_too(runs, key, options.clock, say) if runs else
                      frame.measure(s, options.size, options.repeats, options.clock, options.lmp, say))
            runs, slope = runs or points, frame.order(s, options.size, points)
            if slope is not None:
                say("  order %.2f" % slope)
            answer["sweeps"][label] = {"quantity": quantity, "reference": reference, "kind": kind, "points": points,
                                       "baseline": s.baseline or next(iter(s.settings[options.size])), "order": slope}
    return answer


def write_csv(name, found):
    with open(os.path.join(OUT, name + ".csv"), "w", newline="") as f:
        writer = csv.writer(f)
        writer.writerow(("sweep",) + COLUMNS + ("more",))
        for sweep, s in found["sweeps"].items():
            for p in s["points"]:
                more = " ".join("%s=%.6g" % kv
                                for kv in p.items() if kv[0] not in COLUMNS and isinstance(kv[1], (int, float)))
                writer.writerow([sweep] + ["%.6g" % p[c] if isinstance(p[c], float) else p[c] for c in COLUMNS]
                                + [more])


def cheapest(points, target, clock):
    return min((p for p in points if p["error"] <= target), key=lambda p: p[clock], default=None)


def list_table(path, rows):
    with open(path, "w") as f:
        f.write(".. list-table::\n   :header-rows: 1\n\n")
        for row in rows:
            f.write("   * - %s\n" % row[0] + "".join("     - %s\n" % v for v in row[1:]))


def shortly(note):
    return "stopped" if note.startswith("ERROR") else note


def tables(knobs, clock):
    """What to set for an error: the cheapest setting of each sweep; and all points. Times are over the sweep's
    baseline."""
    time_of = "relative_time" if clock == "wall" else "relative_processor"
    answers = [("knob", "case", "reference", "time is 1 at") + tuple("%g %%" % (100 * t) for t in TARGETS)
               + ("least error",)]
    points = [("case", "setting: error, time; * on the front", "order")]
    for name, k in sorted(knobs.items()):
        for label, s in k["sweeps"].items():
            good = [p for p in s["points"] if p["error"] is not None]
            cells = [cheapest(good, t, clock) for t in TARGETS]
            best = min(good, key=lambda p: p["error"]) if good else None
            answers.append((k["title"], s["quantity"], "%s (%s)" % (s["reference"], s["kind"]), s["baseline"],
                            *("%s: %.2f" % (p["setting"], p[time_of]) if p else "not reached" for p in cells),
                            "%.2g %%: %s" % (100 * best["error"], best["setting"]) if best else "none"))
            points.append(("%s, %s" % (name, label), "; ".join(
                "%s: %s" % (p["setting"], shortly(p["note"]) if p["error"] is None else "%.2g %%, %.2f%s" % (
                    100 * p["error"], p[time_of], " \\*" if p["front"] else "")) for p in s["points"]),
                "" if s["order"] is None else "%.1f" % s["order"]))
    list_table(os.path.join(OUT, "table.rst"), answers)
    list_table(os.path.join(OUT, "points.rst"), points)


def write(knobs, options, seconds):
    for name in options.knobs:
        if name in knobs:
            write_csv(name, knobs[name])
    points = [{"knob": n, "sweep": s, "setting": p["setting"], "error": p["error"], "relative_time": p["relative_time"]}
              for n, k in sorted(knobs.items()) for s, v in k["sweeps"].items() for p in v["points"]]
    with open(os.path.join(OUT, "summary.json"), "w") as f:
        json.dump({"size": options.size, "clock": options.clock, "minutes": round(seconds / 60, 1), "load_average":
                   round(os.getloadavg()[0], 1), "points": points, "knobs": {n: knobs[n] for n in sorted(knobs)}}, f,
                   indent=1)
        f.write("\n")
    tables(knobs, options.clock)


def main():
    options, began = arguments(), time.time()
    modules = load(options)
    os.makedirs(OUT, exist_ok=True)
    path, knobs = os.path.join(OUT, "summary.json"), {}
    if os.path.exists(path):    # knobs of earlier calls of the same size stay
        with open(path) as f:
            earlier = json.load(f)
        knobs = {n: k for n, k in earlier["knobs"].items() if n in NAMES and k["size"] == options.size}
    if options.look:
        options.knobs = [name for name in options.knobs if name in knobs]
        write(knobs, options, 60 * earlier["minutes"] if knobs else 0)
    for name in [] if options.look else options.knobs:
        knobs[name] = knob(name, modules[name], options)
        write(knobs, options, time.time() - began)
    try:
        plot = frame.module(os.path.join(frame.HERE, "plot.py"))
    except ImportError as missing:
        print("no pictures: %s" % missing)
    else:
        plot.draw(knobs, options.knobs, OUT, options.clock)
    print("%.1f minutes; written to %s" % ((time.time() - began) / 60, path))


if __name__ == "__main__":
    main()
