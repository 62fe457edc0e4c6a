"""A floor of needle triangles, 1e4 times as long as wide."""
from floors import floor, stl, strips, write_stl


def prepare(folder, settings):
    n, width, half = 400, 4e-6, 0.02
    triangles = strips([-half] + [(k - n / 2) * width for k in range(n + 1)] + [half])
    write_stl(stl(folder), triangles if settings["needles"] else triangles[:2] + triangles[-2:])


CASE = floor("needle triangles of aspect 1e4", "the needles are left out: a slit", prepare, {"needles": 0},
             {"needles": 1})
