"""Particles that sleep (active of fix sph/tm) with the loops for a GPU: runs that go on from a restart file, on one rank and on
two, which exchange particles where the loops run or on the host, give the bits of the plain styles on one rank."""
from kokkos_scene import Checks, differing, lines_of, new_folder, run_way
from scenes import ASLEEP, end, insert

checks = Checks()
HALF = 80    # between two looks at who sleeps
HEAD, FIXES = ASLEEP.split("variable        way")
HEAD = HEAD.format(style="")
FIXES = "variable        way" + FIXES.format(fix="energy yes active region win speed 5 every 7", sums="")
VALUES = "active density temperature pstrain flowstress vonmises pressure"

folder = new_folder()
insert(folder)
whole = run_way("plain default", HEAD + FIXES + "restart %d plain.*.restart\n" % HALF + end(2 * HALF, VALUES),
                folder=folder)
kinds = whole.dump("end.dump")[-1]["c_p[1]"]
checks.true("particles sleep, stand at the edge and move", all((kinds == k).sum() > 50 for k in (0, 1, 2)),
            "%d, %d, %d" % tuple((kinds == k).sum() for k in (0, 1, 2)))
run_way("device", HEAD + FIXES + "restart %d device.*.restart\nrun %d\n" % (HALF, 2 * HALF), folder=folder)


def go_on(way, file, **more):
    """The second half; particles have the numbers of the file, whatever the number of ranks."""
    script = "newton off\nread_restart %s.%d.restart\n" % (file, HALF) + FIXES + end(HALF, VALUES)
    again = run_way(way, script.replace("end.dump", "again.dump"), folder=folder, **more)
    differ = differing(lines_of(again, "again.dump"), lines_of(whole, "end.dump"))
    checks.true("%s goes on from %s %s" % (way, file, " ".join("%s %s" % m for m in more.items())), not differ,
                "%d particles differ" % differ)


for way, file in ("device", "plain"), ("plain default", "device"), ("device", "device"):
    go_on(way, file)
for where in "comm device sort device", "comm host sort device", "comm no sort no":
    go_on("device", "plain", ranks=2, options="-pk kokkos " + where)
checks.end()
