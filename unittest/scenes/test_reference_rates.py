"""Every rate and the whole step of sph/tm against a second, independent implementation (sph_reference.py).

A perturbed lattice with random velocities, one side periodic, two materials; three steps with each set of
effects. Compared after every step: x, v, f, density, stress, temperature, plastic strain, energy, damage, ...
relative to the largest value in the field."""
import os
import sys

import numpy as np
from sph_kernels import REACH
from sph_material import Material
from sph_reference import Body
from sphtm_scene import Checks, run
from unit_styles import UNITS

SCRIPT = """
units {units}
dimension {dim}
boundary p f {bz}
atom_style atomic
atom_modify map array sort {sort}
newton {newton}
read_data data.{number}
pair_style sph/tm {kernel} {ratio} spacing {dx!r} {style}
{coeffs}
fix body all sph/tm temperature {T!r} dt {dt!r} lost ignore {fix}
{more}
compute p all sph/tm/atom {attributes}
thermo 1
dump d all custom 1 out.{number} id type x y z vx vy vz fx fy fz c_p[*]
dump_modify d format float %.17g
run {steps}
"""
STEPS = 3    # the prediction has seen two steps of its own by then

# --- materials, in the script's words and in those of the reference -----------------------------------------

ALU, COPPER = (2700.0, 70e9, 0.33), (8960.0, 124e9, 0.34)
JC_ALU = (428e6, 327e6, 0.8, 0.05, 1.31, 293.0, 855.0, 1.0)
JC_COPPER = (90e6, 292e6, 0.31, 0.025, 1.09, 298.0, 1356.0, 1.0)


def material(base, eos=("linear",), strength=("elastic",), damage=None, heat=None, expansion=0.0):
    return Material(*base, eos=eos, strength=strength, damage=damage, heat=heat, expansion=expansion)


def words(m, units):
    """The pair_coeff of a material, in a style of units."""
    mass, length, time, energy, _, pressure, density = UNITS[units]
    scale = {"plastic": [pressure] * 2, "johnson/cook": [pressure] * 2 + [1] * 5 + [1 / time],
             "shock": [length / time, 1, 1], "tait": [1], "strain": [1],
             "heat": [energy / (time * length), energy / mass, 1]}

    def text(name, values):
        out = [name]
        for v, unit in zip(values, scale.get(name, [1] * 9) if name != "damage" else [1] * 9):
            out += (["table/%d" % len(v)] + ["%r %r" % (float(t), float(y / unit)) for t, y in v]
                    if isinstance(v, list) else [repr(float(v / unit))])
        return " ".join(out)

    line = "density %r elastic %r %r" % (m.rho0 / density, m.E / pressure, m.nu)
    line += " eos " + text(m.eos[0], m.eos[1:]) + " strength " + text(m.strength[0], m.strength[1:])
    if m.damage:
        line += " damage %s %s" % (m.damage[0], " ".join(repr(float(d)) for d in m.damage[1:]))
    line += " " + text("heat", m.heat) if m.heat else ""
    return line + (" " + text("expansion", [m.expansion]) if m.expansion else "")


ELASTIC = [material(ALU), material(COPPER)]
TAIT = [material(ALU, eos=("tait", 4.0)), material(COPPER, eos=("tait", 7.0))]
PLASTIC = [material(ALU, strength=("plastic", 300e6, 1e9)), material(COPPER, strength=("plastic", 150e6, 0.0))]
FLUID = [material(ALU, strength=("none",)), material(COPPER, strength=("none",))]
SHOCK = [material(ALU, eos=("shock", 5240.0, 1.4, 1.97), strength=("plastic", 300e6, 1e9)),
         material(COPPER, eos=("shock", 3940.0, 1.49, 1.99))]
HOT = [material(ALU, strength=("johnson/cook",) + JC_ALU, heat=(200e3, 900.0, 0.9)),
       material(COPPER, strength=("johnson/cook",) + JC_COPPER,
                heat=([(200.0, 3e5), (400.0, 4e5), (900.0, 2e5)], [(300.0, 383.0), (500.0, 420.0)], 0.8))]
DAMAGED = [material(ALU, strength=("johnson/cook",) + JC_ALU, damage=("johnson/cook", 0.005, 0.01, -1.5, 0.014, 1.12),
                    heat=(0.0, 900.0, 0.9)),
           material(COPPER, strength=("plastic", 150e6, 1e9), damage=("strain", 0.01), heat=(0.0, 383.0, 0.0))]

# c_v must stay above c_p/2
WARM = [material(ALU, strength=("johnson/cook",) + JC_ALU, heat=(200e3, 900.0, 0.9), expansion=4e-5),
        material(COPPER, strength=("johnson/cook",) + JC_COPPER, heat=(3e5, 383.0, 0.8), expansion=3e-5)]
BENT = [material(ALU, heat=(200e3, 900.0, 0.9), expansion=[(200.0, 1e-4), (350.0, 2e-4), (600.0, 3e-4)]),
        material(COPPER, strength=("plastic", 150e6, 1e9), heat=(3e5, 383.0, 0.8))]
HOT_SHOCK = [material(ALU, eos=("shock", 5240.0, 1.4, 1.97), strength=("plastic", 300e6, 1e9), heat=(200e3, 900.0, 0.9)),
             material(COPPER, eos=("shock", 3940.0, 1.49, 1.99), heat=(3e5, 383.0, 0.9))]
HALF_HOT = ("region hot block INF 4e-3 INF INF INF INF units box\ngroup hot region hot\n"
            "fix_modify body temperature hot 700")

# --- cases: name, dimension, kernel, materials, words of pair_style, keywords of Body, more lines -----------

CASES = []


def case(name, dim, kernel, materials, style="", heat=False, more="", meets=None, coeffs="", newton="off", units="si",
         sort=0, speed=100.0, tight=1e-10, fix="", steps=STEPS, **settings):
    CASES.append(dict(name=name, dim=dim, kernel=kernel, materials=materials, style=style, heat=heat, more=more,
                      meets=meets, coeffs=coeffs, newton=newton, units=units, sort=sort, speed=speed, tight=tight,
                      fix=fix, steps=steps, settings=settings))


for dim in (2, 3):
    for k in ("hyperbolic", "cubic", "quintic", "wendland/c2", "wendland/c4"):
        case("elastic %s" % k, dim, k, ELASTIC)
        case("elastic %s, artificial stress" % k, dim, k, ELASTIC, "stabilize artstress", tensile=True)
    case("nothing artificial", dim, "hyperbolic", ELASTIC, "viscosity 0 0 hourglass 0 correction no", viscosity=(0, 0),
         hourglass=0.0, correction=False)
    case("viscosity only, 1.5 2.5", dim, "cubic", ELASTIC, "viscosity 1.5 2.5 hourglass 0 correction no",
         viscosity=(1.5, 2.5), hourglass=0.0, correction=False)
    case("correction only", dim, "hyperbolic", PLASTIC, "viscosity 0 0 hourglass 0", viscosity=(0, 0), hourglass=0.0)
    case("hourglass control, stiffness 0.3", dim, "hyperbolic", PLASTIC, "hourglass 0.3", hourglass=0.3)
    case("hourglass control without correction", dim, "cubic", PLASTIC, "correction no", correction=False)
    case("hourglass control without correction, stiffness 0.05", dim, "hyperbolic", HOT, "hourglass 0.05 correction no",
         heat=True, hourglass=0.05, correction=False)
    case("hourglass control, elastic, stiffness 0.05, stretched", dim, "quintic", ELASTIC, "hourglass 0.05", hourglass=0.05,
         speed=300.0)
    case("artificial stress only, n 6", dim, "cubic", TAIT, "viscosity 0 0 artstress 0.5 6",
         viscosity=(0, 0), artstress=(0.5, 6))
    case("artificial stress per component", dim, "hyperbolic", ELASTIC, "artstress 0.3 6 component",
         artstress=(0.3, 6), component=True)
    case("fluid", dim, "wendland/c2", FLUID)
    case("fluid, artificial stress", dim, "wendland/c2", FLUID, "stabilize artstress", tensile=True, artstress=(0, 4))
    case("form f14, plastic", dim, "cubic", PLASTIC, "form f14", form="f14")
    case("form f14, artificial stress balanced", dim, "cubic", PLASTIC, "form f14 artstress 0.3 4 balanced", form="f14",
         balanced=True)
    case("plastic, sorted every 2 steps", dim, "hyperbolic", PLASTIC, sort=1)
    case("shock equation of state", dim, "wendland/c2", SHOCK, speed=300.0)
    case("bulk viscosity of shocks", dim, "hyperbolic", SHOCK, "shock 0.8", speed=300.0, shock=0.8)
    case("bulk viscosity of shocks, with a linear viscosity and heat", dim, "quintic", HOT, "viscosity 0.1 1 shock 1", heat=True, viscosity=(0.1, 1), shock=1.0)
    case("xsph", dim, "hyperbolic", ELASTIC, "xsph 0.5", xsph=0.5)
    case("balsara", dim, "hyperbolic", PLASTIC, "balsara yes", balsara=True)
    case("artificial stress and correction", dim, "hyperbolic", PLASTIC, "stabilize artstress correction yes", tensile=True,
         correction=True)
    case("artificial stress balanced", dim, "hyperbolic", PLASTIC, "artstress 0.5 4 balanced", artstress=(0.5, 4),
         balanced=True)
    case("balanced, shock", dim, "cubic", SHOCK, "artstress 0.4 3 component balanced correction yes", speed=300.0,
         artstress=(0.4, 3), component=True, balanced=True, correction=True)
    case("smoothing lengths follow", dim, "hyperbolic", PLASTIC, "artstress 0.3 4 balanced", balanced=True,
         artstress=(0.3, 4), follow="psi", more="fix lists all adapt/neigh asph psi every 1")
    case("smoothing lengths follow, hourglass control", dim, "cubic", HOT, follow="psi", heat=True,
         more="fix lists all adapt/neigh asph psi every 1")
    case("smoothing lengths follow the density", dim, "wendland/c2", ELASTIC, follow="density",
         more="fix lists all adapt/neigh asph density every 1")
    case("johnson/cook with heat", dim, "hyperbolic", HOT, heat=True)
    case("johnson/cook with heat, artificial stress", dim, "hyperbolic", HOT, "stabilize artstress", heat=True, tensile=True)
    case("johnson/cook with heat, newton on", dim, "quintic", HOT, heat=True, newton="on",
         more=HALF_HOT)
    case("all at once", dim, "wendland/c4", HOT, "xsph 0.3 balsara yes correction yes hourglass 0.05 artstress 0.4 3",
         heat=True, xsph=0.3, balsara=True, correction=True, hourglass=0.05, artstress=(0.4, 3))
    case("thermal expansion", dim, "hyperbolic", WARM, heat=True, expands=True, compression=True, more=HALF_HOT)
    case("thermal expansion, table", dim, "cubic", BENT, heat=True, expands=True, more=HALF_HOT,
         fix="effects compression-heat off")
    case("shock equation of state with heat", dim, "wendland/c2", HOT_SHOCK, speed=300.0, heat=True, compression=True,
         more=HALF_HOT)
    case("viscosity heats", dim, "hyperbolic", HOT, "viscosity 1 1 hourglass 0", heat=True, viscosity=(1, 1), hourglass=0.0)
    case("artificial terms do not heat", dim, "hyperbolic", HOT, heat=True, dissipation=False,
         fix="effects artificial-heat off")
    case("damage", dim, "hyperbolic", DAMAGED, heat=True, speed=300.0)
    case("damage, artificial stress", dim, "hyperbolic", DAMAGED, "stabilize artstress", heat=True, speed=300.0, tensile=True)
    case("bodies that do not meet", dim, "hyperbolic", PLASTIC, coeffs="pair_coeff 1 2 none", meets={(1, 2): ("none",)})
    case("bodies that share heat", dim, "hyperbolic", HOT, coeffs="pair_coeff 1 2 heat", heat=True,
         meets={(1, 2): ("heat", None)})
    case("bodies in contact", dim, "hyperbolic", PLASTIC, meets={(1, 2): ("contact", 0.3, 0.7, 0.4)},
         coeffs="pair_coeff 1 2 contact friction 0.3 penalty 0.7 damping 0.4")
    case("bodies in contact with friction heat", dim, "hyperbolic", HOT, heat=True,
         meets={(1, 2): ("contact", 0.9, 1.0, 0.2)}, coeffs="pair_coeff 1 2 contact friction 0.9")
case("plane stress, elastic", 2, "hyperbolic", ELASTIC, "plane stress", plane_stress=True)
case("plane stress, thermal expansion", 2, "cubic", WARM, "plane stress", plane_stress=True, heat=True, expands=True,
     compression=True)
case("plane stress, damage", 2, "hyperbolic", DAMAGED, "plane stress", plane_stress=True, heat=True, speed=300.0)
case("plane stress, plastic", 2, "cubic", PLASTIC, "plane stress", plane_stress=True)
for units in UNITS:
    if units != "si":
        case("johnson/cook with heat, units " + units, 3, "hyperbolic", HOT, heat=True, units=units, tight=2e-7)
        case("shock equation of state, units " + units, 2, "hyperbolic", SHOCK, speed=300.0, units=units, tight=2e-7)
for dim in (2, 3):
    case("metal that flows far is shifted", dim, "hyperbolic", PLASTIC, speed=1500.0, steps=8)


def attributes(c):
    plastic = any(m.yields() for m in c["materials"])
    names = ["density"] + ["stress/" + k for k in ("xx", "yy", "zz", "xy")]
    names += ["stress/xz", "stress/yz"] if c["dim"] == 3 else []
    names += ["pstrain", "pstrain/rate", "vonmises"] if plastic else []
    names += ["temperature"] if c["heat"] else []
    names += ["energy"] if any(m.eos[0] == "shock" for m in c["materials"]) else []
    names += ["damage", "failed"] if any(m.damage for m in c["materials"]) else []
    names += ["thickness"] if c["settings"].get("plane_stress") else []
    names += ["h"] if c["settings"].get("follow") else []
    return names


def start(dim, dx, speed, seed):
    """A perturbed lattice, periodic in x, free elsewhere."""
    rng = np.random.default_rng(seed)
    shape = (10, 7, 1) if dim == 2 else (8, 4, 4)
    x = np.stack(np.meshgrid(*[np.arange(n) + 0.5 for n in shape], indexing="ij"), -1).reshape(-1, 3) * dx
    mask = [1, 1, dim == 3]
    x += 0.12 * dx * rng.uniform(-1, 1, x.shape) * mask
    if dim == 2:
        x[:, 2] = 0
    v = speed * rng.uniform(-1, 1, x.shape) * mask
    v += 3 * speed * np.stack([np.sin(2 * np.pi * x[:, 0] / (shape[0] * dx)), -x[:, 0] / (shape[0] * dx), 0 * x[:, 0]],
                              -1)
    kind = np.where(x[:, 1] < 0.5 * shape[1] * dx, 1, 2)
    return x, v, kind, shape


def data_file(x, v, kind, lo, hi):
    lines = ["SPH-TM reference", "", "%d atoms" % len(x), "2 atom types", ""]
    lines += ["%r %r %slo %shi" % (float(lo[k]), float(hi[k]), "xyz"[k], "xyz"[k]) for k in range(3)]
    lines += ["", "Atoms # atomic", ""] + ["%d %d %r %r %r" % ((i + 1, kind[i]) + tuple(map(float, x[i])))
                                           for i in range(len(x))]
    lines += ["", "Velocities", ""] + ["%d %r %r %r" % ((i + 1,) + tuple(map(float, v[i]))) for i in range(len(x))]
    return "\n".join(lines) + "\n"


class Case:
    """One case: its input for lmp, and the same for the reference."""

    def __init__(self, number, c):
        self.c, self.number = c, number
        dim, dx = c["dim"], 1e-3
        x, v, kind, shape = start(dim, dx, c["speed"], 7 + number)
        if "contact" in c["name"]:
            x[kind == 2, 1] -= 0.15 * dx
        ratio, T, self.dt = 1.2, 310.0, 2e-8
        lo, hi = np.array([0, -5 * dx, -5 * dx]), np.array([shape[0], shape[1] + 5, shape[2] + 5]) * dx
        if dim == 2:
            lo[2], hi[2] = -0.5 * dx, 0.5 * dx
        self.period = shape[0] * dx
        assert self.period > 2 * REACH.get(c["kernel"], 2.0) * ratio * dx
        self.names = attributes(c)
        mass, length, time, energy, force, pressure, density = UNITS[c["units"]]
        # 2D: a plate one unit thick
        self.unit = {"x": length, "v": length / time, "f": force if dim == 3 else force / length,
                     "density": density, "energy": energy / mass,
                     "pstrain/rate": 1 / time, "vonmises": pressure}
        self.unit.update(("stress/" + k, pressure) for k in ("xx", "yy", "zz", "xy", "xz", "yz"))
        coeffs = "\n".join("pair_coeff %d %d %s" % (i + 1, i + 1, words(m, c["units"]))
                           for i, m in enumerate(c["materials"]))
        self.script = SCRIPT.format(
            number=number, units=c["units"], dim=dim, bz="p" if dim == 2 else "f", newton=c["newton"],
            kernel=c["kernel"], ratio=ratio, dx=dx / length, style=c["style"], coeffs=coeffs + "\n" + c["coeffs"], T=T,
            dt=self.dt / time, more=c["more"], fix=c["fix"], attributes=" ".join(self.names), steps=c["steps"],
            sort="2 %g" % (2 * dx) if c["sort"] else "0 0")
        self.data = data_file(x / length, v / length * time, kind, lo / length, hi / length)
        self.body = Body(dim, x, v, kind, {i + 1: m for i, m in enumerate(c["materials"])}, [self.period, 0, 0],
                         c["kernel"], ratio * dx, dx, temperature=T, heat=c["heat"], meets=c["meets"], **c["settings"])
        if "700" in c["more"]:
            self.body.T[x[:, 0] <= 4e-3] = self.body.unstrained[x[:, 0] <= 4e-3] = 700.0

    def compare(self, frames):
        """The largest deviation of every quantity, over all steps."""
        body, worst = self.body, {}

        def hold(name, mine, theirs, scale=None):
            scale = scale or np.abs(theirs).max() or 1.0
            worst[name] = max(worst.get(name, 0.0), float(np.abs(mine - theirs).max() / scale))

        assert [f["step"] for f in frames] == list(range(self.c["steps"] + 1))
        for f in frames:
            body.step(self.dt) if f["step"] else body.seed(self.dt)
            d = self.unit["x"] * np.stack([f["x"], f["y"], f["z"]], 1) - body.x
            d[:, 0] -= self.period * np.round(d[:, 0] / self.period)
            hold("x", d, 0 * d, body.spacing)
            hold("v", self.unit["v"] * np.stack([f["vx"], f["vy"], f["vz"]], 1), body.v)
            hold("f", self.unit["f"] * np.stack([f["fx"], f["fy"], f["fz"]], 1), body.out["acc"] * body.m[:, None])
            for j, name in enumerate(self.names):
                ref = body.value(name)
                scale = 1e6 if "stress" in name and np.abs(ref).max() < 1e6 else None
                hold(name, f["c_p[%d]" % (j + 1)] * self.unit.get(name, 1.0), ref, scale)
        return worst


def compare(checks, wanted, where="", ranks=1, isa=None):
    cases = []
    for number, c in enumerate(CASES):
        c["title"] = "%dD %s%s" % (c["dim"], c["name"], where)
        if not wanted or any(w in c["title"] for w in wanted):
            cases.append(Case(number, c))
    if isa:
        os.environ["SPHTM_ISA"] = isa
    result = run("clear\n".join(c.script for c in cases), files={"data.%d" % c.number: c.data for c in cases},
                 ranks=ranks)
    if isa:
        checks.true("rate loops: " + isa, "rate loops: " + isa in result.output)
        del os.environ["SPHTM_ISA"]
    limit = {"pstrain/rate": 1e-8, "damage": 1e-9}
    for c in cases:
        title, body = c.c["title"], c.body
        worst = c.compare(result.dump("out.%d" % c.number))
        name = max(worst, key=lambda k: worst[k] / limit.get(k, 1e-10))
        checks.below("%s: %s" % (title, name), worst[name], max(limit.get(name, 0.0), c.c["tight"]))
        # a case whose effect did nothing would prove nothing
        if "pstrain" in worst:
            checks.above(title + ": it yields", body.eps.max(), 1e-4)
        if "shifted" in title:
            checks.above(title + ": particles", len(body.shifted), 10)
            checks.above(title + ": of them drawn", sum(eps < 0.2 for eps in body.shifted), 2)
        if "contact" in title:
            checks.above(title + ": contacts", body.contacts, 10)
        if "damage" in worst:
            checks.above(title + ": particles fail", body.failed.sum(), 1)


checks = Checks()
compare(checks, sys.argv[1:])
if not sys.argv[1:]:
    some = ["newton on", "all at once", "sorted"]
    compare(checks, some, ", any processor", isa="default")
    compare(checks, some, ", two ranks", ranks=2)
checks.end()
