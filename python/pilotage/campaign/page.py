"""The page on faults, written by the campaign that it tells of."""

from collections.abc import Iterator
from textwrap import fill

from ..evaluate.figures import AGAIN_S, MOST, SILENT_SHARE
from ..evaluate.honesty import BEYOND_DEG, BEYOND_M, BEYOND_SIGMA
from ..evaluate.outcome import SILENT_S
from ..simulate import Cell
from .report import FaultReport
from .table import MEANING, Table, bar_table, cell_table, ladder_table, policy_table

WIDTH = 110
SOURCE = "../python/pilotage/simulate/faults.yaml"


def page(report: FaultReport) -> str:
    """Return the page as Markdown."""
    return "\n".join(_parts(report))


def _parts(report: FaultReport) -> Iterator[str]:
    window, cells = report.campaign.window, report.campaign.cells
    yield "# What goes wrong, and what Pilotage says\n"
    yield _text(
        f"Written by `pilotage faults {report.scenario} --runs {report.runs} --seed {report.seed} "
        "-o docs`; the same figures, and more, stand in [faults.json](faults.json). What is "
        f"injected, how large, and what is required is in [faults.yaml]({SOURCE})."
    )
    yield _text(
        f"A robot drives through the simulated scenario `{report.scenario}`. From "
        f"{window.start_s:g} s to {window.end_s:g} s one of its inputs fails in one way: that is a "
        f"cell, and each has {report.runs} runs with other noise. A **silent failure** is the one "
        f"thing that may not happen: to say OK for more than {SILENT_S:g} s while the position is "
        f"off by more than {BEYOND_SIGMA:g} sigma and {BEYOND_M:g} m, or the heading by more than "
        f"{BEYOND_SIGMA:g} sigma and {BEYOND_DEG:g}°. A pose is judged by the truth at its own "
        "time; where poses stay out, by the truth of now. Never to say OK does not help: OK is "
        "required without a fault, again after it, and during it where it leaves enough to go by."
    )
    yield _markdown(bar_table(report))
    yield "## Cells\n"
    yield _text(
        f"A cell misses what it requires where fewer than {MOST:.0%} of its runs do it, or more "
        f"than {SILENT_SHARE:.1%} fail silently. Where no error is required, what the covariance "
        f"states bounds it. To be OK again within {AGAIN_S:g} s is required of all. The first row "
        "is without a fault: what is said there is a false alarm."
    )
    yield "\n".join(f"- **{name}**: {meaning}" for name, meaning in MEANING.items()) + "\n"
    yield _markdown(cell_table(report))
    yield from (_text(f"**{cell.name}**: {cell.note}") for cell in cells if cell.note)
    yield "## What nobody sees\n"
    yield _text(
        "Small enough, a fault hides in the noise, and does little harm. The same faults in "
        "growing sizes: the smallest from which on most runs notice (they name the input, or do "
        "not say OK), and what the largest does that goes unnoticed."
    )
    yield _markdown(ladder_table(report))
    yield "## Which clock\n"
    yield _text(
        "Above, every sample is dated by its sender's stamp (`time: utime`, the default). The "
        "faults of time again, with the failing input dated otherwise: runs with a silent failure, "
        "and error."
    )
    yield _markdown(policy_table(report))
    yield "## What the faults are\n"
    yield from _faults(cells)


def _text(paragraph: str) -> str:
    return fill(paragraph, WIDTH, break_long_words=False, break_on_hyphens=False) + "\n"


def _markdown(table: Table) -> str:
    widths = [max(map(len, column)) for column in zip(*table, strict=True)]
    head, *rows = (
        "| " + " | ".join(c.ljust(w) for c, w in zip(row, widths, strict=True)) + " |"
        for row in table
    )
    rule = "|" + "|".join("-" * (width + 2) for width in widths) + "|"
    return "\n".join([head, rule, *rows]) + "\n"


def _faults(cells: list[Cell]) -> Iterator[str]:
    """A line a fault: what it is, and its sizes by input."""
    for fault in dict.fromkeys(cell.fault for cell in cells):
        same = [cell for cell in cells if cell.fault == fault]
        sizes = "; ".join(f"{cell.stream} {cell.size_text}".rstrip() for cell in same)
        yield f"- **{fault}**: {' '.join(dict.fromkeys(cell.meaning for cell in same))} ({sizes})"
    yield ""
