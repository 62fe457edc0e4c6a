"""What stops a run says the same with Kokkos (stops.py), and so do wrong names; rows that outgrow their room change
nothing; styles are unloaded by the names they have."""
import stops
from kokkos_scene import Checks, differing, lines_of, run_way

checks = Checks()


def message(way, script):
    result = run_way(way, script, expect_error=True)
    return result.status, stops.message(result.output)


for name in stops.CASES:
    for way, reference in ("threads", "plain"), ("device", "plain default"):
        one, two = message(way, stops.script(name)), message(reference, stops.script(name))
        checks.true("%s: %s" % (name, way), one == two and one[0] != 0 and one[1],
                    one[1][:150] if one == two else "%s\n   %s" % (one, two))
for way in "threads", "device":
    grown, short = (run_way(way, text) for text in (stops.ROWS_GROW, stops.ROWS_STAY))
    differ = differing(lines_of(grown, "end.dump"), lines_of(short, "end.dump"))
    checks.true("rows outgrow their room: " + way, not differ, "%d particles differ" % differ)

BOX = "units si\ndimension 2\nregion box block 0 1 0 1 -1 1\ncreate_box 2 box\n"
for line in ("pair_style sph/tm/kk hyper", "fix tool all contact/tri/kk file x.stl",
             "compute p all sph/tm/atom/kk nonsense"):
    errors = run_way("serial", BOX + line + "\n", expect_error=True).errors()
    checks.true("known with Kokkos: " + line, errors and "Unrecognized" not in errors, errors[:200])

# LAMMPS prefers the name with the suffix, and 'plugin unload' takes one name: a style is gone when both are
USE = {"pair": "pair_style %s hyperbolic 1.2 spacing 1e-3\n", "compute": "compute p all %s density\n",
       "fix": "fix body all %s\n"}
NAMES = {"pair": ("sph/tm", "sph/tm/kk"), "compute": ("sph/tm/atom", "sph/tm/atom/kk"), "fix": ("sph/tm",)}
for kind, names in NAMES.items():
    unload = ["plugin unload %s %s\n" % (kind, n) for n in names]
    for text in unload[:-1]:
        kept = run_way("serial", BOX + text + USE[kind] % names[0], expect_error=True)
        checks.true("%s: %s leaves the other name" % (kind, text.split()[-1]), kept.status == 0, kept.errors()[:200])
    gone = run_way("serial", BOX + USE["pair"] % "sph/tm" + "".join(unload) + USE[kind] % names[0], expect_error=True)
    checks.true("%s: unloaded" % kind, 0 < gone.status < 128 and "Unrecognized" in gone.errors(), gone.errors()[:200])
checks.end()
