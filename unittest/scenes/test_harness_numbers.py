"""The reference numbers of the harness (unittest/harness/yaml) come from the plugin; here they are held against the
equations in numpy: forces at the start for every pair yaml, positions and velocities after eight steps for a fix."""
import glob
import os
import re

import numpy as np
from sph_material import Material
from sph_reference import Body
from sphtm_scene import SOURCE, Checks

YAML = os.path.join(SOURCE, "unittest", "harness", "yaml")


def read_yaml(path):
    """The harness's flat yaml: key -> text of the value or of the indented block."""
    out, key = {}, None
    with open(path) as f:
        for line in f:
            found = re.match(r"(\w+): *(.*)", line)
            if found:
                key = found.group(1)
                out[key] = "" if found.group(2).startswith("!") else found.group(2)
            elif key and line.startswith("  "):
                out[key] += line
    return out


def table(text):
    return np.array([[float(w) for w in line.split()[1:]] for line in text.strip().splitlines()])


def read_data(path):
    with open(path) as f:
        lines = f.read().splitlines()
    lo_hi = [[float(w) for w in line.split()[:2]] for line in lines if line.endswith("hi")]
    first, second = lines.index("Atoms # atomic") + 2, lines.index("Velocities") + 2
    atoms = np.array([[float(w) for w in line.split()] for line in lines[first:second - 3]])
    v = np.array([[float(w) for w in line.split()[1:]] for line in lines[second:] if line.strip()])
    return atoms[:, 2:], v, atoms[:, 1].astype(int), lo_hi[0][1] - lo_hi[0][0]


def material(words):
    """density ... elastic ... eos ... strength ... heat ... of a pair_coeff line."""
    w, at, m = words, 0, {"eos": ("linear",), "strength": ("elastic",), "heat": None}
    counts = {"linear": 0, "tait": 1, "shock": 3, "elastic": 0, "none": 0, "plastic": 2, "johnson/cook": 8}
    while at < len(w):
        if w[at] == "density":
            m["density"], at = float(w[at + 1]), at + 2
        elif w[at] == "elastic":
            m["elastic"], at = (float(w[at + 1]), float(w[at + 2])), at + 3
        elif w[at] in ("eos", "strength"):
            n = counts[w[at + 1]]
            m[w[at]] = (w[at + 1],) + tuple(float(x) for x in w[at + 2:at + 2 + n])
            at += 2 + n
        else:
            assert w[at] == "heat", w[at:]
            values, at = [], at + 1
            while len(values) < 3:
                if w[at].startswith("table/"):
                    n = int(w[at][6:])
                    values.append([(float(w[at + 1 + 2 * k]), float(w[at + 2 + 2 * k])) for k in range(n)])
                    at += 1 + 2 * n
                else:
                    values.append(float(w[at]))
                    at += 1
            m["heat"] = tuple(values)
    return Material(m["density"], *m["elastic"], eos=m["eos"], strength=m["strength"], heat=m["heat"])


def body_of(commands, block, T, **settings):
    """From the lines pair_style and pair_coeff, and the words of fix sph/tm."""
    style = next(c.split()[2:] for c in commands if c.startswith("pair_style"))
    coeffs = [c.split()[1:] for c in commands if c.startswith("pair_coeff")]
    mats = {int(c[0]): material(c[2:]) for c in coeffs if c[0] == c[1]}
    x, v, kind, period = read_data(os.path.join(YAML, "data." + block))
    spacing = float(style[3])
    k = 4
    while k < len(style):
        if style[k] in ("xsph",):
            settings["xsph"], k = float(style[k + 1]), k + 2
        elif style[k] in ("balsara", "correction"):
            settings[style[k]], k = style[k + 1] == "yes", k + 2
        elif style[k] == "form":
            settings["form"], k = style[k + 1], k + 2
        elif style[k] == "plane":
            settings["plane_stress"], k = style[k + 1] == "stress", k + 2
        else:
            assert style[k] == "artstress", style[k:]
            settings.update(artstress=(float(style[k + 1]), int(style[k + 2])))
            k += 3
            while k < len(style) and style[k] in ("component", "balanced"):
                settings[style[k]], k = True, k + 1
    return Body(2 if block == "plate" else 3, x, v, kind, mats, [period, 0, 0], style[0], float(style[1]) * spacing,
                spacing, temperature=T, heat=any(m.heat for m in mats.values()), **settings)


checks = Checks()
for path in sorted(glob.glob(os.path.join(YAML, "pair-*.yaml"))):
    y = read_yaml(path)
    commands = ["pair_style " + y["pair_style"]] + ["pair_coeff " + c.strip()
                                                    for c in y["pair_coeff"].strip().splitlines()]
    T = re.search(r"temperature (\S+)", y["post_commands"])
    body = body_of(commands, "plate" if "plate" in y["pre_commands"] else "block", float(T.group(1)) if T else 293.15,
                   follow="still" if "smoothing on" in y["post_commands"] else None)
    f = body.rates()["acc"] * body.m[:, None]
    ref = table(y["init_forces"])
    checks.below(os.path.basename(path) + ": forces at the start", np.abs(f - ref).max() / np.abs(ref).max(), 1e-12)

for name in ("fix-sph_tm-2d.yaml", "fix-adapt_neigh-asph-2d.yaml"):
    y = read_yaml(os.path.join(YAML, name))
    commands = [c.strip() for c in y["post_commands"].strip().splitlines()]
    words = next(c for c in commands if " sph/tm " in c and c.startswith("fix")).split()
    asph = dict(follow="psi", every=2) if "asph" in name else {}
    T = float(words[words.index("temperature") + 1]) if "temperature" in words else 293.15
    body = body_of(commands, "plate", T, **asph)
    body.seed()    # the first prediction knows the forces of the pair style alone
    load = [c.split()[4:7] for c in commands if "addforce" in c]
    body.load = [float(w) for w in load[0]] if load else (0.0, 0.0, 0.0)
    for _ in range(8):
        body.step(float(words[words.index("dt") + 1]))
    x, v = table(y["run_pos"]), table(y["run_vel"])
    d = x - body.x
    d[:, 0] -= body.box[0] * np.round(d[:, 0] / body.box[0])
    checks.below(name + ": positions after 8 steps, in spacings", np.abs(d).max() / body.spacing, 1e-11)
    checks.below(name + ": velocities after 8 steps", np.abs(v - body.v).max() / np.abs(v).max(), 1e-11)
    if asph:
        low, high = (float(w) for w in y["global_vector"].split()[-3:-1])
        checks.near(name + ": smallest h", low, body.own_h.min(), relative=1e-11)
        checks.near(name + ": largest h", high, body.own_h.max(), relative=1e-11)
        checks.above(name + ": h has followed", body.own_h.max() / body.own_h.min(), 1.001)
    else:
        checks.near(name + ": kinetic energy", float(y["global_vector"].split()[1]),
                    np.sum(0.5 * body.m[:, None] * body.v ** 2), relative=1e-10)
checks.end()
