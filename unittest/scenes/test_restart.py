"""A restarted run continues bit for bit, and so does a run that is cut into two.

A Johnson-Cook block with heat, conduction, damage, hourglass control, gradient correction, and also Balsara switch and XSPH,
is plowed by a moving, rubbing tool: every state field that exists travels through the restart file. Compared exactly, all
digits, on one and on two ranks. Counter-run: a restart that loses one field must be noticed."""
import os
import subprocess
import sys

from sphtm_scene import SOURCE, Checks, lattice_block, new_folder, run

BODY = lattice_block("0 0.012 -0.006 0 0 0.006", "-0.02 0.03 -0.02 0.02 -0.02 0.02", dim=3,
                     more="atom_modify     map array\n") + """
pair_style      sph/tm hyperbolic 1.2 spacing 1e-3 {options}
pair_coeff      1 1 materials.sphtm c45e damage johnson/cook 0.5 1.0 -3.0 0.01 1.0
region          base block INF INF INF -0.004 INF INF units box
group           base region base
"""
FIXES = """
fix             body all sph/tm temperature 300 energy yes
fix             hold base setforce 0 0 0
fix             tool all contact/tri file tool.stl scale 1e-3 move 0.0122 -0.0015 0 friction 0.3 &
                lumped 0.1 480 300 heat conductance 1e5
fix_modify      tool move linear -40 0 0
compute         p all sph/tm/atom temperature pstrain damage vonmises density
thermo          100
thermo_style    custom step time dt f_tool[1] f_tool[2] f_body[1] f_body[9]
"""
DUMP = """
write_dump      all custom {name} id x y z vx vy vz c_p[*] modify format float %.17g
"""
FINISH = "variable f1 equal f_tool[1]\nvariable s equal f_body[9]\nprint 'TOOL $(v_f1:%.17g) SUM $(v_s:%.17g)'\n"
STEPS = 400


def scene(options, ranks):
    folder = new_folder()
    insert = ["insert", "--rake", "10", "--clearance", "7", "--width", "20", "--height", "12", "--length", "8",
              "--radius", "0"]
    subprocess.run([sys.executable, os.path.join(SOURCE, "tools", "make_tool.py"), *insert, "-o",
                    os.path.join(folder, "tool.stl")], check=True, stdout=subprocess.DEVNULL)
    half = STEPS // 2
    fixes = FIXES + "restart %d at.*.restart\n" % half
    whole = run(BODY.format(options=options) + fixes + f"run {STEPS}\n" + DUMP.format(name="whole.dump") + FINISH,
                ranks=ranks, folder=folder)
    run(BODY.format(options=options) + FIXES + f"run {half}\nrun {half}\n" + DUMP.format(name="cut.dump"),
        ranks=ranks, folder=folder)
    again = run(f"newton off\nread_restart at.{half}.restart\n" + FIXES + f"run {half}\n"
                + DUMP.format(name="again.dump") + FINISH, ranks=ranks, folder=folder)
    return whole, again


def text(result, name):
    """Lines of the dump, sorted: exact text of every digit."""
    with open(result.path(name)) as f:
        lines = f.read().splitlines()
    return sorted(lines[next(i for i, l in enumerate(lines) if l.startswith("ITEM: ATOMS")) + 1:])


def difference(a, b):
    return sum(x != y for x, y in zip(a, b)) + abs(len(a) - len(b))


def main():
    checks = Checks()
    for options, ranks in (("", 1), ("viscosity 1 1 balsara yes xsph 0.1 hourglass 0.05", 1), ("stabilize artstress", 1), ("", 2)):
        whole, again = scene(options, ranks)
        one = text(whole, "whole.dump")
        label = f"{options or 'default'}, {ranks} rank{'s' if ranks > 1 else ''}"
        plastic = max(float(l.split()[8]) for l in one)
        checks.true(f"{label}: the scene deforms (plastic strain {plastic:.3f})", plastic > 0.1)
        checks.true(f"{label}: particles that differ after the restart: {difference(one, text(again, 'again.dump'))}",
                    one == text(again, "again.dump"))
        cut = text(whole, "cut.dump")
        checks.true(f"{label}: particles that differ in a run of two halves: {difference(one, cut)}", one == cut)
        last = [r.output[r.output.index("TOOL"):].splitlines()[0] for r in (whole, again)]
        checks.true(f"{label}: tool force and energy sum {last[0]} | {last[1]}",
                    last[0].split()[1] == last[1].split()[1])
    checks.end()


if __name__ == "__main__":
    main()
