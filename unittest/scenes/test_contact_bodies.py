"""Contact of SPH body against SPH body (pair_coeff i j contact): two blocks collide, slide, and meet at their corners.

 - head on and off centre: momentum to round-off, energy book; angular momentum with corrected gradients (plain ones lose
   it in any turning body). Friction acts between centres a spacing apart that do not spin: it takes some of it;
 - rebound: equal blocks exchange their velocities, as equal bars do;
 - a block at rest on another, and sliding on it: it sinks by what its weight presses the contact spring, over particles as
   over gaps, and is braked by mu g;
 - corner on corner and edge on edge, fast: the energy never exceeds what there was, nothing flies off;
 - one body in two types glued by 'bond' is the same as one type; 'none' lets bodies pass."""
import numpy as np
from contact_scene import block, header, particles, rotation
from sphtm_scene import Checks, run

DX, E, RHO, NU = 0.01, 1e7, 1000.0, 0.3
C = np.sqrt(E / RHO)
SCRIPT = """
pair_coeff 1 1 density {rho} elastic {E} {nu}
pair_coeff 2 2 density {rho} elastic {E} {nu}
pair_coeff 1 2 {law}
group one type 1
group two type 2
fix body all sph/tm energy yes
{more}
compute p1 one reduce ave vx vy vz
compute p2 two reduce ave vx vy vz
compute vmax all reduce max vx vy vz
thermo_style custom step time f_body[*] c_p1[*] c_p2[*] c_vmax[*] {watch}
thermo_modify norm no format float %.17g
thermo {every}
dump d all custom {every} bodies.dump id type x y z vx vy vz
dump_modify d format float %.17g
run {steps}
"""


def collide(x1, x2, v1, v2, law, steps, dim=3, more="", every=10, style="", types=None,
            watch=""):
    x = np.r_[x1, x2]
    v = np.r_[np.broadcast_to(v1, x1.shape), np.broadcast_to(v2, x2.shape)]
    types = np.r_[np.ones(len(x1), int), 2 * np.ones(len(x2), int)] if types is None else types
    box = [(-0.5, 0.5), (-0.5, 0.5), (-0.5, 0.5) if dim == 3 else (-0.5 * DX, 0.5 * DX)]
    script = header(DX, dim, style=style) + SCRIPT.format(rho=RHO, E=E, nu=NU, law=law, more=more, every=every,
                                                          steps=steps, watch=watch)
    result = run(script, files={"data.scene": particles(x, box, v=v, types=types, ntypes=2)})
    return result.thermo[-1], result.dump("bodies.dump")


def momenta(frames):
    p, l, scale = [], [], 0.0
    for f in frames:
        x, v = np.c_[f["x"], f["y"], f["z"]], np.c_[f["vx"], f["vy"], f["vz"]]
        p.append(v.sum(axis=0))
        l.append(np.cross(x, v).sum(axis=0))
        scale = max(scale, abs(v).sum())
    return np.array(p), np.array(l), scale


def books(checks, name, t, frames, energy=0.01, angular=None, lever=None):
    p, l, scale = momenta(frames)
    checks.below(name + ": momentum, over sum of |v|", abs(p - p[0]).max() / scale, 1e-13)
    work = t["f_body[1]"][0]
    book = t["f_body[9]"]
    checks.below("    drift of the energy sum, over the kinetic energy", abs(book - book[0]).max() / work, energy)
    checks.below("    work of the stress that is not stored, over the kinetic energy", abs(t["f_body[13]"]).max() / work, 0.005)
    if angular is not None:
        checks.below("    angular momentum, over that of the approach", abs(l - l[0]).max() / lever, angular)


def collisions(checks):
    for dim in (2, 3):
        n = (10, 6, 6 if dim == 3 else 1)
        z = -3 * DX if dim == 3 else -0.5 * DX
        left, right = block(n, DX, (-n[0] * DX - 0.05 * DX, -3 * DX, z)), block(n, DX, (0.05 * DX, -3 * DX, z))
        speed = 0.02 * C
        v = np.array([speed, 0, 0])
        for law in ("contact damping 0", "contact"):
            t, frames = collide(left, right, v, -v, law, 600, dim)
            name = "%dd head on, %s" % (dim, law)
            books(checks, name, t, frames)
            e = (t["c_p2[1]"][-1] - t["c_p1[1]"][-1]) / (2 * speed)
            if law == "contact damping 0":
                checks.above("    rebound over approach", e, 0.8)
            else:
                checks.note("    rebound over approach", "%.3f" % e)
            checks.below("    it is symmetric", abs(t["c_p1[1]"] + t["c_p2[1]"]).max() / speed, 1e-12)
        # off centre, against each other's corners, with friction
        shift = np.array([0, 3.3 * DX, 1.7 * DX if dim == 3 else 0])
        for law, angular in (("contact damping 0", 0.01), ("contact friction 0.4", 0.1)):
            t, frames = collide(left, right + shift, v, -v, law, 600, dim, style="correction yes")
            lever = len(left) * speed * abs(shift).max()
            books(checks, "%dd off centre, %s" % (dim, law), t, frames, angular=angular, lever=lever)


def rest(checks):
    """A block on a held block: force = weight; then it slides. Touching over the lower block's particles, and over the gaps."""
    base, top = block((30, 3, 1), DX, (-0.15, -3 * DX, -0.5 * DX)), block((8, 4, 1), DX, (-0.12, 0, -0.5 * DX))
    g = 20.0
    weight = len(top) * RHO * DX * DX * g
    more = "fix g one gravity %r vector 0 -1 0\nfix h two setforce 0 0 0" % g
    for name, x1 in (("over particles", top), ("over gaps", top + [0.5 * DX, 0, 0])):
        t, frames = collide(x1, base, (0, 0, 0), (0, 0, 0), "contact damping 1", 6000, 2, more, every=100, watch="f_h[2]")
        f = frames[-1]
        sunk = (x1[:, 1].min() - f["y"][f["type"] == 1].min()) / DX
        # weight over k: 4 rows of it press on each column
        due = 4 * RHO * DX * DX * g / (0.5 * E) / DX
        checks.near("block at rest on a block, %s: sunk by (spacings)" % name, sunk, due, absolute=0.001)
        late = t["Step"] > 4000
        checks.near("    force on the lower block over the weight", -t["f_h[2]"][late].mean() / weight, 1.0, relative=0.01)
        checks.below("    speed left over sqrt(g dp)", abs(t["c_p1[2]"][late]).max() / np.sqrt(g * DX), 0.02)
    for mu in (0.0, 0.3):
        v = 1.0
        t, frames = collide(top, base, (v, 0, 0), (0, 0, 0), "contact friction %g damping 0.5" % mu, 4000, 2, more, every=50)
        T = t["Time"][-1]
        checks.near("sliding on a block, friction %g: mean deceleration over g" % mu, (v - t["c_p1[1]"][-1]) / (g * T), mu,
                    absolute=0.001 if mu == 0 else 0.01 * mu)


def corners(checks):
    """Squares on their corners (2d), cubes on corner and on edge (3d), at a third of the speed of sound."""
    shape = block((8, 8, 1), DX, (-4 * DX, -4 * DX, -0.5 * DX)) @ rotation((0, 0, 1), 45).T
    reach = 4 * DX * np.sqrt(2)
    cube = block((7, 7, 7), DX, (-3.5 * DX,) * 3)
    edge = cube @ rotation((0, 0, 1), 45).T
    tip = edge @ rotation((0, 1, 0), np.degrees(np.arctan(1 / np.sqrt(2)))).T
    cases = (("2d corner on corner", shape, shape, reach, (0, 0, 0), 2), ("2d corner beside corner", shape, shape, reach,
             (0, 0.7 * DX, 0), 2), ("3d edge on edge", edge, edge, 3.5 * np.sqrt(2) * DX, (0, 0, 0), 3),
             ("3d corner on corner", tip, tip, 3.5 * np.sqrt(3) * DX, (0, 0, 0), 3),
             ("3d corner beside corner", tip, tip @ rotation((1, 0, 0), 40).T, 3.5 * np.sqrt(3) * DX, (0, 0.3 * DX, 0.2 * DX), 3))
    for name, a, b, reach, shift, dim in cases:
        for part in (0.02, 0.3):
            v = np.array([part * C, 0, 0])
            gap = np.array([reach + 0.1 * DX, 0, 0])
            t, frames = collide(a - gap, -b + gap + np.array(shift), v, -v, "contact friction 0.2", 1500 if part < 0.1 else 500, dim)
            text = "%s at %g c each" % (name, part)
            books(checks, text, t, frames, energy=0.01)
            checks.below("    largest speed over that of the approach", max(abs(np.r_[f["vx"], f["vy"], f["vz"]]).max()
                                                                            for f in frames) / v[0], 3.0)
            kinetic = t["f_body[1]"] / t["f_body[1]"][0]
            checks.below("    kinetic energy over the first, most", kinetic.max(), 1.01)
            checks.below("    kinetic energy over the first, least: they meet", kinetic.min(), 0.9)
            apart = frames[-1]["x"][frames[-1]["type"] == 2].mean() - frames[-1]["x"][frames[-1]["type"] == 1].mean()
            checks.note("    they part, or lie together: distance over that of touch", "%.2f" % (apart / (2 * reach)))


def meetings(checks):
    x = block((10, 6, 1), DX, (-5 * DX, -3 * DX, -0.5 * DX))
    half = x[:, 0] < 0
    order = np.r_[np.nonzero(half)[0], np.nonzero(~half)[0]]
    v = np.array([5.0, 0, 0]) * np.sin(20 * x[order, :1])
    one, f1 = collide(x[order], x[:0], v, np.zeros((0, 3)), "bond", 200, 2, types=[1] * 60)
    two, f2 = collide(x[order], x[:0], v, np.zeros((0, 3)), "bond", 200, 2, types=[1] * 30 + [2] * 30)
    checks.below("two types with bond are one body: places", max(abs(f1[-1][k] - f2[-1][k]).max() for k in "xy") / DX, 1e-12)
    a, b = x[half] - [0.1 * DX, 0, 0], x[~half] + [0.1 * DX, 0, 0]
    t, f = collide(a, b, (5, 0, 0), (-5, 0, 0), "none", 400, 2)
    overlap = (f[-1]["x"][f[-1]["type"] == 1].max() - f[-1]["x"][f[-1]["type"] == 2].min()) / DX
    checks.above("none: they pass through each other, spacings", overlap, 5)
    checks.below("    speed changes by", abs(t["c_p1[1]"] - 5).max(), 1e-12)


if __name__ == "__main__":
    checks = Checks()
    collisions(checks)
    rest(checks)
    corners(checks)
    meetings(checks)
    checks.end()
