"""`pilotage demo`: a simulated drive, localized live."""

from pathlib import Path
from typing import Annotated

import typer


def demo(
    output: Annotated[Path, typer.Option("--output", "-o", help="Folder for everything.")] = Path(
        "pilotage-demo"
    ),
    seed: Annotated[int, typer.Option(help="Of the simulated noise.")] = 1,
) -> None:
    """Simulate a mower's drive, localize it live over LCM, draw it.

    Starts the real pilotage-node, sends it encoders, gyro and marker frames faster than real time,
    and leaves figures, tables and the node's own log of the run. Without a route for multicast it
    uses a private network, or, failing that, the engine in this process.

    Example: pilotage demo -o my-demo
    """
    import numpy as np

    from .. import multicast, replay
    from ..live import running_node, send
    from ..results import save_results
    from ..simulate import SCENARIOS, simulate
    from .console import print_rows, progress_bar

    online = multicast.available()
    if not online:
        typer.echo(f"note: {multicast.ADVICE}\nuntil then a private network may do", err=True)
        status = multicast.rerun_in_private_network()
        if status is not None:
            raise typer.Exit(status)
        typer.echo("note: no private network either: the engine runs in this process", err=True)
    typer.echo("simulating a drive of 549 s past 28 markers ...")
    simulation = simulate(SCENARIOS["mower-spiral"], np.random.default_rng(seed))
    log: Path | None = None
    if online:
        with running_node(simulation.config, output), progress_bar("sending") as progress:
            poses = send(simulation.recording, simulation.config, progress)
        log = output / "node.lcmlog"
        run = replay(simulation.config, str(log), keep_messages=True)
        replayed = run.published.messages(simulation.config["output.pose"])
        same = "the same, byte for byte" if replayed == poses else "NOT the same"
        typer.echo(f"pilotage-node answered with {len(poses)} poses; a replay of its log is {same}")
    else:
        run = replay(simulation.config, simulation.recording)
    rows = save_results(run, simulation.config, simulation.truth, output)
    print_rows("localized", rows)
    typer.echo(f"\n{output}/ holds figures (path.png first), poses, reports and metrics")
    if log is not None:
        typer.echo(f"the node's log: pilotage replay {log}")
