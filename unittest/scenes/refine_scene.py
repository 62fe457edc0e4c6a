"""A free body of metal with stress, plastic strain and heat in it that flies, turns and is refined; used by the tests
of refinement. Coordinates are multiples of a power of two, so that they have the same bits on any number of ranks."""
import numpy as np

DX = 2.0 ** -10
STEEL = ("density 7850 elastic 200e9 0.29 strength johnson/cook 350e6 275e6 0.36 0.022 1.0 293 1793 1.0 "
         "heat 40 480 0.9 damage johnson/cook 0.5 1.0 -3.0 0.01 1.0")

SCRIPT = """
units           si
dimension       {dim}
boundary        {boundary}
atom_style      atomic
newton          off
processors      {grid}
lattice         {lattice} {dx} origin 0.5 0.5 {oz}
region          box block {box} units box
create_box      1 box
region          work block 0 {lx} 0 {ly} {lz} units box
create_atoms    1 region work
pair_style      sph/tm {kernel} spacing {dx} {keywords}
pair_coeff      1 1 {material}
velocity        all set {v}
variable        spin equal {spin}
variable        vx atom vx-v_spin*(y-{ly}/2)+{squeeze}*(x-{lx}/2)
variable        vy atom vy+v_spin*(x-{lx}/2)-{squeeze}*(y-{ly}/2)
velocity        all set v_vx v_vy NULL
"""
STYLES = """
fix             body all sph/tm temperature 300 energy yes {body}
{more}
compute         p all sph/tm/atom density pstrain temperature damage vonmises level h stress/xx stress/yy stress/xy
fix             ad all adapt/neigh {refine}
variable        px atom mass*vx
variable        py atom mass*vy
compute         u all property/atom xu yu
variable        lz atom mass*(c_u[1]*vy-c_u[2]*vx)
variable        m atom mass
compute         sum all reduce sum v_m v_px v_py v_lz
thermo          {thermo}
thermo_style    custom step atoms time dt ke c_sum[*] f_body[*] f_ad[*]
thermo_modify   format float %.17g lost error norm no
"""
DUMP = """
dump            d all custom {every} {name} id mass xu yu zu vx vy vz c_p[*]
dump_modify     d sort id format float %.17g
"""
VALUES = ["density", "pstrain", "temperature", "damage", "vonmises", "level", "h", "stress/xx", "stress/yy", "stress/xy"]


def start(dim=2, size=(24, 16, 8), boundary=None, v="40 20 0", spin=0.0, squeeze=0.0, grid="* * 1", margin=8,
          kernel="hyperbolic 1.2", keywords="", material=STEEL):
    nx, ny, nz = size
    box = [-margin * DX, (nx + margin) * DX, -margin * DX, (ny + margin) * DX]
    box += [-margin * DX, (nz + margin) * DX] if dim == 3 else [-0.5 * DX, 0.5 * DX]
    return SCRIPT.format(dim=dim, boundary=boundary or ("s s s" if dim == 3 else "s s p"), grid=grid, dx=DX,
                         lattice="sc" if dim == 3 else "sq", oz=0.5 if dim == 3 else 0,
                         box=" ".join("%.17g" % b for b in box), lx="%.17g" % (nx * DX), ly="%.17g" % (ny * DX),
                         lz="0 %.17g" % (nz * DX) if dim == 3 else "INF INF", v=v, spin=spin, squeeze=squeeze,
                         kernel=kernel, keywords=keywords, material=material)


def styles(refine, body="", more="", thermo=10):
    return STYLES.format(body=body, more=more, thermo=thermo, refine=refine)


def dump(every, name="d.dump"):
    return DUMP.format(every=every, name=name)


def values(frame, what):
    return frame["c_p[%d]" % (1 + VALUES.index(what))]


def momenta(frame):
    """Mass, momentum, angular momentum about z, kinetic energy of the particles of a frame."""
    m = frame["mass"]
    return dict(mass=np.sum(m), px=np.sum(m * frame["vx"]), py=np.sum(m * frame["vy"]),
                lz=np.sum(m * (frame["xu"] * frame["vy"] - frame["yu"] * frame["vx"])),
                kinetic=0.5 * np.sum(m * (frame["vx"] ** 2 + frame["vy"] ** 2 + frame["vz"] ** 2)))
