"""`pilotage config`: every configuration key, to start a robot's own file from."""

from itertools import takewhile
from pathlib import Path
from typing import Annotated

import typer


def config(
    file: Annotated[
        Path | None, typer.Argument(help="A configuration file; without it the defaults.")
    ] = None,
) -> None:
    """Print a configuration with every key, its value and its meaning, as YAML.

    Example: pilotage config > robot.yaml
    """
    from .. import Config, load_config

    chosen = Config() if file is None else load_config(str(file))
    if not chosen.sensors:
        chosen["sensors.camera.z_m"] = 0.0  # speaking of a sensor adds it, with its defaults
    typer.echo(annotated_yaml(chosen.describe()), nl=False)


def annotated_yaml(rows: list[tuple[str, str, str]]) -> str:
    """Nest dotted keys into YAML sections; a key without a value is commented out."""
    lines: list[str] = []
    open_sections: list[str] = []
    for key, value, meaning in rows:
        *sections, name = key.split(".")
        same = takewhile(
            lambda pair: pair[0] == pair[1], zip(open_sections, sections, strict=False)
        )
        common = len(list(same))
        for depth in range(common, len(sections)):
            lines.append(f"{'  ' * depth}{sections[depth]}:")
        open_sections = sections
        mark = "" if value else "# "
        entry = f"{'  ' * len(sections)}{mark}{name}: {value}"
        lines.append(f"{entry:<36}  # {meaning}")
    return "\n".join(lines) + "\n"
