"""`pilotage plot`: the figures of a recording."""

from pathlib import Path
from typing import Annotated

import typer


def plot(
    input: Annotated[
        Path, typer.Argument(help="The folder of a replay, or a recording that is replayed first.")
    ],
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="Folder for the figures; of a replay, its own."),
    ] = None,
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

    Example: pilotage plot out --window 285 300
    """
    from ..plot import save_all
    from ..stored import is_stored, read_stored

    if is_stored(input):
        stored = read_stored(input)
        drawn = save_all(stored, stored.truth, stored.map, output or input, window)
    else:
        from ..logs import read
        from ..replaying import replay_log

        if input.exists() and output is None:
            raise ValueError(f"{input} is a recording: say where its figures go with -o")
        log = read(input, robot=robot)
        result = replay_log(log, config)
        drawn = save_all(result.run, log.truth, result.config.map, output or input, window)
    for path in drawn:
        typer.echo(path)
