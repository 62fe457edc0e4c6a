"""Every effect with Kokkos as without, particle by particle, all digits: on one thread, on two, and with the loops
for a GPU, whose arrays live in another memory, also with rows of neighbors in LAMMPS's list. Sums over particles add up
in another order there: 1e-12. Energies that are what is left of larger ones (f_body[6], friction work that heats no particle,
and f_body[9], the sum of all, which is constant) differ by 1e-12 of the largest energy."""
from kokkos_scene import Checks, new_folder, run_way, same_bits
from scenes import FILES, SCENES, TOUCHING, insert

checks = Checks()

ENERGIES = ["f_body[%d]" % k for k in range(1, 9)]    # whose sum is f_body[9]
LEFT = "f_body[6]", "f_body[9]"


def largest(a, b):
    """Largest relative difference of the last row of the thermo output, time aside."""
    one, two = ({n: t[n][-1] for n in t if n not in ("Step", "CPU")} for t in (a.thermo[-1], b.thermo[-1]))
    size = {n: abs(two[n]) for n in two}
    if "f_body[9]" in two:
        size.update({n: max(size[e] for e in ENERGIES) for n in LEFT})
    least = 1e-12 * max(size.values())
    return max(abs(one[n] - two[n]) / max(size[n], least) for n in two)


for name, script in SCENES.items():
    results = {}
    for way in "plain", "serial", "threads", "plain default", "device", "rows in list":
        folder = new_folder()
        insert(folder)
        results[way] = run_way(way, script, folder=folder, files=FILES)
    if name in TOUCHING:
        checks.above("%s: bodies touch, %s" % (name, TOUCHING[name]),
                     abs(results["plain"].thermo[-1][TOUCHING[name]][-1]), 1e-9)
    if name.startswith("asleep"):
        kinds = results["plain"].dump("end.dump")[-1]["c_p[1]"]
        checks.true("%s: particles sleep, stand at the edge and move" % name, all((kinds == k).sum() > 50 for k in (0, 1, 2)),
                    "%d, %d, %d" % tuple((kinds == k).sum() for k in (0, 1, 2)))
    for way, reference in ("serial", "plain"), ("threads", "plain"), ("device", "plain default"), \
            ("rows in list", "plain default"):
        same_bits(checks, "%s: %s as %s" % (name, way, reference), results[way], results[reference])
        checks.below("%s: %s, printed sums" % (name, way), largest(results[way], results[reference]), 1e-12)
checks.end()
