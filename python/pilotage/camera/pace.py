"""When it is time for a recorded image."""

from collections.abc import Callable
from threading import Condition, Event
from time import monotonic

PATIENCE_S = 5.0
"""A drive that is silent for longer is over."""


class OwnPace:
    """Images come with the pauses with which they were taken, those of all cameras together."""

    def __init__(self, begin: int, speed: float, stop: Event):
        """Start: the image of the time `begin` [µs] is due now."""
        self._begin, self._speed, self._stop = begin, speed, stop
        self._start = monotonic()

    def __call__(self, utime: int) -> bool:
        """Wait for the time of an image [µs]; whether it comes."""
        due = self._start + (utime - self._begin) * 1e-6 / self._speed
        return not self._stop.wait(max(due - monotonic(), 0.0))


class DrivesPace:
    """Images come when the drive that is heard has come to their time."""

    def __init__(self, stop: Callable[[], bool]):
        self._stop = stop
        self._news = Condition()
        self._newest: int | None = None

    def heard(self, utime: int) -> None:
        """Take the time of a motion sample, µs."""
        with self._news:
            self._newest = utime
            self._news.notify_all()

    def __call__(self, utime: int) -> bool:
        """Wait for the time of an image [µs]; whether it comes."""
        with self._news:
            while not self._stop():
                if self._newest is not None and self._newest >= utime:
                    return True
                before, since = self._newest, monotonic()
                while self._newest == before and not self._stop():
                    self._news.wait(0.2)
                    if before is not None and monotonic() - since > PATIENCE_S:
                        return False
        return False
