"""What each effect costs, on and off: instructions per particle and step (valgrind --tool=callgrind, repeatable),
processor time, bytes per particle. Off is measured twice: with the whole plugin, and with a build that has only the
effects of the scene (CMake: SPHTM_MINIMAL_EFFECTS); the two must not differ by 1 %. What some cost on top of the defaults
of the pair style (scene "usual") is compared with their goal. And what audits cost at their
defaults (fix sph/tm audit yes), which must be less than 1 % of the run. Prints tables and writes summary.json,
table.rst and audit.rst. Called by ./sphtm effects [options].

Instructions are those of the run itself (Verlet::run), with the AVX2 loops: valgrind has no AVX-512. Time is processor
time with the best loops of the processor, the median of interleaved rounds."""
import argparse
import json
import os
import re
import statistics
import subprocess
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
OUT = os.environ.get("SPHTM_OUT", os.path.join(os.path.dirname(HERE), "out", "effects"))
LIMIT = 0.01    # off against minimal

# a block whose shear and stretch start no rebuild; two types make the halves of the contact of bodies
SCENE = """
units           si
dimension       3
boundary        f f f
atom_style      atomic
newton          off
lattice         sc 1e-3 origin 0.5 0.5 0.5
region          box block -5e-3 {far} -5e-3 {far} -5e-3 {far} units box
create_box      2 box
region          lower block 0 {side} 0 {side} 0 {half} units box
region          upper block 0 {side} 0 {side} {half} {side} units box
create_atoms    1 region lower
create_atoms    2 region upper
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 {options}
pair_coeff      1 1 density 7830 elastic 200e9 0.29 {material}
pair_coeff      2 2 density 7830 elastic 200e9 0.29 {material}
pair_coeff      1 2 {meet}
fix             body all sph/tm temperature 300 dt 4e-8 {fix}
{more}
velocity        all ramp vx 0 20 z 0 {side} units box
velocity        all ramp vz 0 20 z 0 {side} sum yes units box
thermo_style    custom step time dt ke
thermo          {steps}
run             {steps}
"""
PLAIN = "viscosity 0 0 hourglass 0 correction no"    # no stabilization
BARE = {"options": PLAIN, "material": "", "meet": "bond", "fix": "effects fracture off", "more": ""}
MORE = dict(BARE, options="viscosity 1 1 hourglass 0 correction no", material="strength plastic 400e6 1e9 heat 0 477 0.9",
            fix="effects fracture off effects artificial-heat off")
SHOCK = dict(BARE, material="eos shock 4570 1.49 1.9", fix="effects fracture off effects internal-energy off")
USUAL = dict(BARE, options="", fix="", material="strength plastic 400e6 1e9 heat 38 477 0.9")
APART = dict(BARE, meet="none")
STABLE = dict(BARE, options="correction linear")
BASES = {"bare": (BARE, "none"), "more": (MORE, "viscosity;plasticity;heat"), "shock": (SHOCK, "none"),
         "apart": (APART, "none"), "stable": (STABLE, "viscosity;correction;hourglass"), "usual": (USUAL, None)}
# effect: base, what turns it on there; without a minimal build: what it adds to a step of the usual scene
EFFECTS = {
    "the default stabilization": ("bare", {"options": ""}),
    "viscosity": ("bare", {"options": "viscosity 0 1 hourglass 0 correction no"}),
    "artstress": ("bare", {"options": PLAIN + " artstress 0.3 4"}),
    "plasticity": ("bare", {"material": "strength plastic 400e6 1e9"}),
    "heat": ("bare", {"material": "heat 0 477 0", "fix": BARE["fix"] + " effects heat on"}),
    "conduction": ("more", {"material": "strength plastic 400e6 1e9 heat 38 477 0.9"}),
    "damage": ("more", {"material": "strength plastic 400e6 1e9 heat 0 477 0.9 damage strain 10"}),
    "balsara": ("more", {"options": MORE["options"] + " balsara yes"}),
    "correction": ("bare", {"options": "viscosity 0 0 hourglass 0 correction yes"}),
    "faces": ("stable", {"options": "correction second"}),
    "hourglass": ("bare", {"options": "viscosity 0 0 hourglass auto correction no"}),
    "xsph": ("bare", {"options": PLAIN + " xsph 0.1"}),
    "surface": ("bare", {"fix": BARE["fix"] + " effects surface on"}),
    "fracture": ("bare", {"fix": ""}),
    "internal-energy": ("shock", {"fix": BARE["fix"]}),
    "energy": ("bare", {"fix": BARE["fix"] + " energy yes"}),
    "bodies": ("apart", {"meet": "contact"}),
    "expansion": ("more", {"material": "strength plastic 400e6 1e9 heat 0 477 0.9 expansion 1e-5",
                           "fix": MORE["fix"] + " effects compression-heat off"}),
    "artificial-heat": ("more", {"fix": BARE["fix"]}),
    "fix contact/tri": ("more", {"more": "fix tool all contact/tri file {mesh} move {mid} {mid} {top} friction 0.2 "
                                         "heat conductance 1e5 temperature 600"}),
    "fix sph/tm/heat": ("more", {"more": "fix air all sph/tm/heat convection 100 300"}),
    "balsara, usual": ("usual", {"options": "balsara yes"}),
    "xsph, usual": ("usual", {"options": "xsph 0.1"}),
    "surface, usual": ("usual", {"fix": "effects surface on"}),
    "fix sph/tm/heat, usual": ("usual", {"more": "fix air all sph/tm/heat convection 100 300"}),
}
ADDED = 0.15    # instructions of a step, goal of what an effect adds to the usual scene
# audits: the scene, particles along an edge of the block; usual: the defaults of the pair style, and conduction
AUDITS = [("usual", 12), ("bare", 12), ("usual", 24)]
EVERY, SAMPLE = 1000, 50    # of 'audit yes'


def script(settings, n, steps, mesh):
    side = n * 1e-3
    place = dict(side=side, half=(n + 1) // 2 * 1e-3, far=side + 5e-3, steps=steps, mesh=mesh, mid=side / 2,
                 top=side + 5.4e-3)
    return SCENE.format(**dict(place, **{k: v.format(**place) for k, v in settings.items()}))


def run(plugin, text, name, valgrind=False):
    path = os.path.join(OUT, "in." + re.sub(r"\W", "_", name))
    with open(path, "w") as f:
        f.write(text)
    counts = os.path.join(OUT, "callgrind.out")
    command = [os.environ["SPHTM_LMP"], "-nocite", "-log", "none", "-in", path]
    if valgrind:
        command = ["valgrind", "--tool=callgrind", "--collect-atstart=no", "--callgrind-out-file=" + counts,
                   "--toggle-collect=LAMMPS_NS::Verlet::run(int)"] + command
    done = subprocess.run(command, cwd=OUT, env=dict(os.environ, LAMMPS_PLUGIN_PATH=plugin, OMP_NUM_THREADS="1"),
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL, text=True, timeout=1800)
    loop = re.search(r"Loop time of (\S+) on \d+ procs for (\d+) steps with (\d+) atoms", done.stdout)
    if done.returncode or not loop:
        sys.exit("%s\n%s\nfailed: %s" % (done.stdout[-3000:], name, " ".join(command)))
    per = 1.0 / (int(loop[2]) * int(loop[3]))
    if valgrind:
        return int(re.search(r"Collected : (\d+)", done.stdout)[1]) * per
    return float(loop[1]) * float(re.search(r"([\d.]+)% CPU", done.stdout)[1]) / 100 * 1e9 * per, done.stdout


def audits(which, steps, mesh):
    """Instructions of one audit, from a run with one at its last step and one that has the keyword but none, and of a
    step without the keyword; the share that audits take of a run at their defaults."""
    rows = []
    for base, n in which:
        count = {}
        for name, every in (("without", 0), ("waiting", EVERY), ("audited", steps)):
            settings = dict(BASES[base][0], fix="audit %d %d" % (every, SAMPLE) if every else "")
            count[name] = run(os.environ["LAMMPS_PLUGIN_PATH"], script(settings, n, steps, mesh), "audit " + name,
                              valgrind=True)
            print("%-26s %10.1f instructions per particle and step" % ("audit %s %d %s" % (base, n, name), count[name]),
                  flush=True)
        per_step = count["waiting"] - count["without"]
        audit = (count["audited"] - count["waiting"]) * steps
        rows.append({"scene": base, "particles": n ** 3, "every": EVERY, "sample": SAMPLE, "step": count["without"],
                     "step_with_the_keyword": count["waiting"], "audit_in_steps": audit / count["without"],
                     "share": (per_step + audit / EVERY) / count["without"]})
    return rows


def bytes_of(text):
    """Per particle: of the lines of the table at the end of the run."""
    lines = re.findall(r"^  (\S.{25}) +\S+ +\S+ +\S+ +(\d+)(?:  |$)", text.split("effect or part")[-1], re.M)
    return sum(int(b) for _, b in lines)


def main():
    options = argparse.ArgumentParser(description=__doc__.split("\n\n")[0],
                                      formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    options.add_argument("--rounds", type=int, default=5, help="timed runs of each case")
    options.add_argument("--n", type=int, default=12, help="particles along an edge of the block")
    options.add_argument("--steps", type=int, default=200, help="steps of a timed run")
    options.add_argument("--counted", type=int, default=10, help="steps of a run whose instructions are counted")
    options.add_argument("--effects", nargs="+", choices=EFFECTS, default=list(EFFECTS), metavar="EFFECT")
    options.add_argument("--only-audits", action="store_true", help="what audits cost, and nothing else")
    options = options.parse_args()
    plugins = {"whole": os.environ["LAMMPS_PLUGIN_PATH"]}
    for pair in os.environ.get("SPHTM_MINIMAL_PLUGINS", "").split(":"):
        name, _, path = pair.partition("=")
        if path:
            plugins[name] = path
    os.makedirs(OUT, exist_ok=True)
    mesh = os.path.join(OUT, "tool.stl")
    subprocess.run([sys.executable, os.path.join(os.path.dirname(HERE), "tools", "make_tool.py"), "block", "--size",
                    "40", "40", "10", "--cells", "20", "20", "5", "--scale", "1e-3", "-o", mesh], check=True,
                   stdout=subprocess.DEVNULL)

    if options.only_audits:
        sys.exit(1 if report_audits(audits(AUDITS, options.counted, mesh)) else 0)

    # the runs: (who, settings, plugin); the lists are walked once per round
    cases = {}
    for base in dict.fromkeys(EFFECTS[e][0] for e in options.effects):
        settings, minimal = BASES[base]
        cases["off " + base] = (settings, plugins["whole"])
        if minimal is not None:
            cases["minimal " + base] = (settings, plugins[minimal])
    for e in options.effects:
        base, on = EFFECTS[e]
        cases["on " + e] = (dict(BASES[base][0], **on), plugins["whole"])
    found = {}
    for name, (settings, plugin) in cases.items():
        count = run(plugin, script(settings, options.n, options.counted, mesh), name, valgrind=True)
        found[name] = {"instructions": count, "ns": []}
        print("%-26s %10.1f instructions per particle and step" % (name, count), flush=True)
    for _ in range(options.rounds):
        for name, (settings, plugin) in cases.items():
            ns, text = run(plugin, script(settings, options.n, options.steps, mesh), name)
            found[name]["ns"].append(ns)
            found[name]["bytes"] = bytes_of(text)
    for f in found.values():
        f["ns_all"] = [round(x, 1) for x in f["ns"]]
        f["ns"] = statistics.median(f["ns"])

    summary = {"particles": options.n ** 3, "steps": options.steps, "rounds": options.rounds, "runs": found, "effects": {},
               "limit": LIMIT, "waste": [], "audits": audits(AUDITS, options.counted, mesh)}
    for e in options.effects:
        base = EFFECTS[e][0]
        row = {"base": base, "on": found["on " + e], "off": found["off " + base]}
        row["on_over_off"] = row["on"]["instructions"] / row["off"]["instructions"] - 1
        if BASES[base][1] is not None:
            row["minimal"] = found["minimal " + base]
            row["off_over_minimal"] = row["off"]["instructions"] / row["minimal"]["instructions"] - 1
            if abs(row["off_over_minimal"]) >= LIMIT:
                summary["waste"].append(e)
        summary["effects"][e] = row
    with open(os.path.join(OUT, "summary.json"), "w") as f:
        json.dump(summary, f, indent=1)
        f.write("\n")
    report(summary)
    dear = report_audits(summary["audits"])
    print("written to", os.path.join(OUT, "summary.json"))
    sys.exit(1 if summary["waste"] or dear else 0)


def show(head, rows, file, left):
    """A table on the screen, its first columns to the left, and in a file."""
    widths = [max(len(str(row[k])) for row in rows + [head]) for k in range(len(head))]
    for row in [head] + rows:
        print("  ".join("%-*s" % (w, v) if k < left else "%*s" % (w, v) for k, (w, v) in enumerate(zip(widths, row))))
    with open(os.path.join(OUT, file), "w") as f:
        f.write(".. list-table::\n   :header-rows: 1\n\n")
        for row in [head] + rows:
            f.write("   * - %s\n" % row[0] + "".join("     - %s\n" % v for v in row[1:]))


def report(summary):
    head = ("effect", "scene", "minimal", "off", "on", "off - minimal", "on - off", "ns minimal", "off", "on", "bytes off",
            "on")
    runs, rows = ("minimal", "off", "on"), []
    for e, r in summary["effects"].items():
        rows.append((e, r["base"]) + tuple("%.0f" % r[k]["instructions"] if k in r else "" for k in runs) +
                    ("%+.2f %%" % (100 * r["off_over_minimal"]) if "minimal" in r else "", "%+.1f %%" % (100 * r["on_over_off"])) +
                    tuple("%.0f" % r[k]["ns"] if k in r else "" for k in runs) +
                    tuple("%d" % r[k]["bytes"] for k in ("off", "on")))
    print("\n%d particles; instructions, ns and bytes per particle and step" % summary["particles"])
    show(head, rows, "table.rst", 2)
    print("off and minimal differ by less than %g %% everywhere" % (100 * LIMIT) if not summary["waste"] else
          "waste: " + ", ".join(summary["waste"]))
    for e, r in summary["effects"].items():
        if "minimal" not in r:
            print("%s: %+.1f %% instructions, goal %g %%: %s" % (e, 100 * r["on_over_off"], 100 * ADDED,
                                                                 "met" if r["on_over_off"] <= ADDED else "missed"))


def report_audits(rows):
    """Prints and writes what audits cost; the scenes in which that is 1 % or more."""
    head = ("scene", "particles", "instructions", "with audit waiting", "an audit, in steps",
            "audit %d %d" % (EVERY, SAMPLE))
    text = [(r["scene"], r["particles"], "%.1f" % r["step"], "%.1f" % r["step_with_the_keyword"],
             "%.2f" % r["audit_in_steps"], "%.3f %%" % (100 * r["share"])) for r in rows]
    print("\naudits; instructions per particle and step")
    show(head, text, "audit.rst", 1)
    return [r["scene"] for r in rows if r["share"] >= LIMIT]


if __name__ == "__main__":
    main()
