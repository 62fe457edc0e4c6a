"""Runs a scene with the plain styles or with Kokkos, and compares what particles hold, digit by digit.

Ways to run it:
    plain       the plain styles in the plain LAMMPS
    serial      Kokkos with one thread
    threads     Kokkos with two threads
    device      the loops written for a GPU, run by Kokkos' threads, with their arrays in a memory of their own
The first three run the same loops, and each particle sums its row in order of tag: they give the same bits. The
device loops are compiled for any x86-64, as the plain ones are that SPHTM_ISA=default selects: those two give the
same bits."""
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.dirname(os.path.abspath(__file__))), "scenes"))
from sphtm_scene import PLANE, SKIPPED, SOURCE, Checks, lattice_block, new_folder, run    # noqa: E402,F401

WAYS = {"plain": {}, "plain default": {"SPHTM_ISA": "default"}, "serial": {}, "threads": {},
        "device": {"SPHTM_KOKKOS_LOOPS": "device"},
        "rows in list": {"SPHTM_KOKKOS_LOOPS": "device", "SPHTM_ROWS_IN_LIST": "yes"},
        "interior first": {"SPHTM_KOKKOS_LOOPS": "device", "SPHTM_OVERLAP": "1"}}


def run_way(way, script, ranks=1, options="", **more):
    """Runs a scene one of the WAYS; options: more of lmp's command line, for Kokkos."""
    environment = dict(WAYS[way], OMP_PROC_BIND="false")
    arguments = []
    if not way.startswith("plain"):
        if "SPHTM_LMP_KK" not in os.environ:
            print("no SPHTM_LMP_KK in the environment: skipped")
            sys.exit(SKIPPED)
        environment.update(SPHTM_LMP=os.environ["SPHTM_LMP_KK"], LAMMPS_PLUGIN_PATH=os.environ["LAMMPS_PLUGIN_PATH_KK"])
        arguments = ["-k", "on", "t", "2" if way == "threads" else "1", "-sf", "kk"] + options.split()
    return run(script, ranks=ranks, arguments=arguments, environment=environment, **more)


def lines_of(result, name):
    """Lines of the particles of the last frame, sorted: the text of every digit."""
    with open(result.path(name)) as f:
        lines = f.read().split("ITEM: ATOMS")[-1].splitlines()
    return sorted(lines[1:])


def differing(a, b):
    return sum(x != y for x, y in zip(a, b)) + abs(len(a) - len(b))


def same_bits(checks, what, result, reference, name="end.dump"):
    one, other = lines_of(result, name), lines_of(reference, name)
    differ = differing(one, other)
    checks.true(what, not differ and len(one) > 0, "%d of %d particles differ" % (differ, len(one)))
