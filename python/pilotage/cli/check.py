"""`pilotage check`: a configuration and its map, tried without a robot."""

from pathlib import Path
from typing import Annotated

import typer


def check(
    file: Annotated[Path, typer.Argument(help="The configuration.")],
    map: Annotated[
        Path | None, typer.Option("--map", help="Markers, instead of the configuration's.")
    ] = None,
    lcm: Annotated[
        bool, typer.Option("--lcm", help="Also check that LCM works on this machine.")
    ] = False,
    strict: Annotated[
        bool, typer.Option("--strict", help="Exit with 1 if there are warnings.")
    ] = False,
) -> None:
    """Load a configuration and its map, say what they mean, and warn of what is hardly meant.

    The exit status is 0 if they can be used, also with warnings unless --strict, and 2 if not.

    Example: pilotage check robot.yaml --strict
    """
    from .. import MarkerMap, load_config
    from ..checks import check_config, no_multicast, summarize
    from .console import print_findings, print_sections

    config = load_config(str(file))
    if map is not None:
        config.map = MarkerMap.load(str(map))
    findings = [*check_config(config), *(no_multicast() if lcm else ())]
    typer.echo(file)
    print_sections(summarize(config, str(map or config["map"])))
    print_findings(findings)
    if findings and strict:
        raise typer.Exit(1)
