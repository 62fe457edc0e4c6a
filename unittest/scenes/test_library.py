"""LAMMPS as a library: several instances in one process, one after the other and side by side, give the numbers of one
alone; values that are asked for before the first run, or of what is gone, are an error message and no crash."""
import ctypes
import os
import subprocess
import sys

from sphtm_scene import SKIPPED, Checks, lattice_block

HEAD = lattice_block("0 6e-3 0 6e-3", "-5e-3 15e-3 -5e-3 15e-3") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff      1 1 density 2700 elastic 70e9 0.33 strength plastic 300e6 1e9 heat 200 900 0.9
fix             body all sph/tm
fix             ad all adapt/neigh threshold 1e-5 %s
compute         p all sph/tm/atom pstrain
compute         most all reduce max c_p
variable        body equal f_body[1]
variable        adapt equal f_ad[1]
velocity        all set 200 0 0
region          half block 0 3e-3 INF INF INF INF units box
group           half region half
velocity        half set %d 0 0
thermo_style    custom step pe c_most
"""
GLOBAL, ATOM, SCALAR, VECTOR = 0, 1, 0, 1


def library():
    """The functions of liblammps.so that are used here."""
    lib = ctypes.CDLL(os.path.join(os.path.dirname(os.environ["SPHTM_LMP"]), "liblammps.so"), ctypes.RTLD_GLOBAL)
    lib.lammps_open_no_mpi.restype = ctypes.c_void_p
    for name in "lammps_extract_fix", "lammps_extract_compute", "lammps_extract_variable", "lammps_extract_atom":
        getattr(lib, name).restype = ctypes.c_void_p
    return lib


class Lammps:
    def __init__(self, lib):
        words = [b"lmp", b"-nocite", b"-log", b"none", b"-screen", b"none"]
        self.lib = lib
        self.handle = ctypes.c_void_p(lib.lammps_open_no_mpi(len(words), (ctypes.c_char_p * len(words))(*words), None))

    def __call__(self, text):
        """Runs the commands up to the first error, and returns its text."""
        for line in text.splitlines():
            self.lib.lammps_command(self.handle, line.encode())
            if self.error():
                return self.said
        return ""

    def error(self):
        text = ctypes.create_string_buffer(4000)
        self.said = ""
        if self.lib.lammps_has_error(self.handle):
            self.lib.lammps_get_last_error_message(self.handle, text, len(text))
            self.said = text.value.decode()
        return self.said

    def places(self):
        n = int(self.lib.lammps_extract_setting(self.handle, b"nlocal"))
        rows = ctypes.POINTER(ctypes.POINTER(ctypes.c_double))
        x = ctypes.cast(self.lib.lammps_extract_atom(self.handle, b"x"), rows)
        return [x[i][d] for i in range(n) for d in range(2)]

    def fix(self, name, kind=VECTOR, i=0, j=0):
        found = self.lib.lammps_extract_fix(self.handle, name, GLOBAL, kind, i, j)
        return ctypes.cast(found, ctypes.POINTER(ctypes.c_double))[0] if found else self.error() or None

    def variable(self, name):
        found = self.lib.lammps_extract_variable(self.handle, name, None)
        return ctypes.cast(found, ctypes.POINTER(ctypes.c_double))[0] if found else self.error() or None

    def compute(self, name, kind=SCALAR, style=GLOBAL):
        found = self.lib.lammps_extract_compute(self.handle, name, style, kind)
        return "found" if found else self.error() or None

    def close(self):
        self.lib.lammps_close(self.handle)


def scene(speed, more=""):
    return HEAD % (more, speed)


def alone(speed, steps=40, more=""):
    one = Lammps(library())
    assert not one(scene(speed, more) + "run %d\n" % steps), one.said
    return one.places()


def expect(name, ok, text=""):
    print("  %-4s %s %s" % ("ok" if ok else "FAIL", name, text if not ok else ""), flush=True)
    if not ok:
        sys.exit(1)


def case_side_by_side():
    slow, fast = alone(150), alone(50)
    lib = library()
    one, two = Lammps(lib), Lammps(lib)
    expect("the first", not one(scene(150)), one.said)
    expect("the second knows the styles", not two(scene(50)), two.said)
    for _ in range(2):    # in turn
        one("run 20")
        two("run 20")
    expect("no errors", not one.said and not two.said, one.said + two.said)
    expect("the first as alone", one.places() == slow)
    expect("the second as alone", two.places() == fast)
    one.close()
    expect("the second goes on after the first is closed", not two("run 5\nclear\n" + scene(50) + "run 40"), two.said)
    expect("after clear as alone", two.places() == fast)
    two.close()


def case_one_after_another():
    slow = alone(150)
    lib = library()
    for k in range(3):
        one = Lammps(lib)
        expect("instance %d" % k, not one(scene(150) + "run 40"), one.said)
        expect("as alone", one.places() == slow)
        one.close()


def case_unload():
    slow = alone(150)
    lib = library()
    one, two = Lammps(lib), Lammps(lib)
    expect("both", not one(scene(150) + "run 20") and not two(scene(50) + "run 5"), one.said + two.said)
    two("plugin unload fix adapt/neigh\nplugin unload fix sph/tm\nplugin unload pair sph/tm")
    expect("it is gone in one", "sph/tm" in two("pair_style sph/tm hyperbolic 1.2 spacing 1e-3"))
    expect("the other goes on", not one("run 20"), one.said)
    expect("as alone", one.places() == slow)
    path = os.path.join(os.environ["LAMMPS_PLUGIN_PATH"], "sphtmplugin.so")
    expect("loaded again", not two('clear\nplugin load "%s"\n' % path + scene(150) + "run 40"), two.said)
    expect("as alone again", two.places() == slow)
    third = Lammps(lib)
    expect("a third", not third(scene(150) + "run 40"), third.said)
    for each in one, third, two:
        each.close()


def case_before_a_run():
    one = Lammps(library())
    expect("set up", not one(scene(150)), one.said)

    def ask(when):
        for name, kind, i, j in ((b"body", SCALAR, 0, 0), (b"body", VECTOR, 0, 0), (b"body", VECTOR, 99, 0),
                                 (b"ad", VECTOR, 0, 0), (b"ad", VECTOR, 99, 0)):
            got = one.fix(name, kind, i, j)
            expect("f_%s[%d] %s" % (name.decode(), i, when), not isinstance(got, float), got)
        for name in b"body", b"adapt":
            got = one.variable(name)
            expect("v_%s %s" % (name.decode(), when), not isinstance(got, float), got)
        if when == "before a run":    # later LAMMPS has values of before
            got = one.compute(b"most"), one.compute(b"p", VECTOR, ATOM)
            expect("computes %s" % when, "found" not in got, got)
        one("info memory")

    ask("before a run")
    expect("the run", not one("run 5"), one.said)
    expect("after it", isinstance(one.fix(b"body"), float) and isinstance(one.fix(b"ad"), float))
    one("pair_style none")
    ask("after pair_style none")
    one.close()
    two = Lammps(library())
    expect("set up", not two(scene(150) + "run 5"), two.said)
    two("uncompute most\nuncompute p\nunfix body")
    got = two.fix(b"ad")
    expect("f_ad after unfix body", not isinstance(got, float), got)
    two("info memory")
    two.close()


def case_refined_before_a_run():
    one = Lammps(library())
    text = scene(150).replace("threshold 1e-5", "refine square epsilon 0.4 alpha 0.6 when pstrain above 0.1")
    expect("set up", not one(text), one.said)
    for i in 0, 3, 9, 99:
        got = one.fix(b"ad", VECTOR, i)
        expect("f_ad[%d] before a run" % i, not isinstance(got, float), got)
    one("info memory\nrun 3\nunfix body")
    for i in 0, 3, 9:
        got = one.fix(b"ad", VECTOR, i)
        expect("f_ad[%d] after unfix body" % i, not isinstance(got, float), got)
    one.close()


if __name__ == "__main__":
    cases = {name[5:]: what for name, what in globals().copy().items() if name.startswith("case_")}
    if len(sys.argv) > 1:
        cases[sys.argv[1]]()
        sys.exit(0)
    if not os.path.exists(os.path.join(os.path.dirname(os.environ.get("SPHTM_LMP", "")), "liblammps.so")):
        print("no liblammps.so beside lmp: skipped")
        sys.exit(SKIPPED)
    checks = Checks()
    for name in cases:    # each in a process of its own, which may crash
        done = subprocess.run([sys.executable, __file__, name], stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              text=True, timeout=120)
        checks.say(done.returncode == 0, name, "status %d" % done.returncode + "\n" * (done.returncode != 0) +
                   done.stdout[-2500:] * (done.returncode != 0))
    checks.end()
