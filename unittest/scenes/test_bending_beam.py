"""The bent beam of C45E (S13 4.2; examples/bending_beam), coarse: with the default stabilization a linear stress over the
height within 4 %; a criterion of strain that splits what is stretched alone, and no gap there, with the options of the example.
Counter-cases: with the artificial stress the profile is off; bare, neighbors part without plastic
strain."""
import os
import re
import sys

from sphtm_scene import SOURCE, Checks, run

EXAMPLE = os.path.join(SOURCE, "examples", "bending_beam")
sys.path.insert(0, EXAMPLE)
import scene                                                                           # noqa: E402
from sphtm_scene import read_dump                                                      # noqa: E402

SCRIPT, ROWS = os.path.join(EXAMPLE, "in.bending_beam"), 9
GAP = 0.5    # spacings: a lattice without plastic strain whose columns gather in pairs opens gaps of up to 1
checks = Checks()


def profile(rows, **variables):
    return scene.profile_error(*scene.elastic_profile(run(SCRIPT, dict({"rows": rows}, **variables)), rows))


error, slope = profile(13, **scene.ELASTIC_RESISTED)
checks.below("elastic: off the linear profile, of the stress at the surface", error, 0.04)
checks.near("elastic: slope of the profile over M/I", slope, 1.0, relative=0.02)
bad, _ = profile(13, sag=0, options="artstress 0.3 4 viscosity 0.5 0.5 correction yes")
checks.above("counter-case, artificial stress: off by", bad, 0.15)

down = {"rows": ROWS, "sag": 0.03}
bare = run(SCRIPT, dict(down, **scene.ROWS["unrefined_bare"]))
gap = scene.opens(bare, read_dump(bare.path("elastic.dump"))[-1], ROWS)["widest_gap"]
checks.above("counter-case, bare and unrefined: gap, spacings", gap, GAP)
straight = run(SCRIPT, dict(down, **scene.ROWS["unrefined"]))
result = run(SCRIPT, dict(down, **scene.ROWS["refined"]))
lattice, first = (read_dump(r.path("elastic.dump"))[-1] for r in (straight, result))
frame, tip = scene.at_sag(result, 1.0)
strain = scene.strains(scene.like(straight, tip), lattice, ROWS)
found = scene.state_of(frame, first, ROWS, strain)
checks.below("refined: the end is down, mm", 1e3 * tip, -25)
checks.below("refined: gap, spacings", scene.opens(result, first, ROWS)["widest_gap"], GAP)
checks.above("refined: split", found["split"], 30)
checks.above("half of the beam is shortened", sum(e < 0 for e in strain.values()) / len(strain), 0.3)
checks.below("refined: of those split, shortened in the unrefined beam", found["split_shortened"] / found["split"], 0.05)
checks.above("refined: neighbors in the stretched half, the 3 % with the fewest", found["neighbors_fewest"], 14)
# With the default the unrefined beam has a seventh of the bare one's gap. Refined it keeps its energy, but child particles part from
# whole ones. With courant 0.6 it made energy and was stopped until hourglass control resisted more in tension; now it holds with 0.6 and 0.8.
result = run(SCRIPT, dict(down, **scene.ROWS["unrefined_default"]))
_, tip = scene.at_sag(result, 1.0)
checks.below("default, unrefined: the end is down, mm", 1e3 * tip, -25)
checks.below("default, unrefined: gap, spacings", scene.opens(result, read_dump(result.path("elastic.dump"))[-1], ROWS)["widest_gap"],
             0.2)
refined = run(SCRIPT, dict(down, **scene.ROWS["refined_default"]))
_, tip = scene.at_sag(refined, 1.0)
checks.below("default, refined: the end is down, mm", 1e3 * tip, -25)
checks.below("default, refined: drift of the energy sum, %", abs(float(re.findall(r"the sum drifted by (\S+) %", refined.output)[-1])), 0.1)
faster = run(SCRIPT, dict(down, courant=0.6, **scene.ROWS["refined_default"]))
checks.below("courant 0.6: drift of the energy sum, %", abs(float(re.findall(r"the sum drifted by (\S+) %", faster.output)[-1])), 0.1)
stopped = run(SCRIPT, dict(down, courant=1.0, **scene.ROWS["refined_default"]), expect_error=True)
checks.true("counter-case, courant 1: stopped by its energies", "sum of the energies" in stopped.errors(), stopped.errors()[:120])
checks.end()
