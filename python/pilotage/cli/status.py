"""`pilotage status`: a running node's health."""

from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Annotated

import typer

if TYPE_CHECKING:
    from ..health import Health

GOOD, NOT_GOOD, SILENT = 0, 1, 2
REFRESH_S = 0.25


def status(
    lcm_url: Annotated[str | None, typer.Option(help="LCM_DEFAULT_URL unless given.")] = None,
    once: Annotated[bool, typer.Option("--once", help="Print one status and end.")] = False,
    timeout: Annotated[
        float, typer.Option(min=0.0, help="Seconds that --once waits at most.")
    ] = 3.0,
    json: Annotated[
        bool, typer.Option("--json", help="Print JSON, a line for each status_t.")
    ] = False,
    config: Annotated[
        Path | None,
        typer.Option("--config", "-c", help="The node's, where it renames the output channels."),
    ] = None,
) -> None:
    """Show a running node's state, pose and inputs, until Ctrl-C.

    With --once the exit status is 0 if the state is OK, 1 if it is another, and 2 if no node was
    heard.

    Example: pilotage status --once --json || echo "do not drive"
    """
    from .. import Config, load_config
    from ..health import Health

    health = Health(lcm_url, load_config(str(config)) if config else Config())
    if once:
        raise typer.Exit(_show_once(health, timeout, json))
    with suppress(KeyboardInterrupt):  # the usual end
        _follow(health, json)


def _show_once(health: "Health", timeout: float, json: bool) -> int:
    from ..lcmtypes import status_t

    if health.listen(timeout, health.status.heard):
        health.listen(2 * REFRESH_S, health.pose.heard)  # there is none while the node waits
        _print(health, json)
        return GOOD if health.status.message.state == status_t.OK else NOT_GOOD
    _say_what_is_missing(health, timeout)
    return SILENT


def _follow(health: "Health", json: bool) -> None:
    """Redraw a terminal in place; elsewhere print each status_t as it comes."""
    from rich.console import Console
    from rich.live import Live

    from ..health import SILENCE_S
    from .status_screen import screen

    console = Console()
    if json or not console.is_terminal:
        while True:
            if health.listen(SILENCE_S, health.status.beyond(health.status.count)):
                _print(health, json)
            else:
                _say_what_is_missing(health, SILENCE_S)
    with Live(screen(health), console=console, auto_refresh=False) as live:
        while True:
            health.listen(REFRESH_S)
            live.update(screen(health), refresh=True)


def _print(health: "Health", json: bool) -> None:
    from json import dumps

    from rich.console import Console

    from .status_screen import screen

    if json:
        print(dumps(health.as_dict(), ensure_ascii=False), flush=True)
    else:
        Console().print(screen(health))


def _say_what_is_missing(health: "Health", patience_s: float) -> None:
    for note in health.notes(patience_s):
        typer.echo(f"pilotage: {health.url}: {note}", err=True)
