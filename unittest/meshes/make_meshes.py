#!/usr/bin/env python3
"""Writes the meshes of this folder, good and malformed, and expected.txt: what a reader should make
of each. Expected values come from how a mesh is made here, not from reading it.

  make_meshes.py [folder]
"""
import math
import os
import struct
import sys

FOLDER = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(os.path.abspath(__file__))
# status facets vertices degenerate duplicate open nonmanifold inconsistent flipped volume
TABLE = []

# a wedge of 8 facets and 6 vertices, volume 1/2
POINTS = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1)]
CELLS = [(0, 2, 1), (3, 4, 5), (0, 1, 4), (0, 4, 3), (1, 2, 5), (1, 5, 4), (2, 0, 3), (2, 3, 5)]
WEDGE = [tuple(POINTS[i] for i in c) for c in CELLS]


def shifted(tris, d):
    return [tuple(tuple(x + y for x, y in zip(p, d)) for p in t) for t in tris]


def scaled(tris, s):
    return [tuple(tuple(s * x for x in p) for p in t) for t in tris]


def normal(t):
    a, b = ([t[k][d] - t[0][d] for d in range(3)] for k in (1, 2))
    n = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
    length = math.sqrt(sum(x * x for x in n))
    return [x / length if length else 0.0 for x in n]


def ascii_stl(tris, name="wedge", number="%.17g", sign=1):
    out = ["solid " + name if name else "solid"]
    for t in tris:
        out += ["facet normal " + " ".join(number % (sign * x) for x in normal(t)), "outer loop"]
        out += ["vertex " + " ".join(number % x for x in p) for p in t] + ["endloop", "endfacet"]
    out.append("endsolid " + name if name else "endsolid")
    return "\n".join(out) + "\n"


def binary_stl(tris, header=b"made for a test", count=None):
    out = header.ljust(80, b"\0") + struct.pack("<I", len(tris) if count is None else count)
    for t in tris:
        out += struct.pack("<12fH", *normal(t), *[x for p in t for x in p], 0)
    return out


def vtk_numbers(values, code, binary, per_line=9):
    if binary:
        return struct.pack(">%d%s" % (len(values), code), *values) + b"\n"
    return ("\n".join(" ".join("%.17g" % x for x in values[i:i + per_line])
                      for i in range(0, len(values), per_line)) + "\n").encode()


def vtk(points, cells, grid=False, binary=False, modern=False, kind="float", types=None, extra=b"",
        first=b"", npoints=None, ncells=None):
    code = {"float": "f", "double": "d", "int": "i"}[kind]
    dataset = "UNSTRUCTURED_GRID" if grid else "POLYDATA"
    out = ("# vtk DataFile Version %s\nmade for a test\n%s\nDATASET %s\n"
           % ("5.1" if modern else "3.0", "BINARY" if binary else "ASCII", dataset)).encode()
    out += first
    out += b"POINTS %d %s\n" % (len(points) if npoints is None else npoints, kind.encode())
    out += vtk_numbers([x for p in points for x in p], code, binary)
    word, n = b"CELLS" if grid else b"POLYGONS", len(cells) if ncells is None else ncells
    flat = [i for c in cells for i in c]
    if modern:
        offsets = [0]
        for c in cells:
            offsets.append(offsets[-1] + len(c))
        out += b"%s %d %d\nOFFSETS vtktypeint64\n" % (word, n + 1, len(flat))
        out += vtk_numbers(offsets, "q", binary)
        out += b"CONNECTIVITY vtktypeint64\n" + vtk_numbers(flat, "q", binary)
    else:
        out += b"%s %d %d\n" % (word, n, len(flat) + len(cells))
        out += vtk_numbers([i for c in cells for i in (len(c),) + tuple(c)], "i", binary, 4)
    if grid and types != "none":
        types = types or [5] * len(cells)
        out += b"CELL_TYPES %d\n" % len(types) + vtk_numbers(types, "i", binary, 1)
    return out + extra


def put(name, data, status, *counts, volume=0.0):
    with open(os.path.join(FOLDER, name), "wb") as f:
        f.write(data.encode() if isinstance(data, str) else data)
    TABLE.append((name, status, list(counts) + [0] * (8 - len(counts)), volume))


def bad(name, data, status):
    put(name, data, status)


def good(name, data, facets=8, vertices=6, volume=0.5, degenerate=0, duplicate=0, open_edges=0,
         nonmanifold=0, inconsistent=0, flipped=0):
    put(name, data, "ok", facets, vertices, degenerate, duplicate, open_edges, nonmanifold,
        inconsistent, flipped, volume=volume)


def good_stl():
    text = ascii_stl(WEDGE)
    good("ascii.stl", text)
    good("ascii_crlf.stl", text.replace("\n", "\r\n"))
    good("ascii_cr.stl", text.replace("\n", "\r"))
    good("ascii_noname.stl", ascii_stl(WEDGE, ""))
    good("ascii_upper.stl", text.upper())
    good("ascii_tabs.stl", text.replace(" ", "\t  "))
    good("ascii_exponents.stl", ascii_stl(WEDGE, "long name of several words", "%.8E"))
    good("ascii_bom.stl", b"\xef\xbb\xbf" + text.encode())
    good("ascii_no_last_newline.stl", text.rstrip("\n"))
    good("ascii_nan_normals.stl", text.replace("normal 0 ", "normal -nan(ind) "))
    good("ascii_flipped_normals.stl", ascii_stl(WEDGE, sign=-1), flipped=8)
    good("ascii_two_solids.stl", text + ascii_stl(shifted(WEDGE, (3, 0, 0)), "other"), 16, 12, 1.0)
    good("ascii_empty_solid_first.stl", "solid nothing\nendsolid nothing\n" + text)
    good("ascii_far.stl", ascii_stl(shifted(WEDGE, (1e6, -1e6, 1e6))))
    good("ascii_tiny.stl", ascii_stl(scaled(WEDGE, 1e-12)), volume=0.5e-36)
    good("ascii_huge.stl", ascii_stl(scaled(WEDGE, 1e15)), volume=0.5e45)
    good("binary.stl", binary_stl(WEDGE))
    good("binary_solid.stl", binary_stl(WEDGE, b"solid in the header, binary all the same"))
    good("binary_plate.stl", binary_stl([((0, 0, 0), (1, 0, 0), (1, 1, 0)), ((0, 0, 0), (1, 1, 0), (0, 1, 0))]),
         2, 4, 0.0, open_edges=4)
    good("binary_one.stl", binary_stl([((0, 0, 0), (1, 0, 0), (1, 1, 0))]), 1, 3, 0.0, open_edges=3)


def odd_topology():
    turned = [(a, c, b) for a, b, c in WEDGE]
    good("inside_out.stl", binary_stl(turned), volume=-0.5)
    good("one_turned.stl", binary_stl(turned[:1] + WEDGE[1:]), volume=0.0, inconsistent=3)
    good("open.stl", binary_stl(WEDGE[1:]), 7, 6, 0.0, open_edges=3)
    good("duplicate.stl", binary_stl(WEDGE + WEDGE[3:4]), duplicate=1)
    good("duplicate_turned.stl", binary_stl(WEDGE + turned[3:4]), duplicate=1)
    a, b, c = WEDGE[0]
    good("degenerate_point.stl", binary_stl(WEDGE + [(a, a, b)]), degenerate=1)
    middle = tuple(0.5 * (x + y) for x, y in zip(a, b))
    good("degenerate_line.stl", ascii_stl(WEDGE + [(a, middle, b), (c, c, c)]), degenerate=2)
    good("needle.stl", ascii_stl([((0, 0, 0), (1, 0, 0), (0.3, 1e-4, 0))]), 1, 3, 0.0, open_edges=3)
    book = [((0, 0, 0), (0, 0, 1), (math.cos(t), math.sin(t), 0.5)) for t in (0.1, 1.7, 4.0)]
    good("book.stl", ascii_stl(book), 3, 5, 0.0, open_edges=6, nonmanifold=1)
    noise = [tuple(tuple(x + 1e-9 * math.sin(12.3 * i + 4.5 * k + 6.7 * d) for d, x in enumerate(p))
                   for k, p in enumerate(t)) for i, t in enumerate(WEDGE)]
    good("noisy_vertices.stl", ascii_stl(noise))


def good_vtk():
    field = (b"FIELD FieldData 2\nTIME 1 1 double\n0.5\nname 2 2 int\n1 2 3 4\n"
             b"METADATA\nINFORMATION 0\n\n")
    data = b"CELL_DATA 8\nSCALARS id int 1\nLOOKUP_TABLE default\n0 1 2 3 4 5 6 7\n"
    for grid in (False, True):
        for binary in (False, True):
            for modern in (False, True):
                name = "%s_%s_%s.vtk" % ("grid" if grid else "poly", "binary" if binary else "ascii",
                                         "51" if modern else "30")
                good(name, vtk(POINTS, CELLS, grid, binary, modern, "double" if modern else "float"))
    good("poly_field.vtk", vtk(POINTS, CELLS, first=field, extra=data))
    good("poly_int_points.vtk", vtk(POINTS, CELLS, kind="int"))
    good("poly_crlf.vtk", vtk(POINTS, CELLS).replace(b"\n", b"\r\n"))


def bad_stl():
    text, binary = ascii_stl(WEDGE), binary_stl(WEDGE)
    lines = text.splitlines(True)
    bad("empty.stl", "", "empty_file")
    bad("blank.stl", " \n\t\n", "empty_file")
    bad("page.stl", "<!DOCTYPE html>\n<html><body>404 not found</body></html>\n", "not_a_mesh")
    bad("page2.stl", "<html><body>log in first</body></html>\n", "not_a_mesh")
    bad("text.stl", "this is not a mesh, but a text of some length\n" * 10, "not_a_mesh")
    bad("picture.stl", b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR" + bytes(range(256)), "not_a_mesh")
    bad("zip.stl", b"PK\x03\x04\x14\0\0\0\x08\0" + bytes(range(200)), "not_a_mesh")
    bad("binary_cut.stl", binary[:-7], "truncated")
    bad("binary_header_only.stl", binary[:84], "truncated")
    bad("binary_half_header.stl", binary[:50] + b"\1\2", "not_a_mesh")
    bad("binary_long.stl", binary + b"more", "trailing_data")
    bad("binary_huge_count.stl", binary_stl(WEDGE, count=0xFFFFFFFF), "truncated")
    bad("binary_overflow_count.stl", binary_stl([], count=85899346), "truncated")
    bad("binary_solid_cut.stl", binary_stl(WEDGE, b"solid and cut")[:-100], "truncated")
    bad("binary_none.stl", binary_stl([]), "no_triangles")
    nan = binary[:84 + 50 + 16] + struct.pack("<f", math.nan) + binary[84 + 50 + 20:]
    bad("binary_nan.stl", nan, "bad_value")
    inf = binary[:84 + 50 + 16] + struct.pack("<f", math.inf) + binary[84 + 50 + 20:]
    bad("binary_inf.stl", inf, "bad_value")
    bad("ascii_nan.stl", text.replace("vertex 1 1 1", "vertex 1 nan 1", 1), "bad_value")
    bad("ascii_inf.stl", text.replace("vertex 1 1 1", "vertex 1 1 1e999", 1), "bad_value")
    bad("ascii_beyond.stl", text.replace("vertex 1 1 1", "vertex 1 1 1e31", 1), "bad_value")
    bad("ascii_cut_number.stl", "".join(lines[:10]) + "vertex 1 1", "truncated")
    bad("ascii_cut_facet.stl", "".join(lines[:11]), "truncated")
    bad("ascii_no_end.stl", "".join(lines[:-1]), "truncated")
    bad("ascii_trailing.stl", text + "and so on\n", "trailing_data")
    bad("ascii_none.stl", "solid nothing\nendsolid nothing\n", "no_triangles")
    bad("ascii_bad_word.stl", text.replace("outer loop", "outer lop", 1), "syntax_error")
    bad("ascii_bad_number.stl", text.replace("vertex 1 1 1", "vertex 1 1,0 1", 1), "syntax_error")
    bad("ascii_quad.stl", text.replace("endloop", "vertex 9 9 9\nendloop", 1), "not_triangles")
    bad("ascii_two_vertices.stl", text.replace("vertex 1 1 1\n", "", 1), "syntax_error")
    bad("ascii_long_word.stl", text.replace("vertex 1 1 1", "vertex 1 1 " + "1" * 200, 1), "syntax_error")
    flat = [((0, 0, 0), (1, 1, 1), (2, 2, 2)), ((0, 0, 0), (0, 0, 0), (1, 0, 0))]
    bad("all_degenerate.stl", ascii_stl(flat), "all_facets_degenerate")
    bad("all_in_one_point.stl", ascii_stl([((1, 1, 1),) * 3] * 4), "all_facets_degenerate")


def bad_vtk():
    quads = [(0, 1, 4, 3), (1, 2, 5, 4)]
    whole = vtk(POINTS, CELLS)
    bad("quads.vtk", vtk(POINTS, quads), "not_triangles")
    bad("quads_51.vtk", vtk(POINTS, quads, modern=True), "not_triangles")
    bad("quads_binary.vtk", vtk(POINTS, quads, binary=True), "not_triangles")
    bad("tets.vtk", vtk(POINTS, [(0, 1, 2, 3)], grid=True, types=[10]), "not_triangles")
    bad("lines_type.vtk", vtk(POINTS, CELLS, grid=True, types=[3] * 8), "not_triangles")
    bad("lines.vtk", whole.replace(b"POLYGONS", b"LINES"), "not_triangles")
    bad("strips.vtk", whole.replace(b"POLYGONS", b"TRIANGLE_STRIPS"), "not_triangles")
    bad("structured.vtk", whole.replace(b"POLYDATA", b"STRUCTURED_GRID"), "unsupported")
    bad("strange_type.vtk", whole.replace(b"float", b"quaternion"), "unsupported")
    bad("third_line.vtk", whole.replace(b"ASCII", b"XML"), "syntax_error")
    bad("index_too_large.vtk", vtk(POINTS[:-1], CELLS), "bad_vertex_index")
    bad("index_negative.vtk", vtk(POINTS, [(0, -1, 2)]), "bad_vertex_index")
    bad("index_negative_binary.vtk", vtk(POINTS, [(0, -1, 2)], binary=True), "bad_vertex_index")
    bad("index_fraction.vtk", whole.replace(b"3 0 2 1", b"3 0 2 1.5"), "bad_vertex_index")
    bad("points_huge.vtk", vtk(POINTS, CELLS, npoints=10**20), "too_large")
    bad("points_too_many.vtk", vtk(POINTS, CELLS, npoints=10**8), "truncated")
    bad("points_too_many_binary.vtk", vtk(POINTS, CELLS, binary=True, npoints=10**8), "truncated")
    bad("cells_huge.vtk", vtk(POINTS, CELLS, ncells=10**15), "too_large")
    bad("cells_too_many.vtk", vtk(POINTS, CELLS, ncells=10**8), "syntax_error")
    bad("cut_points.vtk", whole[:100], "truncated")
    bad("cut_cells.vtk", whole[:-20], "truncated")
    bad("cut_binary.vtk", vtk(POINTS, CELLS, binary=True)[:-9], "truncated")
    bad("cut_51.vtk", vtk(POINTS, CELLS, binary=True, modern=True)[:-50], "truncated")
    bad("only_header.vtk", whole[:66], "truncated")
    bad("no_types.vtk", vtk(POINTS, CELLS, grid=True, types="none"), "truncated")
    bad("no_cells.vtk", vtk(POINTS, []), "no_triangles")
    bad("nan.vtk", vtk([(math.nan, 0, 0)] + POINTS[1:], CELLS), "bad_value")
    bad("inf_binary.vtk", vtk([(math.inf, 0, 0)] + POINTS[1:], CELLS, binary=True), "bad_value")
    bad("unknown_section.vtk", whole + b"GARBAGE 1 2 3\n", "trailing_data")


def main():
    good_stl()
    odd_topology()
    good_vtk()
    bad_stl()
    bad_vtk()
    with open(os.path.join(FOLDER, "expected.txt"), "w") as f:
        f.write("# written by make_meshes.py\n# file status facets vertices degenerate duplicate open "
                "nonmanifold inconsistent flipped volume\n")
        for name, status, counts, volume in TABLE:
            f.write("%s %s %s %.17g\n" % (name, status, " ".join(map(str, counts)), volume))
        f.write("not_there.stl no_file 0 0 0 0 0 0 0 0 0\n")
    print("%d meshes in %s" % (len(TABLE), FOLDER))


if __name__ == "__main__":
    main()
