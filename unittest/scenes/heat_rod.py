"""A rod of 'body heat' particles along x, one particle thick and periodic across: input of the heat tests.

    text = rod([Layer(100, 1e-5, density=2700, k=120, cp=899, T=773.15), ...], "pair_coeff 1 2 heat", "fix ...")

Layer 1 ends at x = 0, the next ones follow on the right; each is one type and one group, l1, l2, ... Temperatures
go to profile.dump at the end of every run command that the caller writes with RUN."""

from collections import namedtuple

# n particles, spacing, material; k and cp are words of pair_coeff, numbers or 'table/N T1 y1 ...'
Layer = namedtuple("Layer", "n density k cp T body")
Layer.__new__.__defaults__ = ("heat",)

HEAD = """
units {units}
dimension {dim}
boundary f p p
atom_style atomic
newton off
atom_modify map array
variable dx equal {dx!r}
lattice {lattice} ${{dx}} origin 0.5 0.5 {origin}
region box block $({lo}*v_dx) $({hi}*v_dx) 0 ${{dx}} {z} units box
create_box {types} box
"""

# runs to the time that is the argument, or a step beyond it
RUN = """
variable left equal {0}-time
fix stop all halt 1 v_left <= 0 error continue message no
thermo 1
run 10000000
unfix stop
write_dump all custom profile.dump id type x c_T modify format float %.15g
"""


def rod(layers, dx, more, dim=2, style="hyperbolic 1.2", units="si", pad=0, body="fix body all sph/tm"):
    """layers: list of Layer; more: the commands after fix sph/tm. pad: empty spacings at both ends."""
    lo = -layers[0].n
    hi = lo + sum(l.n for l in layers)
    text = HEAD.format(units=units, dim=dim, dx=dx, lattice="sq" if dim == 2 else "sc",
                       origin="0" if dim == 2 else "0.5",
                       lo=lo - pad, hi=hi + pad, z="$(-v_dx) ${dx}" if dim == 2 else "0 ${dx}", types=len(layers))
    at = lo
    for k, l in enumerate(layers, 1):
        text += "region l%d block $(%d*v_dx) $(%d*v_dx) INF INF INF INF units box\n" % (k, at, at + l.n)
        text += "create_atoms %d region l%d\ngroup l%d type %d\n" % (k, k, k, k)
        at += l.n
    text += "pair_style sph/tm %s spacing ${dx}\n" % style
    for k, l in enumerate(layers, 1):
        elastic = "elastic 1 0.3 " if l.body == "solid" else ""
        text += "pair_coeff %d %d density %s %sbody %s heat %s %s 0\n" % (k, k, l.density, elastic, l.body, l.k, l.cp)
    coeffs = [c for c in more.splitlines() if c.startswith("pair_coeff")]
    text += "\n".join(coeffs) + "\n" + body + "\n"
    for k, l in enumerate(layers, 1):
        text += "fix_modify body temperature l%d %s\n" % (k, l.T)
    text += "compute T all sph/tm/atom temperature\nthermo 1000000\n"
    for line in more.splitlines():
        if not line.startswith("pair_coeff"):
            text += line + "\n"
        if line.startswith("thermo_style"):    # which resets the format
            text += "thermo_modify format float %.15g\n"
    return text
