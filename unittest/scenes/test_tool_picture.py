"""The tool in pictures of dump image: its triangles in three dimensions, in two the lines where it cuts the plane of the
particles. Counted are the pixels of its color, against the size that its own outline gives in the picture."""
import re

import numpy as np
from contact_scene import mesh
from sphtm_scene import Checks, lattice_block, new_folder, run

SCENE = """
set group all type 2
pair_style sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff * * density 2700 elastic 70e9 0.33
fix body all sph/tm
fix tool all contact/tri file tool.stl move 12e-3 4e-3 0
fix_modify tool move linear 1000 0 0
thermo_style custom step time
dump pic all image 10 with.*.ppm type type size 400 400 box no 0 view 0 0 up 0 1 0 center s 0.5 0.5 0.5 zoom 1.5 {draw}
dump none all image 10 none.*.ppm type type size 400 400 box no 0 view 0 0 up 0 1 0 center s 0.5 0.5 0.5 zoom 1.5
dump_modify pic acolor 1 red acolor 2 blue adiam * 8e-4
dump_modify none acolor 1 red acolor 2 blue adiam * 8e-4
run 10
"""
WIDE, HIGH, LINE = 4e-3, 6e-3, 4e-4    # of the tool, and of the lines it is drawn with


def picture(dim, draw, cells, ranks=1):
    folder = new_folder()
    mesh(folder, "tool.stl", "block --size %g %g 8e-3 --cells 2 3 %d" % (WIDE, HIGH, cells))
    depth = " 0 4e-3" if dim == 3 else ""
    space = " -6e-3 6e-3" if dim == 3 else ""
    head = lattice_block("0 8e-3 0 8e-3" + depth, "-2e-3 18e-3 -6e-3 14e-3" + space, dim=dim, types=2)
    return run(head + SCENE.format(draw="fix tool type %s" % draw), folder=folder, ranks=ranks, timeout=120)


def red(path):
    """Where a PPM picture has the tool's color, in any light: rows and columns."""
    with open(path, "rb") as f:
        raw = f.read()
    wide, high = map(int, re.match(rb"P6\s+(\d+)\s+(\d+)\s+(?:#.*\n)*255\s", raw).groups())
    pixels = np.frombuffer(raw[-3 * wide * high:], np.uint8).reshape(high, wide, 3).astype(int)
    return pixels[..., 0] > 20 + pixels[..., 1:].max(axis=2)


def outline(shown):
    """Middle (column), width and height of what is shown."""
    rows, columns = np.nonzero(shown.any(axis=1))[0], np.nonzero(shown.any(axis=0))[0]
    return 0.5 * (columns[0] + columns[-1]), columns[-1] - columns[0] + 1, rows[-1] - rows[0] + 1


def judge(checks, name, result, flat):
    start, end = (red(result.path("with.%d.ppm" % step)) for step in (0, 10))
    checks.true(name + ": without the tool no pixel of its color", not red(result.path("none.10.ppm")).any())
    checks.above(name + ": pixels of the tool", start.sum(), 500)
    if not start.any() or not end.any():
        return start
    middle, wide, high = outline(start)
    more = LINE if flat else 0.0
    scale = high / (HIGH + more)    # pixels per length
    checks.near(name + ": width over height", wide / high, (WIDE + more) / (HIGH + more), relative=0.03)
    inside = (WIDE - more) * (HIGH - more) if flat else 0.0
    checks.near(name + ": pixels over those of its " + ("outline" if flat else "side"), start.sum(),
                ((WIDE + more) * (HIGH + more) - inside) * scale ** 2, relative=0.15)
    checks.near(name + ": it has moved, in pixels", outline(end)[0] - middle,
                1000 * result.thermo[-1]["Time"][-1] * scale, absolute=1.01)
    return start


def main():
    checks = Checks()
    flat = judge(checks, "2d, lines", picture(2, "%g 0" % LINE, cells=1), True)
    cut = judge(checks, "2d, corners in the plane", picture(2, "%g 0" % LINE, cells=2), True)
    checks.below("2d: pixels that differ, of the same tool in other triangles", (flat != cut).sum() / flat.sum(), 0.15)
    checks.true("2d: the same picture on two ranks", (red(picture(2, "%g 0" % LINE, 1, ranks=2).path("with.0.ppm")) == flat).all())
    space = judge(checks, "3d, triangles", picture(3, "1 0", cells=2), False)
    checks.true("3d: the same picture on two ranks", (red(picture(3, "1 0", 2, ranks=2).path("with.0.ppm")) == space).all())
    judge(checks, "3d, type 0 0", picture(3, "0 0", cells=2), False)
    checks.end()


main()
