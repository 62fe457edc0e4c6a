"""Orthogonal cuts of Ti6Al4V, in plane strain.

Measured by Ducobu et al. 2024 (Int. J. Adv. Manuf. Technol., doi 10.1007/s00170-024-12956-7): dry, carbide, rake 15, clearance 2
degrees, edge radius 20 um, width 1 mm, length 10 mm, three repeats; forces read off its vector figures, scatter of two standard
deviations. Friction coefficient and the part of the friction heat that goes into the work by speed, as given there.

What was chosen, before the first run and for all rows alike: material constants as given there at 293 K, none fitted; the
defaults of the pair style; a tool that takes no heat but its part of that of friction (the conductance of the contact is not
given); 10 uncut chip thicknesses of cut, means over the last half; 160 um below the cut, held and kept at 293 K at the bottom;
time scaled so that the tool runs at 50 m/s, where inertia (rho v^2) is 11 MPa, 1 % of the flow stress. Changed afterwards: the speed of
the chip is the median of its particles, not the mean, since some cling to the tool."""
import os
import sys

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
EXAMPLE = os.path.join(ROOT, "examples", "orthogonal_ti6al4v")
sys.path.insert(0, EXAMPLE)
from measure import measure                                                            # noqa: E402,F401

TITLE = "orthogonal cuts of Ti6Al4V"
REFERENCE = "measured, Ducobu et al. 2024"
SCRIPT = os.path.join(EXAMPLE, "in.orthogonal_ti6al4v")
FILES = [os.path.join(EXAMPLE, "insert.stl")]
BASE = {"dx": 5, "run": 50, "length": 10}
COMPARED = {"cutting force": ("N/mm", 0.05), "feed force": ("N/mm", 0.15), "chip ratio": ("", 0.10)}    # unit, goal

FRICTION = {5: (0.24, 1.0), 10: (0.21, 0.80), 30: (0.18, 0.55)}    # m/min: coefficient, part of its heat into the work
# uncut chip thickness (um), speed (m/min): cutting, feed force (N per mm of width), chip ratio, each with two standard deviations
MEASURED = {(40, 5): ((106.0, 8.4), (50.1, 7.3), (1.96, 0.13)), (40, 10): ((97.2, 13.4), (46.6, 4.1), (1.77, 0.14)),
            (40, 30): ((88.4, 16.4), (46.9, 10.0), (1.36, 0.15)), (60, 5): ((138.7, 11.4), (55.7, 9.5), (1.97, 0.12)),
            (60, 10): ((129.8, 15.8), (53.8, 7.4), (1.85, 0.23)), (60, 30): ((118.2, 20.3), (50.3, 9.1), (1.23, 0.09)),
            (80, 5): ((176.0, 13.2), (62.3, 13.5), (1.76, 0.16)), (80, 10): ((161.2, 15.6), (56.6, 9.1), (1.77, 0.06)),
            (80, 30): ((153.8, 27.3), (53.0, 12.4), (1.18, 0.08))}
ROWS = {"%d_um_%d" % (h, v): {"variables": {"chip": h, "speed": v, "mu": FRICTION[v][0], "share": FRICTION[v][1]},
                              "title": "%d um, %d m/min" % (h, v), "reference": dict(zip(COMPARED, MEASURED[h, v]))}
        for h, v in MEASURED}

CARD = "materials.sphtm ti6al4v-ducobu"
# Mills 2002, Recommended values of thermophysical properties for selected commercial alloys, as quoted elsewhere; not checked in the
# book itself: T (K), W/(m K), J/(kg K)
TABLE = ((298, 7, 546), (373, 7.45, 562), (473, 8.75, 584), (573, 10.15, 606), (673, 11.35, 629), (773, 12.6, 651), (873, 14.2, 673),
         (973, 15.5, 694), (1073, 17.8, 714), (1173, 20.2, 734))
HEAT = "heat table/10 %s table/10 %s 0.9" % tuple(" ".join("%g %g" % (t[0], t[k]) for t in TABLE) for k in (1, 2))
JC = "997.9e6 653.1e6 0.45 0.0198 0.7 293 1873 1.0"
# what ./sphtm identify can fit, of the card, and to what
CONSTANTS = {"jc_a": 997.9e6, "jc_b": 653.1e6, "jc_n": 0.45, "jc_c": 0.0198, "jc_m": 0.7, "conductivity": 6.3, "capacity": 531.0,
             "taylor_quinney": 0.9}
FITTED = ("cutting force", "feed force")
# its numerics: root mean square difference from the spacing of 2.5 um over the nine cuts (commit 1bc22f2), over the force; of that
# spacing itself the error of the means
NUMERICAL = {"dx_10": {"cutting force": 0.09, "feed force": 0.27}, "dx_5": {"cutting force": 0.04, "feed force": 0.21},
             "dx_2.5": {"cutting force": 0.01, "feed force": 0.03}}
MESH = ("dx_10", "dx_5", "dx_2.5")         # from coarse to fine
SCALING = ("run_25", "dx_5")               # from slow to the base
SETTINGS = {
    "dx_10": {"dx": 10}, "dx_5": {}, "dx_2.5": {"dx": 2.5},
    "run_25": {"run": 25}, "run_100": {"run": 100},
    "heat_table": {"material": "density 4430 elastic 113.8e9 0.34 strength johnson/cook %s %s expansion 8.6e-6" % (JC, HEAT)},
    "tool_293_K": {"contact": "heat conductance 1e5 temperature 293"},
    "tool_293_K_perfect": {"contact": "heat perfect temperature 293"},
    "heat_table_tool": {"contact": "heat conductance 1e5 temperature 293",
                        "material": "density 4430 elastic 113.8e9 0.34 strength johnson/cook %s %s expansion 8.6e-6" % (JC, HEAT)},
    "shear_limit": {"contact": "heat none friction/shear 1"},
    "no_expansion": {"material": CARD + " set expansion 0"},
    "softening": {"material": "density 4430 elastic 113.8e9 0.34 strength johnson/cook/tanh %s 1.6 0.4 1 6 1 heat 6.3 531 0.9 "
                              "expansion 8.6e-6" % JC},
    "klippel_2026": {"material": "materials.sphtm ti6al4v"},
    "artstress": {"options": "stabilize artstress"},
    "viscosity_1_1": {"options": "viscosity 1 1"},
    "correction_no": {"options": "correction no"},
}
SAID = {
    "dx_10": "spacing 10 um", "dx_5": "spacing 5 um", "dx_2.5": "spacing 2.5 um", "run_25": "5 um, time scaled half as much",
    "run_100": "5 um, time scaled twice as much", "heat_table": "5 um, conductivity and heat capacity by temperature (Mills 2002)",
    "heat_table_tool": "5 um, both: by temperature, and tool at 293 K behind 1e5 W/m2K",
    "tool_293_K": "5 um, tool at 293 K behind 1e5 W/m2K", "tool_293_K_perfect": "5 um, tool at 293 K, perfect contact",
    "shear_limit": "5 um, friction at most the shear flow stress", "no_expansion": "5 um, without thermal expansion",
    "softening": "5 um, strain softening, constants of the page of the pair style", "klippel_2026": "5 um, card ti6al4v (other constants)",
    "artstress": "5 um, *stabilize artstress*", "viscosity_1_1": "5 um, *viscosity 1 1*", "correction_no": "5 um, *correction no*",
}
QUICK = "dx_10"


def only(setting):
    """Rows that a setting is run for: spacings for all, variants for those of 60 um, of the numerics for one."""
    one = ("run_25", "run_100", "artstress", "viscosity_1_1", "correction_no")
    return [row for row in ROWS if setting in MESH or row == "60_um_30" or setting not in one and row.startswith("60_um")]


def cost(variables):
    """Particles times steps, in some unit: the dearest runs start first."""
    h, dx = variables["chip"], variables["dx"]
    return (variables["length"] + 3) * h * (h + 160) * variables["length"] * h / dx ** 3 / variables["run"]
