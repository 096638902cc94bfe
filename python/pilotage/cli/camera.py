"""The command `pilotage-camera`: images in, sightings out."""

from pathlib import Path
from typing import Annotated

import typer

from .opencv import needs_opencv
from .words import run

PROGRAM = "pilotage-camera"

app = typer.Typer(add_completion=False, rich_markup_mode="markdown", pretty_exceptions_enable=False)


@app.command(no_args_is_help=True)
def camera(
    inputs: Annotated[
        list[str],
        typer.Argument(
            metavar="INPUT...",
            help="A video device (0, /dev/video0), a video file, a folder of images or a pattern "
            "of them ('front/*.png'). Of several cameras NAME=INPUT each, the names being those of "
            "the configuration's sensors.",
        ),
    ],
    config: Annotated[
        Path, typer.Option("--config", "-c", help="The node's, with cameras and detectors.")
    ],
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="An LCM log to write, instead of sending over LCM."),
    ] = None,
    poses: Annotated[
        Path | None,
        typer.Option(
            help="Of -o: a log with the robot's poses, by which markers get their ids: an LCM log "
            "with POSE or REFERENCE, pose.csv, pose.tum, or the first paper's *poselog*.txt."
        ),
    ] = None,
    merge: Annotated[
        Path | None,
        typer.Option(help="Of -o: the drive's log; the output is this with the images' messages."),
    ] = None,
    begin: Annotated[
        int | None,
        typer.Option(help="Of a video file: time of its first frame, microseconds."),
    ] = None,
    speed: Annotated[
        float, typer.Option(help="Of recorded images sent over LCM, times real time.")
    ] = 1.0,
    follow: Annotated[
        bool,
        typer.Option(
            "--follow",
            help="Of recorded images sent over LCM: send each when the drive's motion that is "
            "heard has come to its time, as beside lcm-logplayer.",
        ),
    ] = False,
    show: Annotated[bool, typer.Option("--show", help="Show what is found in a window.")] = False,
    save_video: Annotated[
        Path | None,
        typer.Option(help="Write the same as a video (.mp4, .avi), one a camera."),
    ] = None,
    save_images: Annotated[
        Path | None,
        typer.Option(
            help="Of what is sent over LCM: keep the images as they came, for this program to read "
            "again: in a folder in this one for each camera."
        ),
    ] = None,
    lcm_url: Annotated[str | None, typer.Option(help="LCM_DEFAULT_URL unless given.")] = None,
    version: Annotated[
        bool,
        typer.Option(
            "--version", is_eager=True, callback=lambda asked: _version(asked), help="Print it."
        ),
    ] = False,
) -> None:
    """Find markers in a camera's images and send what they tell of the robot.

    Sent over LCM, with the time of capture, as the sensor's `measures` says: marker_frame_t,
    pixel_frame_t or pose_fix_t. Once a second it says how it goes; Ctrl-C ends it. Recorded images
    are sent at the pace at which they were taken.

    With -o nothing is sent, and all goes into a log. An image that cannot be used is left out,
    named and counted. The exit status is 0, 1 if no image could be used, 2 if it cannot begin.

    Example: pilotage-camera --config robot.yaml 0 --show

    Example: pilotage-camera --config mower/robot.yaml front=mower/front rear=mower/rear
    --poses mower/drive.lcmlog --merge mower/drive.lcmlog -o mower/found.lcmlog &&
    pilotage replay mower/found.lcmlog --config mower/robot.yaml
    """
    with needs_opencv(PROGRAM):
        from ..camera.program import Options, look_offline
    from ..fields import within

    options = Options(
        config=config,
        inputs=inputs,
        begin=begin,
        show=show,
        save_video=save_video,
        save_images=save_images,
        say=_say,
    )
    within("--speed", speed, 1e-3, 1e6)
    if output is None:
        if poses is not None or merge is not None:
            raise ValueError("--poses and --merge are of recorded images: name a log with -o")
        with needs_opencv(PROGRAM):
            from ..camera.live import look_live
        some = look_live(options, speed, follow, lcm_url)
    else:
        if save_images is not None:
            raise ValueError("--save-images is of what is sent over LCM: leave -o out")
        some = look_offline(options, output, poses, merge)
    if not some:
        raise typer.Exit(1)


def main() -> None:
    """Run the command line."""
    run(app, PROGRAM)


def _version(asked: bool) -> None:
    if asked:
        from .. import __version__

        typer.echo(f"{PROGRAM} {__version__}")
        raise typer.Exit


def _say(words: str) -> None:
    typer.echo(f"{PROGRAM}: {words}", err=True)
