"""What became of the frames of a camera: read = published + dropped by reason, always."""

from collections import Counter
from collections.abc import Callable
from threading import Lock
from time import monotonic

QUIET_S = 1.0
"""A camera says the same no more often than this."""


class Tally:
    """Counts the frames of one camera, and says what goes wrong; `say` takes a line of text."""

    def __init__(self, name: str, say: Callable[[str], None]):
        self.name = name
        self.read = 0
        self.published = 0
        self.detections = 0
        self.dropped: Counter[str] = Counter()
        self._say = say
        self._lock = Lock()
        self._said: dict[str, float] = {}
        self._unsaid: Counter[str] = Counter()

    def say(self, words: str) -> None:
        """Say something of the camera as a whole."""
        self._say(f"{self.name}: {words}")

    def warn(self, reason: str, words: str) -> None:
        """Say what is so of one frame, unless the same was said just now."""
        with self._lock:
            now = monotonic()
            if now - self._said.get(reason, -QUIET_S) < QUIET_S:
                self._unsaid[reason] += 1
                return
            self._said[reason] = now
            more = self._unsaid.pop(reason, 0)
        self.say(words + (f" (and {more} more since)" if more else ""))

    def frame(self) -> None:
        """Count a frame that was read."""
        with self._lock:
            self.read += 1

    def publish(self, detections: int) -> None:
        """Count a frame that was published."""
        with self._lock:
            self.published += 1
            self.detections += detections

    def drop(self, reason: str, words: str = "") -> None:
        """Count a frame that was read and not published; words say why, now and then."""
        with self._lock:
            self.dropped[reason] += 1
        if words:
            self.warn(reason, words)

    def settle(self, reason: str) -> None:
        """Count what was read and is not accounted for, when the camera's work has broken off."""
        with self._lock:
            open_ones = self.read - self.published - self.dropped.total()
            if open_ones > 0:
                self.dropped[reason] += open_ones

    def summary(self) -> str:
        """Return where all frames went."""
        with self._lock:
            parts = [f"{self.published} published"]
            parts += [f"{count} {reason}" for reason, count in sorted(self.dropped.items())]
            return f"{self.read} frames = {' + '.join(parts)}; {self.detections} detections"
