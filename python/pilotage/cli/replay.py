"""`pilotage replay`: a recording through the localizer."""

from pathlib import Path
from typing import Annotated

import typer


def replay(
    input: Annotated[
        Path,
        typer.Argument(
            help="An LCM log, a mower folder (poselog, angles, map), an MRCLAM folder, "
            "a Lost in the Woods .mat or a Plaza .mat."
        ),
    ],
    config: Annotated[
        Path | None,
        typer.Option("--config", "-c", help="Instead of the ready configuration of this kind."),
    ] = None,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Folder for poses, reports and figures.")
    ] = None,
    robot: Annotated[int | None, typer.Option(help="Which robot of an MRCLAM folder.")] = None,
    figures: Annotated[
        bool, typer.Option("--figures/--no-figures", help="Draw figures into the output folder.")
    ] = True,
) -> None:
    """Replay a recording, print how good the estimate is, and keep it in a folder.

    The folder gets pose.csv, pose.tum, reports.csv, metrics.json, config.yaml as used, and figures.
    The same recording gives the same bytes as the live node did.

    Example: pilotage replay MRCLAM_Dataset6 --robot 2 -o out
    """
    from ..logs import read
    from ..replaying import replay_log
    from ..results import save_results
    from .console import print_rows, progress_bar

    log = read(input, robot=robot)
    for note in log.notes:
        typer.echo(f"note: {note}", err=True)
    with progress_bar("replaying") as progress:
        result = replay_log(log, config, progress)
    for notice in result.run.notices:
        typer.echo(f"note: {notice}", err=True)
    if result.run.poses.size == 0:
        raise ValueError(f"{input}: no pose came out; still waiting for {result.run.waiting_for}")
    rows = save_results(result.run, result.config, log.truth, output, figures)
    print_rows(str(input), rows)
    if output is not None:
        typer.echo(f"\n{output}/ holds poses, reports, metrics" + (", figures" if figures else ""))
