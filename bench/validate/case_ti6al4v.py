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

import case

measure = case.example("orthogonal_ti6al4v").measure
TITLE = "orthogonal cuts of Ti6Al4V"
REFERENCE = "measured, Ducobu et al. 2024"
SCRIPT = case.script_of("orthogonal_ti6al4v")
FILES = [os.path.join(os.path.dirname(SCRIPT), "insert.stl")]
BASE = {"dx": 5, "run": 50, "length": 10}
COMPARED = {"cutting force": ("N/mm", 0.05), "feed force": ("N/mm", 0.15), "chip ratio": ("", 0.10)}    # unit, goal

# m/min: coefficient, part of its heat into the work
FRICTION = {5: (0.24, 1.0), 7.5: (0.22, 0.89), 10: (0.21, 0.80), 20: (0.19, 0.63), 30: (0.18, 0.55), 40: (0.17, 0.50)}
# uncut chip thickness (um), speed (m/min): cutting, feed force (N per mm of width), chip ratio, each with two standard deviations
MEASURED = {(40, 5): ((106.0, 8.4), (50.1, 7.3), (1.96, 0.13)), (40, 10): ((97.2, 13.4), (46.6, 4.1), (1.77, 0.14)),
            (40, 30): ((88.4, 16.4), (46.9, 10.0), (1.36, 0.15)), (60, 5): ((138.7, 11.4), (55.7, 9.5), (1.97, 0.12)),
            (60, 10): ((129.8, 15.8), (53.8, 7.4), (1.85, 0.23)), (60, 30): ((118.2, 20.3), (50.3, 9.1), (1.23, 0.09)),
            (80, 5): ((176.0, 13.2), (62.3, 13.5), (1.76, 0.16)), (80, 10): ((161.2, 15.6), (56.6, 9.1), (1.77, 0.06)),
            (80, 30): ((153.8, 27.3), (53.0, 12.4), (1.18, 0.08))}
NINE = list(MEASURED)
# nine more, read off the vector figures of the same authors' article as they have published its source (CIRP-2022-paper), once those
# above had been run; they were not looked at before
MEASURED.update({(40, 7.5): ((100.2, 9.6), (47.2, 5.6), (1.58, 0.33)), (40, 20): ((87.0, 13.0), (37.1, 7.2), (1.46, 0.20)),
                 (40, 40): ((87.4, 22.1), (46.8, 11.6), (1.33, 0.03)), (60, 7.5): ((132.1, 13.2), (53.3, 8.1), (1.93, 0.19)),
                 (60, 20): ((117.4, 18.1), (40.9, 7.5), (1.37, 0.09)), (60, 40): ((118.0, 26.7), (50.4, 13.9), (1.20, 0.10)),
                 (80, 7.5): ((167.5, 14.2), (58.6, 11.7), (1.50, 0.10)), (80, 20): ((156.8, 21.3), (61.0, 11.9), (1.45, 0.27)),
                 (80, 40): ((149.6, 23.5), (51.0, 12.8), (1.31, 0.19))})
name = lambda key: "%d_um_%g" % key
ROWS = {name(key): {"variables": {"chip": key[0], "speed": key[1], "mu": FRICTION[key[1]][0], "share": FRICTION[key[1]][1]},
                    "title": "%d um, %g m/min" % key, "reference": dict(zip(COMPARED, found))} for key, found in MEASURED.items()}

# softening: both sets as the cutting programs of ETH's IWF have them (mfree_iwf), with the Johnson-Cook constants that go with them
CARD = "materials.sphtm ti6al4v-ducobu"
# Mills 2002, Recommended values of thermophysical properties for selected commercial alloys; the book was not at hand, digitized data of
# its sources (k after Polev et al. 1985) and other programs' tables give these values within 1 %: T (K), W/(m K), J/(kg K)
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
SCALING = ("run_25", "variants")           # from slow to the base
SPACING = {"dx_10": 10, "dx_5": 5, "dx_2.5": 2.5}
TABLES = "density 4430 elastic 113.8e9 0.34 strength johnson/cook %s %s expansion 8.6e-6" % (JC, HEAT)
VARIANT = {"dx": 6.6667, "length": 6}      # of all rows; the base of them is 'variants'
SETTINGS = {
    "dx_10": {"dx": 10}, "dx_5": {}, "dx_2.5": {"dx": 2.5},
    "variants": VARIANT, "more_rows": VARIANT,
    "run_25": dict(VARIANT, run=25), "run_100": dict(VARIANT, run=100),
    "heat_table": dict(VARIANT, material=TABLES),
    "tool_293_K": dict(VARIANT, contact="heat conductance 1e5 temperature 293"),
    "heat_table_tool": dict(VARIANT, contact="heat conductance 1e5 temperature 293", material=TABLES),
    "shear_limit": dict(VARIANT, contact="heat none friction/shear 1"),
    "no_expansion": dict(VARIANT, material=CARD + " set expansion 0"),
    "softening_ducobu": dict(VARIANT, material="density 4430 elastic 113.8e9 0.34 strength johnson/cook/tanh 862e6 331e6 0.34 0.01 0.8 300 "
                                               "1836 1 1.1 0.4 1 12 1 heat 6.3 531 0.9 expansion 8.6e-6"),
    "softening_sima": dict(VARIANT, material="density 4430 elastic 113.8e9 0.34 strength johnson/cook/tanh 724.7e6 683.1e6 0.47 0.035 1 298 "
                                             "1878 1 2 5 1 2 0.05 heat 6.3 531 0.9 expansion 8.6e-6"),
    "klippel_2026": dict(VARIANT, material="materials.sphtm ti6al4v"),
    "artstress": dict(VARIANT, options="stabilize artstress"),
    "viscosity_1_1": dict(VARIANT, options="viscosity 1 1"),
    "correction_no": dict(VARIANT, options="correction no"),
    "second": dict(VARIANT, options="correction second"), "second_2.5": {"dx": 2.5, "options": "correction second"},
}
SAID = {
    "dx_10": "spacing 10 um", "dx_5": "spacing 5 um", "dx_2.5": "spacing 2.5 um", "variants": "6.7 um, cut of 6 thicknesses: base of those below",
    "more_rows": "the same, the nine rows read later",
    "run_25": "time scaled half as much", "run_100": "time scaled twice as much",
    "heat_table": "conductivity and heat capacity by temperature (Mills 2002)", "tool_293_K": "tool at 293 K behind 1e5 W/m2K",
    "heat_table_tool": "both: by temperature, and tool at 293 K", "shear_limit": "friction at most the shear flow stress",
    "no_expansion": "without thermal expansion", "softening_ducobu": "strain softening, constants of Ducobu 2017", "softening_sima": "strain softening, constants of Sima and Ozel 2010",
    "klippel_2026": "card ti6al4v (other constants)",
    "artstress": "*stabilize artstress*", "viscosity_1_1": "*viscosity 1 1*", "correction_no": "*correction no*",
    "second": "*correction second*", "second_2.5": "*correction second*, spacing 2.5 um, cut of 10 thicknesses",
}
QUICK = "dx_10"


def only(setting):
    return [row for row, key in zip(ROWS, MEASURED) if (key in NINE) != (setting == "more_rows")]


def cost(variables):
    """Particles times steps, in some unit: the dearest runs start first."""
    h, dx = variables["chip"], variables["dx"]
    return (variables["length"] + 3) * h * (h + 160) * variables["length"] * h / dx ** 3 / variables["run"]
