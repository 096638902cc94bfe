"""`pilotage map`: a map looked at without a robot."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from .. import Config
    from ..checks import Finding
    from ..site import Survey

app = typer.Typer(help="Look at a map of markers.", no_args_is_help=True)


@app.callback()
def _group() -> None:
    """Keep `check` a command of its own, though it is the only one."""


@app.command()
def check(
    file: Annotated[Path, typer.Argument(help="A map, or a configuration that names one.")],
    config: Annotated[
        Path | None,
        typer.Option("--config", "-c", help="Of a map: whose sensors look at it, not a default."),
    ] = None,
    reach: Annotated[
        float | None, typer.Option(help="Metres that the sensors see; without it, any distance.")
    ] = None,
    view: Annotated[float, typer.Option(help="Degrees that they see, half to each side.")] = 360.0,
    area: Annotated[
        tuple[float, float, float, float] | None,
        typer.Option(
            help="Where the robot drives: lowest x and y, highest x and y, m.",
            metavar="X Y X Y",
        ),
    ] = None,
    components: Annotated[
        str,
        typer.Option(help="What the sensors measure: bearing,range. Else guessed by their noise."),
    ] = "",
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Folder for map.json and map.png.")
    ] = None,
    show: Annotated[bool, typer.Option("--show", help="Open the picture.")] = False,
    strict: Annotated[
        bool, typer.Option("--strict", help="Exit with 1 if there are warnings.")
    ] = False,
) -> None:
    """Find what makes a map ambiguous, and how well each place on it is seen.

    Layouts that repeat, markers too close, in a line or on a circle, blind zones, and how sure
    one frame makes the position. What a sensor measures is what --components says, else it is
    guessed: a component whose noise its configuration leaves at the default it does not have. The
    exit status is 0, with warnings and --strict 1, and 2 if the map cannot be used.

    Example: pilotage map check robot.yaml --reach 8 --view 170 -o out
    """
    import math

    from ..checks import summarize
    from ..checks.site import check_survey
    from ..site import Survey
    from ..site.words import describe
    from .console import make_folder, print_findings, print_sections, progress_bar

    if reach is not None and not 0.0 < reach < math.inf:
        raise ValueError(f"--reach is {reach:g}, expected more than 0 m")
    if not 0.0 < view <= 360.0:
        raise ValueError(f"--view is {view:g}, expected more than 0° and no more than 360°")
    if area is not None and not (
        all(map(math.isfinite, area)) and area[0] < area[2] and area[1] < area[3]
    ):
        raise ValueError(
            f"--area is {' '.join(f'{v:g}' for v in area)}, expected numbers: the lowest x and y, "
            "then the highest"
        )
    measured = [name.strip() for name in components.split(",")] if components else []
    chosen, map_name = _load(file, config)
    make_folder(output)
    with progress_bar("looking at the map") as progress:
        survey = Survey.of(chosen, reach or math.inf, math.radians(view), area, measured, progress)
    findings = check_survey(survey)
    typer.echo(file)
    summary = summarize(chosen, map_name)
    print_sections({section: summary[section] for section in ("map", "sensors")})
    print_sections(describe(survey))
    print_findings(findings)
    if output is not None or show:
        _save(survey, findings, output, show)
    if strict and not all(finding.note for finding in findings):
        raise typer.Exit(1)


def _save(survey: "Survey", findings: "list[Finding]", output: Path | None, show: bool) -> None:
    """Write the numbers and the picture, for `show` alone into a folder for a while."""
    from tempfile import mkdtemp

    from ..plot import style
    from ..plot.site import site_figure
    from ..site.report import save_report

    folder = output or Path(mkdtemp(prefix="pilotage-map-"))
    save_report(survey, [finding._asdict() for finding in findings], folder / "map.json")
    style.save(site_figure(survey), folder / "map.png")
    typer.echo(f"\n{folder}/map.json, {folder}/map.png")
    if show and typer.launch(str(folder / "map.png")) != 0:
        raise RuntimeError(f"nothing here opens pictures: look at {folder}/map.png elsewhere")


def _load(file: Path, config: Path | None) -> "tuple[Config, str]":
    """Load a configuration, or a map into one; with the name of the map's file."""
    from .. import Config, MarkerMap, load_config

    if not _is_map(file):
        if config is not None:
            raise ValueError(f"{file} is a configuration itself: leave out -c {config}")
        chosen, name = load_config(str(file)), ""
    else:
        chosen, name = Config() if config is None else load_config(str(config)), str(file)
        chosen.map = MarkerMap.load(name)
        if config is None:
            chosen["sensors.assumed.z_m"] = 0.0  # speaking of a sensor adds it, with its defaults
    if len(chosen.map) == 0:
        raise ValueError(f"{file} has no map: name one with map: in it, or check MAP -c {file}")
    if not chosen.marker_sensors:
        raise ValueError(
            f"{config or file} has no sensor: name one, sensors: {{camera: {{z_m: 0.3}}}}"
        )
    return chosen, name or str(chosen["map"])


def _is_map(file: Path) -> bool:
    """Tell a map, a YAML list, from a configuration; what is neither is for their loaders."""
    import yaml

    try:
        return isinstance(yaml.safe_load(file.read_text(encoding="utf-8")), list)
    except (OSError, UnicodeDecodeError, yaml.YAMLError):
        return False
