"""`pilotage convert`: any readable recording as an LCM log."""

from pathlib import Path
from typing import Annotated

import typer


def convert(
    input: Annotated[Path, typer.Argument(help="A recording that `pilotage replay` reads.")],
    output: Annotated[Path, typer.Option("--output", "-o", help="The LCM log to write.")],
    robot: Annotated[int | None, typer.Option(help="Which robot of an MRCLAM folder.")] = None,
) -> None:
    """Convert a recording to an LCM log with the truth as reference_t.

    Beside it goes the configuration that `pilotage replay` would use for it, with the map.

    Example: pilotage convert Plaza1_.mat -o plaza1.lcmlog
    """
    from ..logs import read, write_lcmlog
    from ..replaying import prepared_config

    if output.suffix == ".yaml":
        raise ValueError(f"{output} is for the configuration: give the log another name")
    log = read(input, robot=robot)
    for note in log.notes:
        typer.echo(f"note: {note}", err=True)
    write_lcmlog(log, output)
    typer.echo(f"{output}: {len(log.recording)} messages")
    if log.map is not None:
        config = output.with_suffix(".yaml")
        config.write_text(prepared_config(log).to_yaml(), encoding="utf-8")
        typer.echo(f"pilotage replay {output} --config {config}")
