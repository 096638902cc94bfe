"""The list of commands."""

import typer

from . import (
    assignment,
    camera_calibrate,
    check,
    config,
    convert,
    demo,
    evaluate,
    faults,
    map,
    montecarlo,
    plot,
    replay,
    simulate,
    status,
    study,
)
from .words import run

app = typer.Typer(
    help="Localizes ground robots on surveyed markers, with dead reckoning in between.",
    no_args_is_help=True,
    add_completion=False,
    rich_markup_mode="markdown",
    pretty_exceptions_enable=False,
)


@app.callback(invoke_without_command=True)
def _options(
    version: bool = typer.Option(False, "--version", help="Print the version."),
) -> None:
    if version:
        from .. import __version__

        print(f"pilotage {__version__}")
        raise typer.Exit


for command in (
    demo.demo,
    replay.replay,
    convert.convert,
    simulate.simulate,
    evaluate.evaluate,
    faults.faults,
    montecarlo.montecarlo,
    plot.plot,
    config.config,
    check.check,
    status.status,
    study.study,
    assignment.assignment,
):
    app.command()(command)
app.add_typer(map.app, name="map")
app.add_typer(camera_calibrate.app, name="camera-calibrate")


def main() -> None:
    """Run the command line."""
    run(app, "pilotage")
