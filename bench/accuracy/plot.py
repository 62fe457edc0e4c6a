"""Pictures of ./sphtm accuracy: error against time, the points of the Pareto front filled and joined."""
import os

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
from matplotlib.ticker import FuncFormatter, LogLocator, NullFormatter

FLOOR = 1e-5    # what is exact but for round-off is drawn there


def sweep_on(axes, sweep, clock, label=None, texts=True):
    time_of = "relative_time" if clock == "wall" else "relative_processor"
    points = [(p[time_of], max(p["error"], FLOOR), p) for p in sweep["points"] if p["error"] is not None]
    best = sorted((t, e) for t, e, p in points if p["front"])
    line, = axes.plot(*zip(*best), "-", lw=1, label=label) if best else axes.plot([], [], label=label)
    for t, e, p in points:
        axes.plot(t, e, "o", ms=5 if p["front"] else 4, color=line.get_color(), mfc=None if p["front"] else "none",
                  alpha=0.9)
        if texts:
            axes.annotate(p["setting"], (t, e), xytext=(4, 3), textcoords="offset points", fontsize=6.5)
    for p in sweep["points"]:
        if p["error"] is None and p["note"] != "the reference" and texts:
            axes.plot(p[time_of], 1.0, "x", color=line.get_color())
            axes.annotate(p["setting"] + ": broke", (p[time_of], 1.0), xytext=(4, 3), textcoords="offset points",
                          fontsize=6.5)
    axes.set(xscale="log", yscale="log")
    for axis, text in ((axes.xaxis, lambda t, _: "%g" % t), (axes.yaxis, lambda e, _: "%g %%" % (100 * e))):
        axis.set_major_locator(LogLocator(subs=(1, 2, 5), numticks=8))
        axis.set_major_formatter(FuncFormatter(text))
        axis.set_minor_formatter(NullFormatter())
    low, high = axes.get_xlim()
    if high < 2 * low:    # room for readable numbers
        axes.set_xlim(low / 1.3, high * 1.3)
    axes.grid(True, which="major", color="0.9", lw=0.6)


def one(name, knob, out, clock):
    sweeps = knob["sweeps"]
    figure, axes = plt.subplots(1, len(sweeps), figsize=(1 + 4.2 * len(sweeps), 3.8), squeeze=False)
    for ax, (label, sweep) in zip(axes[0], sweeps.items()):
        sweep_on(ax, sweep, clock)
        slope = "" if sweep["order"] is None else ", order %.1f" % sweep["order"]
        ax.set(title="%s\nagainst %s%s" % (sweep["quantity"], sweep["kind"], slope), ylabel="relative error",
               xlabel="%s time over '%s'" % (clock, sweep["baseline"]))
        ax.margins(x=0.22, y=0.15)
    figure.suptitle(knob["title"], fontsize=10)
    figure.tight_layout()
    figure.savefig(os.path.join(out, name + ".png"), dpi=130)
    plt.close(figure)


def overview(knobs, out, clock):
    names = [n for n in sorted(knobs) if knobs[n]["sweeps"]]
    if not names:
        return
    columns = min(4, len(names))
    rows = -(-len(names) // columns)
    figure, axes = plt.subplots(rows, columns, figsize=(3.2 * columns, 2.7 * rows), squeeze=False)
    for ax in axes.flat[len(names):]:
        ax.axis("off")
    for ax, name in zip(axes.flat, names):
        for label, sweep in knobs[name]["sweeps"].items():
            sweep_on(ax, sweep, clock, label, texts=False)
        for target in (0.01, 0.05, 0.1):
            ax.axhline(target, color="0.75", lw=0.6, ls=":")
        ax.set(title=knobs[name]["title"])
        ax.legend(frameon=False, fontsize=6)
    figure.supxlabel("%s time over that of the sweep's baseline" % clock, fontsize=9)
    figure.supylabel("relative error", fontsize=9)
    figure.tight_layout()
    figure.savefig(os.path.join(out, "overview.png"), dpi=130)
    plt.close(figure)


def draw(knobs, names, out, clock):
    plt.rcParams.update({"font.size": 8, "axes.titlesize": 8})
    for name in names:
        if knobs[name]["sweeps"]:
            one(name, knobs[name], out, clock)
    overview(knobs, out, clock)
