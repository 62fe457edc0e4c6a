"""Tools act on the surface of a body, half a spacing outside the outermost centers, and the half spacing takes part in the strain.

A block of metal that hardens between smooth plates (closed form: homogeneous flow), in plane strain and as a cube, and an elastic one
(closed form), of few rows. With *effects contact-layer off* the half spacings are rigid: the force is too high by about 1/(rows - 1), which
shows that the check can fail. The books of energy close, both ways. With friction in a corner of two tools, one that turns: 2 ranks end with the bits of
1, and a run that is restarted with those of one that is not; a tool that is taken away between runs and comes again."""
import re

import numpy as np
from contact_scene import mesh
from sphtm_scene import Checks, new_folder, run

Y, HARDER, E, NU, DENSITY = 400e6, 400e6, 210e9, 0.3, 7850.0

UPSET = """
units si
dimension {dim}
boundary f f {flat}
atom_style atomic
newton off
lattice {lattice} {dx} origin 0.5 {middle} {origin}
region box block -{W} {W} -{H} {H} {depth} units box
create_box 1 box
region work block $(-{W}/2) $({W}/2) $(-{H}/2) $({H}/2) {z} units box
create_atoms 1 region work
pair_style sph/tm hyperbolic 1.2 spacing {dx} {style}
pair_coeff 1 1 density 7850 elastic 210e9 0.3 {strength}
fix body all sph/tm energy yes {effects}
fix upper all contact/tri file plate.stl move 0 $({H}/2+5e-3) 0 reference 0 $({H}/2) 0 {law}
fix lower all contact/tri file plate.stl move 0 $(-{H}/2-5e-3) 0 reference 0 $(-{H}/2) 0 {law}
fix_modify upper move linear 0 -{speed} 0 ramp {ramp}
fix_modify lower move linear 0 {speed} 0 ramp {ramp}
{more}
variable height equal f_upper[8]-f_lower[8]
variable force equal (f_upper[2]-f_lower[2])/2
fix history all ave/time 1 50 50 v_height v_force file force.dat
thermo 50
thermo_style custom step time dt v_height v_force f_body[7] f_body[8] f_body[9] atoms
thermo_modify format float %.15g
variable left equal v_height-{left}*{H}
fix stop all halt 50 v_left <= 0 error continue message no
run 10000000
"""


def upset(dim, rows, flows, effects="", H=10e-3, W=20e-3, more="", left=0.88, speed=5.0, law="", style=""):
    """Height and force over the closed form, the drift of the sum of energies over what went in, and the run."""
    folder, dx = new_folder(), H / rows
    mesh(folder, "plate.stl", "block --size 60e-3 10e-3 60e-3" if dim == 3 else "block --size 60e-3 10e-3 10e-3")
    script = UPSET.format(dim=dim, dx=dx, H=H, W=W, flat="f" if dim == 3 else "p", middle=0.5 * (rows % 2 == 0), lattice="sc" if dim == 3 else "sq",
                          origin=0.5 if dim == 3 else 0, depth="-%r %r" % (W, W) if dim == 3 else "%r %r" % (-dx, dx),
                          z="$(-{0}/2) $({0}/2)".format(W) if dim == 3 else "INF INF", speed=speed, ramp=2e-5 if flows else 1e-5, law=law, style=style,
                          strength="strength plastic %r %r" % (Y, HARDER) if flows else "", effects=effects, more=more, left=left)
    result = run(script, folder=folder)
    d, t = result.columns("force.dat"), result.thermo[-1]
    height, force = d[:, 1], d[:, 2]
    if flows and dim == 2:
        e = 2 / np.sqrt(3) * np.log(H / height)
        due = 2 / np.sqrt(3) * (Y + HARDER * e) * W * H / height
    elif flows:
        due = (Y + HARDER * np.log(H / height)) * W * W * H / height
    else:
        due = E / (1 - NU ** 2) * W * (1 - height / H)
    return 1 - height / H, force / np.maximum(due, 1e-9), abs(t["f_body[9]"][-1] / t["f_body[8]"][-1]), result


def over(reduction, force, lo, hi):
    return force[(reduction > lo) & (reduction < hi)].mean()


def presses(checks):
    for name, dim, rows, bound, rigid in (("plane strain, 10 rows", 2, 10, 0.015, 0.08), ("plane strain, 6 rows", 2, 6, 0.02, 0.15),
                                          ("cube, 6 rows", 3, 6, 0.03, 0.12)):
        size = {} if dim == 2 else {"H": 10e-3, "W": 10e-3}
        reduction, force, drift, _ = upset(dim, rows, True, **size)
        checks.near("metal, %s: force at 8 to 12 %% of the height over the closed form" % name, over(reduction, force, 0.08, 0.12), 1.0,
                    absolute=bound)
        checks.below("    drift of the sum of the energies", drift, 2e-3)
        reduction, force, drift, _ = upset(dim, rows, True, "effects contact-layer off", **size)
        checks.above("    with rigid half spacings", over(reduction, force, 0.08, 0.12), 1.0 + rigid)
        checks.below("    drift of the sum of the energies", drift, 2e-3)
    for rows, bound, rigid in ((10, 0.05, 0.06), (20, 0.03, 0.03)):
        for law in ("layer strains", ""):    # an elastic material has rigid layers by default
            reduction, force, drift, _ = upset(2, rows, False, more="fix calm all viscous 20", left=0.9985, speed=0.1, law=law)
            stiffness = over(reduction, force, 0.0008, 0.0014)
            if law:
                checks.near("elastic, plane strain, %d rows, layer strains: stiffness over the closed form" % rows, stiffness, 1.0, absolute=bound)
            else: checks.above("    layer rigid", stiffness, 1.0 + rigid)


def books(checks):
    """What once made energy beside a layer that strains: strong damping, approach yes (its layers are rigid), XSPH, particles that split under load."""
    split = "variable go atom step>%d\nfix ad all adapt/neigh refine square epsilon 0.4167 alpha 0.5 when v_go above 0.5 every 100"
    for name, due, bound, scene in (("damping 1", 1.0, 0.01, {"law": "damping 1"}),
                                    ("penalty 3 damping 0.7", 1.0, 0.01, {"law": "penalty 3 damping 0.7"}),
                                    ("approach yes, as with rigid layers", 1.125, 0.01, {"law": "approach yes"}),
                                    ("xsph 0.5", 1.0, 0.01, {"style": "xsph 0.5"}),
                                    ("particles split at the first touch", 1.0, 0.01, {"more": split % 0}),
                                    ("particles split under load", 1.0, 0.01, {"more": split % 900})):
        reduction, force, drift, result = upset(2, 10, True, **scene)
        checks.near("metal, plane strain, 10 rows, %s: force over the closed form" % name, over(reduction, force, 0.08, 0.12), due,
                    absolute=bound)
        checks.below("    drift of the sum of the energies", drift, 5e-3 if "approach" in name else 2e-4)
        off = re.search(r"^sph/tm shock 0 .*approach yes", result.output, re.M)
        checks.true("    bulk viscosity of shocks, which makes energy with 'approach yes', is off there alone", bool(off) == ("approach" in name))
        atoms = result.thermo[-1]["Atoms"]
        if "split" in name: checks.above("    particles at the end, over those at the start", atoms[-1] / atoms[0], 3.0)


def one_row(checks):
    """Nothing strains across a sheet of one row, and a warning says so; more rows, and walls at right angles, draw none."""
    for rows in 1, 2, 6:
        reduction, force, _, result = upset(2, rows, True, H=rows * 1e-3, left=0.95, speed=2.0)
        said = [w for w in result.warnings() if "pressed from two opposite sides" in w]
        factor = over(reduction, force, 0.03, 0.05)
        if rows == 1:
            checks.above("one row: force over the closed form", factor, 2.0)
            checks.true("    a warning names the tool and the particles", len(said) == 1 and "20 particles" in said[0] and ("upper" in said[0] or "lower" in said[0]), said)
        else: checks.true("%d rows (%.2f of the closed form): no such warning" % (rows, factor), not said, said)


CORNER = """
units si
dimension 3
boundary f f f
atom_style atomic
atom_modify map array
newton off
lattice sc 1e-3 origin 0.5 0.5 0.5
region box block -12e-3 12e-3 -12e-3 12e-3 -12e-3 12e-3 units box
create_box 1 box
region work block -4e-3 4e-3 -4e-3 4e-3 -2e-3 2e-3 units box
create_atoms 1 region work
pair_style sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff 1 1 density 7850 elastic 210e9 0.3 strength plastic 400e6 400e6 heat 40 480 0.9
"""
FIXES = """
fix body all sph/tm energy yes
fix upper all contact/tri file plate.stl move 0 9e-3 0 friction 0.2 share 0.5
fix side all contact/tri file plate.stl rotate axis 0 0 1 angle 90 move 9e-3 0 0 friction 0.1 share 0.5
fix lower all contact/tri file plate.stl move 0 -9e-3 0 friction 0.2 share 0.5
fix_modify upper move linear 0 -40 0
fix_modify side move linear -20 0 0
fix_modify lower move rotate 4e-3 -4e-3 0 0 0 1 3e-3
compute p all sph/tm/atom temperature pstrain
thermo_style custom step time f_body[8] f_body[9]
thermo_modify format float %.15g
"""
END = """
dump d all custom 1 out.dump id x y z vx vy vz fx fy fz c_p[*]
dump_modify d sort id format float %.17g
run 0 post no
"""


def same(checks, name, a, b):
    worst = max(np.abs(a[k] - b[k]).max() for k in a if k not in ("step", "box"))
    checks.true(name, worst == 0.0, "largest difference %g" % worst)


def bits(checks):
    folder = new_folder()
    mesh(folder, "plate.stl", "block --size 30e-3 10e-3 30e-3")

    def go(script, ranks=1):
        result = run(script, ranks=ranks, folder=folder)
        return result.dump("out.dump")[-1], result

    whole, result = go(CORNER + FIXES + "run 400\n" + END)
    t = result.thermo[0]
    checks.above("a corner of two tools and one that turns: plastic strain", whole["c_p[2]"].max(), 0.1)
    checks.below("    drift of the sum of the energies", abs(t["f_body[9]"][-1] / t["f_body[8]"][-1]), 2e-3)
    checks.true("    two walls at a corner do not face each other", not [w for w in result.warnings() if "opposite sides" in w])
    same(checks, "    2 ranks: the same bits", whole, go(CORNER + FIXES + "run 400\n" + END, 2)[0])
    go(CORNER + FIXES + "run 250\nwrite_restart state.restart\nrun 0\n" + END)
    again = run("read_restart state.restart\n" + FIXES + "run 150\n" + END, folder=folder).dump("out.dump")[-1]
    split = go(CORNER + FIXES + "run 250\nwrite_restart other.restart\nrun 150\n" + END)[0]
    same(checks, "    restarted: the same bits", split, again)
    # taken away, and come again: as if it were another tool
    gone = CORNER + FIXES + "run 250\nunfix upper\nrun 20\n" + "".join(
        line + "\n" for line in FIXES.splitlines() if line.startswith("fix upper")).replace("9e-3", "$(9e-3+1e-3)") + "run 20\n"
    checks.true("    a tool taken away between runs", run(gone, folder=folder).status == 0)


if __name__ == "__main__":
    checks = Checks()
    presses(checks)
    books(checks)
    one_row(checks)
    bits(checks)
    checks.end()
