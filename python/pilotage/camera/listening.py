"""What a node and the drive say over LCM."""

import re
from collections import deque
from collections.abc import Callable, Mapping
from contextlib import suppress
from select import select
from struct import error as StructError
from threading import Event, Lock

from .. import Config
from ..bus import connect
from ..lcmtypes import marker_report_t, pose_t
from .annotate import Answer
from .offline import STAMP
from .pace import DrivesPace
from .poses import Poses

REMEMBERED = 200
"""Messages of which the answers are kept."""


class Listener:
    """Takes poses, what became of detections, and how the drive goes on."""

    def __init__(self, url: str | None, config: Config, stop: Event):
        self.poses = Poses()
        self.drive = DrivesPace(stop.is_set)
        self._answers: dict[tuple[str, int], dict[int, Answer]] = {}
        self._order: deque[tuple[str, int]] = deque()
        self._lock = Lock()
        self._stop = stop
        self._bus = connect(url)
        motion = config[f"{config['motion.source']}.channel"]
        for channel, take in (
            (config["output.pose"], self._pose),
            (config["output.report"], self._report),
            (motion, self._motion),
        ):
            subscription = self._bus.subscribe(re.escape(channel), _if_sound(take))
            subscription.set_queue_capacity(0)

    def run(self) -> None:
        """Listen until the end."""
        while not self._stop.is_set():
            if select([self._bus], [], [], 0.1)[0]:
                self._bus.handle()

    def answers(self, sensor: str, seq: int) -> Mapping[int, Answer]:
        """Return what became of the detections of a message, by index."""
        with self._lock:
            return dict(self._answers.get((sensor, seq), {}))

    def _pose(self, data: bytes) -> None:
        pose = pose_t.decode(data)
        self.poses.add(pose.utime, (pose.x, pose.y, pose.heading))

    def _report(self, data: bytes) -> None:
        report = marker_report_t.decode(data)
        key = (report.sensor, report.frame_seq)
        with self._lock:
            if key not in self._answers:
                self._answers[key] = {}
                self._order.append(key)
                if len(self._order) > REMEMBERED:
                    del self._answers[self._order.popleft()]
            self._answers[key][report.index] = Answer(report.id, report.reason)

    def _motion(self, data: bytes) -> None:
        self.drive.heard(STAMP.unpack_from(data)[0])


def _if_sound(take: Callable[[bytes], None]) -> Callable[[str, bytes], None]:
    def taken(_: str, data: bytes) -> None:
        with suppress(ValueError, StructError):  # another program's message on this channel
            take(data)

    return taken
