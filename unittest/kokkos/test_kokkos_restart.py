"""A restart file written with Kokkos continues without it, and the other way round, as if nothing had been: all
digits."""
from kokkos_scene import Checks, differing, lines_of, new_folder, run_way
from scenes import CUT, end, insert

checks = Checks()
HALF = 60
HEAD, FIXES = CUT.split("fix             body")
FIXES = "fix             body" + FIXES
folder = new_folder()
insert(folder)
whole = run_way("plain", HEAD + FIXES + "restart %d plain.*.restart\n" % HALF + end(2 * HALF), folder=folder)
run_way("serial", HEAD + FIXES + "restart %d kokkos.*.restart\nrun %d\n" % (HALF, 2 * HALF), folder=folder)
for way, file in ("serial", "plain"), ("threads", "plain"), ("plain", "kokkos"), ("serial", "kokkos"):
    script = "newton off\nread_restart %s.%d.restart\n" % (file, HALF) + FIXES + end(HALF)
    again = run_way(way, script.replace("end.dump", "again.dump"), folder=folder)
    differ = differing(lines_of(again, "again.dump"), lines_of(whole, "end.dump"))
    checks.true("%s goes on from %s" % (way, file), not differ, "%d particles differ" % differ)
checks.end()
