"""`pilotage camera-calibrate`: a camera's lens and how it is mounted."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any

import typer

if TYPE_CHECKING:
    from numpy.typing import NDArray

    from .. import Config
    from ..calibrate.sightings import Sightings
    from ..logs import Log

app = typer.Typer(help="Calibrate a camera: its lens, its mounting.", no_args_is_help=True)


@app.command()
def intrinsics(
    inputs: Annotated[
        list[str], typer.Argument(help="Pictures, folders, patterns in quotes, or a video.")
    ],
    board: Annotated[
        str,
        typer.Option(
            help="'chessboard 9x6 0.025' (inner corners, square's side in m) or 'charuco 7x5 0.04 "
            "0.03 4x4_50' (squares, sides of square and tag in m, dictionary)."
        ),
    ],
    output: Annotated[
        Path,
        typer.Option("--output", "-o", help="File for the intrinsics; its figure goes beside it."),
    ] = Path("camera.yaml"),
    coefficients: Annotated[
        int, typer.Option(help="Of the distortion: 0, 4, 5 or 8; 8 for a wide angle.")
    ] = 5,
) -> None:
    """Find a camera's matrix and distortion from pictures of a chessboard or ChArUco board.

    10 to 20 pictures: all of the picture covered, the board near, tilted in most. The file is as
    OpenCV writes it, and is what `intrinsics:` of a sensor names.

    Example: pilotage camera-calibrate intrinsics pictures/ --board "chessboard 9x6 0.025" -o
    front.yaml
    """
    import numpy as np

    from .opencv import needs_opencv

    with needs_opencv("camera-calibrate"):
        from ..calibrate.boards import parse_board
        from ..calibrate.doubts import coverage, doubts
        from ..calibrate.intrinsics import LENSES, calibrate, rms
        from ..calibrate.looking import find_views
        from ..calibrate.pictures import pictures
        from ..camera.intrinsics_file import write_intrinsics
    from ..plot import style
    from ..plot.calibration import residuals_figure
    from .console import aligned, print_findings

    if coefficients not in LENSES:
        raise ValueError(f"--coefficients is {coefficients}, expected 0, 4, 5 or 8")
    looked_for = parse_board([board])
    without: list[str] = []
    views, size = find_views(
        pictures(inputs), looked_for, lambda name, there: None if there else without.append(name)
    )
    found = calibrate(views, size, coefficients)
    typer.echo(f"{len(views)} pictures of {size[0]} by {size[1]} with the board")
    for name in without:
        typer.echo(f"  not in {name}")
    rows: list[tuple[str, ...]] = [("picture", "corners", "rms px", "largest px", "tilt °")]
    for view, left, tilt in zip(views, found.residuals, np.degrees(found.tilts_rad), strict=True):
        largest = np.hypot(*left.T).max()
        rows.append(
            (view.name, str(len(left)), f"{rms(left):.3f}", f"{largest:.3f}", f"{tilt:.0f}")
        )
    _print(aligned(rows, rows[0][1:]))
    rows = [("", "value", "sigma", "unit")]
    for name, value, sigma in zip(found.names, found.values, found.sigmas, strict=True):
        lens = name[0] in "kp"
        digits = 5 if lens else 3
        rows.append((name, f"{value:.{digits}f}", f"{sigma:.{digits}f}", "" if lens else "px"))
    _print(aligned(rows, ("value", "sigma")))
    covered = coverage(found)
    typer.echo(f"\nreprojection error {found.rms_px:.3f} px rms")
    typer.echo(f"corners in {covered.mean():.0%} of the picture")
    print_findings(doubts(found))
    write_intrinsics(output, size, found.matrix, found.distortion, found.rms_px)
    every = np.concatenate([view.pixels for view in views])
    figure = residuals_figure(size, every, np.concatenate(list(found.residuals)), covered)
    style.save(figure, output.with_suffix(".png"))
    typer.echo(f"\n{output}, {output.with_suffix('.png')}")


@app.command()
def extrinsics(
    config: Annotated[Path, typer.Argument(help="The configuration: map, intrinsics, a start.")],
    log: Annotated[Path, typer.Argument(help="LCM log of the drive.")],
    sensor: Annotated[
        str | None, typer.Option(help="Which camera, where the configuration has several.")
    ] = None,
    pictures: Annotated[
        Path | None,
        typer.Option(help="Folder of pictures named by their time in µs, not the log's pixels."),
    ] = None,
    poses: Annotated[
        Path | None,
        typer.Option(help="pose.csv or TUM file, instead of the log's reference_t or pose_t."),
    ] = None,
    latency: Annotated[bool, typer.Option("--latency", help="Look for latency_s too.")] = False,
    hold: Annotated[str, typer.Option(help="Parameters to leave as they are: x_m,y_m,z_m.")] = "",
    radius: Annotated[
        float, typer.Option(help="Without ids: px from a pixel to its marker's projection.")
    ] = 64.0,
    output: Annotated[
        Path | None, typer.Option("--output", "-o", help="Folder for the lines and a figure.")
    ] = None,
) -> None:
    """Find how a camera is mounted from a drive past surveyed markers, by least squares in pixels.

    The configuration's mounting is the start; a ruler is good enough. Poses are the truth
    (reference_t in the log), or else those of the log's pose_t: a run that did without this camera.

    Example: pilotage camera-calibrate extrinsics robot.yaml drive.lcmlog --sensor front --pictures
    drive/front
    """
    import numpy as np

    from .opencv import needs_opencv

    with needs_opencv("camera-calibrate"):
        from ..calibrate.extrinsics import calibrate
    from .. import load_config
    from ..calibrate.reprojection import NAMES
    from ..calibrate.weak import weaknesses
    from ..calibrate.words import configuration_lines, left_words, parameter_rows
    from ..fields import known_keys, within
    from ..logs import read
    from ..plot import style
    from ..plot.calibration import residuals_figure
    from .console import aligned, make_folder, print_findings

    held = {name.strip() for name in hold.split(",") if name.strip()}
    known_keys(dict.fromkeys(held), NAMES, "--hold")
    within("--radius", radius, 1.0, 1e4)
    chosen = load_config(str(config))
    if len(chosen.map) == 0:
        raise ValueError(f"{config} has no map: name the surveyed markers with map:")
    name = _camera_of(chosen, sensor, config)
    recorded = read(log)
    seen = _seen(recorded, chosen, name, pictures)
    camera = chosen.camera(name)
    assert camera is not None  # _seen has asked for it
    start = np.array([float(chosen[f"sensors.{name}.{key}"]) for key in NAMES])
    if not latency:
        held.add("latency_s")
    make_folder(output)
    found = calibrate(
        camera, seen, _poses(recorded, poses), chosen.map, start, held, radius_px=radius
    )
    typer.echo(f"{name}: {left_words(found)}")
    _print(aligned(parameter_rows(found), ("start", "found", "sigma")))
    print_findings(weaknesses(found))
    lines = configuration_lines(name, found)
    typer.echo("\n" + lines)
    if output is not None:
        (output / "extrinsics.yaml").write_text(lines + "\n", encoding="utf-8")
        figure = residuals_figure(
            camera.size, found.seen.pixel, found.after, before=found.before, used=found.used
        )
        style.save(figure, output / "extrinsics.png")
        typer.echo(f"\n{output}/extrinsics.yaml, {output}/extrinsics.png")


def _camera_of(config: "Config", sensor: str | None, file: Path) -> str:
    if sensor is not None:
        return sensor
    cameras = [name for name in config.sensors if config.camera(name) is not None]
    if len(cameras) != 1:
        there = f"has the cameras {', '.join(cameras)}" if cameras else "has no camera"
        raise ValueError(f"{file} {there}: name one with --sensor, its lens with intrinsics: in it")
    return cameras[0]


def _seen(log: "Log", config: "Config", sensor: str, folder: Path | None) -> "Sightings":
    from ..calibrate.sightings import of_log, of_pictures
    from ..camera.tally import Tally

    if folder is not None:
        return of_pictures(folder, config, sensor, Tally(sensor, typer.echo))
    return of_log(log.recording, config, sensor)


def _poses(log: "Log", file: Path | None) -> "NDArray[Any]":
    from ..evaluate.trajectory import read_trajectory
    from ..logs.poses import recorded_poses

    if file is not None:
        return read_trajectory(file)
    poses = log.truth if log.truth is not None else recorded_poses(log.recording)
    if poses is None:
        raise ValueError(
            "the log has neither reference_t nor pose_t: name the robot's poses with --poses, such "
            "as the pose.csv of pilotage replay -o"
        )
    return poses


def _print(lines: list[str]) -> None:
    typer.echo("\n" + "\n".join(f"  {line}" for line in lines))
