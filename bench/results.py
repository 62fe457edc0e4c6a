#!/usr/bin/python3
"""The table of results in README.md, from the summaries in doc/results.

  ./sphtm results                      writes the table anew
  ./sphtm results check                says whether it is what the summaries give
  ./sphtm results collect [FILE ...]   takes summary.json files, or all in out/, into doc/results, then writes the table
  ./sphtm results record NAME COMMAND key=value ...
                                       a summary of numbers read by hand; its commit and date are those of now

A summary of doc/results is a JSON file with "command", "commit" and "date" beside its numbers. Scenes and the demo write into
their summary.json which numbers go to which ("results"). Rows are in ROWS below: what, summary, text with
{path/in/summary:format} or {other.summary|path:format}, reference, where the reference is from, and 'met', 'missed' or ''
(nothing to hold it to). 'published' stands only where a source prints the number; 'derived' is computed for this project,
by the closed form or solver that is named."""
import glob
import json
import os
import re
import sys

sys.dont_write_bytecode = True
from provenance import ROOT, provenance                                                # noqa: E402

FOLDER = os.path.join(ROOT, "doc", "results")
README = os.path.join(ROOT, "README.md")
BEGIN, END = "<!-- results: ./sphtm results -->", "<!-- end of results -->"

ROWS = [
    ("high speed machining: force with heat over without, to 1.75 mm; 1 to 4 mm", "high_speed_machining",
     "{force_ratio_to_1.75_mm:.3f}; {force_ratio_heat_over_no_heat:.3f}", "0.854", "published, Fraser et al. 2015, length "
     "of averaging not given; with half the spacing 0.783 in the long cut (e7fef21, a GPU)", "missed"),
    ("mean of the maximum interface temperature", "high_speed_machining", "{max_interface_temperature_C:.0f} C", "376 C",
     "published, the same", "missed"),
    ("drift of the energy sum, over the work of the tool", "high_speed_machining", "{energy_error_fraction:.0e}", "0",
     "", "met"),
    ("Taylor bar, 227 m/s, 4, 5, 6 rings: length", "taylor_bar",
     "{linear_4/length:.2f}, {linear_5/length:.2f}, {linear_6/length:.2f} mm", "21.48 mm",
     "derived, finite elements, limit of four meshes; 21.4 published", "met"),
    ("its radius", "taylor_bar", "{linear_4/radius:.2f}, {linear_5/radius:.2f}, {linear_6/radius:.2f} mm",
     "7.36 mm", "derived, the same; 7.22, 7.12, 7.11 published", "met"),
    ("the same, 9 and 12 rings: length; radius", "taylor_bar.fine", "{linear_9/length:.2f}, {linear_12/length:.2f}; {linear_9/radius:.2f}, {linear_12/radius:.2f} mm",
     "21.48; 7.36 mm", "derived, the same", "met; met"),
    ("Taylor bar, OFHC 190 m/s, 4, 5, 7 rings: length", "taylor_bar",
     "{ofhc190_4/length:.2f}, {ofhc190_5/length:.2f}, {ofhc190_7/length:.2f} mm", "17.36 mm",
     "derived, finite elements, finest of four meshes; 17.40 published", "met"),
    ("its radius", "taylor_bar", "{ofhc190_4/radius:.2f}, {ofhc190_5/radius:.2f}, {ofhc190_7/radius:.2f} mm", "7.40 mm",
     "derived, the limit of the same; 7.28 published", "met"),
    ("Taylor bar, OFHC 210 m/s, 4, 5, 7 rings: length", "taylor_bar",
     "{ofhc210_4/length:.2f}, {ofhc210_5/length:.2f}, {ofhc210_7/length:.2f} mm", "14.80 mm",
     "measured, Wilkins and Guinan 1973", "met"),
    ("its radius", "taylor_bar", "{ofhc210_4/radius:.2f}, {ofhc210_5/radius:.2f}, {ofhc210_7/radius:.2f} mm", "8.40 mm",
     "measured, the same", "missed"),
    ("Taylor bar, OFHC 225 m/s, 4, 5 rings: length", "taylor_bar",
     "{ofhc225_4/length:.2f}, {ofhc225_5/length:.2f} mm", "22.25 mm", "measured, collected by Zelepugin et al. 2023",
     "missed"),
    ("its radius", "taylor_bar", "{ofhc225_4/radius:.2f}, {ofhc225_5/radius:.2f} mm", "8.02 mm", "measured, the same",
     "missed"),
    ("nine measured cuts of Ti6Al4V, spacing 2.5 um, nothing fitted: mean absolute error of cutting force, feed force, chip ratio",
     "validate.ti6al4v", "{dx_2.5/cutting_force/absolute:.0f}, {dx_2.5/feed_force/absolute:.0f}, {dx_2.5/chip_ratio/absolute:.0f} %",
     "0; a commercial model, 36 such cuts: 4, 39, 17 %", "measured and published, Ducobu et al. 2024", "missed"),
    ("perfectly plastic flow in plane strain: cut without friction, flat punch, block, 40 spacings over chip or height: force",
     "validate.slip_line", "{values/cut/force_over_the_closed_form:.3f}, {values/punch/force_over_the_closed_form:.3f}, "
     "{values/block/force_over_the_closed_form:.3f}", "1, 1, 1",
     "derived, slip-line theory; the chip curls, a plane of shear for its thickness has 1.083", "missed, met, met"),
    ("bullet through a plate of 12 mm, 5 particles over it: residual velocity", "bullet_plate.default", "{residual:.1f} m/s", "141.0 m/s",
     "published, Fraser 2014, its thickness not given; depends on the size, near the ballistic limit", "missed"),
    ("tensile cylinder, 4, 6 and 8 particles over the radius: force at the end, largest force, least radius, off by", "validate.tensile_cylinder",
     "{n_4/force_at_the_end/mean:+.1f}, {n_6/force_at_the_end/mean:+.1f}, {n_8/force_at_the_end/mean:+.1f}; {n_4/largest_force/mean:+.1f}, "
     "{n_6/largest_force/mean:+.1f}, {n_8/largest_force/mean:+.1f}; {n_4/least_radius/mean:+.1f}, {n_6/least_radius/mean:+.1f}, {n_8/least_radius/mean:+.1f} %",
     "2.785 MN, 3.172 MN, 45.91 mm", "derived, finite elements, finest of three meshes", "met"),
    ("flat specimen, 10, 25, 50 particles over the width, with ASPH: stress at strain 0.15 over that of the "
     "material", "flat_tensile_c45e.10",
     "{asph_resisted:.3f}, {flat_tensile_c45e.25|asph_resisted:.3f}, {flat_tensile_c45e.50|asph_resisted:.3f}", "1", "derived, the flow curve", "met"),
    ("square bar of Weldox 460E, 6 and 8 particles over the side: strain at half of the largest stress, kept pairs, off by",
     "validate.weldox", "{rows_6/strain_at_half_of_it/mean:+.1f}, {rows_8/strain_at_half_of_it/mean:+.1f} %",
     "0.192", "published, finite elements", "missed; met"),
    ("the same with the default lists, 6, 8 particles: that strain; first failure by damage with 6", "weldox_bar_default",
     "{half:.4f}, {half_8:.4f}; {first:.4f}", "0.192", "published, finite elements; with 8, corners are torn off before", "missed"),
    ("oscillating plate, 6, 10, 20 and 40 particles over the thickness: period, over finite elements", "validate.plate",
     "{rows_6/period/mean:+.1f}, {rows_10/period/mean:+.1f}, {rows_20/period/mean:+.1f}, {rows_40/period/mean:+.1f} %", "0.2621 s",
     "derived, finite elements; published SPH: 0.2745 s", "met"),
    ("block of metal that hardens, upset without friction, 40 rows: force at 10, 30, 50, 60 % of the height over the closed form", "validate.upset",
     "{values/block/force_at_10_%:.3f}, {values/block/force_at_30_%:.3f}, {values/block/force_at_50_%:.3f}, {values/block/force_at_60_%:.3f}", "1, 1, 1, 1",
     "derived, closed form; with 20 rows 0.978 at 50, 0.950 at 60 %", "met"),
    ("strip of perfectly plastic metal, drawn through a smooth die, reduced by a third, 24 rows: force, height behind the die over theory",
     "validate.drawing", "{values/third/force:.3f}, {values/third/height_behind_the_die:.3f}", "1, 1",
     "derived, slip-line theory; without shifting it parts numerically, and reduced by a half with it", "met"),
    ("can of perfectly plastic metal, extruded backward without friction, bottom 4, 2 half widths of the punch thick, 30 spacings: pressure at 0.1, 0.25, 0.55 half widths over 2 k (1 + pi/2)",
     "validate.extrusion", "{values/thick/pressure_at_0.1:.3f}, {values/thick/pressure_at_0.25:.3f}, {values/thick/pressure_at_0.55:.3f}; "
     "{values/thin/pressure_at_0.1:.3f}, {values/thin/pressure_at_0.25:.3f}, {values/thin/pressure_at_0.55:.3f}", "1, 1, 1; 0.931, 0.901, 0.827",
     "derived, slip-line theory; limit analysis by finite elements", "met"),
    ("cylinder of perfectly plastic metal, upset with friction 0, 0.1 and 0.3, 20 rows: force at 30, at 50 % of the height over that of the slab method",
     "validate.cylinder", "{values/mu_0/force_at_30_%:.3f}, {values/mu_0/force_at_50_%:.3f}; {values/mu_0.1/force_at_30_%:.3f}, {values/mu_0.1/force_at_50_%:.3f}; "
     "{values/mu_0.3/force_at_30_%:.3f}, {values/mu_0.3/force_at_50_%:.3f}", "1, 1; 0.979, 0.985; 0.885, 0.897", "derived, closed form without friction, with it finite elements, as it barrels",
     "met, met, met at 30 %, missed at 50 % (-6 %)"),
    ("elastic cantilever at rest: stiffness with 16 particles over the height in bending, in tension; mean error of both with 4, 8, 16",
     "validate.beam", "{values/bend/stiffness:.3f}, {values/pull/stiffness:.3f}; {rows_4/stiffness/mean:+.1f}, {rows_8/stiffness/mean:+.1f}, "
     "{rows_16/stiffness/mean:+.1f} %", "1", "closed form, Timoshenko; from the face of the held "
     "particles", "missed in bending with 4 and 8"),
    ("C45E: cutting force, uniformly fine, 0.15 mm", "cutting_c45e", "{fine/cutting:.0f} N/mm", "2085 to 2220 N/mm",
     "derived, Kienzle's law with printed constants, at a sixth of the speed", "missed"),
    ("C45E, refined at the edge of the tool: cutting and passive force over uniformly fine; time", "cutting_c45e",
     "{refined_over_fine/cutting:.3f}, {refined_over_fine/passive:.3f}; {refined_over_fine/time:.2f}", "1, 1", "", "missed"),
    ("the same: cutting force in the thirds of the second half of the cut", "cutting_c45e",
     "{refined/thirds/0:.0f}, {refined/thirds/1:.0f}, {refined/thirds/2:.0f} N/mm", "one level", "published, Spreng et al. "
     "2013: it swings about a level", "missed"),
    ("bent beam of C45E, without and with hourglass control: largest difference from the linear stress profile",
     "bending_beam", "{elastic:.1f}, {elastic_resisted:.1f} %", "0", "derived, beam theory", "met"),
    ("conduction across a jump of the conductivity, 1 : 10, 1 : 100, 1 : 1000, 800 particles: heat that has crossed, over the closed form",
     "validate.layers", "{values/ratio_10/heat_that_has_crossed:.4f}, {values/ratio_100/heat_that_has_crossed:.4f}, "
     "{values/ratio_1000/heat_that_has_crossed:.4f} J/m2", "2.7110, 1.0258, 0.5991 J/m2", "derived, closed form", "met"),
    ("friction heat of steel on aluminum, spacing 10 um, after 1 ms: fraction into the aluminum", "validate.tool_heat",
     "{values/sliding/part_of_the_heat_in_the_aluminum:.3f}", "0.5507", "derived, closed form", "met"),
    ("block on a slope, mu = 0, 0.7, 0.98 tan(angle): acceleration", "validate.slope",
     "{values/share_0/acceleration:.3f}, {values/share_0.7/acceleration:.3f}, {values/share_0.98/acceleration:.4f} m/s^2",
     "3.420, 1.026, 0.0684 m/s^2", "derived, closed form; close to the angle of friction a block without damping flutters", "met, met, missed"),
    ("cylinder through a plate at 3.1 km/s, 0.125 mm: hole after 8 us", "validate.hypervelocity", "{values/3.1/diameter_of_the_hole:.2f} mm",
     "19.2 to 19.8 mm", "published, computed by others; *shock 0*: 19.29; the time is not published, and the hole still grows", "missed"),
    ("plates of hardening aluminum, 400 m/s, spacing 0.025 mm: longitudinal and von Mises stress (Pa), plastic strain behind the shock", "validate.plate_impact",
     "{values/aluminum_400/longitudinal_stress:.4g}, {values/aluminum_400/von_Mises_stress:.3g}, {values/aluminum_400/plastic_strain:.4f}", "3.139e9, 2.89e8, 0.0197",
     "derived, jump conditions; *shock 0*: 3.111e9, 1.57e8, 0.0222", "met"),
    ("two elastic bars collide, 20 particles over the thickness: speed back over that of approach; contact time over 2 L/c", "validate.impact",
     "{values/bars/speed_back_over_that_of_approach:.3f}; {values/bars/contact_time:.3f}", "1; 1", "derived, closed form", "met"),
    ("spinning block, ten turns, 40 rows: angular momentum, kinetic energy left", "validate.spin",
     "{values/block/angular_momentum_left:.8f}, {values/block/kinetic_energy_left:.4f}", "1, 1", "conservation", "met"),
]


def summary(name):
    path = os.path.join(FOLDER, name + ".json")
    if not os.path.exists(path):
        return None
    with open(path) as f:
        return json.load(f)


def value(of, path):
    for key in path.split("/"):
        of = of[int(key)] if isinstance(of, list) else of[key]
    return of


def filled(text, name):
    """The text, and the summaries that it took numbers from, each once; None for the text where one is not there."""
    used = []

    def put_in(m):
        other, _, path = m.group(1).rpartition("|")
        of = summary(other or name)
        if of is None:
            return "?"
        if not any(of[k] == u[k] for u in used for k in ("command",)):
            used.append(of)
        try:
            return format(value(of, path), m.group(2))
        except (KeyError, IndexError, TypeError, ValueError) as e:
            sys.exit("results: doc/results/%s.json: %r, for '%s'" % (other or name, e, text))

    return re.sub(r"\{([^:{}]+):([^{}]*)\}", put_in, text), used


def table():
    lines = ["| | here | reference | from | | commit, date | command |", "|---|---|---|---|---|---|---|"]
    for what, name, text, reference, source, verdict in ROWS:
        here, used = filled(text, name)
        when = "; ".join(dict.fromkeys("%s, %s" % (u["commit"], u["date"]) for u in used))    # in the order of the values
        how = "; ".join("`%s`" % u["command"] for u in used)
        lines.append("| %s | %s | %s | %s | %s | %s | %s |" % (what, here, reference, source, verdict, when, how))
    return "\n".join(lines)


def written(text):
    if text.count(BEGIN) != 1 or text.count(END) != 1:
        sys.exit("results: README.md must have one line '%s' and one '%s'" % (BEGIN, END))
    head, rest = text.split(BEGIN)
    return head + BEGIN + "\n\n" + table() + "\n\n" + END + rest.split(END)[1]


def put(name, of):
    with open(os.path.join(FOLDER, name + ".json"), "w") as f:
        json.dump(of, f, indent=1, sort_keys=True)
        f.write("\n")
    print("doc/results/%s.json" % name)


def collect(files):
    files = files or glob.glob(os.path.join(ROOT, "out", "**", "summary.json"), recursive=True)
    for path in sorted(files):
        with open(path) as f:
            of = json.load(f)
        if not all(of.get(k) for k in ("command", "commit", "date", "results")):
            print("left out: %s (no results, commit, command and date in it)" % path)
            continue
        for name, values in of["results"].items():
            put(name, dict({k: of[k] for k in ("command", "commit", "date")}, **values))    # values may say themselves when they were made


def number(text):
    try:
        return float(text)
    except ValueError:
        sys.exit("results: '%s' is no number" % text)


def record(name, command, *pairs):
    of = summary(name) or {}
    for pair in pairs:
        path, _, text = pair.partition("=")
        at, keys = of, path.split("/")
        for key in keys[:-1]:
            at = at.setdefault(key, {})
        at[keys[-1]] = number(text)
    put(name, dict(of, **provenance(command)))


def main(arguments):
    what = arguments[0] if arguments else "write"
    with open(README) as f:
        text = f.read()
    if what == "check":
        good = written(text) == text
        print("README.md has the table of doc/results" if good else "README.md is not what doc/results gives: ./sphtm results")
        return 0 if good else 1
    if what == "collect":
        collect(arguments[1:])
    elif what == "record" and len(arguments) > 3:
        record(*arguments[1:])
    elif what != "write":
        sys.exit(__doc__)
    text = written(text)    # before the file is opened
    with open(README, "w") as f:
        f.write(text)
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
