"""Bodies at rest on a mesh, and an elastic body pressed on one: weight, sign of f_tool, Hertz.

At rest the force on the tool is the weight (within 1 %), and its torque is r x F: for single particles over a
face, an edge and a corner, for blocks in 2d and 3d.

Hertz: a rigid ball (mesh) is pressed into a flat layer of SPH particles, and a plane into a layer
whose surface is curved by the same radius (columns of the lattice shifted by rho^2/(2 R), so that the surface has no
stairs). F = 4/3 E* sqrt(R) d^1.5, times a polynomial in sqrt(R d)/t for a layer of thickness t bonded to a rigid
base (Dimitriadis et al., Biophys. J. 82, 2798, 2002, eqs. 13-15); small strain, so d is taken up to R/10. The radius of contact is 2 to
2.5 spacings only. With *penalty material* what the half spacing between surface and particles
lacks in compliance is in the contact: corrected gradients come within 5 %. *penalty 10* leaves it out and is stiffer by
8 %, *penalty 1* is softer by 15 %. With plain gradients the surface of an SPH body is too soft, since its particles lack half of
their neighbors. The mesh of the ball is fine (20480 triangles): one of 1280, inscribed like all, lies 0.02 spacings inside of its
sphere and takes 5 % off the force. Of the curved layers the one with R = 16 spacings has *penalty material*; that with R = 8, whose surface has slopes
of 0.3 at the edge of the contact, is no half-space any more and has *penalty 10*. A ball cut from the lattice is given for information: its pole is a flat of 3 spacings radius, so it meets the
plate as a punch and not as a ball."""
import numpy as np
from contact_scene import MATERIAL, block, header, mesh, particles
from sphtm_scene import Checks, new_folder, run

G = 10.0
REST = """
pair_coeff 1 1 {material}
{group}
fix body all sph/tm
fix gravity all gravity {g} vector 0 0 -1
{fixes}
compute v all reduce max vx vy vz
thermo_style custom step time {columns}
thermo_modify norm no format float %.12g
thermo 500
run {steps}
"""


def single(checks):
    """One particle each over a face, over an edge and over a corner of blocks, held upright by the symmetry."""
    dx = 0.1
    folder = new_folder()
    mesh(folder, "block.stl", "block --size 0.5 0.5 0.5 --cells 2 2 2")
    corner = 0.25 * np.sqrt(3) + 0.5 * dx
    places = {"face": ((0.1, 0.05, 0.25 + 0.5 * dx), "", (0.1, 0.05)),
              "edge": ((0.0, 0.07, 0.25 * np.sqrt(2) + 0.5 * dx), "rotate axis 0 1 0 angle 45", (0.0, 0.07)),
              "corner": ((0.0, 0.0, corner), "rotate axis 0 0 1 angle 45 rotate axis 0 1 0 angle %.15g" %
                         np.degrees(-np.arctan(np.sqrt(2))), (0.0, 0.0))}
    for name, (x, turn, at) in places.items():
        # what keeps a particle on an edge is the fix setforce: the lateral force is left out
        script = header(dx) + REST.format(
            material=MATERIAL, g=G, steps=2000, group="", columns="f_tool[*]",
            fixes="fix tool all contact/tri file block.stl %s damping 1\nfix up all setforce 0 0 NULL" % turn)
        t = run(script, files={"data.scene": particles([x], [(-1, 1)] * 3)}, folder=folder).thermo[-1]
        weight = 1000 * dx ** 3 * G
        checks.near("single particle on a " + name + ": f_tool[3]/weight", t["f_tool[3]"][-1] / weight, -1.0,
                    relative=1e-6)
        checks.near("    torque about the origin, x", t["f_tool[4]"][-1] / weight, -at[1], absolute=1e-7)
        checks.near("    torque about the origin, y", t["f_tool[5]"][-1] / weight, at[0], absolute=1e-7)
        checks.near("    contacts", t["f_tool[12]"][-1], 1)


def blocks(checks):
    """Blocks and a ball on a plane of triangles; mean over the last half of the run."""
    dx = 0.05
    for name, dim, counts in (("block 2d", 2, (10, 8, 1)), ("block 3d", 3, (10, 8, 6)), ("ball 3d", 3, (9, 9, 9))):
        folder = new_folder()
        mesh(folder, "plane.stl", "plane --size 2 2 --cells 11 9")
        x = block(counts, dx, (-0.5 * counts[0] * dx, 0.0, -0.5 * counts[2] * dx))
        if name == "ball 3d":
            x = x[np.linalg.norm(x - x.mean(0), axis=1) <= 4.3 * dx]
        fixes = "fix tool all contact/tri file plane.stl rotate axis 1 0 0 angle -90 damping 1"
        script = (header(dx, dim) + REST).format(
            material=MATERIAL, g="%g" % G, steps=6000, group="", fixes=fixes,
            columns="f_tool[*]").replace("vector 0 0 -1", "vector 0 -1 0").replace("thermo 500", "thermo 20")
        box = [(-1, 1), (-0.5, 1), (-1, 1) if dim == 3 else (-0.025, 0.025)]
        t = run(script, files={"data.scene": particles(x, box)}, folder=folder).thermo[-1]
        late = t["Step"] > 3000
        weight = len(x) * 1000 * dx ** dim * G
        checks.near(name + ": f_tool[2]/weight", t["f_tool[2]"][late].mean() / weight, -1.0, relative=0.01)
        checks.near("    f_tool[1]/weight", t["f_tool[1]"][late].mean() / weight, 0.0, absolute=1e-6)
        touching = (x[:, 1] < 0.6 * dx).sum()
        checks.note("    deepest over mean penetration of the lowest row", "%.3f" %
                    (t["f_tool[13]"][late].mean() / (len(x) / touching * 1000 * dx * G / 1e7)))


def layer_factor(depth, radius, thickness, nu):
    """Force over that of the half-space, layer bonded to a rigid base."""
    a = -(1.2876 - 1.4678 * nu + 1.3442 * nu ** 2) / (1 - nu)
    b = (0.6387 - 1.0277 * nu + 1.5164 * nu ** 2) / (1 - nu)
    c = np.sqrt(radius * depth) / thickness
    return (1 - 2 * a / np.pi * c + 4 * a ** 2 / np.pi ** 2 * c ** 2 -
            8 / np.pi ** 3 * (a ** 3 + 4 * np.pi ** 2 / 15 * b) * c ** 3 +
            16 * a / np.pi ** 4 * (a ** 3 + 3 * np.pi ** 2 / 5 * b) * c ** 4)


PRESS = """
pair_coeff 1 1 density 1000 elastic {E} {nu} strength elastic
pair_coeff 2 2 density 1000 elastic {E} {nu} strength elastic
group free type 1
fix body free sph/tm
{tools}
thermo_style custom step time f_{first}[3] f_{first}[9] f_{last}[3]
thermo_modify norm no format float %.12g
thermo 10
run {steps}
"""
E, NU, RADIUS, WIDE, THICK = 1e7, 0.3, 8.0, 21, 10
SPEED = 0.005 * np.sqrt(E / 1000)
DT = 0.35 * 2 * (np.sqrt(1.04) - 0.2) / np.sqrt(10 * E / 1000)    # what the contact spring allows at penalty 10


def press(x, types, style, tools, depth, law=""):
    """Tools approach by depth; force on the first, its reference height, force on the last."""
    folder = new_folder()
    mesh(folder, "ball.stl", "sphere --radius %r --levels 5 --format ascii" % RADIUS)
    mesh(folder, "plane.stl", "plane --size 40 40 --cells 13 13")
    lines = ["fix %s all contact/tri %s %s damping 0.2\nfix_modify %s move linear 0 0 %r ramp %r" %
             (name, what, law, name, speed, 20 * DT) for name, what, speed in tools]
    script = header(1.0, style=style) + PRESS.format(E=E, nu=NU, tools="\n".join(lines), first=tools[0][0],
                                                     last=tools[-1][0], steps=int(depth / SPEED / DT) + 10)
    box = [(-12, 12), (-12, 12), (-26, 20)]
    t = run(script, files={"data.scene": particles(x, box, types=types, ntypes=2)}, folder=folder).thermo[-1]
    return t["f_%s[3]" % tools[0][0]], t["f_%s[9]" % tools[0][0]], t["f_%s[3]" % tools[-1][0]]


def compare(checks, name, d, F, radius, factor, lowest, highest, from_depth=0.5):
    due = 4 / 3 * E / (1 - NU ** 2) * np.sqrt(radius) * np.maximum(d, 1e-9) ** 1.5
    for depth in (0.3, 0.5, 0.65, 0.8):
        at = np.argmin(abs(d - depth))
        ratio = F[at] / due[at] / (layer_factor(d[at], radius, THICK - 2.0, NU) if factor else 1.0)
        text = "%s: contact radius %.1f dp, F/F_due" % (name, np.sqrt(radius * d[at]))
        if depth >= from_depth:
            checks.true(text, lowest <= ratio <= highest, "%.4f, allowed %.2f to %.2f" % (ratio, lowest, highest))
        else:
            checks.note(text, "%.4f" % ratio)


def hertz(checks):
    x = block((WIDE, WIDE, THICK), 1.0, (-0.5 * WIDE, -0.5 * WIDE, -THICK))
    types = np.where(x[:, 2] < -THICK + 2, 2, 1)
    ball = [("tool", "file ball.stl move 0 0 %r" % RADIUS, -SPEED)]
    for name, style, law, lowest, most in (("second order", "", "penalty material", 0.95, 1.05),
                                           ("corrected", "correction linear", "penalty material", 0.95, 1.05),
                                           ("plain", "stabilize artstress", "penalty material", 0.7, 1.05),
                                           ("second order, penalty 10,", "", "penalty 10", 1.07, 1.14),
                                           ("second order, penalty 1,", "", "penalty 1", 0.82, 0.92),
                                           ("second order, layer strains,", "", "penalty material layer strains", 0.84, 1.0)):
        F, z, _ = press(x, types, style, ball, 0.9, law)
        checks.true("ball on layer, %s gradients: pushed up" % name, (F[RADIUS - z > 0.1] > 0).all())
        compare(checks, "    ball on layer", RADIUS - z, F, RADIUS, True, lowest, most)
    for radius, law in ((RADIUS, "penalty 10"), (2 * RADIUS, "penalty material")):
        curved = x.copy()
        curved[:, 2] -= (x[:, 0] ** 2 + x[:, 1] ** 2) / (2 * radius)
        plane = [("tool", "file plane.stl rotate axis 1 0 0 angle 180", -SPEED)]
        F, z, _ = press(curved, types, "", plane, 0.9, law)
        compare(checks, "curved layer, radius %g, %s" % (radius, law), -z, F, radius, True, 0.9, 1.1)


COLUMN = """
pair_coeff 1 1 density 1000 elastic {E} {nu}
fix body all sph/tm
fix low all contact/tri file floor.stl rotate axis 1 0 0 angle -90 {law}
fix high all contact/tri file floor.stl rotate axis 1 0 0 angle 90 move 0 {height} 0 {law}
variable u equal "(time < {ramp})*time/{ramp} + (time >= {ramp})"
variable y equal -{way}*(1-cos(PI*v_u))/2
variable v equal -{way}*PI*sin(PI*v_u)/2/{ramp}
fix_modify high move variable NULL v_y NULL NULL v_v NULL
fix rest all sph/tm/relax
thermo_style custom step time f_low[2] f_high[2]
thermo_modify norm no format float %.12g
thermo 100
run {steps}
"""


def column(checks):
    """Rows between two plates that come together, with nowhere to go sideways: stress M times strain. The force of the plate acts on one
    row alone, which takes the compliance of a third of a spacing off either end; the contact itself has that of half a spacing. Where the layer
strains, what is off is the contact's compliance, an eighth of a spacing with penalty material."""
    M, squeeze = E * (1 - NU) / ((1 + NU) * (1 - 2 * NU)), 0.004
    for rows in (5, 20):
        for law, checked in (("penalty material", True), ("penalty 1", False), ("penalty 10", False), ("penalty material layer strains", True),
                             ("penalty 1 layer strains", False), ("penalty 10 layer strains", False)):
            folder = new_folder()
            mesh(folder, "floor.stl", "plane --size 20 20 --cells 3 3")
            sound = np.sqrt(M / 1000)
            script = header(1.0, 2, boundary="p f p") + COLUMN.format(E=E, nu=NU, law=law, height=rows, way=squeeze * rows,
                                                                      ramp=20 * rows / sound, steps=300 * rows)
            t = run(script, files={"data.scene": particles(block((8, rows, 1), 1.0, (-4, 0, -0.5)), [(-4, 4), (-1, rows + 1), (-0.5, 0.5)])},
                    folder=folder).thermo[-1]
            off = 0.5 * (t["f_high[2]"][-1] - t["f_low[2]"][-1]) / 8.0 / (M * squeeze) - 1
            text = "%d rows between plates, %s: stress over M strain, off by" % (rows, law)
            if checked: checks.true(text, abs(off) < 0.8 / rows, "%.4f, allowed %.4f" % (off, 0.8 / rows))
            else: checks.note(text, "%.4f" % off)


def lattice_ball(checks):
    """For information; the two plates must feel the same force."""
    x = block((16, 16, 16), 1.0, (-8, -8, -8))
    x = x[np.linalg.norm(x, axis=1) <= RADIUS]
    equal, pole = (3 * len(x) / (4 * np.pi)) ** (1 / 3), x[:, 2].max() + 0.5
    plates = [("top", "file plane.stl rotate axis 1 0 0 angle 180 move 0 0 %r" % pole, -SPEED),
              ("bottom", "file plane.stl move 0 0 -%r" % pole, SPEED)]
    F, z, F2 = press(x, np.ones(len(x), int), "", plates, 0.9)
    checks.note("ball cut from the lattice, %d particles" % len(x),
                "radius of equal volume %.3f, of the poles %.3f spacings" % (equal, pole))
    compare(checks, "    ball between plates", equal - z, F, equal, False, 0, 0, from_depth=9)
    checks.below("    forces of the two plates differ, relative", abs(F + F2).max() / F.max(), 1e-3)


if __name__ == "__main__":
    checks = Checks()
    single(checks)
    blocks(checks)
    column(checks)
    hertz(checks)
    lattice_ball(checks)
    checks.end()
