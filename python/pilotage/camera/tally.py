"""What became of the frames of a camera: read = published + dropped by reason, always."""

from collections import Counter
from collections.abc import Callable
from threading import Lock
from time import monotonic

QUIET_S = 1.0
"""A camera says no more often than this that frames were dropped."""


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
        """Say something about the camera as a whole."""
        self._say(f"{self.name}: {words}")

    def frame(self, count: int = 1) -> None:
        """Count frames that were read."""
        with self._lock:
            self.read += count

    def publish(self, detections: int) -> None:
        """Count a frame that was published."""
        with self._lock:
            self.published += 1
            self.detections += detections

    def drop(self, reason: str, words: str = "", count: int = 1) -> None:
        """Count frames that were not published, and say why, now and then."""
        with self._lock:
            self.dropped[reason] += count
            if not words:
                return
            now = monotonic()
            if now - self._said.get(reason, -QUIET_S) < QUIET_S:
                self._unsaid[reason] += count
                return
            self._said[reason] = now
            more = self._unsaid.pop(reason, 0)
        self.say(words + (f" (and {more} more before it)" if more else ""))

    def summary(self) -> str:
        """Return where all frames went."""
        with self._lock:
            parts = [f"{self.published} published"]
            parts += [f"{count} {reason}" for reason, count in sorted(self.dropped.items())]
            return f"{self.read} frames = {' + '.join(parts)}; {self.detections} detections"
