"""The campaign's results as rows of text, for the terminal and for the page."""

from ..evaluate import CellFigures, Required
from ..evaluate.figures import AGAIN_S, MOST, OK_SHARE, SILENT_SHARE
from ..simulate import Cell
from ..simulate.cells import NO_FAULT
from .report import FaultReport, Ladder

Table = list[list[str]]
"""Rows of text; the first is the head."""

MEANING = {
    "required": "of the state while the fault lasts, how soon the status names the input, and how "
    "far off the pose may be",
    "OK": "part of the fault's time in which the state was OK",
    "said": "runs in which the status named the input in time (its `problem`, or the `reason`)",
    "after": "median time until it did",
    "again": f"runs that were OK again, and right, within {AGAIN_S:g} s of the fault's end",
    "error": "95th percentile of a run's largest position error since the fault began",
    "silent": "runs with a silent failure",
    "missed": "what is required and was not met",
}
"""Of the columns of the table of cells."""


def cell_table(report: FaultReport, covered_only: bool = False) -> Table:
    """Return a row a cell, also of those that were not run; the first is without a fault."""
    rows = [
        _cell_row(cell, report.figures.get(cell.name))
        for cell in report.campaign.cells
        if cell.name in report.figures or not covered_only
    ]
    return [["input", "fault", *MEANING], _cell_row(NO_FAULT, report.no_fault), *rows]


def bar_table(report: FaultReport) -> Table:
    """Return what is required over all cells that were run, and whether it is met."""
    covered = [
        (c, report.figures[c.name]) for c in report.campaign.cells if c.name in report.figures
    ]
    runs = report.total("runs")
    again = sum(figures.again * figures.runs for _, figures in covered) / runs
    silent, ok = report.total("silent") / runs, report.no_fault.ok
    crashes, not_finite = report.total("crashes"), report.total("not_finite")
    met = sum(not figures.missed(cell.required) for cell, figures in covered)
    every = len(report.campaign.cells)
    bars = [
        ("crashes", f"{crashes}", "0", crashes == 0),
        ("runs with other than numbers out", f"{not_finite}", "0", not_finite == 0),
        ("silent failures", _share(silent), f"≤ {_share(SILENT_SHARE)}", silent <= SILENT_SHARE),
        ("OK again in time", _share(again), f"≥ {_share(MOST)}", again >= MOST),
        ("time OK without a fault", _share(ok), f"≥ {_share(OK_SHARE)}", ok >= OK_SHARE),
        ("cells that meet all they require", f"{met}", f"{every}", met == every),
    ]
    head = [f"over {runs:,} runs", "measured", "required", ""]
    return [head, *([what, is_, bar, "met" if ok else "missed"] for what, is_, bar, ok in bars)]


def ladder_table(report: FaultReport) -> Table:
    """Return a row a fault: the smallest size that most runs noticed, and what smaller ones do."""
    head = ["input", "fault", "smallest seen", "largest unseen", "its error", "its silent"]
    return [head, *map(_ladder_row, report.ladders)]


def policy_table(report: FaultReport) -> Table:
    """Return a row a cell of time: silent failures and error with each time policy."""
    head = ["input", "fault", *("utime", *report.policies)]
    rows = []
    for cell in report.campaign.timely:
        if cell.name in report.figures:
            by_time = [report.figures, *report.policies.values()]
            figures = [by_name[cell.name] for by_name in by_time]
            entries = [f"{_share(f.silent / f.runs)}, {_metres(f.error_m)}" for f in figures]
            rows.append([cell.stream, cell.fault, *entries])
    return [head, *rows]


def required_text(required: Required) -> str:
    """Return it in a few words."""
    parts = [required.state] if required.state != "any" else []
    if required.say_s is not None:
        parts.append(f"said in {required.say_s:g} s")
    if required.error_m is not None:
        parts.append(f"≤ {required.error_m:g} m")
    return ", ".join(parts)


def _cell_row(cell: Cell, figures: CellFigures | None) -> list[str]:
    required = required_text(cell.required)
    if figures is None:
        return [cell.stream, cell.fault, required, *["–"] * 6, "not covered"]
    return [
        cell.stream,
        cell.fault,
        required,
        _share(figures.ok_during),
        _share(figures.said),
        "–" if figures.said_s is None else f"{figures.said_s:.1f} s",
        _share(figures.again),
        _metres(figures.error_m),
        _share(figures.silent / figures.runs),
        ", ".join(figures.missed(cell.required)),
    ]


def _ladder_row(ladder: Ladder) -> list[str]:
    first, unseen = ladder.rungs[0], ladder.unseen
    seen = ladder.rungs[unseen].size_text if unseen < len(ladder.rungs) else "none of these"
    if unseen == 0:
        return [first.stream, first.fault, seen, "–", "–", "–"]
    figures = ladder.figures[unseen - 1]
    return [
        first.stream,
        first.fault,
        seen,
        ladder.rungs[unseen - 1].size_text,
        _metres(figures.error_m),
        _share(figures.silent / figures.runs),
    ]


def _share(part: float) -> str:
    """Percent, with a digit more where it is small but not nothing."""
    percent = 100.0 * part
    return (
        f"{percent:.1f} %" if 0.0 < percent < 10.0 or 90.0 < percent < 100.0 else f"{percent:.0f} %"
    )


def _metres(error_m: float | None) -> str:
    return "–" if error_m is None else f"{error_m:.2f} m"
