"""What ./sphtm validate prints: errors and uncertainties of a case, a table, a picture."""
import math
import statistics


def line(answer):
    found = ", ".join("%s %.4g" % (k, v[0]) for k, v in answer["quantities"].items())
    return "%s; %d particles, %d steps, %.0f s" % (found, answer["particles"], answer["steps"], answer["seconds"])


def finest(case, settings):
    """The finest spacing of which there is an answer."""
    there = [s for s in case.MESH if "quantities" in settings.get(s, {})]
    return there[-1] if there else None


def difference(settings, pair, quantity):
    """Of a quantity between two settings, or None."""
    try:
        a, b = (settings[s]["quantities"][quantity][0] for s in pair)
    except (KeyError, TypeError, ValueError):    # no such pair, setting or quantity
        return None
    return b - a


def order(sizes, values):
    """Of convergence, from three spacings (coarse to fine) and their values, a + b size^order; None where they are not monotonic or
    no order up to 8 does it."""
    if len(values) < 3 or (values[0] - values[1]) * (values[1] - values[2]) <= 0:
        return None
    ratio, (x, y, z) = (values[0] - values[1]) / (values[1] - values[2]), sizes
    of = lambda p: (x ** p - y ** p) / (y ** p - z ** p)
    low, high = 0.01, 8.0
    if not of(low) < ratio < of(high):
        return None
    for _ in range(60):
        p = 0.5 * (low + high)
        low, high = (p, high) if of(p) < ratio else (low, p)
    return p


def of_row(case, row, settings):
    """The value at the finest spacing beside the reference. Uncertainty: what the last halving of the spacing changed, what the
    scaling of time changes, the error of the mean over the window (all of them one, their squares added)."""
    best = finest(case, settings)
    if not best:
        return None
    answer = {"setting": best, "seconds": settings[best]["seconds"], "particles": settings[best]["particles"], "commit": settings[best]["commit"],
              "date": settings[best]["date"], "quantities": {}, "all": {s: a.get("quantities", a["error"]) for s, a in settings.items()}}
    for quantity in case.COMPARED:
        if quantity not in settings[best]["quantities"]:
            continue
        value, window = settings[best]["quantities"][quantity]
        place = case.MESH.index(best)
        mesh = difference(settings, case.MESH[place - 1:place + 1], quantity) if place else None
        scaling = difference(settings, case.SCALING, quantity)
        measured, scatter = case.ROWS[row]["reference"].get(quantity, (None, None))
        answer["quantities"][quantity] = {
            "value": value, "measured": measured, "scatter": scatter, "error": value / measured - 1 if measured else None, "window": window,
            "mesh": mesh, "scaling": scaling, "uncertainty": math.sqrt(sum((u or 0) ** 2 for u in (window, mesh, scaling)))}
    return answer


def mean_errors(case, answers):
    """Setting -> quantity -> mean of the absolute relative errors, their mean with sign, over how many rows."""
    found = {}
    for setting in case.SETTINGS:
        for quantity in case.COMPARED:
            errors = [answers[row][setting]["quantities"][quantity][0] / case.ROWS[row]["reference"][quantity][0] - 1
                      for row in case.ROWS if quantity in answers[row].get(setting, {}).get("quantities", {})
                      and quantity in case.ROWS[row]["reference"]]
            if errors:
                found.setdefault(setting, {})[quantity] = [statistics.mean(abs(e) for e in errors), statistics.mean(errors), len(errors)]
    return found


def of_case(case, answers):
    rows = {row: of_row(case, row, answers[row]) for row in case.ROWS}
    stopped = {s: sum(bool(answers[row].get(s, {}).get("error")) for row in case.ROWS) for s in case.SETTINGS}
    return {"stopped": {s: n for s, n in stopped.items() if n}, "title": case.TITLE, "choices": case.__doc__, "rows": {k: v for k, v in rows.items() if v},
            "mean_errors": mean_errors(case, answers)}


def results(name, case, summary):
    """For the table of results: setting -> quantity -> mean absolute and mean error in percent, rows; values by row; when they were made."""
    found = {setting: dict({"rows": max(e[2] for e in errors.values())},
                           **{q.replace(" ", "_"): {"absolute": 100 * e[0], "mean": 100 * e[1]} for q, e in errors.items()})
             for setting, errors in summary["mean_errors"].items()}
    made = {k: "; ".join(sorted({a[k] for a in summary["rows"].values()})) for k in ("commit", "date")}
    return dict(found, command="./sphtm validate " + name, **made, values={row: {q.replace(" ", "_"): v["value"] for q, v in a["quantities"].items()} for row, a in summary["rows"].items()})


def cell(q):
    """Value, reference and error as text; without a reference, the value."""
    value = "%.4g" % q["value"] + (" +- %.2g" % q["uncertainty"] if q["uncertainty"] else "")
    if q["measured"] is None:
        return (value,)
    return value, "%.4g" % q["measured"] + (" +- %.2g" % q["scatter"] if q["scatter"] else ""), "%+.*f %%" % (
        0 if abs(q["error"]) > 0.095 else 1, 100 * q["error"])


def text(name, case, summary):
    """For the terminal."""
    lines = ["", "%s: %s, here at the finest spacing" % (name, case.REFERENCE)]
    for row, answer in summary["rows"].items():
        for quantity, q in answer["quantities"].items():
            lines.append("  %-18s %-14s %-18s %s" % (case.ROWS[row]["title"], quantity, cell(q)[0], "reference %-16s %s" % cell(q)[1:]
                                                     if q["measured"] is not None else "no reference"))
    lines.append("  mean absolute error (goal), mean error, rows")
    for setting, errors in summary["mean_errors"].items():
        lines.append("  %-46s %s" % (case.SAID[setting], ", ".join("%s %.1f %% (%.0f) %+.1f %% %d" % (
            q, 100 * e[0], 100 * case.COMPARED[q][1], 100 * e[1], e[2]) for q, e in errors.items())))
    return "\n".join(lines)


def rst_rows(rows):
    if len(rows) < 2:
        return ["(No run of it is kept.)", ""]
    lines = [".. list-table::", "   :header-rows: 1", ""]
    for row in rows:
        lines += ["   * - " + row[0]] + ["     - " + v for v in row[1:]]
    return lines + [""]


def titled(case, quantity):
    unit = case.COMPARED[quantity][0]
    return quantity + (", " + unit if unit else "")


def rows_table(case, summary):
    """Values at the finest spacing, the worst row first."""
    worst = lambda item: -max([abs(q["error"]) / case.COMPARED[k][1] for k, q in item[1]["quantities"].items() if q["error"] is not None] or [0])
    rows = [["row"] + ["%s; reference; error" % titled(case, q) for q in case.COMPARED]]
    for row, answer in sorted(summary["rows"].items(), key=worst):
        rows.append([case.ROWS[row]["title"]] + ["; ".join(cell(answer["quantities"][q])) if q in answer["quantities"] else "-" for q in case.COMPARED])
    made = sorted({(a["commit"], a["date"], case.SAID[a["setting"]]) for a in summary["rows"].values()})
    return rst_rows(rows) + ["Each at the finest spacing that was run (%s): commit %s." % (
        "; ".join(sorted({s for _, _, s in made})), "; ".join(sorted({"%s, %s" % (c, d) for c, d, _ in made}))), ""]


def spacings_table(case, summary):
    """Values of each spacing, with the order that three of them give."""
    rows = [["row", "quantity"] + [case.SAID[s] for s in case.MESH] + ["order"]]
    for row, answer in summary["rows"].items():
        for quantity in case.COMPARED:
            values = [answer["all"].get(s) for s in case.MESH]
            values = [v[quantity][0] if isinstance(v, dict) and quantity in v else None for v in values]
            there = [(case.SPACING[s], v) for s, v in zip(case.MESH, values) if v is not None][-3:]
            p = order(*zip(*there)) if len(there) == 3 else None
            if there:
                rows.append([case.ROWS[row]["title"], titled(case, quantity)] + ["-" if v is None else "%.4g" % v for v in values] +
                            ["-" if p is None else "%.1f" % p])
    return rst_rows(rows)


def settings_table(case, summary):
    """Variants: mean errors over their rows; where there is but one row with a reference, value and error."""
    rows = [["setting", "rows"] + ["%s, mean absolute and mean error" % q for q in case.COMPARED]]
    for setting, errors in summary["mean_errors"].items():
        rows.append([case.SAID[setting], "%d" % max(v[2] for v in errors.values())] + [
            "-" if q not in errors else "%+.1f %%" % (100 * errors[q][1]) if errors[q][2] == 1 else
            "%.1f %%, %+.1f %%" % (100 * errors[q][0], 100 * errors[q][1]) for q in case.COMPARED])
    stopped = [[case.SAID[s], "%d" % n] + ["stopped"] * len(case.COMPARED) for s, n in summary["stopped"].items()]
    return rst_rows(rows + stopped)


def overview(cases, summaries):
    """Of all cases: mean absolute error of each quantity at the finest spacing of each row, the largest over its goal first."""
    found = []
    for name, summary in summaries.items():
        for quantity, (_, goal) in cases[name].COMPARED.items():
            errors = [a["quantities"][quantity]["error"] for a in summary["rows"].values() if a["quantities"].get(quantity, {}).get("error") is not None]
            if errors:
                mean = statistics.mean(abs(e) for e in errors)
                found.append((mean / goal, [cases[name].TITLE, quantity, "%d" % len(errors), "%.2g %%" % (100 * mean) if mean < 0.995 else "%.0f %%" % (100 * mean), "%+.2g %%" % (100 * statistics.mean(errors)),
                                            "%g %%" % (100 * goal), "missed" if mean > goal else "met", cases[name].REFERENCE]))
    return rst_rows([["case", "quantity", "rows", "mean absolute error", "mean error", "goal", "", "reference"]] + [
        row for _, row in sorted(found, key=lambda item: -item[0])])


def table(case, summary):
    """For doc/validation.rst."""
    return "\n".join(rows_table(case, summary) + spacings_table(case, summary) + settings_table(case, summary))


def draw(case, summary, path):
    try:
        import matplotlib
    except ImportError:
        return
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    plt.rcParams.update({"font.size": 9})
    figure = (draw_values if len(summary["rows"]) > 5 else draw_ratios)(plt, case, summary)
    figure.savefig(path, dpi=110)
    plt.close(figure)


def draw_ratios(plt, case, summary):
    """Value over reference at each spacing, and of the variants."""
    points = [(row, q, v) for row, a in summary["rows"].items() for q, v in a["quantities"].items() if v["measured"] is not None]
    figure, ax = plt.subplots(figsize=(7.5, 1.3 + 0.42 * max(1, len(points))), constrained_layout=True)
    settings = [s for s in case.SETTINGS if any(isinstance(summary["rows"][row]["all"].get(s), dict) for row, _, _ in points)]
    colors = dict(zip(case.MESH, plt.cm.viridis([0.75, 0.45, 0.1, 0.0][-len(case.MESH):])))
    for k, (row, quantity, v) in enumerate(points):
        ax.barh(k, 2 * case.COMPARED[quantity][1], left=1 - case.COMPARED[quantity][1], height=0.8, color="0.93")
        if v["scatter"]:
            ax.errorbar(1, k, xerr=v["scatter"] / v["measured"], fmt="none", ecolor="0.4", capsize=4)
        for s in settings:
            found = summary["rows"][row]["all"].get(s)
            if isinstance(found, dict) and quantity in found:
                ax.plot(found[quantity][0] / v["measured"], k, "o" if s in colors else "x", color=colors.get(s, "tab:red"), ms=6 if s in colors else 4)
    for s in case.MESH:
        if s in settings:
            ax.plot([], [], "o", color=colors[s], label=case.SAID[s])
    ax.plot([], [], "x", color="tab:red", label="variants")
    ax.axvline(1, color="0.3", lw=1)
    ax.set(yticks=range(len(points)), yticklabels=["%s: %s" % (case.ROWS[row]["title"], q) for row, q, _ in points], ylim=(len(points) - 0.5, -0.5),
           xlabel="computed over reference; gray: goal and scatter", title=case.TITLE)
    ax.spines[["top", "right"]].set_visible(False)
    ax.legend(frameon=False, fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
    return figure


def draw_values(plt, case, summary):
    """Computed over measured, a panel for each quantity."""
    figure, axes = plt.subplots(1, len(case.COMPARED), figsize=(4.2 * len(case.COMPARED), 4), squeeze=False, constrained_layout=True)
    for ax, (quantity, (unit, goal)) in zip(axes[0], case.COMPARED.items()):
        points = [(row, a["quantities"][quantity]) for row, a in summary["rows"].items()
                  if a["quantities"].get(quantity, {"measured": None})["measured"] is not None]
        values = [v for _, q in points for v in (q["measured"] + q["scatter"], q["measured"] - q["scatter"], q["value"])] or [0, 1]
        low, top = 0.9 * min(values), 1.1 * max(values)
        ax.plot([low, top], [low, top], color="0.3", lw=1)
        ax.fill_between([low, top], [low * (1 - goal), top * (1 - goal)], [low * (1 + goal), top * (1 + goal)], color="0.9", lw=0, label="goal, %.0f %%" % (100 * goal))
        for k, (row, q) in enumerate(points):
            ax.errorbar(q["measured"], q["value"], xerr=q["scatter"], yerr=q["uncertainty"], fmt="o", ms=5, capsize=2, lw=1,
                        label=case.ROWS[row]["title"], color=plt.cm.viridis(k / max(1, len(points) - 1)))
        ax.set(xlim=(low, top), ylim=(low, top), aspect="equal", xlabel="measured%s" % (", " + unit if unit else ""), ylabel="computed",
               title=quantity)
        ax.spines[["top", "right"]].set_visible(False)
    axes[0][-1].legend(frameon=False, fontsize=7, loc="center left", bbox_to_anchor=(1, 0.5))
    return figure
