"""Two examples whose particles are numbered by the rank that makes them, on two ranks with Kokkos as on one without:
particle by particle, found by the place where it started. Rows are summed in order of the numbers, so only round-off
differs, which motion and contact magnify (bench/gpu/tests.py says by how much)."""
import os
import shutil
import sys

from kokkos_scene import SOURCE, Checks, new_folder, run_way

sys.path.insert(0, os.path.join(SOURCE, "bench", "gpu"))
import scenes    # noqa: E402

BOUND = 1e-9
checks = Checks()
for name in "high_speed_machining", "orthogonal_cut_2d":
    script, variables, steps = scenes.SCENES[name]
    states = {}
    for way, ranks in ("plain", 1), ("serial", 2):
        folder = new_folder()
        source = os.path.dirname(os.path.join(SOURCE, script))
        for entry in os.listdir(source):
            if entry.endswith(".stl"):
                shutil.copy(os.path.join(source, entry), folder)
        with open(os.path.join(SOURCE, script)) as f:
            text = scenes.small_script(f.read(), steps)
        states[ranks] = scenes.state(run_way(way, text, ranks=ranks, variables=variables, folder=folder).folder)
    worst = scenes.differences(states[2], states[1])
    checks.true(name + ": the same particles", worst is not None and len(states[1]) > 100, "%d" % len(states[1]))
    for what, apart in (worst or {}).items():
        checks.below("%s: %s" % (name, what), apart, BOUND)
checks.end()
