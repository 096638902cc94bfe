"""`pilotage simulate`: a recording of a drive that never was."""

from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    import numpy as np

    from ..simulate import Scenario

PATIENCE_S = 60.0
"""For somebody to start a node in another terminal."""


def simulate(
    scenario: Annotated[
        str,
        typer.Argument(
            help="mower-spiral, circle-four-poles, figure-eight, yard, or a file as in "
            "docs/montecarlo.md; with cameras: mower-cameras, aruco-ring, poles, or a file as in "
            "docs/camera-rendered.md"
        ),
    ],
    output: Annotated[
        Path | None,
        typer.Option(
            "--output",
            "-o",
            help="LCM log; the configuration goes beside it. With --cameras a folder.",
        ),
    ] = None,
    cameras: Annotated[
        bool, typer.Option("--cameras", help="Draw what the cameras see, into the folder of -o.")
    ] = False,
    jobs: Annotated[int, typer.Option(help="Of --cameras: processes, -1 for one a core.")] = 1,
    live: Annotated[bool, typer.Option("--live", help="Send it over LCM instead.")] = False,
    wait: Annotated[
        bool, typer.Option("--wait/--no-wait", help="Of --live: begin once a node is heard.")
    ] = True,
    speed: Annotated[float, typer.Option(help="Of --live, times real time.")] = 1.0,
    lcm_url: Annotated[
        str | None, typer.Option(help="Of --live; LCM_DEFAULT_URL unless given.")
    ] = None,
    duration: Annotated[float | None, typer.Option(help="Seconds, instead of the whole.")] = None,
    noise: Annotated[float, typer.Option(help="Factor on every noise; 0 measures exactly.")] = 1.0,
    gyro_bias: Annotated[
        float | None, typer.Option(help="rad/s, instead of the scenario's.")
    ] = None,
    slip: Annotated[
        float | None,
        typer.Option(help="Part of the wheels' travel that moves nothing, not the scenario's."),
    ] = None,
    latency: Annotated[
        float | None,
        typer.Option(help="Seconds from a frame to its arrival, instead of the scenario's."),
    ] = None,
    fault: Annotated[
        str | None,
        typer.Option(help="What fails for a while, a cell of `pilotage faults`: 'gyro stuck'."),
    ] = None,
    seed: Annotated[int, typer.Option(help="Of all chance.")] = 1,
    run: Annotated[
        int | None, typer.Option(min=0, help="The run of `pilotage montecarlo` of that number.")
    ] = None,
) -> None:
    """Simulate a drive past markers, into an LCM log or live over LCM.

    The log holds encoders, gyro, marker frames and the truth (reference_t); beside it stands a
    configuration with the map, for `pilotage replay` and `pilotage-node`. Live, the same messages
    are sent with the same stamps, which begin at one second; the configuration goes into this
    folder, and the drive begins once a node is heard.

    With --cameras, the folder gets a subfolder of pictures a camera, named by their time of capture
    (us), robot.yaml with markers.yaml and each camera's intrinsics, drive.lcmlog with wheels, gyro
    and truth but no sightings, and ideal.lcmlog with exact angles of what is in view besides.

    Example: pilotage simulate figure-eight -o eight.lcmlog --gyro-bias 0.001 && pilotage replay
    eight.lcmlog --config eight.yaml

    Example: pilotage simulate mower-cameras --cameras --duration 60 -o mower && pilotage replay
    mower/ideal.lcmlog --config mower/robot.yaml
    """
    from dataclasses import replace

    import numpy as np

    from ..fields import within
    from ..montecarlo import find_scenario, simulate_run
    from ..simulate import Campaign, Measured
    from ..simulate import simulate as simulated
    from .console import progress_bar

    chosen = find_scenario(scenario)
    if cameras and (output is None or live or fault is not None or run is not None):
        raise ValueError("--cameras draws into the folder of -o, without --live, --fault and --run")
    if live == (output is not None):
        raise ValueError("say where it goes: either -o FILE.lcmlog or --live")
    file = Path(f"{chosen.name}.yaml") if output is None else output.with_suffix(".yaml")
    if file == output and not cameras:
        raise ValueError(f"{output} is for the configuration: give the log another name")
    for written in (file, output):
        if written is not None and _same(written, Path(scenario)):
            way = "start it in another folder" if live else "give the log another name"
            raise ValueError(f"{written} would be written, and is the scenario itself: {way}")
    within("--noise", noise, 0.0, 100.0)
    within("--speed", speed, 1e-3, 1e6)
    chosen = chosen.with_noise(noise)
    if duration is not None:
        chosen = replace(chosen, duration_s=duration)
    if latency is not None:
        chosen = replace(chosen, latency_s=latency)
    if slip is not None:
        known = max(abs(slip), chosen.encoders.scale_sigma)
        chosen = replace(chosen, encoders=replace(chosen.encoders, slip=slip, scale_sigma=known))
    if gyro_bias is not None:
        known = max(abs(gyro_bias), chosen.gyro.bias_sigma_rad_s)
        chosen = replace(
            chosen, gyro=replace(chosen.gyro, bias_rad_s=gyro_bias, bias_sigma_rad_s=known)
        )
    rng = np.random.default_rng(seed)
    if cameras and output is not None:
        _draw(chosen, rng, output, jobs)
        return

    def spoiled(measured: Measured) -> Measured:
        if fault is None:
            return measured
        campaign = Campaign.load()
        return campaign.cell(fault).strike(measured, chosen.cameras, campaign.window, rng)

    simulation = (
        simulated(chosen, rng, spoiled) if run is None else simulate_run(chosen, seed, run, spoiled)
    )
    config = simulation.config.to_yaml()
    if output is not None:
        simulation.recording.save(str(output))
        file.write_text(config, encoding="utf-8")
        typer.echo(f"{output}: {len(simulation.recording)} messages")
        typer.echo(f"pilotage replay {output} --config {file}")
        return
    from ..health import Health
    from ..live import play

    file.write_text(config, encoding="utf-8")
    typer.echo(f"a node for it: pilotage-node --config {file}")
    if wait:
        health = Health(lcm_url, simulation.config)
        if not health.listen(PATIENCE_S, health.status.heard):
            raise RuntimeError(f"no node was heard on {health.url}; --no-wait sends to nobody")
    typer.echo("sending")
    with progress_bar("sending") as progress:
        play(simulation.recording, speed, progress, lcm_url)


def _draw(scenario: "Scenario", rng: "np.random.Generator", folder: Path, jobs: int) -> None:
    """Draw pictures into a folder and say what to do with them."""
    from .console import check_jobs, make_folder, progress_bar
    from .opencv import needs_opencv

    check_jobs(jobs)
    with needs_opencv("--cameras"):
        from ..simulate.pictures import take_pictures
    make_folder(folder)
    with progress_bar("drawing") as progress:
        taken = take_pictures(scenario, rng, folder, jobs, progress)
    for one in taken:
        seen = f"{len(one.ideal)} markers in view"
        typer.echo(f"{folder / one.camera.name}: {len(one.utime)} pictures, {seen}")
    typer.echo(f"pilotage replay {folder / 'ideal.lcmlog'} --config {folder / 'robot.yaml'}")


def _same(one: Path, other: Path) -> bool:
    """Tell whether both are there and are one file."""
    return one.exists() and other.exists() and one.samefile(other)
