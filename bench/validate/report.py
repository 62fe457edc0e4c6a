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
    except (KeyError, TypeError):
        return None
    return b - a


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
        measured, scatter = case.ROWS[row]["reference"][quantity]
        answer["quantities"][quantity] = {
            "value": value, "measured": measured, "scatter": scatter, "error": value / measured - 1, "window": window, "mesh": mesh,
            "scaling": scaling, "uncertainty": math.sqrt(sum((u or 0) ** 2 for u in (window, mesh, scaling)))}
    return answer


def mean_errors(case, answers):
    """Setting -> quantity -> mean of the absolute relative errors, their mean with sign, over how many rows."""
    found = {}
    for setting in case.SETTINGS:
        for quantity in case.COMPARED:
            errors = [answers[row][setting]["quantities"][quantity][0] / case.ROWS[row]["reference"][quantity][0] - 1
                      for row in case.ROWS if quantity in answers[row].get(setting, {}).get("quantities", {})]
            if errors:
                found.setdefault(setting, {})[quantity] = [statistics.mean(abs(e) for e in errors), statistics.mean(errors), len(errors)]
    return found


def of_case(case, answers):
    rows = {row: of_row(case, row, answers[row]) for row in case.ROWS}
    return {"title": case.TITLE, "choices": case.__doc__, "rows": {k: v for k, v in rows.items() if v},
            "mean_errors": mean_errors(case, answers)}


def results(case, summary):
    """For the table of results: setting -> quantity -> mean absolute and mean error in percent, rows."""
    return {setting: dict({"rows": max(e[2] for e in errors.values())},
                          **{q.replace(" ", "_"): {"absolute": 100 * e[0], "mean": 100 * e[1]} for q, e in errors.items()})
            for setting, errors in summary["mean_errors"].items()}


def cell(q, unit):
    return "%.3g +- %.2g" % (q["value"], q["uncertainty"]), "%.3g +- %.2g" % (q["measured"], q["scatter"]), "%+.0f %%" % (100 * q["error"])


def text(name, case, summary):
    """For the terminal."""
    lines = ["", "%s: %s, here at the finest spacing" % (name, case.REFERENCE)]
    for row, answer in summary["rows"].items():
        for quantity, q in answer["quantities"].items():
            lines.append("  %-18s %-14s %-18s measured %-16s %s" % ((case.ROWS[row]["title"], quantity) + cell(q, case.COMPARED[quantity][0])))
    lines.append("  mean absolute error (goal), mean error, rows")
    for setting, errors in summary["mean_errors"].items():
        lines.append("  %-46s %s" % (case.SAID[setting], ", ".join("%s %.0f %% (%.0f) %+.0f %% %d" % (
            q, 100 * e[0], 100 * case.COMPARED[q][1], 100 * e[1], e[2]) for q, e in errors.items())))
    return "\n".join(lines)


def rst_rows(rows):
    lines = [".. list-table::", "   :header-rows: 1", ""]
    for row in rows:
        lines += ["   * - " + row[0]] + ["     - " + v for v in row[1:]]
    return lines + [""]


def table(case, summary):
    """For doc/validation.rst: misses first."""
    head = ["row"] + ["%s%s, measured, error" % (q, ", " + u if u else "") for q, (u, _) in case.COMPARED.items()]
    worst = lambda item: -max([abs(q["error"]) / case.COMPARED[k][1] for k, q in item[1]["quantities"].items()] or [0])
    rows = [head]
    for row, answer in sorted(summary["rows"].items(), key=worst):
        rows.append([case.ROWS[row]["title"]] + ["%s; %s; %s" % cell(answer["quantities"][q], u) if q in answer["quantities"] else "no chip yet"
                                                 for q, (u, _) in case.COMPARED.items()])
    lines = rst_rows(rows)
    lines += rst_rows([["setting", "rows"] + ["%s, mean absolute and mean error" % q for q in case.COMPARED]] + [
        [case.SAID[s], "%d" % max(v[2] for v in e.values())] +
        ["%.0f %%, %+.0f %%" % (100 * e[q][0], 100 * e[q][1]) if q in e else "-" for q in case.COMPARED]
        for s, e in summary["mean_errors"].items()])
    return "\n".join(lines)


def draw(case, summary, path):
    """Computed over measured, a panel for each quantity."""
    try:
        import matplotlib
    except ImportError:
        return
    matplotlib.use("Agg")
    import matplotlib.pyplot as plt
    plt.rcParams.update({"font.size": 9})
    figure, axes = plt.subplots(1, len(case.COMPARED), figsize=(4.2 * len(case.COMPARED), 4), squeeze=False, constrained_layout=True)
    for ax, (quantity, (unit, goal)) in zip(axes[0], case.COMPARED.items()):
        points = [(row, a["quantities"][quantity]) for row, a in summary["rows"].items() if quantity in a["quantities"]]
        top = 1.15 * max([max(q["measured"] + q["scatter"], q["value"] + q["uncertainty"]) for _, q in points] or [1])
        ax.plot([0, top], [0, top], color="0.3", lw=1)
        ax.fill_between([0, top], [0, top * (1 - goal)], [0, top * (1 + goal)], color="0.9", lw=0, label="goal, %.0f %%" % (100 * goal))
        for k, (row, q) in enumerate(points):
            ax.errorbar(q["measured"], q["value"], xerr=q["scatter"], yerr=q["uncertainty"], fmt="o", ms=5, capsize=2, lw=1,
                        label=case.ROWS[row]["title"], color=plt.cm.viridis(k / max(1, len(points) - 1)))
        ax.set(xlim=(0, top), ylim=(0, top), aspect="equal", xlabel="measured%s" % (", " + unit if unit else ""), ylabel="computed",
               title=quantity)
        ax.spines[["top", "right"]].set_visible(False)
    axes[0][-1].legend(frameon=False, fontsize=7, loc="lower right")
    figure.savefig(path, dpi=110)
    plt.close(figure)
