"""Two colliding rubber rings (Gray, Monaghan, Swift 2001): they rebound in one piece with the artificial stress, and
break without it. Plane strain, radii 0.03 to 0.04 m, spacing 1 mm, closing at 0.12 times the bulk speed of sound (each ring
at 0.059). At twice that speed both rings break here, with the artificial stress too."""
import numpy as np

from sphtm_scene import Checks, run

SCRIPT = """
units           si
dimension       2
boundary        f f p
atom_style      atomic
newton          off
variable        dx equal 1e-3
lattice         sq ${dx} origin 0.5 0.5 0
region          box block -0.14 0.14 -0.1 0.1 -0.5 0.5 units box
create_box      2 box
region          lo cylinder z -0.041 0 0.04 INF INF units box
region          li cylinder z -0.041 0 0.03 INF INF units box side out
region          ro cylinder z  0.041 0 0.04 INF INF units box
region          ri cylinder z  0.041 0 0.03 INF INF units box side out
region          left intersect 2 lo li
region          right intersect 2 ro ri
create_atoms    1 region left
create_atoms    2 region right
group           left type 1
group           right type 2
pair_style      sph/tm hyperbolic 1.2 spacing ${dx} artstress ${eps} 4
pair_coeff      * * materials.sphtm rubber
fix             body all sph/tm energy yes
variable        v equal 0.059*sqrt(1e7/3/(1-2*0.3975)/1200)
velocity        left set $v 0 0 units box
velocity        right set -$v 0 0 units box
variable        px equal mass(all)*vcm(all,x)
variable        py equal mass(all)*vcm(all,y)
variable        pl equal mass(left)*vcm(left,x)
thermo          200
thermo_style    custom step time v_px v_py v_pl f_body[1] f_body[7] f_body[9]
thermo_modify   format float %.15g
variable        done equal time>0.012
fix             stop all halt 20 v_done > 0.5 error continue message no
run             100000
write_dump      all custom end.dump id type x y modify format float %.10g
"""
SPACING, BOND = 1e-3, 1.5


def pieces(frame):
    """Sizes of the clusters of particles closer than 1.5 spacings, largest first, and of how many rings."""
    p = np.column_stack([frame["x"], frame["y"]])
    near = np.sum((p[:, None] - p[None]) ** 2, axis=2) < (BOND * SPACING) ** 2
    label, sizes = -np.ones(len(p), int), []
    for start in range(len(p)):
        if label[start] >= 0:
            continue
        front, members = [start], 0
        label[start] = len(sizes)
        while front:
            i = front.pop()
            members += 1
            for j in np.nonzero(near[i] & (label < 0))[0]:
                label[j] = len(sizes)
                front.append(j)
        sizes.append(members)
    return sorted(sizes, reverse=True)


def main():
    checks = Checks()
    whole = run(SCRIPT, {"eps": 0.3})
    table, end = whole.thermo[-1], whole.dump("end.dump")[-1]
    size = pieces(end)
    rings = [np.sum(end["type"] == t) for t in (1, 2)]
    scale = abs(table["v_pl"][0])
    checks.true("no numerical fracture", sum(size) == sum(rings) and len(size) in (1, 2), "pieces %s" % size)
    checks.above("rebound: speed back over speed of approach", -table["v_pl"][-1] / table["v_pl"][0], 0.3)
    checks.below("momentum in x, over that of one ring", np.max(np.abs(table["v_px"])) / scale, 1e-12)
    checks.below("momentum in y", np.max(np.abs(table["v_py"])) / scale, 1e-12)
    checks.note("energy sum, drift over kinetic energy", "%.2e" % (np.ptp(table["f_body[9]"]) / table["f_body[1]"][0]))
    checks.note("artificial work over kinetic energy", "%.3f" % (table["f_body[7]"][-1] / table["f_body[1]"][0]))
    plain = run(SCRIPT, {"eps": 0}, expect_error=True)
    if plain.errors():    # fragments fly out of the box
        checks.true("without artificial stress the rings break", "leaves the box" in plain.errors(), plain.errors()[:120])
    else:
        broken = pieces(plain.dump("end.dump")[-1])
        checks.true("without artificial stress the rings break", len(broken) > 2, "pieces %s" % broken)
    checks.end()


if __name__ == "__main__":
    main()
