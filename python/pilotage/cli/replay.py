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
    from ..evaluate import compute_metrics, table_rows
    from ..logs import read
    from ..replaying import replay_log
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
    metrics = compute_metrics(result.run, log.truth)
    if output is not None:
        output.mkdir(parents=True, exist_ok=True)
        result.run.write_poses_csv(str(output / "pose.csv"))
        result.run.write_poses_tum(str(output / "pose.tum"))
        result.run.write_reports_csv(str(output / "reports.csv"))
        (output / "config.yaml").write_text(result.config.to_yaml(), encoding="utf-8")
        metrics.save(output / "metrics.json")
        if figures:
            from ..plot import save_all

            save_all(result.run, log.truth, result.config.map, output)
    print_rows(str(input), table_rows(metrics))
    if output is not None:
        typer.echo(f"\n{output}/ holds poses, reports, metrics" + (", figures" if figures else ""))
