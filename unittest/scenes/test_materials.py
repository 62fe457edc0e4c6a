"""Material cards.

 - every card of materials/materials.sphtm, read here apart from the plugin, says what the literature says: the flow
   stress at some points, or the constants themselves;
 - a run with a card is, bit for bit, the run with its constants in the script, and each constant arrives: with 'set' it
   gives the run with that constant in the script, and another one than before;
 - malformed cards stop with file, line and word; cut and damaged files stop or load, and never crash."""
import os
import random
from concurrent.futures import ThreadPoolExecutor

import numpy as np
from sphtm_scene import SOURCE, Checks, lattice_block, run

CARDS = os.path.join(SOURCE, "materials", "materials.sphtm")
NAMES = {"density": ["density"], "elastic": ["young", "poisson"],
         "heat": ["conductivity", "capacity", "taylor_quinney"],
         "strength johnson/cook": ["jc_a", "jc_b", "jc_n", "jc_c", "jc_m", "t_ref", "t_melt", "jc_rate0"],
         "strength zerilli/armstrong": ["za_c0", "za_c1", "za_c2", "za_c3", "za_c4", "za_c5", "za_n", "za_rate0", "t_melt"],
         "strength plastic": ["yield", "hardening"], "strength elastic": [], "eos linear": [],
         "eos shock": ["eos_c0", "eos_s", "eos_gamma"], "emissivity": ["emissivity"], "expansion": ["expansion"]}

# flow stress (MPa) at plastic strain, rate and temperature above Tref, worked out apart
POINTS = ((0.1, 1.0, 0.0), (0.5, 1e3, 0.0), (0.5, 1e3, 300.0), (1.0, 1e5, 500.0))
FLOW = {"c45e": (903.634, 1162.428, 920.230, 869.397), "ofhc-copper": (233.015, 381.758, 285.117, 274.625),
        "4340": (1072.266, 1335.676, 1080.255, 1022.564)}
VALUES = {
    "al6082-t6": {"density": 2690, "young": 68.9e9, "poisson": 0.33, "jc_a": 428e6, "jc_b": 327e6, "jc_n": 1.008,
                  "jc_c": 0.00747, "jc_m": 1.31, "t_ref": 293, "t_melt": 855, "conductivity": 200, "capacity": 900,
                  "expansion": 2.34e-5},
    "c45e": {"density": 7870, "young": 205e9, "poisson": 0.29, "t_ref": 293.15, "t_melt": 1733, "conductivity": 50.7,
             "capacity": 486, "expansion": 1.15e-5},
    "ofhc-copper": {"density": 8960, "t_ref": 298, "t_melt": 1356, "capacity": 383, "eos_c0": 3940, "eos_s": 1.489,
                    "eos_gamma": 2.02},
    "4340": {"density": 7830, "t_ref": 298, "t_melt": 1793, "capacity": 477, "eos_c0": 4578, "eos_s": 1.33,
             "eos_gamma": 1.67},
    "ti6al4v": {"density": 4430, "young": 110e9, "poisson": 0.35, "jc_a": 852.1e6, "jc_b": 338.9e6, "jc_n": 0.148,
                "jc_c": 0.02754, "jc_m": 0.5961, "t_ref": 300, "t_melt": 1836, "conductivity": 6.8, "capacity": 526,
                "taylor_quinney": 0.9, "expansion": 8.6e-6},
    "ti6al4v-ducobu": {"density": 4430, "young": 113.8e9, "poisson": 0.34, "jc_a": 997.9e6, "jc_b": 653.1e6, "jc_n": 0.45,
                       "jc_c": 0.0198, "jc_m": 0.7, "jc_rate0": 1, "t_ref": 293, "t_melt": 1873, "conductivity": 6.3,
                       "capacity": 531, "taylor_quinney": 0.9, "expansion": 8.6e-6},
    "ofhc-copper-za": {"density": 8960, "za_c0": 65e6, "za_c1": 0, "za_c2": 890e6, "za_c3": 0.0028, "za_c4": 0.000115,
                       "za_c5": 0, "za_rate0": 1, "t_melt": 1356, "capacity": 383},
    "armco-iron-za": {"density": 7890, "za_c0": 65e6, "za_c1": 1033e6, "za_c2": 0, "za_c3": 0.00698, "za_c4": 0.000415,
                      "za_c5": 266e6, "za_n": 0.289, "za_rate0": 1, "t_melt": 1811, "capacity": 452},
    "rubber": {"density": 1200, "young": 1e7, "poisson": 0.3975},
    "steel-f14": {"density": 7850, "young": 210e9, "poisson": 0.3, "yield": 350e6, "hardening": 0},
    "al6061-t6": {"density": 2700, "young": 68.9e9, "poisson": 0.33, "yield": 276e6, "eos_c0": 5240, "eos_s": 1.4,
                  "eos_gamma": 1.97}}

# --- a run in which every constant matters ------------------------------------------------------------------

SCENE = "clear\n" + lattice_block("0 8e-3 0 8e-3", "-5e-3 13e-3 -5e-3 13e-3") + """
region hot block 4e-3 INF INF INF INF INF units box
group hot region hot
pair_style sph/tm hyperbolic 1.2 spacing 1e-3
pair_coeff 1 1 {material}
velocity all create 1 12345 dist uniform loop geom
velocity all scale {scale}
fix body all sph/tm temperature 310
{heat}
compute p all sph/tm/atom pstrain vonmises pressure temperature
dump d all custom 12 out.{number} id x y vx vy c_p[*]
dump_modify d format float %.17g
run 12
"""


def read_cards():
    """name -> list of (keyword with option, values)."""
    cards, name = {}, None
    with open(CARDS) as f:
        for line in f:
            words = line.split("#")[0].split()
            if not words:
                continue
            if words[0] == "material":
                name = words[1]
                cards[name] = []
            elif words[0] != "end":
                key = " ".join(words[:2]) if words[0] in ("strength", "eos") else words[0]
                cards[name].append((key, words[len(key.split()):]))
    return cards


def inline(card, changes={}):
    out = []
    for key, values in card:
        out += [key] + [changes.get(c, v) for c, v in zip(NAMES[key], values)]
    return " ".join(out)


def arrive(checks, cards):
    """All runs of all cards in one process."""
    scenes, due = [], []

    def scene(material, rho, young, heat):
        # speeds of 0.02 sqrt(E/rho), about 100 m/s in metal; LAMMPS scales them by a temperature of its own
        speed = 0.02 * np.sqrt(young / rho)
        scenes.append(SCENE.format(material=material, number=len(scenes), scale=rho * 1e-6 * speed ** 2 / 1.380649e-23,
                                   heat="fix_modify body temperature hot 450" if heat else ""))
        return len(scenes) - 1

    for name, card in cards.items():
        constants = {c: v for key, values in card for c, v in zip(NAMES[key], values)}
        like = float(constants["density"]), float(constants["young"]), "capacity" in constants
        base = scene("materials.sphtm " + name, *like)
        due.append((name + ": card is inline", base, scene(inline(card), *like), True))
        for c, v in constants.items():
            changed = repr(float(v) * 1.01 or 1e9)    # of a perfectly plastic card the hardening is 0
            this = scene("materials.sphtm %s set %s %s" % (name, c, changed), *like)
            due.append(("%s: set %s is inline" % (name, c), this, scene(inline(card, {c: changed}), *like), True))
            # of Zerilli and Armstrong: melting, which nothing here does, and the exponent of a term that is 0
            silent = "za_c0" in constants and (c == "t_melt" or c == "za_n" and float(constants["za_c5"]) == 0)
            due.append(("%s: %s matters" % (name, c), this, base, silent))
    result = run("".join(scenes))
    state = []
    for k in range(len(scenes)):
        f = result.dump("out.%d" % k)[-1]
        state.append(np.concatenate([f[c] for c in f if c not in ("step", "box", "id")]))
    wrong = [name for name, a, b, same in due if np.array_equal(state[a], state[b]) != same]
    checks.true("%d comparisons of %d runs" % (len(due), len(scenes)), not wrong, "; ".join(wrong))
    checks.true("all values are finite", np.isfinite(np.concatenate(state)).all())


def literature(checks, cards):
    checks.true("the cards are those expected", sorted(cards) == sorted(VALUES), ", ".join(cards))
    for name, card in cards.items():
        have = {c: float(v) for key, values in card for c, v in zip(NAMES[key], values)}
        off = ["%s %g, not %g" % (c, have[c], v) for c, v in VALUES[name].items() if have[c] != v]
        checks.true(name + ": constants", not off, "; ".join(off))
        for (eps, rate, above), due in zip(POINTS, FLOW.get(name, ())):
            hot = above / (have["t_melt"] - have["t_ref"])
            flow = (have["jc_a"] + have["jc_b"] * eps ** have["jc_n"]) * (1 + have["jc_c"] * np.log(
                rate / have["jc_rate0"])) * (1 - hot ** have["jc_m"])
            checks.near("%s: flow stress at %g, %g/s, Tref + %g K, MPa" % (name, eps, rate, above), flow / 1e6, due,
                        absolute=6e-4)


# --- malformed cards ----------------------------------------------------------------------------------------

CARD = """# a card
material one
  density 2700
  elastic 70e9 0.33     # Pa
  strength johnson/cook 428e6 327e6 1.008 0.01 &
           1.31 293 855 1.0
  heat table/2 200 100 400 150 900 0.9
end
material two
  density 1000
  elastic 1e7 0.3
end
"""
LOAD = SCENE[:SCENE.index("velocity all create")].replace("clear\n", "")
MALFORMED = [    # what, text, what its place is taken by, fragments of the message
    ("no material line", "material one\n", "", ["line 2", "material <name>", "density"]),
    ("material without a name", "material one", "material", ["line 2", "material <name>"]),
    ("material with two names", "material one", "material one more", ["line 2", "material <name>"]),
    ("two of one name", "material two", "material one", ["line 9", "second", "one"]),
    ("material within a material", "end\nmaterial two", "material two", ["line 8", "end", "one"]),
    ("text between materials", "end\nmaterial two", "end\nhello\nmaterial two", ["line 9", "hello"]),
    ("words after end", "end\nmaterial", "end of one\nmaterial", ["line 8", "end", "of"]),
    ("end in capitals", "end\nmaterial", "END\nmaterial", ["line 9", "one"]),
    ("misspelt keyword", "density", "desnity", ["line 3", "desnity", "known are"]),
    ("keyword twice", "heat table", "density 2700\n heat table", ["line 7", "density", "twice"]),
    ("number missing", "70e9 0.33", "70e9", ["line 4", "elastic value 2 of 2", "poisson", "missing"]),
    ("number too many", "2700", "2700 1", ["line 3", "density", "1 values", "one more"]),
    ("word for a number", "70e9", "70GPa", ["line 4", "young", "70GPa", "number"]),
    ("comma for a point", "0.33", "0,33", ["line 4", "poisson", "0,33"]),
    ("nan", "2700", "nan", ["line 3", "density", "nan"]),
    ("infinite", "70e9", "1e999", ["line 4", "young", "1e999"]),
    ("negative density", "2700", "-2700", ["line 3", "density", "-2700", "> 0"]),
    ("nought for E", "70e9", "0", ["line 4", "young", "> 0"]),
    ("Poisson's ratio 0.5", "0.33 ", "0.5 ", ["line 4", "poisson", "0.5", "below 0.5"]),
    ("unknown strength", "johnson/cook", "johnson-cook", ["line 5", "strength", "johnson-cook", "johnson/cook"]),
    ("continued number missing", "855 1.0", "855", ["line 5", "jc_rate0", "missing"]),
    ("continuation lost", " &\n", "\n", ["line 5", "jc_m", "missing"]),
    ("melts below Tref", "293 855", "855 293", ["one of", "t_melt", "855"]),
    ("table of none", "table/2", "table/0", ["line 7", "conductivity", "table/0", "1 to 16"]),
    ("table of too many", "table/2", "table/17", ["line 7", "conductivity", "table/17"]),
    ("table of x", "table/2", "table/x", ["line 7", "table/x"]),
    ("table that goes down", "200 100 400", "400 100 200", ["line 7", "increasing", "200", "400"]),
    ("table that is short", "200 100 400 150", "200 100 400", ["line 7", "taylor_quinney", "missing"]),
    ("chi above 1", "0.9\nend", "9\nend", ["line 7", "taylor_quinney", "9", "0 to 1"]),
    ("set in a card", "  heat", "  set jc_c 0\n  heat", ["line 7", "set", "input script"]),
    ("no density", "  density 2700\n", "", ["one of", "missing", "density"]),
    ("no elastic", "  elastic 70e9 0.33", "#", ["one of", "missing", "elastic"]),
    ("no end at all", "end\n", "", ["line", "end", "one"]),
    ("binary", CARD, "\x01\x02\x7f\x03 \x05\n", ["line 1", "material <name>"]),
    ("a lone &", CARD, "&", ["no material 'one'", "it has none"]),
    ("a lone & after the cards", CARD, CARD.replace("one", "three") + "&\n", ["no material 'one'", "three, two"]),
    ("a mesh", CARD, "solid tool\nfacet normal 0 0 1\n", ["line 1", "solid"]),
]


def malformed(checks):
    def attempt(case):
        old, new = case[1:3]
        assert old in CARD, old
        return run(LOAD.format(material="cards.sphtm one"), files={"cards.sphtm": CARD.replace(old, new, 1)},
                   expect_error=True)

    with ThreadPoolExecutor(2) as pool:
        for case, result in zip(MALFORMED, pool.map(attempt, MALFORMED)):
            said = result.errors()
            missing = [f for f in case[3] + ["cards.sphtm"] if f not in said]
            checks.true("malformed: " + case[0], result.status == 1 and not missing,
                        "not said: %s <- %s" % (missing, said[:300] or "status %d" % result.status) if missing else "")
    fine = run(LOAD.format(material="cards.sphtm one"), files={"cards.sphtm": CARD.replace("\n", "\r\n")})
    checks.true("line ends of Windows", fine.status == 0)


def damaged(checks, count=40):
    """The cards, cut or with bytes changed: loaded, or refused with a message that names the file."""
    random.seed(1)
    with open(CARDS) as f:
        text = f.read()
    texts = []
    for k in range(count):
        if k % 2:
            texts.append(text[:random.randrange(len(text))])
        else:
            broken = list(text)
            for _ in range(20):
                broken[random.randrange(len(text))] = chr(random.randrange(1, 127))
            texts.append("".join(broken))

    def attempt(t):
        return run(LOAD.format(material="cards.sphtm ti6al4v"), files={"cards.sphtm": t}, expect_error=True)

    with ThreadPoolExecutor(2) as pool:
        results = list(pool.map(attempt, texts))
    bad = [r for r in results if not (r.status == 0 or r.status == 1 and "cards.sphtm" in r.errors())]
    checks.true("damaged files: %d loaded, %d refused" % (sum(r.status == 0 for r in results),
                sum(r.status == 1 for r in results)), not bad, bad[0].output[-300:] if bad else "")


if __name__ == "__main__":
    checks = Checks()
    cards = read_cards()
    literature(checks, cards)
    arrive(checks, cards)
    malformed(checks)
    damaged(checks)
    checks.end()
