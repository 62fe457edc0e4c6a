"""The stiffness that a contact gets, and what the log says of one that is softer than elastic material.

Tools: the stiffness in the log is PFAC E dp, with *penalty material* 2 M dp, where the layer strains 4 M dp: M = K + 4G/3, in plane stress
E/(1 - nu^2). An elastic
type whose contact is softer than that gets words; one that yields, or a stiff penalty, does not. The same for two bodies. A restart keeps
*penalty material* between bodies: the run that goes on ends as the one that was not interrupted. It tells which *correction* and
which penalty of a tool are not those of before."""
import re

import numpy as np
from contact_scene import block, header, mesh, particles
from sphtm_scene import Checks, new_folder, run

E, NU, DX = 1e7, 0.3, 0.1
CONFINED = E * (1 - NU) / ((1 + NU) * (1 - 2 * NU))
SOFT, SOFT_BODIES = "where few spacings touch", "is softer than the elastic material"


def tool(law, dim=3, style="", material="elastic %r %r" % (E, NU)):
    """Stiffness in the log, and whether it has the words."""
    folder = new_folder()
    mesh(folder, "block.stl", "block --size 0.5 0.5 0.5 --cells 2 2 2")
    x = block((2, 2, 2 if dim == 3 else 1), DX, (-0.1, -0.1, 0.3) if dim == 3 else (-0.1, 0.3, -0.05))
    box = [(-1, 1)] * 3 if dim == 3 else [(-1, 1), (-1, 1), (-0.05, 0.05)]
    script = header(DX, dim, style=style) + "pair_coeff 1 1 density 1000 %s\nfix body all sph/tm\n" \
        "fix tool all contact/tri file block.stl %s\nrun 0\n" % (material, law)
    out = run(script, files={"data.scene": particles(x, box)}, folder=folder).output
    return float(re.search(r"stiffness (\S+), damping", out)[1]), SOFT in out


def tools(checks):
    flows = "elastic %r %r strength plastic 1e5 1e6" % (E, NU)
    for name, given, due, soft in (("default", ("",), 2 * CONFINED * DX, False), ("penalty 1", ("penalty 1",), E * DX, True),
                                   ("penalty 3", ("penalty 3",), 3 * E * DX, False),
                                   ("penalty material", ("penalty material",), 2 * CONFINED * DX, False),
                                   ("default, metal that flows", ("", 3, "", flows), E * DX, False),
                                   ("plane strain, penalty material", ("penalty material", 2), 2 * CONFINED, False),
                                   ("plane stress, penalty material", ("penalty material", 2, "plane stress"),
                                    2 * E / (1 - NU ** 2), False),
                                   ("plane stress, penalty 1", ("penalty 1", 2, "plane stress"), E, True),
                                   ("plane stress, default", ("", 2, "plane stress"), 2 * E / (1 - NU ** 2), False),
                                   ("default, layer strains", ("layer strains",), 4 * CONFINED * DX, False),
                                   ("penalty 1, layer strains", ("penalty 1 layer strains",), E * DX, True),
                                   ("metal that flows, penalty material", ("penalty material", 3, "", flows), 4 * CONFINED * DX, False),
                                   ("the same, layer rigid", ("penalty material layer rigid", 3, "", flows), 2 * CONFINED * DX, False)):
        k, words = tool(*given)
        checks.near("tool, %s: stiffness" % name, k, due, relative=1e-5)
        checks.true("    words in the log: %s" % ("yes" if soft else "no"), words == soft)


BODIES = """
pair_coeff 1 1 density 1000 elastic 1e7 0.3 {flow}
pair_coeff 2 2 density 1000 elastic 3e7 0.3 {flow}
pair_coeff 1 2 contact damping 0.1 {law}
fix body all sph/tm
"""
GO = """
thermo_style custom step time ke
thermo_modify norm no format float %.17g
thermo 40
run {steps}
"""


def two_blocks():
    x = np.r_[block((4, 4, 4), DX, (-0.2, -0.2, -0.41)), block((4, 4, 4), DX, (-0.2, -0.2, 0.0))]
    return particles(x, [(-1, 1)] * 3, v=np.outer(np.repeat([1.0, -1.0], 64), [0, 0, 1]), types=np.repeat([1, 2], 64))


def bodies(checks):
    data = {"data.scene": two_blocks()}
    for law, flow, soft in (("", "", False), ("penalty 1", "", True), ("penalty material", "", False), ("penalty 3", "", False),
                            ("", "strength plastic 1e5 1e6", False)):
        out = run(header(DX) + BODIES.format(law=law, flow=flow) + "run 0\nrun 0\n", files=data).output
        checks.true("bodies, %s: words in the log: %s" % (" ".join((law or "default", flow)), "once" if soft else "no"),
                    out.count(SOFT_BODIES) == soft)


def restart(checks):
    folder = new_folder()
    mesh(folder, "block.stl", "block --size 0.5 0.5 0.5 --cells 2 2 2")
    data, law = {"data.scene": two_blocks()}, BODIES.format(law="penalty material", flow="")
    tool = "fix tool all contact/tri file block.stl move 0 0 2 overlap allow %s\n"
    whole = run(header(DX) + law + tool % "" + GO.format(steps=400), files=data, folder=folder).thermo[-1]
    run(header(DX) + law + tool % "" + GO.format(steps=200) + "write_restart state.restart\n", folder=folder)

    def again(coefficients, law):
        return run("read_restart state.restart\n" + coefficients + "fix body all sph/tm\n" + tool % law + GO.format(steps=200),
                   folder=folder)

    rest = again("", "")
    touched = whole["KinEng"].min() < 0.9 * whole["KinEng"][0]
    checks.true("two blocks have met", touched, "kinetic energy down to %.3f" % (whole["KinEng"].min() / whole["KinEng"][0]))
    checks.true("penalty material in a restart: the same end", rest.thermo[-1]["KinEng"][-1] == whole["KinEng"][-1],
                "%.17g, %.17g" % (rest.thermo[-1]["KinEng"][-1], whole["KinEng"][-1]))
    checks.true("    without a warning", not rest.warnings(), "; ".join(rest.warnings()))
    linear = "pair_style sph/tm hyperbolic 1.2 spacing %r correction linear\n" % DX + law.split("fix")[0]
    warned = "; ".join(again(linear, "penalty 1").warnings())
    checks.true("another correction is named", "correction was yes, is linear" in warned,
                warned)
    checks.true("another penalty of the tool is named", "other values of penalty" in warned, warned)


if __name__ == "__main__":
    checks = Checks()
    tools(checks)
    bodies(checks)
    restart(checks)
    checks.end()
