"""Taylor bars: copper bars that hit a rigid wall.

linear_227: linear hardening; fe_190: Johnson and Cook's OFHC copper; both against the limit of finite elements that are refined
(examples/taylor_bar/finite_elements.py, since 2026-11-25; in print 21.4 and 7.11 to 7.22, 17.40 and 7.28 mm, of coarser meshes). All others are shots, whose scatter is not given: Johnson and Cook 1983, Wilkins and Guinan 1973, Gust 1982, House et
al. 1995, as collected in tables by B. Banerjee (HighRateExptData, plotOFHCCu.m), the shot of 225 m/s as collected by Zelepugin et al. 2023;
where two shots of one set-up differ, that is the scatter: 200 m/s over 188 and 189 m/s of House, 0.643 and 0.631 of the length for 210 m/s in
the two collections. 'foot' is its largest diameter there. The one of 718 K is of electrolytic tough pitch copper.

What was chosen, before the first run of this command: no friction on the wall; the constants of Johnson and Cook 1983 (card ofhc-copper) with
a linear equation of state, heat of plastic work and conduction, no damage; the defaults of the pair style; ends of 75 to 120 us, longer for
longer bars, after which nothing moves but elastically. Variants: the shock equation of state of the card, Zerilli and Armstrong's law, friction
0.3 at the foot, yield and hardening 10 % up and down."""
import case

EXAMPLE = case.example("taylor_bar")
SHOTS = case.example("taylor_bar", "shots")

TITLE = "Taylor bars of copper"
REFERENCE = "measured: Johnson and Cook, Wilkins and Guinan, Gust, House; finite elements"
SCRIPT = case.script_of("taylor_bar")
BASE = {"rings": 6}
COMPARED = {"length": ("mm", 0.03), "radius of the foot": ("mm", 0.03)}
OFHC = "materials.sphtm ofhc-copper"
# row: radius, length (mm), density, speed, temperature, end (us); length, radius of the foot (mm)
BARS = {"linear_227": (3.2, 32.4, 8930, 227, 298, 81, 21.48, 7.36), "fe_190": (3.81, 25.4, 8960, 190, 298, 75, 17.36, 7.40),
        "johnson_cook_130": (3.81, 25.4, 8960, 130, 298, 75, 19.558, 4.955), "johnson_cook_146": (3.81, 25.4, 8960, 146, 298, 75, 18.694, 5.335),
        "johnson_cook_190": (3.81, 25.4, 8960, 190, 298, 75, 16.205, 6.78),
        "wilkins_guinan_123": (3.81, 23.47, 8960, 123, 298, 75, 19.60, None), "wilkins_guinan_183": (3.81, 23.47, 8960, 183, 298, 75, 16.80, None),
        "wilkins_guinan_210": (3.81, 23.47, 8960, 210, 298, 75, 14.80, 8.40), "zelepugin_225": (3.9, 34.5, 8960, 225, 298, 100, 22.25, 8.02),
        "house_215": (3.7975, 15.19, 8960, 215, 294, 60, 10.8, 7.0), "house_200": (3.7975, 22.785, 8960, 200, 294, 75, 16.9, 7.1),
        "house_182": (3.7975, 37.975, 8960, 182, 294, 110, 28.1, 6.6), "gust_138": (3.0, 30.0, 8909, 138, 295, 90, 21.90, None),
        "gust_213": (3.0, 30.0, 8929, 213, 295, 90, 18.00, None), "gust_733_K": (3.0, 30.0, 8910, 185, 733, 120, 17.22, None),
        "gust_718_K": (3.0, 30.0, 8930, 188, 718, 120, 16.65, 5.45), "gust_1235_K": (3.0, 30.0, 8927, 157, 1235, 160, 12.75, None)}
FINITE = ("linear_227", "fe_190")


def title(row):
    r, l, _, speed, T = BARS[row][:5]
    who = {"linear_227": "finite elements, linear hardening", "fe_190": "finite elements, OFHC"}.get(row, " and ".join(
        w.capitalize() for w in row.split("_") if not w.isdigit() and w != "K"))
    return "%s: %g x %.3g mm, %d m/s%s" % (who, l, 2 * r, speed, ", %d K" % T if T > 300 else "")


def reference(row):
    length, radius = BARS[row][6:]
    return dict({"length": (length, 0.0)}, **({"radius of the foot": (radius, {"linear_227": 0.01, "fe_190": 0.02}.get(row, 0.0))} if radius else {}))


ROWS = {row: {"variables": {"bar": row}, "title": title(row), "reference": reference(row)} for row in BARS}
SETTINGS = {"rings_4": {"rings": 4}, "rings_6": {}, "rings_9": {"rings": 9},
            "shock": {"material": OFHC}, "zerilli_armstrong": {"material": OFHC + "-za"}, "friction": {"foot": "friction 0.3"},
            "stronger": {"material": OFHC + " set jc_a 99e6 set jc_b 321e6"}, "weaker": {"material": OFHC + " set jc_a 81e6 set jc_b 263e6"},
            "artstress": {"options": "stabilize artstress"}}
SAID = {"rings_4": "4 rings", "rings_6": "6 rings", "rings_9": "9 rings", "shock": "6 rings, shock equation of state and expansion with it",
        "zerilli_armstrong": "6 rings, law of Zerilli and Armstrong", "friction": "6 rings, friction 0.3 at the wall",
        "stronger": "6 rings, shock equation of state, A and B 10 % up", "weaker": "6 rings, shock equation of state, A and B 10 % down",
        "artstress": "6 rings, *stabilize artstress*"}
MESH, QUICK = ("rings_4", "rings_6", "rings_9"), "rings_4"
SPACING = {"rings_4": 1 / 4.5, "rings_6": 1 / 6.5, "rings_9": 1 / 9.5}


def only(setting):
    """Nine rings and variants of the numerics for some bars of which the radius is known; other materials for all of OFHC."""
    if setting in ("rings_9", "friction", "artstress"):
        return ["linear_227", "johnson_cook_190", "wilkins_guinan_210", "house_215", "gust_718_K"]
    return [row for row in ROWS if row != "linear_227" or "material" not in SETTINGS[setting]]


def cost(variables):
    r, l = BARS[variables["bar"]][:2]
    return float(variables["rings"]) ** 4 * l / r


def bar_of(variables):
    r, l, rho = BARS[variables["bar"]][:3]
    return SHOTS.files_of(1e-3 * r, 1e-3 * l, rho, int(variables["rings"]))


def prepare(folder, variables):
    files, dx = bar_of(variables)
    files(folder)
    _, _, _, speed, T, end = BARS[variables["bar"]][:6]
    more = {} if variables["bar"] == "linear_227" else {"material": SHOTS.OFHC}
    more.update({k: v for k, v in variables.items() if k not in ("bar", "rings")})
    return dict(more, dx="%.9g" % dx, speed=speed, T=T, end="%g" % (1e-6 * end))


def measure(result, variables):
    length, radius, least, largest = (1e3 * float(v) for v in EXAMPLE.shape(result.dump("end.dump")[-1], bar_of(variables)[1]))
    t = result.thermo[-1]
    return {"length": case.exact(length), "radius of the foot": (radius, (largest - least) / 12),
            "drift of the energy sum": case.exact(abs(t["f_body[9]"] - t["f_body[9]"][0]).max() / t["f_body[1]"][0]),
            "artificial share": case.exact(t["f_body[7]"][-1] / t["f_body[1]"][0])}
