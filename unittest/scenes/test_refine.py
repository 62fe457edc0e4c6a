"""Splitting and merging: what is conserved, bounds of the state, and the same bits on ranks, after a restart and
where a run is cut. A body of steel with stress, plastic strain, damage and heat in it flies, turns and is refined."""
import numpy as np
from refine_scene import DX, dump, momenta, start, styles, values
from sphtm_scene import Checks, read_dump, run

SQUARE = "refine square epsilon 0.41666667 alpha 0.6 every 20 "
PATTERNS = [(2, "square epsilon 0.41666667 alpha 0.5"), (2, "hexagon epsilon 0.5 alpha 0.7"), (3, "cube epsilon 0.41666667 alpha 0.5"),
            (3, "cube/centre epsilon 0.9 alpha 0.8"), (3, "icosahedron epsilon 0.7 alpha 0.8")]

def conservation(checks):
    for dim, pattern in PATTERNS:
        for velocity in ("parent", "linear"):
            if velocity == "linear" and dim == 3:
                continue
            size = (12, 10, 6) if dim == 3 else (24, 16, 8)
            # the state of one run, from a restart file, goes on with steps of 1e-18 s
            make = start(dim=dim, size=size, spin=2000.0, squeeze=6e3)
            more = "settle 0 velocity " + velocity
            refine = "refine %s when pstrain above 0.005 every %d %s"
            first = make + styles(refine % (pattern, 1000000, more)) + "run 120\nwrite_restart at.restart\n" + dump(1, "before.dump") + "run 0\n"
            base = run(first)
            second = ("units si\nnewton off\nread_restart at.restart\n" +
                      styles(refine % (pattern, 120, more), body="dt 1e-18", thermo=1) + "run 1\n" + dump(1, "after.dump") + "run 0\n")
            done = run(second, folder=base.folder)
            a, b = done.dump("before.dump")[-1], done.dump("after.dump")[-1]
            t = done.thermo[0]
            name = pattern.split()[0] + (", velocity linear" if velocity == "linear" else "")
            checks.above(name + ": splits", t["f_ad[1]"][-1], 20)
            n = {"square": 4, "hexagon": 7, "cube": 8, "cube/centre": 9, "icosahedron": 13}[pattern.split()[0]]
            checks.near(name + ": particles", len(b["id"]), len(a["id"]) + (n - 1) * t["f_ad[1]"][-1])
            checks.true(name + ": IDs", np.array_equal(b["id"], np.arange(1, len(b["id"]) + 1)))
            one, other = momenta(a), momenta(b)
            checks.near(name + ": mass", other["mass"], one["mass"], relative=1e-14)
            scale = np.sum(a["mass"] * np.hypot(a["vx"], a["vy"]))
            for p in ("px", "py"):
                checks.near(name + ": momentum " + p, other[p], one[p], absolute=1e-12 * scale)
            spin = other["lz"] / one["lz"] - 1
            if velocity == "parent":
                checks.near(name + ": angular momentum", other["lz"], one["lz"], relative=1e-11)
                checks.near(name + ": kinetic energy", other["kinetic"], one["kinetic"], relative=1e-11)
            else:
                checks.note(name + ": angular momentum, kinetic energy gained", "%.3g, %.3g of the whole" %
                            (spin, other["kinetic"] / one["kinetic"] - 1))
                checks.near(name + ": the change is in the output", t["f_ad[7]"][-1], abs(other["lz"] - one["lz"]),
                            relative=1e-6)
            checks.below(name + ": elastic energy, change over all", abs(t["f_ad[9]"][-1]) / max(t["f_body[2]"].max(), 1e-300)
                         if t["f_body[2]"].max() > 0 else 0.0, 0.05)
            for what in ("pstrain", "temperature", "damage", "density"):
                x, y = values(a, what), values(b, what)
                room = 1e-12 * np.max(np.abs(x))
                checks.true(name + ": bounds of " + what, y.min() >= x.min() - room and y.max() <= x.max() + room,
                            "%.9g to %.9g in %.9g to %.9g" % (y.min(), y.max(), x.min(), x.max()))
                checks.near(name + ": mean of " + what, np.sum(b["mass"] * y), np.sum(a["mass"] * x), relative=1e-11)


def same(checks, name, frames, run_of_b):
    a, b = frames[-1], run_of_b.dump("d.dump")[-1]
    equal = len(a["id"]) == len(b["id"]) and all(np.array_equal(a[k], b[k]) for k in a if k != "box")
    checks.true(name, equal, "%d and %d particles" % (len(a["id"]), len(b["id"])))


def bits(checks):
    """Refined to two levels inside a circle that moves through the body, merged behind it; ranks, restart, cut run."""
    more = ("compute xu all property/atom xu yu\nvariable near atom ((c_xu[1]-%.17g-%.17g*step)^2+(c_xu[2]-%.17g)^2<%.17g)" %
            (2 * DX, 0.02 * DX, 6 * DX, (4 * DX) ** 2))
    refine = SQUARE + "when v_near above 0.5 level 2 settle 4 coarsen fallen"
    body = styles(refine, more=more)
    make = start(spin=2000.0, squeeze=3e3, size=(24, 12, 8))
    whole = run(make + body + "write_restart start.restart\nrestart 90 at.*.restart\nrun 300\n" +
                dump(1) + "run 0\n")
    t = whole.thermo[0]
    checks.above("moving circle: splits", t["f_ad[1]"][-1], 100)
    checks.above("moving circle: merges", t["f_ad[2]"][-1], 50)
    checks.near("moving circle: particles by level", t["f_ad[10]"][-1] + t["f_ad[11]"][-1] + t["f_ad[12]"][-1], t["Atoms"][-1])
    p = momenta(whole.dump("d.dump")[-1])
    checks.near("moving circle: mass", p["mass"], t["c_sum[1]"][0], relative=1e-13)
    checks.near("moving circle: momentum", p["px"], t["c_sum[2]"][0], relative=1e-11)
    energy = t["f_body[9]"]
    checks.below("moving circle: drift of the energy sum", np.ptp(energy) / energy[0], 2e-3)
    checks.note("moving circle: kinetic, elastic energy changed by splits and merges", "%.3g, %.3g of the kinetic energy" %
                (t["f_ad[8]"][-1] / energy[0], t["f_ad[9]"][-1] / energy[0]))
    checks.note("moving circle: angular momentum lost in merges", "%.3g of the whole" % (t["f_ad[7]"][-1] / abs(t["c_sum[4]"][0])))
    first = read_dump(whole.path("d.dump"))

    def read(grid, name):
        return "units si\nnewton off\nprocessors %s\nread_restart %s.restart\n" % (grid, name) + body

    end = dump(1) + "run 0\n"
    for ranks, grid in ((2, "2 1 1"), (4, "2 2 1")):
        other = run(read(grid, "start") + "run 300\n" + end, ranks=ranks, folder=whole.folder)
        same(checks, "%d ranks" % ranks, first, other)
    same(checks, "a run cut in two", first, run(read("* * 1", "start") + "run 90\nrun 210\n" + end, folder=whole.folder))
    same(checks, "restart", first, run(read("* * 1", "at.90") + "run 210\n" + end, folder=whole.folder))
    wrong = run("units si\nnewton off\nread_restart at.90.restart\n" + body.replace("alpha 0.6", "alpha 0.7") + "run 1\n", folder=whole.folder,
                expect_error=True)
    checks.true("restart with another pattern", "alpha 0.7" in wrong.errors() and "alpha 0.6" in wrong.errors(), wrong.errors())


def periodic(checks):
    """A body across the periodic boundary is refined as one inside the box."""
    body = styles(SQUARE + "when pstrain above 0.02")
    size = (24, 12, 8)
    runs = []
    for shift in (0, 12):
        script = start(size=size, squeeze=6e3, boundary="p s p", v="0 0 0", margin=8)
        script += "displace_atoms all move %.17g 0 0 units box\n" % (shift * DX) if shift else ""
        runs.append(run(script + body + "run 200\n" + dump(1) + "run 0\n"))
    a, b = (r.dump("d.dump")[-1] for r in runs)
    checks.near("periodic: particles", len(b["id"]), len(a["id"]))
    checks.above("periodic: splits", runs[0].thermo[0]["f_ad[1]"][-1], 20)
    checks.below("periodic: places", np.max(np.abs(b["xu"] - a["xu"] - 12 * DX)) / DX if len(a["id"]) == len(b["id"]) else 1.0, 1e-6)


def settling(checks):
    """Particles that settle after a split: momentum and angular momentum stay."""
    make = start(spin=2000.0, squeeze=6e3)
    refine = "refine square epsilon 0.41666667 alpha 0.6 when pstrain above 0.005 every %d settle 10"
    base = run(make + styles(refine % 1000000) + "run 120\nwrite_restart at.restart\n" + dump(1, "before.dump") + "run 0\n")
    done = run("units si\nnewton off\nread_restart at.restart\n" + styles(refine % 120, body="dt 1e-18", thermo=1) + "run 1\n" +
               dump(1, "after.dump") + "run 0\n", folder=base.folder)
    one, other = momenta(base.dump("before.dump")[-1]), momenta(done.dump("after.dump")[-1])
    checks.above("settling: splits", done.thermo[0]["f_ad[1]"][-1], 20)
    checks.near("settling: momentum", other["px"], one["px"], relative=1e-11)
    checks.near("settling: angular momentum", other["lz"], one["lz"], relative=1e-9)
    checks.near("settling: kinetic energy", other["kinetic"], one["kinetic"], relative=5e-3)


def main():
    checks = Checks()
    conservation(checks)
    settling(checks)
    bits(checks)
    periodic(checks)
    checks.end()


if __name__ == "__main__":
    main()
