"""'run test' and 'run sanitize' of a bundle: small scenes, what stops a run, and the physics headers by themselves."""
import concurrent.futures
import json
import math
import os
import re
import shutil
import subprocess
import time

import cases
import scenes
import stops
from host import TOP, fresh, lammps, write

# Another machine adds in another order, with or without fused multiply-add: each step differs by some 1e-16 of the sums
# of a row, and motion, contact and yield magnify that. On one CPU the loops for AVX-512 and those of any x86-64 come
# out at most 2.5e-11 apart after these steps (block_on_slope); a GPU is given forty times that.
BOUND = 1e-9
# The same in single: the two instruction sets come out at most 2.9e-7 apart (contact_mixed).
MIXED_BOUND = 1.2e-5
# errors over the largest rate of the sample
AUDIT_BOUND = 1e-8
# numbers in a message are printed with six digits, of a state that is running away
MESSAGE_BOUND = 1e-4
HEADERS, STOPS = "headers", "stops"    # what 'run test' has besides scenes
HEADER_TEST = os.path.join(TOP, "libexec", "device")
EXPECTED = os.path.join(TOP, "expected")


def in_parallel(work, names, jobs):
    """work(name) of all, so many at a time, in their order."""
    with concurrent.futures.ThreadPoolExecutor(jobs) as pool:
        yield from pool.map(work, names)


def bound(name):
    return MIXED_BOUND if scenes.precision(name) == "mixed" else BOUND


def run_scene(name, folder, gpus, steps=None, more="", before=(), environment=None):
    """One small scene in a fresh folder with the files beside its script; seconds and what went wrong, or ''."""
    script, _, usual = scenes.SCENES[name]
    source = os.path.join(TOP, "scenes", name)
    fresh(folder)
    for entry in os.listdir(source):
        shutil.copy(os.path.join(source, entry), folder)
    with open(os.path.join(folder, os.path.basename(script))) as f:
        text = f.read()
    if scenes.precision(name) == "mixed":
        text = scenes.in_mixed(text)
    if name.endswith(scenes.AUDIT):
        text = scenes.audited(text)
    if name.endswith(scenes.ACTIVE):
        text = scenes.in_window(text)
    write(os.path.join(folder, "in.small"), scenes.small_script(text, steps or usual, scenes.displaced(name) + more))
    start = time.time()
    output, status = lammps(folder, ["-in", "in.small"] + scenes.variables(name, folder), gpus, before=before,
                            environment=environment)
    write(os.path.join(folder, "output"), output)
    return time.time() - start, "" if status == 0 else cases.failure(output, status)


def run_stop(name, folder, gpus=1, before=()):
    write(os.path.join(fresh(folder), "in.stop"), stops.script(name))
    output, status = lammps(folder, ["-in", "in.stop"], gpus, before=before)
    write(os.path.join(folder, "output"), output)
    return stops.message(output), status


def stop_folder(out, name):
    return os.path.join(out, "stop_" + name.replace(" ", "_"))


def reference(out, names):
    """Expected results, beside the scenes."""
    os.makedirs(EXPECTED, exist_ok=True)
    for name in names:
        if name in scenes.SCENES:
            seconds, error = run_scene(name, os.path.join(out, name), 1)
            if error:
                raise SystemExit("%s: %s" % (name, error))
            scenes.write_state(os.path.join(EXPECTED, name + ".gz"), scenes.state(os.path.join(out, name)))
            if name.endswith(scenes.AUDIT):
                shutil.copy(os.path.join(out, name, scenes.AUDITED), os.path.join(EXPECTED, name + ".audit"))
            print("%-22s %6.1f s" % (name, seconds), flush=True)
        if name == STOPS:
            said = {stop: run_stop(stop, stop_folder(out, stop))[0] for stop in stops.CASES}
            write(os.path.join(EXPECTED, "stops.json"), json.dumps(said, indent=1))


def audit_error(found, expected):
    """'' where an audit found what is expected, and something at all."""
    with open(expected) as f:
        wanted = [float(word) for word in f.read().split()]
    apart = max(abs(a - b) for a, b in zip(found, wanted))
    return "" if apart <= AUDIT_BOUND and min(wanted) > 0 else "audits %s, expected %s" % (found, wanted)


def test_scene(name, out, gpus):
    folder = os.path.join(out, name)
    seconds, error = run_scene(name, folder, gpus)
    result = {"scene": name, "steps": scenes.SCENES[name][2], "seconds": round(seconds, 2)}
    if not error:
        rows = scenes.state(folder)
        worst = scenes.differences(rows, scenes.read_state(os.path.join(EXPECTED, name + ".gz")))
        result.update(particles=len(rows), differences=worst)
        if worst is None:
            error = "other particles than expected"
        elif not all(d <= bound(name) for d in worst.values()):    # NaN is no <= either
            error = "differs by %.1e, allowed %.0e" % (max(worst.values(), key=lambda d: math.inf if d != d else d),
                                                       bound(name))
        if name.endswith(scenes.AUDIT):
            result["audit"] = scenes.audit(folder)
            error = error or audit_error(result["audit"], os.path.join(EXPECTED, name + ".audit"))
        # where there are ghosts: rates of the interior while their records travel
        _, trouble = run_scene(name, folder + ".again", gpus, environment={"SPHTM_OVERLAP": "1"})
        result["same_again"] = not trouble and scenes.state(folder + ".again") == rows
        if not result["same_again"]:
            error += ("; " if error else "") + "a second run is not the same bit for bit"
    result["error"] = error
    result["what"] = "" if error else "largest difference %.1e, twice the same" % max(worst.values())
    return result


def test_stops(out, gpus, jobs):
    """What stops a run says the same; rows that outgrow their room change nothing."""
    with open(os.path.join(EXPECTED, "stops.json")) as f:
        expected = json.load(f)
    results = []
    work = in_parallel(lambda name: run_stop(name, stop_folder(out, name), gpus), stops.CASES, jobs)
    for name, (said, status) in zip(stops.CASES, work):
        # with several ranks another one may be the first to say it
        texts = [re.sub(r" on proc \d+", "", text) for text in (said, expected[name])]
        same = status not in (0, "timeout") and stops.same(*texts, MESSAGE_BOUND)
        results.append({"scene": "stops: " + name, "what": said[:60],
                        "error": "" if same else "says '%s', expected '%s'" % (said, expected[name])})
    rows = []
    for script in stops.ROWS_GROW, stops.ROWS_STAY:
        folder = fresh(os.path.join(out, "rows%d" % len(rows)))
        write(os.path.join(folder, "in.rows"), script)
        output, status = lammps(folder, ["-in", "in.rows"], gpus)
        rows.append(scenes.rows_of(os.path.join(folder, "end.dump")) if status == 0 else cases.failure(output, status))
    same = rows[0] == rows[1] and len(rows[0]) == 64
    results.append({"scene": "rows outgrow their room", "what": "the same state",
                    "error": "" if same else "%s, %s" % tuple(
        r if isinstance(r, str) else "%d particles" % len(r) for r in rows)})
    return results


def test_headers():
    done = subprocess.run([HEADER_TEST], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    rows = [line.split() for line in done.stdout.splitlines()]
    checked = [{"group": r[0], "case": r[1], "values": int(r[2]), "share_of_allowed": float(r[3]), "ok": r[4] == "ok"}
               for r in rows if len(r) == 5]
    failed = [c for c in checked if not c["ok"]]
    error = ""
    if done.returncode != 0 or failed or not checked:
        error = "ends with %s: %s" % (done.returncode,
                                      "; ".join("%(group)s %(case)s" % c for c in failed) or done.stdout[-300:])
    most = max([c["share_of_allowed"] for c in checked] or [math.nan])
    what = "%d cases, at most %.3f of what is allowed" % (len(checked), most)
    return [{"scene": "headers on the device", "cases": checked, "what": what, "error": error}]


def say(result):
    print("%-6s %-32s %6.1f s  %s" % ("FAILED" if result["error"] else "ok", result["scene"], result.get("seconds", 0),
                                      result["error"] or result["what"]), flush=True)
    return result


def summary(results, **more):
    failed = sum(bool(r["error"]) for r in results)
    print("%d passed, %d failed" % (len(results) - failed, failed))
    return dict(more, passed=len(results) - failed, failed=failed, scenes=results), failed


def test(out, names, gpus, jobs):
    results = []
    if HEADERS in names and os.path.isfile(HEADER_TEST):
        results += [say(r) for r in test_headers()]
    if STOPS in names:
        results += [say(r) for r in test_stops(out, gpus, jobs)]
    chosen = [name for name in names if name in scenes.SCENES]
    results += [say(r) for r in in_parallel(lambda name: test_scene(name, out, gpus), chosen, jobs)]
    return summary(results, gpus=gpus, bound=BOUND, message_bound=MESSAGE_BOUND)


# --- compute-sanitizer

TOOLS = ("memcheck", "racecheck")
SANITIZE_STEPS = 12
SANITIZE_MORE = "neigh_modify    delay 0 every 4 check no\n"    # some rebuilds in these steps
FOUND = 86                                                      # exit status of a run with findings


def find_sanitizer():
    for folder in "", os.environ.get("CUDA_HOME", "/usr/local/cuda"):
        for within in "bin", "compute-sanitizer":
            path = os.path.join(folder, within, "compute-sanitizer")
            if folder and os.path.isfile(path):
                return path
    return shutil.which("compute-sanitizer")


def sanitize(out, names, jobs):
    """Short runs of all scenes and stops, and the headers' test, under memcheck and racecheck."""
    program = find_sanitizer()
    if not program:
        raise SystemExit("no compute-sanitizer here")
    chosen = [n for n in names if n in scenes.SCENES]
    if STOPS in names:
        chosen += ["stops: " + n for n in stops.CASES]
    if HEADERS in names and os.path.isfile(HEADER_TEST):
        chosen.append(HEADERS)

    def work(item):
        tool, name = item
        folder = os.path.join(out, tool + "_" + re.sub(r"\W+", "_", name))
        log = folder + ".log"
        before = [program, "--tool", tool, "--error-exitcode", str(FOUND), "--target-processes", "all", "--log-file",
                  log]
        start, error = time.time(), ""
        if name == HEADERS:
            done = subprocess.run(before + [HEADER_TEST], stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
            status = done.returncode
            error = "" if status == 0 else "ended with %s: %s" % (status, done.stdout[-200:])
        elif name in scenes.SCENES:
            _, error = run_scene(name, folder, 1, SANITIZE_STEPS, SANITIZE_MORE, before)
        else:
            said, _ = run_stop(name.split(": ")[1], folder, before=before)
            error = "" if said else "no message"
        text = ""
        if os.path.isfile(log):
            with open(log) as f:
                text = f.read()
        found = re.findall(r"(?:ERROR|RACECHECK) SUMMARY: (\d+) (?:errors?|hazards?)", text)
        if not found:
            error = (error + "; " if error else "") + "no summary of " + tool
        elif any(int(n) for n in found):
            error = "%s errors: %s" % (found[-1], " ".join(text.split("=========")[2:6])[:400])
        return {"scene": "%s: %s" % (tool, name), "seconds": round(time.time() - start, 2), "error": error,
                "what": "clean", "log": text[-4000:] if error else ""}

    items = [(tool, name) for tool in TOOLS for name in chosen]
    results = [say(r) for r in in_parallel(work, items, jobs)]
    return summary(results, steps=SANITIZE_STEPS, program=program)


