"""The plots of scripts/study.py, as SVG."""

import html
import math

from study_tables import case_keys

COLOURS = "#c0392b #1f6fb2 #2e8b57 #8e5ea2 #d98200 #555555 #17a2a2 #a0522d".split()
WIDTH, HEIGHT, LEFT, RIGHT, TOP, BOTTOM = 760, 340, 64, 250, 34, 52


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
    rivals = study.rivals()
    names = [name for name in study.scores[points[0][1]] if name == study.ours or name in rivals]
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
