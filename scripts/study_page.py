"""What scripts/study.py writes: a page with tables, plots and pictures in one file, and a summary in Markdown."""

import base64
import html

from study_plot import plot, points_of
from study_tables import (
    about,
    bar_table,
    default_table,
    detail_table,
    loss_table,
    losses,
    tables_of,
    totals,
    win_table,
)

STYLE = """body{font:15px/1.45 sans-serif;color:#222;max-width:1180px;margin:2em auto;padding:0 1em}
table{border-collapse:collapse;margin:.6em 0 1.6em;font-size:13.5px;display:block;overflow-x:auto}
td,th{padding:.22em .7em;border-bottom:1px solid #ddd;text-align:right}
th{background:#f4f4f2;text-align:right}td:first-child,th:first-child{text-align:left;white-space:nowrap}
tr.ours td{font-weight:bold;background:#fbf3ee}
img,svg{max-width:100%}img{display:block;margin:.5em 0}h2{margin-top:2em}summary{cursor:pointer}"""


def explained(study):
    """What the numbers are; then what is missing."""
    told = [method["name"] for method in study.configuration["methods"] if method.get("told")]
    text = ["ASSD is the mean distance between the surfaces over the area of both, HD95 the larger of the two distances "
            "within which 95 % of one surface's area lies, both in voxels (the smallest spacing); docs/metrics.md defines "
            "them. Noise is in percent of the contrast (gaussian), or of the samples that take any value of the scan's "
            "range (impulse). Numbers are means over the seeds. \"lost\": the method found nothing on at least one of "
            "them."]
    if told:
        text.append(f"Told the truth: {', '.join(told)}. The parameter of these is the one whose surface is nearest by the "
                    "mean distance, found by trying many; no user can do as well. volsurf gets no such help.")
    if any(method.get("blur") for method in study.configuration["methods"]):
        text.append("\"Gaussian +\": after the Gaussian that volsurf's gradient takes by default on the same scan, as its "
                    "report tells it.")
    if any(case.get("real") for case in study.configuration["cases"]):
        text.append("Real scans are measured against labels. Labels are bound to samples: their own surface is 0.14 voxels "
                    "from the body that they stand for (docs/metrics.md), so that a distance, or a lead, below about 0.15 "
                    "voxels says nothing there.")
    text.append(f"{study.surfaces} surfaces were measured{f' with {study.version}' if study.version else ''}.")
    return text + study.notes


def head_sections(study):
    """Titles, texts and tables that come before the cases, in both pages."""
    sections = [("What volsurf lost", "The reason is what other options of volsurf gave on the same scan.",
                 loss_table(study)) if losses(study) else ("What volsurf lost", "Nothing.", None),
                ("Who is nearer to the truth", "Against all rivals, those that are told the best level, too.", win_table(study)),
                ("The bars for the sphere", "The distance of the surface's vertices from the truth, root mean square, in "
                 "voxels, and the volume: the worst seed of each.", bar_table(study)),
                ("The evidence for the defaults", "Means over the phantoms' scans, in voxels.", default_table(study))]
    return [section for section in sections if section[2] is None or len(section[2]) > 1]


# --- HTML


def html_table(rows, ours=""):
    def cells(row, tag):
        return "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in row)

    body = "".join(f"<tr{' class=ours' if row[0] == ours else ''}>{cells(row, 'td')}</tr>\n" for row in rows[1:])
    return f"<table><tr>{cells(rows[0], 'th')}</tr>\n{body}</table>"


def html_case(study, case):
    parts = [f"<h2>{html.escape(case['name'])}</h2><p>{html.escape(about(study, case))}</p>"]
    parts += [plot(study, case, kind) for kind in ("gaussian", "impulse") if len(points_of(study, case, kind)) > 1]
    for title, rows in tables_of(study, case):
        parts += [f"<p>{html.escape(title)}</p>", html_table(rows, study.ours)]
    return [*parts, f"<details><summary>All measures</summary>{html_table(detail_table(study, case))}</details>"]


def html_figure(figure):
    parts = [f"<h2>{html.escape(figure.title)}</h2><p>{html.escape(figure.about)}</p>"]
    for png in figure.rows:
        data = base64.b64encode(png).decode("ascii")
        parts.append(f"<img alt='{html.escape(figure.title)}' src='data:image/png;base64,{data}'>")
    return parts


def html_page(study, figures):
    """All of it."""
    title = html.escape(study.configuration["title"])
    parts = [f"<!doctype html><html lang=en><meta charset=utf-8><title>{title}</title><style>{STYLE}</style>",
             f"<h1>{title}</h1>", *(f"<p>{html.escape(text)}</p>" for text in [totals(study), *explained(study)])]
    for heading, text, rows in head_sections(study):
        parts += [f"<h2>{heading}</h2><p>{html.escape(text)}</p>", html_table(rows) if rows else ""]
    for figure in figures:
        parts += html_figure(figure)
    for case in study.configuration["cases"]:
        parts += html_case(study, case)
    return "\n".join(parts) + "\n</html>\n"


# --- Markdown


def markdown_table(rows):
    lines = ["| " + " | ".join(rows[0]) + " |", "|---|" + "---:|" * (len(rows[0]) - 1)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows[1:]])


def markdown_page(study):
    """Summary, losses first."""
    parts = [f"# {study.configuration['title']}", totals(study), *explained(study),
             "Made by `" + study.configuration["command"] + "`."]
    for heading, text, rows in head_sections(study):
        parts += [f"## {heading}", text, markdown_table(rows) if rows else ""]
    for case in study.configuration["cases"]:
        parts += [f"## {case['name']}", about(study, case)]
        for title, rows in tables_of(study, case):
            parts += [title + ":", markdown_table(rows)]
    return "\n\n".join(part for part in parts if part) + "\n"
