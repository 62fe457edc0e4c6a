"""Answers that the project keeps, doc/validation/CASE.json, and their tables in doc/validation.rst.

A table stands between the comments '.. table CASE KIND' and '.. end'; KIND is rows, spacings or settings, or CASE KIND are 'all
overview'."""
import json
import os
import re

import report

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
FOLDER, PAGE = os.path.join(ROOT, "doc", "validation"), os.path.join(ROOT, "doc", "validation.rst")
KEPT = ("mark", "error", "quantities", "seconds", "particles", "steps", "commit", "date", "lmp")
TABLES = {"rows": report.rows_table, "spacings": report.spacings_table, "settings": report.settings_table}
PLACE = re.compile(r"^\.\. table (\S+) (\S+)\n.*?^\.\. end$", re.M | re.S)


def rounded(value):
    return float("%.6g" % value) if isinstance(value, float) else [rounded(v) for v in value] if isinstance(value, list) else value


def kept(name):
    """row -> setting -> answer, of a case."""
    try:
        with open(os.path.join(FOLDER, name + ".json")) as f:
            return json.load(f)
    except OSError:
        return {}


def keep(name, answers):
    """Takes answers in, beside those that are there of other rows and settings."""
    found = kept(name)
    for row, settings in answers.items():
        for setting, a in settings.items():
            found.setdefault(row, {})[setting] = {k: {q: rounded(v) for q, v in a[k].items()} if k == "quantities" else a[k] for k in KEPT if k in a}
    if not any(found.values()):
        return
    os.makedirs(FOLDER, exist_ok=True)
    with open(os.path.join(FOLDER, name + ".json"), "w") as f:
        lines = ["%s: {%s}" % (json.dumps(row), ",".join("\n  %s: %s" % (json.dumps(s), json.dumps(a)) for s, a in sorted(settings.items())))
                 for row, settings in sorted(found.items()) if settings]
        f.write("{" + ",\n ".join(lines) + "}\n")


def written(text, cases, summaries):
    """The page with its tables made anew."""
    def one(match):
        name, kind = match.groups()
        if kind == "overview":
            return ".. table all overview\n\n" + "\n".join(report.overview(cases, summaries)) + "\n.. end"
        if name not in summaries:
            return match.group()
        head = ".. table %s %s\n\n" % (name, kind)
        return head + "\n".join(TABLES[kind](cases[name], summaries[name])) + "\n.. end"

    return PLACE.sub(one, text)


def write(cases, summaries):
    with open(PAGE) as f:
        text = f.read()
    with open(PAGE, "w") as f:
        f.write(written(text, cases, summaries))


def stale(cases, summaries):
    with open(PAGE) as f:
        text = f.read()
    return written(text, cases, summaries) != text
