"""`pilotage check`: a configuration and its map, tried without a robot."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from ..checks import Finding


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

    config = load_config(str(file))
    if map is not None:
        config.map = MarkerMap.load(str(map))
    findings = [*check_config(config), *(no_multicast() if lcm else ())]
    typer.echo(file)
    for section, lines in summarize(config, str(map or config["map"])).items():
        for i, line in enumerate(lines):
            typer.echo(f"  {section if i == 0 else '':<8}  {line}")
    _print_findings(findings)
    if findings and strict:
        raise typer.Exit(1)


def _print_findings(findings: "list[Finding]") -> None:
    plural = "" if len(findings) == 1 else "s"
    typer.echo(f"\n{len(findings) or 'no'} warning{plural}" + (":" if findings else ""))
    for finding in findings:
        typer.secho(f"  {finding.key}: ", fg="yellow", nl=False)
        remedy = finding.remedy.replace("\n", "\n    ")
        typer.echo(f"{finding.problem}\n    → {remedy}")
