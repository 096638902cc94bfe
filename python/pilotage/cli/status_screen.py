"""A node's health as a terminal shows it."""

import math
from time import localtime, strftime
from typing import Any

from rich.console import Group, RenderableType
from rich.table import Table
from rich.text import Text

from ..health import Health, radius_95_m, sigma_heading_rad, state_name
from ..lcmtypes import status_t

DASH = "—"
STYLES = {"OK": "bold green", "AMBIGUOUS": "bold red", "LOST": "bold red"}
"""Of states; the others ask for patience, not for help."""
SUSPECT = ("slipping", "lifted")
"""Motion that the wheels do not measure."""
UNITS = ((86400.0, "d"), (3600.0, "h"), (60.0, "min"), (1.0, "s"), (1e-3, "ms"))


def screen(health: Health) -> RenderableType:
    """Draw all that is known; what is not known is a dash."""
    notes = [Text(note, style="yellow") for note in health.notes()]
    heading = Text(f"pilotage-node on {health.url}", style="dim")
    status = health.status.message
    if status is None:
        return Group(heading, *notes)
    problems = [
        Text.assemble((f"{entry.name}: ", "bold red"), (entry.problem, "red"))
        for entry in status.inputs
        if entry.problem and f"{entry.name}: {entry.problem}" not in status.reason
    ]
    heading = Text(f"pilotage-node {status.version or DASH} on {health.url}", style="dim")
    return Group(
        heading,
        *notes,
        _last_known(status) if health.stale() else _state(status),
        *problems,
        Text(),
        _estimate(status, health.pose.message),
        Text(),
        _inputs(status),
    )


def _state(status: Any) -> Text:
    name = state_name(status.state)
    lasted = duration((status.utime - status.since) * 1e-6)
    line = Text.assemble(
        (name, STYLES.get(name, "bold yellow")), f" since {_time_of_day(status.since)} ({lasted})"
    )
    if status.reason:
        waits = "for " if status.state == status_t.WAITING else ""
        line.append(f"\n{waits}{status.reason}", style="yellow")
    return line


def _last_known(status: Any) -> Text:
    """No green OK of a node that may be gone."""
    name = state_name(status.state)
    return Text(f"last heard at {_time_of_day(status.utime)}: {name}", style="bold red")


def _time_of_day(utime: int) -> str:
    return strftime("%H:%M:%S", localtime(utime * 1e-6))


def _estimate(status: Any, pose: Any) -> Table:
    grid = Table.grid(padding=(0, 2))
    grid.add_column(style="dim", no_wrap=True)
    grid.add_column()
    position = heading = DASH
    motion = status.motion or DASH
    if pose is not None:
        radius = number(radius_95_m(pose), "{:.3f} m")
        position = f"x {pose.x:+.3f} m, y {pose.y:+.3f} m; 95 % radius {radius}"
        sigma = number(math.degrees(sigma_heading_rad(pose)), "{:.2f}°")
        heading = f"{math.degrees(pose.heading):+.2f}°; σ {sigma}"
        motion += f"; {pose.v:+.2f} m/s, {math.degrees(pose.omega):+.1f} °/s"
    grid.add_row("motion", Text(motion, "yellow" if status.motion in SUSPECT else ""))
    grid.add_row("position", position)
    grid.add_row("heading", heading)
    grid.add_row("resets", _resets(status))
    age = duration(status.checkpoint_age_s)
    grid.add_row("checkpoint", DASH if age == DASH else f"{age} old")
    drops = f"{status.drops:,} datagrams by the kernel"
    grid.add_row("dropped", Text(drops, style="red" if status.drops > 0 else ""))
    return grid


def _resets(status: Any) -> Text:
    text = Text(f"{status.resets}")
    if status.reset_answer:
        style = "" if status.reset_answer == "accepted" else "red"
        text.append(f"; pose_reset_t {status.reset_seq}: ").append(status.reset_answer, style)
    return text


def _inputs(status: Any) -> Table:
    """Two lines an input, so that all fits in 80 columns."""
    table = Table(box=None, padding=(0, 2, 0, 0), header_style="dim")
    table.add_column("input\nchannel", no_wrap=True)
    for title in ("rate\nage", "received\nlost", "fused\npending"):
        table.add_column(title, justify="right", no_wrap=True)
    table.add_column("rejected\nby reason", no_wrap=True)
    table.add_column("clock offset\nskew", justify="right", no_wrap=True)
    for entry in status.inputs:
        table.add_row(
            _two(entry.name, entry.channel, "bold red" if entry.problem else "bold"),
            _two(number(entry.rate_hz, "{:.1f} Hz"), duration(entry.age_s)),
            _two(f"{entry.received:,}", f"{entry.lost:,}", alarm=entry.lost > 0),
            _two(f"{entry.fused:,}", f"{entry.pending:,}"),
            _rejected(entry),
            _clock(entry),
        )
    return table


def _two(first: str, second: str, style: str = "", alarm: bool = False) -> Text:
    return Text.assemble((first, style), "\n", (second, "yellow" if alarm else "dim"))


def _rejected(entry: Any) -> Text:
    """Counts by reason, the largest first; messages that came twice, and noise that grew, below."""
    by_count = sorted(entry.rejected, key=lambda rejected: -rejected.count)
    lines = [f"{rejected.count:,} {rejected.reason}" for rejected in by_count]
    if entry.repeated > 0:
        lines.append(f"{entry.repeated:,} repeated")
    text = Text("\n".join(lines) or DASH, style="yellow" if lines else "dim")
    if entry.noise_scale != 1 and not math.isnan(entry.noise_scale):
        text.append(f"\nσ × {entry.noise_scale:.2f}", style="")
    return text


def _clock(entry: Any) -> Text:
    if math.isnan(entry.age_s):
        return Text(DASH, style="dim")
    offset = duration(entry.clock_offset_us * 1e-6, "+")
    lines = [offset, number(entry.clock_skew_ppm, "{:+.0f} ppm")]
    if entry.clock_steps > 0:
        lines.append(f"stepped {entry.clock_steps}×")
    return Text("\n".join(lines))


def number(value: float, form: str) -> str:
    """Format a number, with a dash for what is not known."""
    return form.format(value) if math.isfinite(value) else DASH


def duration(seconds: float, sign: str = "-") -> str:
    """Format a time in the unit that suits its size; the sign as in format strings."""
    if not math.isfinite(seconds):
        return DASH
    size, unit = next((u for u in UNITS if abs(seconds) >= u[0]), UNITS[-1])
    return f"{seconds / size:{sign}.1f} {unit}"
