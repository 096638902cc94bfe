"""`pilotage montecarlo`: how good the localizer is on a site, over many runs."""

from pathlib import Path
from typing import Annotated

import typer


def montecarlo(
    scenario: Annotated[
        str,
        typer.Argument(
            help="A name as in `pilotage simulate`, a file (docs/montecarlo.md), or a row of the "
            "bars; with --bars, only the rows with this in their name."
        ),
    ] = "",
    runs: Annotated[int, typer.Option(min=1, help="With other noise each.")] = 1000,
    jobs: Annotated[int, typer.Option(help="Processes; -1 for one a core.")] = -1,
    seed: Annotated[int, typer.Option(min=0, help="Of all chance.")] = 1,
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="Folder for montecarlo.json and montecarlo.png."),
    ] = None,
    bars: Annotated[
        bool, typer.Option("--bars", help="Hold against what it must show, row by row.")
    ] = False,
) -> None:
    """Run a scenario many times on the real core, and compare with the truth.

    Prints the errors beside the smallest that are possible (posterior Cramér-Rao bound), whether
    covariances and sigmas tell the truth (NEES, NIS), lost runs, and how honest the status was.
    The numbers depend on the seed alone, not on the number of processes. The exit status is 0, and
    with --bars 1 if a bar is missed.

    Example: pilotage montecarlo site.yaml --runs 1000 -o out
    """
    from ..montecarlo import find_scenario, run_montecarlo
    from .console import aligned, check_jobs, make_folder, print_rows, progress_bar

    check_jobs(jobs)
    chosen = None if bars else find_scenario(scenario)
    make_folder(output)
    if chosen is None:
        from ..montecarlo.judging import judge

        with progress_bar("running") as progress:
            verdict = judge(scenario, runs, seed, jobs, progress, output)
        typer.echo("\n".join(aligned(verdict.table(), ("measured", "bar"))))
        if output is not None:
            typer.echo(f"{output}/bars.json, and a folder for each row")
        raise typer.Exit(0 if verdict.met else 1)
    from ..montecarlo.summary import rows, runs_to_look_at

    with progress_bar("running") as progress:
        result = run_montecarlo(chosen, runs, seed, jobs, progress)
    print_rows(f"{scenario}, {runs} runs", list(rows(result)))
    for line in runs_to_look_at(result, scenario):
        typer.echo(line)
    if output is not None:
        result.save(output)
        typer.echo(f"{output}/montecarlo.json, {output}/montecarlo.png")
