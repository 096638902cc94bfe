"""An engine on a bench: messages go in, and what it publishes comes out decoded."""

from collections.abc import Iterable
from typing import Any

from pilotage import Config, Engine, lcmtypes

TYPES = {
    "POSE": lcmtypes.pose_t,
    "ODOMETRY": lcmtypes.odometry_t,
    "POSE_JUMP": lcmtypes.pose_jump_t,
    "MARKER_REPORT": lcmtypes.marker_report_t,
    "STATUS": lcmtypes.status_t,
}


class Bench:
    """Ticks it as `pilotage-node` does, as time passes with the messages."""

    def __init__(self, config: str | Config, checkpoint: bytes | None = None):
        self.engine = Engine(config if isinstance(config, Config) else Config.parse(config))
        if checkpoint is not None:
            self.engine.restore(checkpoint)
        self.messages: dict[str, list[Any]] = {channel: [] for channel in TYPES}
        self.said: list[tuple[int, str]] = []
        self._next_tick: int | None = None

    def send(self, channel: str, message: Any, received: int | None = None) -> None:
        """Arrives when it was stamped, unless told otherwise."""
        now = message.utime if received is None else received
        self.pass_time(now)
        self._take(now, self.engine.handle(channel, now, message.encode()))

    def send_all(self, messages: Iterable[tuple[str, Any]]) -> None:
        for channel, message in messages:
            self.send(channel, message)

    def pass_time(self, now: int) -> None:
        """Tick up to that time."""
        tick = now if self._next_tick is None else self._next_tick
        while tick <= now:
            self._take(tick, self.engine.tick(tick))
            tick += self.engine.tick_period
        self._next_tick = tick

    def _take(self, now: int, published: list[tuple[str, bytes]]) -> None:
        for channel, data in published:
            self.messages[channel].append(TYPES[channel].decode(data))
        self.said += [(now, line) for line in self.engine.notices[len(self.said) :]]

    @property
    def pose(self) -> Any:
        return self.messages["POSE"][-1]

    @property
    def status(self) -> Any:
        return self.messages["STATUS"][-1]
