"""Floors of triangles that an elastic cube falls on: the mesh decides, the result must not."""
import os

from frame import Case, lattice_block

SIDE = 4    # particles along an edge of the cube


def write_stl(path, triangles):
    with open(path, "w") as f:
        f.write("solid floor\n")
        for t in triangles:
            f.write("facet normal 0 0 0\nouter loop\n" + "".join("vertex %.9g %.9g %.9g\n" % p for p in t) +
                    "endloop\nendfacet\n")
        f.write("endsolid floor\n")


def strips(cuts, half=0.02):
    """A plane with normal +z: one strip along y between each pair of cuts, two triangles each."""
    triangles = []
    for a, b in zip(cuts[:-1], cuts[1:]):
        triangles += [((a, -half, 0), (b, -half, 0), (b, half, 0)), ((a, -half, 0), (b, half, 0), (a, half, 0))]
    return triangles


def judge(r):
    """Departure of the rebound from that of a floor of two triangles (closed form of none): change of the energy sum
    over the kinetic energy; 1 where the cube is not above the floor and on its way up."""
    e = r.end
    if e["z"].min() < 0 or e["vz"].mean() <= 0:
        return 1.0
    return max(abs(r.t["f_body[9]"] / r.t["f_body[9]"][0] - 1).max(), r.t["f_floor[13]"].max() / 10)


def floor(title, counter, prepare, bad, settings=None):
    return Case(
        title=title,
        criterion="change of the energy sum over the kinetic energy, deepest penetration over ten spacings; the cube "
                  "rebounds",
        counter=counter,
        setup=lattice_block("-4e-4 4e-4 -4e-4 4e-4 2e-4 1e-3", "-2e-3 2e-3 -2e-3 2e-3 -2e-3 4e-3", "2e-4", dim=3) + """
pair_style      sph/tm hyperbolic 1.2 spacing 2e-4
pair_coeff      1 1 density 7850 elastic 210e9 0.3
velocity        all set 0.3 0.2 -20 units box
""",
        model="""
fix             body all sph/tm energy yes lost ignore
fix             floor all contact/tri file floor.stl penalty {penalty}
thermo          10
thermo_style    custom step time dt f_floor[3] f_floor[13] f_body[1] f_body[5] f_body[9]
thermo_modify   lost ignore
""",
        steps=2600, prepare=prepare, bad=bad, settings=dict({"penalty": 1}, **(settings or {})), judge=judge,
        limit=0.05)


def stl(folder):
    return os.path.join(folder, "floor.stl")
