"""Particles that are split and merged while they are pressed against a tool: the energy book and the penetration are
those of a run that is not refined, on planes square to the pattern and not, in 2D and in 3D."""
import numpy as np
from contact_scene import block, header, mesh, particles, rotation
from sphtm_scene import Checks, new_folder, run

DX, SPEED = 1e-3, 20.0
SCRIPT = """
pair_coeff      1 1 density 2700 elastic 70e9 0.3
fix             body all sph/tm energy yes
fix             plate all contact/tri file plate.stl penalty 1 move 0 -0.001 0 rotate axis 0 0 1 angle {angle}
variable        pressed atom (step>40)*(step<=80)*(id<={foot})
variable        back atom (step>80)
fix             ad all adapt/neigh refine {pattern} alpha 0.5 when v_pressed above 0.5 every 10 &
                coarsen when v_back above 0.5
thermo          5
thermo_style    custom step atoms f_plate[1] f_plate[2] f_plate[13] f_ad[1] f_ad[2] f_body[1] f_body[9]
thermo_modify   lost error norm no
run             {steps}
"""


def press(counts, angle, pattern, steps=110):
    """A block that hits a plate; its lowest rows are split at step 50 and merged again at step 90."""
    dim = 3 if counts[2] > 1 else 2
    turn = rotation((0, 0, 1), angle)
    corner = (-0.5 * DX * counts[0], 0.0, -0.5 * DX * counts[2])
    x = block(counts, DX, corner)
    x = x[np.lexsort((x[:, 2], x[:, 0], x[:, 1]))] @ turn.T    # numbered from the foot on
    v = np.broadcast_to(turn @ (0, -SPEED, 0), x.shape)
    folder = new_folder()
    mesh(folder, "plate.stl", "block --size 0.05 0.002 0.05")
    box = [(-0.03, 0.03), (-0.03, 0.03), (-0.02, 0.02) if dim == 3 else (-0.5 * DX, 0.5 * DX)]
    script = header(DX, dim) + SCRIPT.format(
        angle=angle, pattern=pattern, foot=2 * counts[0] * counts[2], steps=steps)
    t = run(script, folder=folder, files={"data.scene": particles(x, box, v=v)}).thermo[0]
    return t, abs(t["f_body[9]"] - t["f_body[9]"][0]) / t["f_body[1]"][0]


def main():
    checks = Checks()
    for counts, kind, angles in (((12, 8, 1), "square", (0, 25, 45)), ((4, 6, 4), "cube", (0, 25))):
        for angle in angles:
            name = "%s on a plane at %g degrees" % (kind, angle)
            t, drift = press(counts, angle, kind + " epsilon 0.41666667")
            checks.near(name + ": splits", t["f_ad[1]"][-1], 2 * counts[0] * counts[2])
            checks.near(name + ": merges", t["f_ad[2]"][-1], t["f_ad[1]"][-1])
            force = np.hypot(t["f_plate[1]"], t["f_plate[2]"])
            pressed = force[t["Step"] == 50][0] / force.max()
            checks.above(name + ": force on the plate at the split, of the largest", pressed, 0.3)
            refined = drift[t["Step"] < 90].max()
            checks.below(name + ": energy sum, change over the kinetic energy, before merging", refined, 4e-3)
            # children that are pressed together reach a little less far than the particle that stands for them again
            checks.below(name + ": the same, after merging", drift.max(), 0.02)
            checks.below(name + ": penetration over that before the split",
                         t["f_plate[13]"].max() / t["f_plate[13]"][t["Step"] <= 50].max(), 1.3)
    checks.end()


if __name__ == "__main__":
    main()
