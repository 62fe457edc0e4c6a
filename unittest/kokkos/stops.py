"""What stops a run on its way: scripts that do, and the message. It must be the same with Kokkos as without; on a GPU
the bundle's 'run test' compares too (bench/gpu/run.py)."""
import re

BASE = """
units si
dimension 2
boundary f f p
atom_style atomic
newton off
lattice sq 1e-3 origin 0.5 0.5 0
region box block {box} -0.5e-3 0.5e-3 units box
create_box 2 box
region work block 0 8e-3 0 8e-3 INF INF units box
create_atoms 1 region work
{more}
pair_style sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff 1 1 density 2700 elastic 70e9 0.33 strength johnson/cook 428e6 327e6 1.008 0.01 1.31 293 855 1.0 &
  heat 200 900 0.9
pair_coeff 2 2 density 2700000 elastic 70e12 0.33 heat 200 900 0.9
fix body all sph/tm {fix}
group one id 30
thermo 10
run 20
{lines}
run 80
"""
SMALL, LARGE = "-13e-3 13e-3 -13e-3 13e-3", "-1 1 -1 1"
CASES = {
    "state that is no number": dict(lines="variable f equal exp(800*(step>25))\nfix push one addforce v_f 0 0"),
    "runaway": dict(lines="fix push one addforce 1e10 0 0"),
    "velocity set too high": dict(lines="velocity one set 1e6 0 0 units box"),
    "density": dict(fix="density/max 1e9", more="set atom 31 type 2",
                    lines="group heavy id 31\nvelocity heavy set 300 0 0 units box"),
    "leaves the box": dict(box=SMALL, more="create_atoms 1 single 11.5e-3 3.5e-3 0 units box",
                           lines="group last id 65\nvelocity last set 3000 300 0 units box"),
    "heat taken out": dict(lines="fix sink one sph/tm/heat source -1e20"),
    "overlap at the start": dict(more="create_atoms 1 single 2.5e-3 2.5e-3 0 units box"),
    "too dense at the start": dict(more="create_atoms 1 single 3.2e-3 3.3e-3 0 units box"),
    "density beyond its bound": dict(
        fix="density/max 1.05", lines="variable vx atom -2e5*(x-4e-3)\nvelocity all set v_vx NULL NULL units box"),
    "plastic strain in a step": dict(
        fix="courant 1 density/max 1e9",
        lines="variable vx atom 1.2e7*(x-4e-3)\nvariable vy atom -1.2e7*(y-4e-3)\nvelocity all set v_vx v_vy NULL units box"),
    "above the melting temperature, then too hot": dict(lines="fix glow one sph/tm/heat source 1e16"),
    "above the largest temperature": dict(fix="temperature/max 400", lines="fix glow one sph/tm/heat source 1e16"),
    "moved together between runs": dict(lines="displace_atoms one move 0.5e-3 0 0 units box"),
    "another material between runs": dict(lines="set group one type 2"),
    "state lost between runs": dict(lines="unfix body\nfix body all sph/tm"),
}

# Rows that become many times longer than the room there was for them. What a row holds beyond the reach of the kernel
# does not count: the state is the same, bit for bit, as with short rows.
GROW = BASE.format(box=LARGE, more="", fix="", lines="velocity one set 100 0 0 units box\n{skin}") + \
    "write_dump all custom end.dump id x y vx vy fx fy modify sort id format float %.17g\n"
ROWS_GROW, ROWS_STAY = GROW.format(skin="neighbor 6e-3 bin"), GROW.format(skin="")


def script(name):
    return BASE.format(**dict(dict(box=LARGE, more="", lines="", fix=""), **CASES[name]))


def message(output):
    """LAMMPS's error message and the warnings of fix sph/tm, without the places in the code."""
    text = " ".join(" ".join(re.findall(r"^(?:ERROR|WARNING: Fix sph/tm:).*", output, re.M)).split())
    return re.sub(r" \(\S*\.cpp:\d+\)", "", text)


NUMBER = r"[-+]?\d+\.?\d*(?:e[-+]?\d+)?"


def same(one, other, relative):
    """The same words, the same whole numbers, other numbers to that difference."""
    if re.split(NUMBER, one) != re.split(NUMBER, other):
        return False
    for a, b in zip(re.findall(NUMBER, one), re.findall(NUMBER, other)):
        whole = a.lstrip("-").isdigit() and b.lstrip("-").isdigit()
        if a != b and (whole or abs(float(a) - float(b)) > relative * max(abs(float(a)), abs(float(b)))):
            return False
    return bool(one)
