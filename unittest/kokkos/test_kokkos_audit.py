"""fix sph/tm audit with Kokkos: the numbers of the plain styles on one thread and on two; with the loops of a GPU,
whose arrays live in another memory and which round differently, to 1e-9."""
import numpy as np
from kokkos_scene import Checks, run_way
from scenes import BAR

NAMES = ("all rows precision smoothing viscosity artstress correction xsph conduction on_viscosity on_artstress on_hourglass "
         "on_xsph").split()
END = """
{lists}
thermo          10
thermo_style    custom step %s
thermo_modify   format float %%.15g
run             60
""" % " ".join("f_body[%d]" % (16 + k) for k in range(len(NAMES)))
METAL = "strength plastic 100e6 1e9 heat 200 900 0.9"
checks = Checks()
for name, style, fix, lists in (
        ("all on", "correction yes xsph 0.5", "", ""), ("some off", "viscosity 0 0 artstress 0 4", "energy yes", ""),
        ("mixed", "precision mixed", "", ""), ("kept rows", "", "", "fix lists all adapt/neigh threshold 1e-3"),
        ("lengths", "", "", "fix lists all adapt/neigh asph psi every 20")):
    script = BAR.format(style=style, material=METAL, fix=fix + " audit 20 30") + END.format(lists=lists)
    values = {}
    for way in "plain", "serial", "threads", "device":
        t = run_way(way, script).thermo[0]
        values[way] = np.array([t["f_body[%d]" % (16 + k)] for k in range(len(NAMES))])
    checks.above(name + ": something differs", values["plain"].max(), 1e-8)
    for way in "serial", "threads":
        checks.below("%s: %s as plain" % (name, way), abs(values[way] - values["plain"]).max(), 1e-12)
    limit = 2e-6 if name == "mixed" else 1e-9    # rounding of single is not the same
    checks.below("%s: device as plain" % name, abs(values["device"] - values["plain"]).max(), limit)
checks.end()
