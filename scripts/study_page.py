"""What scripts/study.py writes: a page with tables, plots and pictures in one file, and a summary in Markdown."""

import base64
import html
import math
from dataclasses import dataclass

COLOURS = "#c0392b #1f6fb2 #2e8b57 #8e5ea2 #d98200 #555555 #17a2a2 #a0522d".split()
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 760, 340, 64, 250, 34, 52
STYLE = """body{font:15px/1.45 sans-serif;color:#222;max-width:1120px;margin:2em auto;padding:0 1em}
table{border-collapse:collapse;margin:.6em 0 1.6em}td,th{padding:.22em .7em;border-bottom:1px solid #ddd;text-align:right}
th{background:#f4f4f2;text-align:right}td:first-child,th:first-child{text-align:left;white-space:nowrap}
img,svg{max-width:100%}h2{margin-top:2em}"""


@dataclass(frozen=True)
class Study:
    """What the pages are made of."""

    configuration: dict
    scores: dict  # {(case, bias field, noise): {method: Score}}
    surfaces: int
    notes: list

    @property
    def ours(self):
        return self.configuration["ours"]

    def rivals(self, told=True):
        """All, or only those that are not told the truth."""
        methods = self.configuration["methods"]
        return [method["name"] for method in methods if method.get("rival") and (told or not method.get("search"))]

    def main_cases(self):
        return [case for case in self.configuration["cases"] if not case.get("evidence")]


def number(value, digits=3):
    return "lost" if math.isinf(value) else "-" if math.isnan(value) else f"{value:.{digits}f}"


def scan_name(key):
    case, bias, noise = key
    return f"{case}{f', bias {bias:g}' if bias else ''}, noise {noise}"


# --- Who wins


@dataclass(frozen=True)
class Contest:
    """volsurf as it comes against the best rival on one scan."""

    key: tuple
    measure: str
    ours: float
    rival: str
    theirs: float

    @property
    def outcome(self):
        if self.ours == self.theirs:
            return "drawn"
        return "won" if self.ours < self.theirs else "lost"


def contests(study, measure, told=True):
    """One for each scan on which both ran; against the rivals that are not told the truth, or against all."""
    main = {case["name"] for case in study.main_cases()}
    for key, scores in study.scores.items():
        rivals = [name for name in study.rivals(told) if name in scores]
        if key[0] in main and study.ours in scores and rivals:
            best = min(rivals, key=lambda name: getattr(scores[name], measure))
            yield Contest(key, measure, getattr(scores[study.ours], measure), best, getattr(scores[best], measure))


def losses(study):
    """All that volsurf lost, by the factor."""
    both = [contest for measure in ("assd", "hd95") for contest in contests(study, measure)]
    lost = [contest for contest in both if contest.outcome == "lost"]
    return sorted(lost, key=lambda contest: -contest.ours / contest.theirs)


def reason(study, contest):
    """What the configuration says of a case, after looking into it."""
    for remark in study.configuration.get("remarks", []):
        if remark["case"] == contest.key[0] and contest.key[2].startswith(remark.get("noise", "")):
            return remark["text"]
    return ""


# --- Tables, as rows of text that both pages write


def loss_table(study):
    rows = [["scan", "measure", "volsurf", "best rival", "rival's", "why"]]
    for contest in losses(study):
        rows.append([scan_name(contest.key), contest.measure.upper(), number(contest.ours), contest.rival,
                     number(contest.theirs), reason(study, contest)])
    return rows


def win_table(study):
    """A row for each case: how often volsurf won."""
    rows = [["case", "scans", "ASSD won", "HD95 won", "volsurf found nothing"]]
    for case in study.main_cases():
        found = {measure: [c for c in contests(study, measure) if c.key[0] == case["name"]] for measure in ("assd", "hd95")}
        if found["assd"]:
            rows.append([case["name"], str(len(found["assd"])),
                         *(str(sum(c.outcome == "won" for c in found[measure])) for measure in ("assd", "hd95")),
                         str(sum(math.isinf(c.ours) for c in found["assd"]))])
    return rows


def totals(study):
    """Two sentences: against rivals without help, and against those that are told the truth, too."""

    def count(told):
        parts = []
        for measure in ("assd", "hd95"):
            found = list(contests(study, measure, told))
            parts.append(f"{measure.upper()} on {sum(c.outcome == 'won' for c in found)} of {len(found)} scans")
        return " and by ".join(parts)

    return (f"volsurf with its defaults and the automatic delta is nearer to the truth than every rival whose "
            f"level is automatic (Otsu) by {count(False)}. Against rivals that are told the best level, too, it is "
            f"by {count(True)}.")


def case_keys(study, case):
    """The scans of a case, in the order of the configuration."""
    keys = [key for key in study.scores if key[0] == case["name"]]
    return sorted(keys, key=lambda key: (key[1], case["noise"].index(key[2])))


def case_table(study, case, measure):
    """A row for each method, a column for each scan of a case."""
    keys = case_keys(study, case)
    names = list(dict.fromkeys(name for key in keys for name in study.scores[key]))
    rows = [["method", *(f"{key[2]}{f', bias {key[1]:g}' if key[1] else ''}" for key in keys)]]
    for name in names:
        scores = [study.scores[key].get(name) for key in keys]
        rows.append([name, *(number(getattr(score, measure)) if score else "-" for score in scores)])
    return rows


def detail_table(study, case):
    rows = [["scan", "method", "ASSD", "HD95", "bias", "Dice", "volume error", "s", "parameter", "lost"]]
    for key in case_keys(study, case):
        for name, score in study.scores[key].items():
            rows.append([scan_name(key), name, number(score.assd), number(score.hd95), number(score.bias),
                         number(score.dice), number(100 * score.volume_error, 2) + " %", number(score.seconds, 2),
                         ", ".join(score.parameters), f"{score.lost} of {score.seeds}" if score.lost else ""])
    return rows


# --- HTML


def html_table(rows):
    def cells(row, tag):
        return "".join(f"<{tag}>{html.escape(cell)}</{tag}>" for cell in row)

    body = "".join(f"<tr>{cells(row, 'td')}</tr>\n" for row in rows[1:])
    return f"<table><tr>{cells(rows[0], 'th')}</tr>\n{body}</table>"


def html_page(study, pictures):
    """All of it."""
    title = html.escape(study.configuration["title"])
    parts = [f"<!doctype html><html lang=en><meta charset=utf-8><title>{title}</title><style>{STYLE}</style>",
             f"<h1>{title}</h1><p>{html.escape(totals(study))}</p>", *(f"<p>{html.escape(text)}</p>" for text in explained(study))]
    parts += ["<h2>What volsurf lost</h2>", html_table(loss_table(study)) if losses(study) else "<p>Nothing.</p>",
              "<h2>Who is nearer to the truth</h2>", html_table(win_table(study))]
    for case in study.configuration["cases"]:
        parts.append(f"<h2>{html.escape(case['name'])}</h2><p>{html.escape(case.get('about', ''))}</p>")
        parts += [plot(study, case, kind) for kind in ("gaussian", "impulse") if len(points_of(study, case, kind)) > 1]
        parts += ["<p>ASSD in voxels</p>", html_table(case_table(study, case, "assd")),
                  f"<details><summary>All measures</summary>{html_table(detail_table(study, case))}</details>"]
    for caption, png in pictures:
        data = base64.b64encode(png).decode("ascii")
        parts.append(f"<h2>{html.escape(caption)}</h2><img alt='{html.escape(caption)}' src='data:image/png;base64,{data}'>")
    return "\n".join(parts) + "\n</html>\n"


def explained(study):
    """What the numbers are; then what is missing."""
    searched = [method["name"] for method in study.configuration["methods"] if method.get("search")]
    text = ["ASSD is the mean distance between the surfaces over the area of both, HD95 the larger of the two distances "
            "within which 95 % of one surface's area lies, both in voxels (the smallest spacing); docs/metrics.md defines "
            "them. Numbers are means over the seeds. \"lost\": the method found nothing on at least one of them."]
    if searched:
        text.append(f"Told the truth: {', '.join(searched)}. The parameter of these is the one whose ASSD is best, found by "
                    "trying each; no user can do as well. volsurf gets no such help.")
    text.append(f"{study.surfaces} surfaces were measured.")
    return text + study.notes


# --- Plots


def points_of(study, case, kind):
    """Noise in percent and key, without bias, in order; no noise is 0."""
    found = []
    for key in case_keys(study, case):
        if key[1] == 0 and (key[2] == "none" or key[2].startswith(kind)):
            found.append((0.0 if key[2] == "none" else float(key[2].split(":")[1].rstrip("%")), key))
    return sorted(found)


def plot(study, case, kind):
    """ASSD over noise as SVG, on a logarithmic scale; a cross on the upper edge stands for a lost case."""
    points = points_of(study, case, kind)
    names = [name for name in study.scores[points[0][1]]]
    values = [study.scores[key][name].assd for _, key in points for name in names if name in study.scores[key]]
    finite = [value for value in values if 0 < value < math.inf] or [0.1, 1]
    low, high = math.log10(min(finite)) - 0.08, math.log10(max(finite)) + 0.12

    def across(index):
        return LEFT + (WIDTH - LEFT - RIGHT) * index / (len(points) - 1)

    def upward(value):
        return HEIGHT - BOTTOM - (HEIGHT - TOP - BOTTOM) * (math.log10(value) - low) / (high - low)

    parts = [axes(points, across, upward, low, high, kind, case["name"])]
    for index, name in enumerate(names):
        colour, marks, path = COLOURS[index % len(COLOURS)], [], []
        dash = ' stroke-dasharray="6 4"' if index >= len(COLOURS) else ""
        for position, (_, key) in enumerate(points):
            score = study.scores[key].get(name)
            if score is None:
                continue
            x = across(position) + 1.5 * (index - len(names) / 2)
            if math.isinf(score.assd) or score.assd <= 0:
                marks.append(f'<text x="{x:.1f}" y="{TOP + 5}" fill="{colour}" text-anchor="middle" font-size="13">×</text>')
            else:
                y = upward(score.assd)
                path.append(f"{x:.1f},{y:.1f}")
                marks.append(f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>')
        width = 2.6 if name == study.ours else 1.4
        parts.append(f'<polyline points="{" ".join(path)}" fill="none" stroke="{colour}" stroke-width="{width}"{dash}/>')
        y = TOP + 8 + 21 * index
        parts.append(f'<line x1="{WIDTH - RIGHT + 14}" x2="{WIDTH - RIGHT + 38}" y1="{y}" y2="{y}" stroke="{colour}" '
                     f'stroke-width="{width}"{dash}/><text x="{WIDTH - RIGHT + 44}" y="{y + 4}" font-size="12">'
                     f"{html.escape(name)}</text>")
        parts += marks
    return f'<svg viewBox="0 0 {WIDTH} {HEIGHT}" width="{WIDTH}" font-family="sans-serif">{"".join(parts)}</svg>'


def axes(points, across, upward, low, high, kind, name):
    """Frame, ticks and titles."""
    right, bottom = WIDTH - RIGHT, HEIGHT - BOTTOM
    parts = [f'<rect x="{LEFT}" y="{TOP}" width="{right - LEFT}" height="{bottom - TOP}" fill="none" stroke="#999"/>']
    for exponent in range(math.floor(low) - 1, math.ceil(high) + 1):
        for step in (1, 2, 5):
            value = step * 10.0**exponent
            if low <= math.log10(value) <= high:
                y = upward(value)
                parts.append(f'<line x1="{LEFT}" x2="{right}" y1="{y:.1f}" y2="{y:.1f}" stroke="#e4e4e4"/><text '
                             f'x="{LEFT - 6}" y="{y + 4:.1f}" text-anchor="end" font-size="12">{value:g}</text>')
    for index, (level, _) in enumerate(points):
        parts.append(f'<text x="{across(index):.1f}" y="{bottom + 18}" text-anchor="middle" font-size="12">{level:g}</text>')
    unit = "% of the contrast (Gaussian)" if kind == "gaussian" else "% of the samples (impulses)"
    parts.append(f'<text x="{(LEFT + right) / 2}" y="{HEIGHT - 12}" text-anchor="middle" font-size="13">noise, {unit}</text>'
                 f'<text transform="translate(16 {(TOP + bottom) / 2}) rotate(-90)" text-anchor="middle" font-size="13">'
                 f'ASSD in voxels</text><text x="{LEFT}" y="20" font-size="14" font-weight="bold">{html.escape(name)}</text>')
    return "".join(parts)


# --- Markdown


def markdown_table(rows):
    lines = ["| " + " | ".join(rows[0]) + " |", "|---|" + "---:|" * (len(rows[0]) - 1)]
    return "\n".join(lines + ["| " + " | ".join(row) + " |" for row in rows[1:]])


def markdown_page(study):
    """Summary, losses first; the evidence for the defaults last."""
    parts = [f"# {study.configuration['title']}", totals(study), *explained(study),
             "Made by `" + study.configuration["command"] + "`.",
             "## What volsurf lost", markdown_table(loss_table(study)) if losses(study) else "Nothing.",
             "## Who is nearer to the truth", markdown_table(win_table(study))]
    for case in study.configuration["cases"]:
        parts += [f"## {case['name']}", case.get("about", ""), "ASSD in voxels:", markdown_table(case_table(study, case, "assd"))]
        if case.get("evidence"):
            parts += ["HD95 in voxels:", markdown_table(case_table(study, case, "hd95"))]
    return "\n\n".join(part for part in parts if part) + "\n"
