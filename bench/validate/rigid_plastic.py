"""References of case_extrusion.py and case_cylinder.py: flow of rigid, perfectly plastic metal by finite elements, in plane strain or with an axis.

Of all flows of a mesh that keep the volume, the one that takes the least power, Y times the rate of equivalent strain over the volume, plus that of friction: an
upper bound of the limit load (Prager and Hodge 1951). Squares of four triangles that meet in their middle keep the volume without locking (Nagtegaal, Parks and
Rice 1974). The minimum is found by a viscosity Y/rate from one flow to the next, above a least rate; what friction takes, mu times the force of
a node, likewise. Slip lines are as wide as the squares, so bounds fall with their size in the first power, and two sizes give the limit.

  rigid_plastic.py punch                    pressure of a punch of half the width of a smooth container, over 2 k (1 + pi/2): a thick bottom, which has to
                                            give 1, and the thin one of case_extrusion.py; ten minutes
  rigid_plastic.py punch THICKNESS WALL     one: thickness of the bottom, height of the metal beside the punch over it, in half widths of the punch
  rigid_plastic.py cylinder MU              force over Y A (1 + 2 mu R/(3 h)) of a cylinder, as high as wide, upset to half of its height;
                                            five minutes

Needs scipy."""
import sys

import numpy as np

try:
    import scipy.sparse as sparse
    import scipy.sparse.linalg as solver
except ImportError:
    sys.exit("rigid_plastic.py needs scipy (Debian: python3-scipy)")

FIRST, LEAST, FASTER = 1e-2, 1e-4, 0.8    # least rate at the start and the end, and its factor from flow to flow
VOLUME = 1e4                              # penalty of changes of volume, over the viscosity
SLIP = 1e-3                               # velocity below which friction holds, over that of the tool


def squares(cells, n):
    """Nodes and triangles of the squares (i, j) of the size 1/n."""
    number, nodes, triangles = {}, [], []

    def node(x, y):
        key = (round(2 * x), round(2 * y))
        if key not in number:
            number[key] = len(nodes)
            nodes.append((x / n, y / n))
        return number[key]

    for i, j in cells:
        corners, middle = [node(i, j), node(i + 1, j), node(i + 1, j + 1), node(i, j + 1)], node(i + 0.5, j + 0.5)
        triangles += [(corners[q], corners[(q + 1) % 4], middle) for q in range(4)]
    return np.array(nodes), np.array(triangles)


class Metal:
    """A mesh that flows; velocities are those in x of all nodes, then those in y. axis: around x = 0."""

    def __init__(self, nodes, triangles, axis):
        self.nodes, self.triangles, self.axis = nodes, triangles, axis
        self.viscosity, self.least = np.ones(len(triangles)), FIRST

    def matrices(self):
        """Weights of the triangles (volume), rows of the strain rates xx yy zz, shear."""
        x, y = self.nodes[self.triangles][:, :, 0], self.nodes[self.triangles][:, :, 1]
        area = 0.5 * ((x[:, 1] - x[:, 0]) * (y[:, 2] - y[:, 0]) - (x[:, 2] - x[:, 0]) * (y[:, 1] - y[:, 0]))
        row, shape = np.repeat(np.arange(len(area)), 3), (len(area), len(self.nodes))

        def matrix(value):
            return sparse.csr_matrix((value.ravel(), (row, self.triangles.ravel())), shape)

        nxt, last = [1, 2, 0], [2, 0, 1]
        dx, dy = matrix((y[:, nxt] - y[:, last]) / (2 * area)[:, None]), matrix((x[:, last] - x[:, nxt]) / (2 * area)[:, None])
        none, middle = sparse.csr_matrix(shape), x.mean(axis=1)
        hoop = matrix(np.repeat(1 / (3 * middle)[:, None], 3, axis=1)) if self.axis else none
        weight = area * (2 * np.pi * middle if self.axis else 1.0)
        return weight, [sparse.hstack(m).tocsr() for m in ([dx, none], [none, dy], [hoop, none], [dy, dx])]

    def flow(self, held, given, flows, rubs=None, mu=0.0, rub=None):
        """Velocities and forces of the nodes after so many flows; given: velocities of those held; rubs: nodes with friction in x; rub: forces of
        the nodes before."""
        weight, (xx, yy, zz, shear) = self.matrices()
        volume = xx + yy + zz
        third = volume / 3
        parts = [(xx - third, 2 / 3), (yy - third, 2 / 3), (zz - third, 2 / 3), (shear, 1 / 3)]
        count, free, u = len(self.nodes), ~held, given
        for _ in range(flows):
            of = weight * self.viscosity
            K = sum(B.T @ sparse.diags(c * of) @ B for B, c in parts)
            K = K + VOLUME * volume.T @ sparse.diags(weight * np.maximum(self.viscosity, 1)) @ volume
            total = K
            if rubs is not None and rub is not None:
                drag = np.zeros(2 * count)
                drag[:count][rubs] = mu * np.maximum(rub[count:][rubs], 0) / np.maximum(abs(u[:count][rubs]), SLIP)
                total = K + sparse.diags(drag)
            total, before = total.tocsc(), given
            u = given.copy()
            u[free] = solver.spsolve(total[free][:, free], -(total @ before)[free])
            rate = np.sqrt(sum(c * (B @ u)**2 for B, c in parts))
            self.least = max(FASTER * self.least, LEAST)
            self.viscosity = 1 / np.maximum(rate, self.least)
            rub = -(K @ u)
        self.power, self.volume = (weight * rate).sum(), weight.sum()
        return u, rub


# ---------------------------------------------------------------------- punch

CLOSED = 2 / np.sqrt(3) * (1 + np.pi / 2)    # pressure of a thick bottom over Y
CONTAINER = 2                                # half width, in half widths of the punch


def punch(thickness, wall, n):
    """Upper bound of the pressure over that of a thick bottom; the metal beside the punch slides along it."""
    rows, beside = round(thickness * n), round(wall * n)
    metal = Metal(*squares([(i, j) for i in range(CONTAINER * n) for j in range(rows + (beside if i >= n else 0))], n), False)
    x, y, eps, count = metal.nodes[:, 0], metal.nodes[:, 1], 1e-9, len(metal.nodes)
    held, given = np.zeros(2 * count, bool), np.zeros(2 * count)
    held[:count] = (x < eps) | (x > CONTAINER - eps) | ((abs(x - 1) < eps) & (y > thickness + eps))
    beneath = (abs(y - thickness) < eps) & (x < 1 + eps)
    held[count:] = (y < eps) | beneath
    given[count:][beneath] = -1
    metal.flow(held, given, 80)
    return metal.power / CLOSED


# ---------------------------------------------------------------------- cylinder

def cylinder(mu, n, step=0.005, until=0.5):
    """(shortening, force over that of the slab method) of a cylinder of radius and half height 1."""
    metal = Metal(*squares([(i, j) for i in range(n) for j in range(n)], n), True)
    count, eps = len(metal.nodes), 1e-9
    top = metal.nodes[:, 1] > 1 - eps
    corners = np.ones(count, bool)    # of squares, not their middles
    corners[metal.triangles[:, 2]] = False
    side, axis, base = metal.nodes[:, 0] > 1 - eps, metal.nodes[:, 0] < eps, metal.nodes[:, 1] < eps
    given, high, out, rub = np.zeros(2 * count), 1.0, [], None
    while True:
        held = np.concatenate([axis, base | top])
        given[:] = 0
        given[count:][top] = -1
        u, rub = metal.flow(held, given, 60 if rub is None else 12, top, mu, rub)
        radius2 = metal.volume / (np.pi * high)    # steps of the mesh change its volume, by 0.4 % in all
        slab = np.pi * radius2 * (1 + 2 * mu * np.sqrt(radius2) / (3 * 2 * high))
        out.append((1 - high, rub[count:][top].sum() / slab))
        if high < 1 - until + eps: return np.array(out)
        metal.nodes = metal.nodes + step * np.stack([u[:count], u[count:]], 1)
        high -= step
        top = top | (side & (metal.nodes[:, 1] > high - eps))    # the side folds onto the plate
        metal.nodes[top, 1] = high


if __name__ == "__main__":
    kind, numbers = sys.argv[1] if len(sys.argv) > 1 else "", [float(a) for a in sys.argv[2:]]
    if kind == "punch" and len(numbers) in (0, 2):
        for thickness, wall in [numbers] if numbers else [(4, 0), (1.92, 0.16), (1.74, 0.52), (1.44, 1.12)]:
            coarse, fine = punch(thickness, wall, 25), punch(thickness, wall, 50)
            print("bottom {:.3g}, wall {:.3g}: 25 squares {:.4f}, 50 {:.4f}, limit {:.3f}".format(thickness, wall, coarse, fine, 2 * fine - coarse),
                  flush=True)
    elif kind == "cylinder" and len(numbers) == 1:
        coarse, fine = cylinder(numbers[0], 24), cylinder(numbers[0], 48)
        for part in (0.1, 0.2, 0.3, 0.4, 0.5):
            a, b = (f[np.argmin(abs(f[:, 0] - part)), 1] for f in (coarse, fine))
            print("friction {:g}, shortened by {:.2f}: 24 squares {:.4f}, 48 {:.4f}".format(numbers[0], part, a, b), flush=True)
    else:
        sys.exit(__doc__)
