"""What a running node says of its health, over LCM."""

import math
import re
from collections.abc import Callable
from select import select
from struct import error as StructError
from time import monotonic
from typing import Any

import numpy as np

from . import Config
from .bus import connect, resolved
from .evaluate import ellipse_scale
from .lcmtypes import pose_t, status_t

STATES = {getattr(status_t, name): name for name in vars(status_t) if name.isupper()}
SILENCE_S = 3.0
"""A node speaks once a second: what is silent for longer is missing."""


class Newest:
    """The newest message of a type on a channel; what is no such message is counted."""

    def __init__(self, bus: Any, channel: str, kind: Any):
        self.channel = channel
        self.kind = kind
        self.message: Any = None
        self.count = 0
        self.foreign = 0
        self._since = monotonic()
        bus.subscribe(re.escape(channel), self._take)  # LCM takes a pattern

    def heard(self) -> bool:
        """Whether there was any."""
        return self.count > 0

    def beyond(self, count: int) -> Callable[[], bool]:
        """Give a function that tells whether there were more than that."""
        return lambda: self.count > count

    def silent_s(self) -> float:
        """Time since the newest, or since we listen."""
        return monotonic() - self._since

    def _take(self, _: str, data: bytes) -> None:
        try:
            self.message = self.kind.decode(data)
        except (ValueError, StructError):
            self.foreign += 1
        else:
            self.count += 1
            self._since = monotonic()


class Health:
    """Listens to a node's status_t and pose_t; `config` names their channels."""

    def __init__(self, url: str | None, config: Config):
        self.url = resolved(url)
        self._bus = connect(url)
        self.status = Newest(self._bus, config["output.status"], status_t)
        self.pose = Newest(self._bus, config["output.pose"], pose_t)

    def listen(self, seconds: float, until: Callable[[], bool] = lambda: False) -> bool:
        """Take messages for a time, or until something is so; returns whether it is."""
        end = monotonic() + seconds
        while not until() and (left := end - monotonic()) > 0:
            # Not handle_timeout, which takes Ctrl-C for an error of the network.
            if select([self._bus], [], [], left)[0]:
                self._bus.handle()
        return until()

    def stale(self, patience_s: float = SILENCE_S) -> bool:
        """Whether the newest status_t, if any, is so old that the node may be gone."""
        return self.status.silent_s() >= patience_s

    def notes(self, patience_s: float = SILENCE_S) -> list[str]:
        """Say what has been missing on the bus for longer than that, a line each."""
        lines = []
        status, pose = self.status, self.pose
        if self.stale(patience_s):
            lines.append(
                f"no status_t on {status.channel} for {status.silent_s():.1f} s; "
                f"is pilotage-node running on this URL?"
            )
        elif not status.heard():
            lines.append(f"waiting for status_t on {status.channel}")
        elif status.message.state != status_t.WAITING and pose.silent_s() >= patience_s:
            lines.append(
                f"no pose_t on {pose.channel} for {pose.silent_s():.1f} s; "
                f"it answers every motion sample"
            )
        lines += [
            f"messages on {newest.channel} that are no {newest.kind.__name__}: {newest.foreign}; "
            f"another program's, or built with other .lcm files?"
            for newest in (status, pose)
            if newest.foreign > 0
        ]
        return lines

    def as_dict(self) -> dict[str, Any]:
        """Return status and pose as JSON knows them; NaN is None, so is what was not heard."""
        status, pose = self.status.message, self.pose.message
        result = {"url": self.url, "status": plain(status), "pose": plain(pose)}
        if status is not None:
            result["status"]["state"] = state_name(status.state)
        if pose is not None:
            result["radius_95_m"] = plain(radius_95_m(pose))
            result["sigma_heading_rad"] = plain(sigma_heading_rad(pose))
        return result


def state_name(state: int) -> str:
    """Return the name of a state, also of one that only a newer node knows."""
    return STATES.get(state, f"state {state}")


def radius_95_m(pose: Any) -> float:
    """Return the larger half-axis of the ellipse that holds the position with 95 %."""
    covariance = np.reshape(pose.covariance, (3, 3))[:2, :2]
    if not np.isfinite(covariance).all():
        return math.nan
    return ellipse_scale(0.95) * math.sqrt(max(np.linalg.eigvalsh(covariance)[-1], 0.0))


def sigma_heading_rad(pose: Any) -> float:
    """Return the heading's standard deviation."""
    variance = pose.covariance[8]
    return math.sqrt(variance) if variance >= 0.0 else math.nan


def plain(value: Any) -> Any:
    """Turn a message, with those in it, into dictionaries and lists."""
    if hasattr(value, "__slots__"):
        return {name: plain(getattr(value, name)) for name in value.__slots__}
    if isinstance(value, list | tuple):
        return [plain(item) for item in value]
    if isinstance(value, float) and not math.isfinite(value):
        return None
    return value
