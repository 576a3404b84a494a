"""What the measurements of scripts/study.py say: who is nearer to the truth, and tables as rows of text."""

import math
from dataclasses import dataclass
from statistics import fmean

MEASURES = ("assd", "hd95")


@dataclass(frozen=True)
class Study:
    """What the pages are made of."""

    configuration: dict
    scores: dict  # {(case, bias field, noise): {method: Score}}
    surfaces: int
    notes: list
    version: str = ""

    @property
    def ours(self):
        return self.configuration["ours"]

    def rivals(self, told=True):
        """All, or only those that are not told the truth."""
        methods = self.configuration["methods"]
        return [method["name"] for method in methods if method.get("rival") and (told or not method.get("told"))]

    def case(self, name):
        return next((case for case in self.configuration["cases"] if case["name"] == name), {})


def number(value, digits=3):
    return "lost" if math.isinf(value) else "-" if math.isnan(value) else f"{value:.{digits}f}"


def scan_name(key):
    case, bias, noise = key
    return f"{case}{f', bias {bias:g}' if bias else ''}, noise {noise}"


def case_keys(study, case):
    """The scans of a case, in the order of the configuration."""
    keys = [key for key in study.scores if key[0] == case["name"]]
    return sorted(keys, key=lambda key: (key[1], case["noise"].index(key[2])))


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

    @property
    def behind(self):
        return self.ours - self.theirs if not math.isinf(self.theirs) else -math.inf

    @property
    def is_noisy(self):
        return self.key[2] != "none"


def contests(study, measure, told=True):
    """One for each scan on which both ran; against the rivals that are not told the truth, or against all."""
    for key, scores in study.scores.items():
        rivals = [name for name in study.rivals(told) if name in scores]
        if study.ours in scores and rivals:
            best = min(rivals, key=lambda name: getattr(scores[name], measure))
            yield Contest(key, measure, getattr(scores[study.ours], measure), best, getattr(scores[best], measure))


def losses(study):
    """All that volsurf lost, the noisy scans before those without noise, by how far it is behind."""
    both = [contest for measure in MEASURES for contest in contests(study, measure)]
    lost = [contest for contest in both if contest.outcome == "lost"]
    return sorted(lost, key=lambda contest: (not contest.is_noisy, -contest.behind))


def reason(study, contest):
    """What was measured of volsurf with other options on the same scan: the nearest of them, if it is nearer."""
    scores = study.scores[contest.key]
    values = {method["name"]: getattr(scores[method["name"]], contest.measure)
              for method in study.configuration["methods"] if method.get("variant") and method["name"] in scores}
    nearest = min(values, key=values.get, default=None)
    if nearest is None:
        return "nothing else was measured"
    if not values[nearest] < contest.ours:
        return "none of volsurf's options tried here is nearer"
    text = next(method["variant"] for method in study.configuration["methods"] if method["name"] == nearest)
    verdict = "nearer than the rival" if values[nearest] < contest.theirs else "the rival is nearer still"
    return f"{text} ({nearest}) gives {number(values[nearest])}: {verdict}"


def counted(contests_of):
    """As '12 of 13'."""
    found = list(contests_of)
    return f"{sum(contest.outcome == 'won' for contest in found)} of {len(found)}"


def totals(study):
    """Sentences: phantoms and real scans, with noise and without, rivals that are told the truth and others."""
    bar = study.configuration.get("noise_free_bar", 0)
    texts = []
    for is_real, what in ((False, "phantoms, whose true surface is known"), (True, "real scans, against labels")):
        def of(measure, told, is_noisy, is_real=is_real):
            return [contest for contest in contests(study, measure, told)
                    if bool(study.case(contest.key[0]).get("real")) == is_real and contest.is_noisy == is_noisy]

        if not of("assd", True, True) + of("assd", True, False):
            continue
        parts = [" and by ".join(f"{measure.upper()} on {counted(of(measure, told, True))}" for measure in MEASURES) + text
                 for told, text in ((False, " scans with noise"), (True, " where rivals are told the best level, too"))
                 if of("assd", told, True)]
        if parts:
            texts.append(f"On {what}: volsurf with its defaults and the automatic delta is nearer than every rival by "
                         f"{'; by '.join(parts)}.")
        clean = {measure: of(measure, True, False) for measure in MEASURES}
        within = [f"{measure.upper()} on {sum(c.behind <= bar for c in found)} of {len(found)} scans"
                  for measure, found in clean.items() if found]
        if within:
            texts.append(f"Without noise, on {'real scans' if is_real else 'phantoms'}, it is nearer than every rival, told the best level, or within {bar:g} voxel of "
                         f"it, by {' and by '.join(within)}.")
    return " ".join(texts)


# --- Tables


def loss_table(study):
    rows = [["scan", "measure", "volsurf", "best rival", "rival's", "behind by", "why"]]
    for contest in losses(study):
        rows.append([scan_name(contest.key), contest.measure.upper(), number(contest.ours), contest.rival,
                     number(contest.theirs), number(contest.behind), reason(study, contest)])
    return rows


def win_table(study):
    """A row for each case: how often volsurf won."""
    rows = [["case", "scans", "ASSD won", "HD95 won", "volsurf found nothing"]]
    for case in study.configuration["cases"]:
        found = {measure: [c for c in contests(study, measure) if c.key[0] == case["name"]] for measure in MEASURES}
        if found["assd"]:
            rows.append([case["name"], str(len(found["assd"])),
                         *(str(sum(c.outcome == "won" for c in found[measure])) for measure in MEASURES),
                         str(sum(math.isinf(c.ours) for c in found["assd"]))])
    return rows


def bar_table(study):
    """Where a case sets bars: the vertices' distance and the volume, each by its worst seed."""
    rows = [["scan", "seeds", "vertex RMS, worst", "bar", "volume error, worst", "bar", "kept"]]
    volume_bar = study.configuration.get("volume_bar", 0)
    for case in study.configuration["cases"]:
        for noise, bar in case.get("bars", {}).items():
            score = study.scores.get((case["name"], 0, noise), {}).get(study.ours)
            if score:
                kept = score.worst_vertex_rms <= bar and score.worst_volume_error <= volume_bar
                rows.append([scan_name((case["name"], 0, noise)), str(score.seeds), number(score.worst_vertex_rms),
                             number(bar, 2), number(100 * score.worst_volume_error, 2) + " %",
                             number(100 * volume_bar, 2) + " %", "yes" if kept else "no"])
    return rows


def default_table(study):
    """A row for each other value of a default: means over all scans on which both found something, and how often only one
    did."""
    rows = [["default", "instead", "scans", "ASSD, default", "ASSD, instead", "HD95, default", "HD95, instead",
             "default nearer by ASSD", "lost, default", "lost, instead"]]
    for wanted in study.configuration.get("defaults", []):
        for name in wanted["methods"]:
            pairs = [(scores[study.ours], scores[name]) for key, scores in study.scores.items()
                     if name in scores and study.ours in scores and counts(study, wanted, key)]
            both = [pair for pair in pairs if not any(math.isinf(score.assd) for score in pair)]
            if pairs:
                means = [number(fmean(getattr(pair[side], measure) for pair in both) if both else math.nan)
                         for measure in MEASURES for side in (0, 1)]
                nearer = sum(ours.assd < theirs.assd for ours, theirs in pairs)
                lost = [str(sum(math.isinf(pair[side].assd) for pair in pairs)) for side in (0, 1)]
                rows.append([wanted["about"], name, str(len(pairs)), *means, f"{nearer} of {len(pairs)}", *lost])
    return rows


def counts(study, wanted, key):
    """Whether a scan is evidence for a default: phantoms, of the cases and the noise that it names."""
    if study.case(key[0]).get("real") or key[1]:
        return False
    cases, noise = wanted.get("cases"), wanted.get("noise", "")
    return (not cases or key[0] in cases) and key[2].startswith(noise)


def case_table(study, case, measure):
    """A row for each method, a column for each scan of a case."""
    keys = case_keys(study, case)
    ran = {name for key in keys for name in study.scores[key]}
    names = [method["name"] for method in study.configuration["methods"] if method["name"] in ran]
    rows = [["method", *(f"{key[2]}{f', bias {key[1]:g}' if key[1] else ''}" for key in keys)]]
    for name in names:
        scores = [study.scores[key].get(name) for key in keys]
        rows.append([name, *(number(getattr(score, measure)) if score else "-" for score in scores)])
    return rows


def detail_table(study, case):
    rows = [["scan", "method", "ASSD", "worst", "HD95", "worst", "bias", "Dice", "volume error", "s", "parameter", "seeds",
             "lost"]]
    for key in case_keys(study, case):
        for name, score in study.scores[key].items():
            rows.append([scan_name(key), name, number(score.assd), number(score.worst_assd), number(score.hd95),
                         number(score.worst_hd95), number(score.bias), number(score.dice),
                         number(100 * score.volume_error, 2) + " %", number(score.seconds, 2), ", ".join(score.parameters),
                         str(score.seeds), f"{score.lost} of {score.seeds}" if score.lost else ""])
    return rows


def about(study, case):
    """What a case is, and how many seeds its noise has."""
    seeds = max(score.seeds for key in case_keys(study, case) for score in study.scores[key].values())
    return f"{case.get('about', '')} {seeds} seed{'s' if seeds > 1 else ''} for each noise.".strip()


def tables_of(study, case):
    """Titles and rows of what is told of a case."""
    tables = [("ASSD in voxels", case_table(study, case, "assd")), ("HD95 in voxels", case_table(study, case, "hd95"))]
    if case.get("stability"):
        title = "How far noise moves each method: ASSD in voxels from its own surface of the scan without noise"
        tables.append((title, case_table(study, case, "moved_assd")))
    return tables
