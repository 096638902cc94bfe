"""What commands share on the screen."""

from collections.abc import Callable, Iterator, Mapping, Sequence
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryFile
from time import monotonic
from typing import TYPE_CHECKING

import typer

from ..evaluate import Row

if TYPE_CHECKING:
    from ..checks import Finding

PATIENCE_S = 2.0
"""What takes longer than this shows a progress bar."""


@contextmanager
def progress_bar(what: str) -> Iterator[Callable[[float], None]]:
    """Give a function that takes the part done, 0 to 1; the bar appears after a while."""
    bar = None
    start = monotonic()

    def update(done: float) -> None:
        nonlocal bar
        if bar is None and monotonic() - start > PATIENCE_S:
            from rich.console import Console
            from rich.progress import Progress

            console = Console(stderr=True)
            bar = Progress(transient=True, console=console, disable=not console.is_terminal)
            bar.add_task(what, total=1.0)
            bar.start()
        if bar is not None:
            bar.update(bar.task_ids[0], completed=done)

    try:
        yield update
    finally:
        if bar is not None:
            bar.stop()


def check_jobs(jobs: int) -> None:
    """Refuse a number of processes that means nothing."""
    if jobs < 1 and jobs != -1:
        raise ValueError(f"--jobs is {jobs}, expected 1 or more, or -1 for one a core")


def make_folder(output: Path | None) -> None:
    """Make the folder of -o, if one is named, before the work whose results it is for."""
    if output is None:
        return
    try:
        output.mkdir(parents=True, exist_ok=True)
        with TemporaryFile(dir=output):
            pass
    except OSError as error:
        raise ValueError(
            f"-o {output} cannot be a folder for results: {error.strerror}; name another folder"
        ) from error


def print_rows(title: str, rows: Sequence[Row]) -> None:
    """Print a table of label, value and unit."""
    width = max((len(row.label) for row in rows), default=0)
    print(title)
    for row in rows:
        print(f"  {row.label:<{width}}  {row.value:>10}  {row.unit}".rstrip())


def print_sections(sections: Mapping[str, Sequence[str]]) -> None:
    """Print lines, with their section's name before the first."""
    for section, lines in sections.items():
        for i, line in enumerate(lines):
            typer.echo(f"  {section if i == 0 else '':<8}  {line}")


def print_findings(findings: "Sequence[Finding]") -> None:
    """Print warnings, or that there are none, and then the notes."""
    notes = [finding for finding in findings if finding.note]
    warnings = [finding for finding in findings if not finding.note]
    for kind, some, colour in (("warning", warnings, "yellow"), ("note", notes, "cyan")):
        if some or kind == "warning":
            plural = "" if len(some) == 1 else "s"
            typer.echo(f"\n{len(some) or 'no'} {kind}{plural}" + (":" if some else ""))
        for finding in some:
            typer.secho(f"  {finding.key}: ", fg=colour, nl=False)
            remedy = finding.remedy.replace("\n", "\n    ")
            typer.echo(f"{finding.problem}\n    → {remedy}")


def aligned(table: Sequence[Sequence[str]], numbers: Sequence[str] = ()) -> list[str]:
    """Return lines with columns of equal width; those whose head is in `numbers` stand right."""
    widths = [max(map(len, column)) for column in zip(*table, strict=True)]
    right = [head in numbers for head in table[0]]
    return [
        "  ".join(
            cell.rjust(width) if is_right else cell.ljust(width)
            for cell, width, is_right in zip(row, widths, right, strict=True)
        ).rstrip()
        for row in table
    ]
