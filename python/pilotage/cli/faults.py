"""`pilotage faults`: what the localizer says when its inputs fail."""

from pathlib import Path
from typing import Annotated

import typer


def faults(
    scenario: Annotated[str, typer.Argument(help="As in `pilotage simulate`.")] = "yard",
    runs: Annotated[int, typer.Option(min=1, help="Of each cell.")] = 200,
    jobs: Annotated[int, typer.Option(help="Processes; -1 for one a core.")] = -1,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Folder for faults.json and faults.md.")
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="Of all chance.")] = 1,
    only: Annotated[str, typer.Option(help="Only cells with this in their name.")] = "",
) -> None:
    """Inject faults into encoders, gyro and markers, and hold what is said against the truth.

    Each cell is a fault of an input, with many runs of a simulated drive. The table says what is
    required of the localizer and what came out; the numbers depend on the seed alone, not on the
    number of processes.

    Example: pilotage faults yard --runs 20 --only gyro -o out
    """
    from ..campaign import FaultReport
    from ..campaign.table import bar_table, cell_table
    from .console import aligned, check_jobs, make_folder, progress_bar

    check_jobs(jobs)
    make_folder(output)
    with progress_bar("injecting faults") as progress:
        report = FaultReport.make(scenario, runs, seed, jobs, only, progress)
    numbers = ("OK", "said", "after", "again", "error", "silent", "measured")
    for table in (cell_table(report, covered_only=True), bar_table(report)):
        typer.echo("\n".join(aligned(table, numbers)) + "\n")
    if output is not None:
        report.save(output)
        typer.echo(f"{output}/faults.json; what it means: {output}/faults.md")
