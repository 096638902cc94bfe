"""`pilotage study`: the published systems behind this project, rerun."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from ..studies.study import Table


def study(
    name: Annotated[str, typer.Argument(help="As `pilotage study list` names it, or list.")],
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="Folder for results.json and the figures."),
    ] = None,
    seed: Annotated[int, typer.Option(min=0, help="Of all chance.")] = 1,
    jobs: Annotated[int, typer.Option(help="Processes; -1 for one a core.")] = -1,
    show: Annotated[bool, typer.Option("--show", help="Show the figures in windows.")] = False,
) -> None:
    """Rerun a published system on the core, and print its tables with ours beside them.

    Example: pilotage study sousa-poles -o out
    """
    from ..studies.study import Request, all_studies, find_study
    from .console import check_jobs, progress_bar

    if name == "list":
        for each, study in all_studies():
            typer.echo(f"{each:<15} {study.title}\n{'':<15} {study.source}")
        return
    check_jobs(jobs)
    chosen = find_study(name)
    with progress_bar(name) as progress:
        found = chosen.run(Request(seed, 1.0, jobs, progress))
    for table in found.tables:
        print_table(table)
    if output is not None:
        typer.echo(f"{output}: {', '.join(path.name for path in found.save(output))}")
    if show:
        from ..plot.window import show_figures

        show_figures(found.figures)


def print_table(table: "Table") -> None:
    """Print a table with its title above and its note below."""
    from rich import box
    from rich.console import Console
    from rich.table import Table as Drawn

    drawn = Drawn(
        title=table.title,
        title_justify="left",
        box=box.SIMPLE_HEAD,
        caption=table.note,
        caption_justify="left",
    )
    for i, name in enumerate(table.head):
        drawn.add_column(name, justify="left" if i == 0 else "right")
    for row in table.rows:
        drawn.add_row(*(cell if isinstance(cell, str) else f"{cell:.3g}" for cell in row))
    Console().print(drawn)
