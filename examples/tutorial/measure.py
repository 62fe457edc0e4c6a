#!/usr/bin/python3
"""The numbers of the tutorial, from the files that its steps leave in this folder: measure.py prints those that are there.
unittest/scenes/test_tutorial.py holds them against doc/Tutorial.rst."""
import csv
import os

import numpy as np

WINDOW = 9    # samples of 100 steps over which the force of the milling cutter is smoothed


def mean(table, column, first, last):
    """Of a column between two values of the length of cut in column 1."""
    use = (table[:, 1] >= first) & (table[:, 1] <= last)
    return table[use, column].mean()


def bar(folder):
    t = np.loadtxt(os.path.join(folder, "stress.dat"))
    return {"nominal stress at a strain of 0.02": 1e-6 * np.interp(0.02, t[:, 1], t[:, 2]),
            "nominal stress at a strain of 0.08": 1e-6 * np.interp(0.08, t[:, 1], t[:, 2])}


def cut(folder):
    t = np.loadtxt(os.path.join(folder, "force.dat"))
    return {"mean cutting force from 0.2 to 0.4 mm": 1e-3 * mean(t, 2, 0.2e-3, 0.4e-3),
            "mean thrust from 0.2 to 0.4 mm": 1e-3 * mean(t, 3, 0.2e-3, 0.4e-3)}


def heat(folder):
    t = np.loadtxt(os.path.join(folder, "heat.dat"))
    last = t[-5:].mean(0)
    return {"hottest particle of the tool at 0.4 mm": last[5],
            "heat in the tool at 0.4 mm": last[6],
            "heat in the tool over the work of cutting": 100 * last[6] / last[7]}


def mill(folder):
    t = np.loadtxt(os.path.join(folder, "mill.dat"))
    smooth = np.convolve(np.hypot(t[:, 2], t[:, 3]), np.ones(WINDOW) / WINDOW, "same")
    most = np.argmax(smooth)
    travel = np.radians(t[0, 1] - t[:, 1])    # of the cutter
    return {"largest force, smoothed": 1e-3 * smooth[most],
            "angle of the edge above the bottom at that force": t[most, 1],
            "work of one tooth": (np.diff(travel) * (t[1:, 4] + t[:-1, 4]) / 2).sum()}


def study(folder):
    with open(os.path.join(folder, "study.csv")) as f:
        rows = list(csv.reader(f))[1:]
    return {"cutting force with friction %s" % row[0]: float(row[1]) for row in rows}


STEPS = (("stress.dat", bar), ("force.dat", cut), ("heat.dat", heat), ("mill.dat", mill), ("study.csv", study))

if __name__ == "__main__":
    for name, step in STEPS:
        if os.path.exists(name):
            for what, value in step(".").items():
                print("%-52s %.4g" % (what, value))
