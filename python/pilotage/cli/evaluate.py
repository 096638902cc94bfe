"""`pilotage evaluate`: one trajectory against another."""

from pathlib import Path
from typing import Annotated

import typer


def evaluate(
    poses: Annotated[Path, typer.Argument(help="The estimate: pose.csv or a TUM file.")],
    truth: Annotated[Path, typer.Argument(help="The truth, likewise.")],
    json: Annotated[bool, typer.Option("--json", help="Print JSON instead of a table.")] = False,
) -> None:
    """Print the errors of a trajectory against a true one, without alignment.

    Example: pilotage evaluate out/pose.csv truth.tum
    """
    from dataclasses import asdict
    from json import dumps

    from ..evaluate import Heading, Position, error_rows, pose_errors, read_trajectory

    errors = pose_errors(read_trajectory(poses), read_trajectory(truth))
    position, heading = Position.of(errors), Heading.of(errors)
    if position is None:
        raise ValueError(f"{poses} and {truth} have no time in common")
    if json:
        content = {"position": asdict(position), "heading": asdict(heading) if heading else None}
        typer.echo(dumps(content, indent=2))
        return
    from .console import print_rows

    print_rows(f"{poses} against {truth}", error_rows(position, heading))
