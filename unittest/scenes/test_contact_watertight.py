"""Particles thrown at edges and corners from all sides never get inside; with F15's test they leak.

A cube, a wedge with an edge of 30 degrees and an insert with a sharp edge (rake 20, clearance 20: 50 degrees). 2000
particles that do not see each other are aimed at points on the edges and corners of each, at a speed that a face would
stop within 0.3 spacings, some of them off by up to a spacing. Inside means: the centre behind all faces of the convex
body, by more than 1e-6 spacings (the mesh is in single precision). A particle that comes straight onto a sharp edge is stopped there too, before its
centre reaches the edge."""
import numpy as np
from contact_scene import MATERIAL, header, mesh, particles, read_stl, rotation
from sphtm_scene import Checks, new_folder, run

DX = 0.1
OMEGA = 100.0 / DX                     # sqrt(k/m) of a particle on a face
SPEED = 0.3 * DX * OMEGA
SCRIPT = """
pair_coeff 1 1 {material}
neigh_modify exclude type 1 1
fix body all sph/tm lost ignore
fix tool all contact/tri file body.stl damping 0.1 method {method}
{move}
dump d all custom 5 thrown.dump id x y z
dump_modify d format float %.12g
thermo_style custom step time f_tool[12] f_tool[13]
thermo_modify format float %.15g
thermo 5
run 450
"""


def faces(triangles):
    """Planes n.x = d of a convex body, each once."""
    n = np.cross(triangles[:, 1] - triangles[:, 0], triangles[:, 2] - triangles[:, 0])
    n /= np.linalg.norm(n, axis=1)[:, None]
    planes = np.c_[n, (n * triangles[:, 0]).sum(1)]
    return planes[np.unique(np.round(planes, 5), axis=0, return_index=True)[1]]


def sharp_edges(triangles):
    """Pairs of points: edges whose two faces are not in one plane."""
    seen, out = {}, []
    for t in triangles:
        n = np.cross(t[1] - t[0], t[2] - t[0])
        n /= np.linalg.norm(n)
        for k in range(3):
            key = tuple(sorted((tuple(np.round(t[k], 5)), tuple(np.round(t[(k + 1) % 3], 5)))))
            if key in seen and n @ seen[key] < 0.999:
                out.append(key)
            seen[key] = n
    return np.array(out)


def throw(triangles, count, seed):
    """Starts and velocities: at distance 3 spacings or so from the aim, outside the body by more than one."""
    rng = np.random.default_rng(seed)
    planes, edges = faces(triangles), sharp_edges(triangles)
    x, v = [], []
    while len(x) < count:
        e = edges[rng.integers(len(edges))]
        s = rng.uniform() if rng.uniform() < 0.6 else float(rng.integers(2))    # edge or corner
        aim = e[0] + s * (e[1] - e[0])
        if rng.uniform() < 0.5:
            aim = aim + rng.uniform(-DX, DX, 3)
        u = rng.normal(size=3)
        u /= np.linalg.norm(u)
        start = aim - rng.uniform(2, 4) * DX * u
        if (planes[:, :3] @ start - planes[:, 3]).max() > DX:
            x.append(start)
            v.append(SPEED * u)
    return np.array(x), np.array(v), planes


MOVE = "fix_modify tool move transrot 3 2 1 0 0 0 1 1 1 0.5"


def in_tool(x, time):
    """Places in the frame of the tool under MOVE."""
    return (x - time * np.array([3, 2, 1])) @ rotation((1, 1, 1), 360 * time / 0.5)


def attack(checks, name, shape, move, method):
    folder = new_folder()
    triangles = read_stl(mesh(folder, "body.stl", shape))
    x, v, planes = throw(triangles, 2000, 7)
    result = run(header(DX) + SCRIPT.format(material=MATERIAL, method=method, move=move),
                 files={"data.scene": particles(x, [(-9, 9)] * 3, v=v)}, folder=folder)
    t = result.thermo[-1]
    inside, deepest = np.zeros(len(x), bool), 0.0
    for frame, time in zip(result.dump("thrown.dump"), t["Time"]):
        at = np.c_[frame["x"], frame["y"], frame["z"]]
        height = ((in_tool(at, time) if move else at) @ planes[:, :3].T - planes[:, 3]).max(1)
        deepest = max(deepest, -height.min())
        inside |= height < -1e-6 * DX
    name = "%s, %s" % (name, method)
    if method == "f15":
        checks.note(name + ": ever inside", "%d of %d, by up to %.3f spacings" % (inside.sum(), len(x), deepest / DX))
        return
    checks.true(name + ": ever inside", inside.sum() == 0, "%d of %d" % (inside.sum(), len(x)))
    checks.below("    deepest penetration over the radius", t["f_tool[13]"].max() / 0.5, 1.0)
    checks.above("    touches at once", t["f_tool[12]"].max(), 300)


if __name__ == "__main__":
    checks = Checks()
    for method in ("closest", "f15"):
        attack(checks, "cube", "block --size 1 1 1 --cells 2 3 4", "", method)
        attack(checks, "wedge", "wedge --size 1.732 1 1", "", method)
        attack(checks, "insert", "insert --rake 20 --clearance 20 --height 1 --length 1.5 --width 1", "", method)
        attack(checks, "moving cube", "block --size 1 1 1 --cells 2 3 4", MOVE, method)
    checks.end()
