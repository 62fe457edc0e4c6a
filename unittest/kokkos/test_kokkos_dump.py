"""dump sph/tm/vtp with Kokkos: with one thread and with two the bytes of the plain styles, tool included; with the loops of a
GPU, whose arrays live in another memory, the same values to round-off."""
import os

import numpy as np
from kokkos_scene import Checks, new_folder, run_way
from contact_scene import block, header, mesh, particles
from test_dump_vtp import DX, SCENE, read_pvd, read_vtp

END = """
dump a all sph/tm/vtp 10 a.*.vtp id type x y z vx vy vz c_p[*] v_height
dump_modify a sort id
run 20
"""
FILES = ["a.%d.vtp" % step for step in (0, 10, 20)] + ["a_tool_%d.vtp" % step for step in (0, 10, 20)]
BOUND = 1e-9


def files_of(way):
    folder = new_folder()
    mesh(folder, "block.stl", "block --size 0.3 0.3 0.3 --cells 3 4 5")
    x = block((8, 8, 4), DX, (-0.08, -0.08, -0.06))
    v = np.tile([0.0, 0.0, -1.5], (len(x), 1))
    result = run_way(way, header(DX) + SCENE + END, folder=folder, files={"data.scene": particles(x, [(-0.4, 0.4)] * 3, v=v)})
    return result, {f: open(result.path(f), "rb").read() for f in FILES}


checks = Checks()
plain, bytes_of_plain = files_of("plain")
checks.true("list of the plain styles", [e[2] for e in read_pvd(plain.path("a.pvd"))] ==
            [f for step in (0, 10, 20) for f in ("a.%d.vtp" % step, "a_tool_%d.vtp" % step)])
for way in "serial", "threads", "device":
    result, found = files_of(way)
    if way != "device":
        differ = [f for f in FILES if found[f] != bytes_of_plain[f]]
        checks.true(way + ": the bytes of the plain styles", not differ, " ".join(differ))
    for f in FILES:
        due, got = read_vtp(plain.path(f)), read_vtp(result.path(f))
        names = due["in PointData"] + ["Points", "connectivity", "offsets"]
        apart = max(abs(got[n] - due[n]).max() / max(abs(due[n]).max(), 1e-300) for n in names) \
            if got["in PointData"] == due["in PointData"] else float("inf")
        checks.below("%s: %s" % (way, os.path.basename(f)), apart, BOUND)
checks.end()
