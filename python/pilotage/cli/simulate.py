"""`pilotage simulate`: a recording of a drive that never was."""

from pathlib import Path
from typing import Annotated

import typer

PATIENCE_S = 60.0
"""For somebody to start a node in another terminal."""


def simulate(
    scenario: Annotated[
        str,
        typer.Argument(
            help="mower-spiral, circle-four-poles, figure-eight, yard, or a file as in "
            "docs/montecarlo.md"
        ),
    ],
    output: Annotated[
        Path | None,
        typer.Option("--output", "-o", help="LCM log; the configuration goes beside it."),
    ] = None,
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
    gyro_bias: Annotated[float, typer.Option(help="rad/s")] = 0.0,
    slip: Annotated[
        float, typer.Option(help="Part of the wheels' travel that moves nothing.")
    ] = 0.0,
    latency: Annotated[
        float | None, typer.Option(help="Seconds from a frame to its arrival.")
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

    Example: pilotage simulate figure-eight -o eight.lcmlog --gyro-bias 0.001 && pilotage replay
    eight.lcmlog --config eight.yaml
    """
    from dataclasses import replace

    import numpy as np

    from ..montecarlo import find_scenario, simulate_run
    from ..simulate import Campaign, Measured
    from ..simulate import simulate as simulated
    from .console import progress_bar

    chosen = find_scenario(scenario)
    if live == (output is not None):
        raise ValueError("say where it goes: either -o FILE.lcmlog or --live")
    if output is not None and output.suffix == ".yaml":
        raise ValueError(f"{output} is for the configuration: give the log another name")
    duration = chosen.duration_s if duration is None else duration
    latency = chosen.latency_s if latency is None else latency
    for name, value, low, high in (
        ("duration", duration, 1.0, 1e5),
        ("noise", noise, 0.0, 100.0),
        ("gyro-bias", gyro_bias, -1.0, 1.0),
        ("slip", slip, -0.9, 0.9),
        ("latency", latency, 0.0, 60.0),
        ("speed", speed, 1e-3, 1e6),
    ):
        if not low <= value <= high:
            raise ValueError(f"--{name} is {value:g}, expected {low:g} to {high:g}")
    chosen = chosen.with_noise(noise)
    chosen = replace(
        chosen,
        duration_s=duration,
        encoders=replace(
            chosen.encoders, slip=slip, scale_sigma=max(slip, chosen.encoders.scale_sigma)
        ),
        gyro=replace(
            chosen.gyro,
            bias_rad_s=gyro_bias,
            bias_sigma_rad_s=max(abs(gyro_bias), chosen.gyro.bias_sigma_rad_s),
        ),
        latency_s=latency,
    )
    rng = np.random.default_rng(seed)

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
        output.with_suffix(".yaml").write_text(config, encoding="utf-8")
        typer.echo(f"{output}: {len(simulation.recording)} messages")
        typer.echo(f"pilotage replay {output} --config {output.with_suffix('.yaml')}")
        return
    from ..health import Health
    from ..live import play

    file = Path(f"{chosen.name}.yaml")
    file.write_text(config, encoding="utf-8")
    typer.echo(f"a node for it: pilotage-node --config {file}")
    if wait:
        health = Health(lcm_url, simulation.config)
        if not health.listen(PATIENCE_S, health.status.heard):
            raise RuntimeError(f"no node was heard on {health.url}; --no-wait sends to nobody")
    typer.echo("sending")
    with progress_bar("sending") as progress:
        play(simulation.recording, speed, progress, lcm_url)
