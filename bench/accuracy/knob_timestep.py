"""Factor on the time step: a wave, whose frequency on the lattice is known for plain sums without hourglass control, and the Taylor bar."""
import numpy as np

from cases import taylor
from frame import CLOSED, Sweep
from sph_kernels import kernel

TITLE = "time-step factor"
SPACING, N, SPEED = 1e-2, 32, 1e-5    # m; particles to a wave; amplitude, m/s
RATIO, PERIODS = 1.2, 10
SOUND = np.sqrt(1e7 * 0.7 / (1.3 * 0.4) / 1000)    # of E 1e7, nu 0.3, 1000 kg/m3
SCRIPT = """
units           si
dimension       2
boundary        p p p
atom_style      atomic
newton          off
variable        length equal {n}*{dx}
variable        width index 16
lattice         sq {dx} origin 0.5 0.5 0
region          box block 0 ${{length}} 0 $({dx}*v_width) -0.005 0.005 units box
create_box      1 box
create_atoms    1 box
pair_style      sph/tm hyperbolic {ratio} spacing {dx} viscosity 0 0 hourglass 0 correction no
pair_coeff      1 1 density 1000 elastic 1e7 0.3
fix             body all sph/tm dt {dt!r}
variable        c atom cos(2*PI*x/v_length)
variable        u atom {speed}*v_c
run             0
velocity        all set v_u 0 0 units box
variable        m atom 2*vx*v_c/{speed}
compute         m all reduce ave v_m
thermo_style    custom step time c_m
thermo_modify   format float %.12g
thermo          1
run             {steps}
"""


def frequency():
    """Of the plane wave on the lattice, 1/s: sums of gradients instead of derivatives, exact in time."""
    k, h, m = 2 * np.pi / (N * SPACING), RATIO * SPACING, np.arange(-4, 5) * SPACING
    x, y = (c.ravel() for c in np.meshgrid(m, m))
    r = np.hypot(x, y)
    x, r = x[r > 0], r[r > 0]
    slope = kernel("hyperbolic", r / h)[1] * x / r
    return SOUND * (slope * np.sin(k * x)).sum() / (slope * x).sum()


def script(variables):
    dt = variables.pop("courant") * RATIO * SPACING / SOUND
    steps = int(np.ceil(PERIODS * 2 * np.pi / frequency() / dt))
    return SCRIPT.format(n=N, dx=SPACING, ratio=RATIO, dt=float(dt), speed=SPEED, steps=steps)


def off(run):
    t = run.thermo[-1]
    return {"error": abs(t["c_m"] - np.cos(frequency() * t["Time"])).max()}


def by(values, **more):
    return {"courant %g" % c: dict(more, courant=c) for c in values}


WAVE = (0.6, 0.4, 0.3, 0.2, 0.1, 0.05)
SWEEPS = [
    Sweep(name="wave", quantity="amplitude and phase of an elastic wave over ten periods",
          reference="frequency on the lattice",
          kind=CLOSED, script=script, settings={"quick": by(WAVE), "full": by(WAVE, width=64)}, measure=off,
          baseline="courant 0.4", order=lambda v: v["courant"]),
    taylor({"quick": by((0.6, 0.4, 0.3, 0.15), rings=3), "full": by((0.6, 0.5, 0.4, 0.3, 0.15), rings=4),
            "large": by((0.6, 0.4, 0.3), rings=9)}, baseline="courant 0.4"),
]
