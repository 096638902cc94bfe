"""`pilotage plot`: the figures of a recording."""

from pathlib import Path
from typing import Annotated

import typer


def plot(
    input: Annotated[Path, typer.Argument(help="A recording that `pilotage replay` reads.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder for the figures.")],
    config: Annotated[
        Path | None, typer.Option("--config", "-c", help="Instead of the ready configuration.")
    ] = None,
    robot: Annotated[int | None, typer.Option(help="Which robot of an MRCLAM folder.")] = None,
    window: Annotated[
        tuple[float, float] | None,
        typer.Option(help="Seconds from the start that the close-up shows."),
    ] = None,
) -> None:
    """Draw path, close-up, visible markers and trace of P, errors with ±2σ, and NIS.

    Without --window the close-up shows where the error is largest.

    Example: pilotage plot Plaza1_.mat -o figures --window 285 300
    """
    from ..logs import read
    from ..plot import save_all
    from ..replaying import replay_log

    log = read(input, robot=robot)
    result = replay_log(log, config)
    for path in save_all(result.run, log.truth, result.config.map, output, window):
        typer.echo(path)
