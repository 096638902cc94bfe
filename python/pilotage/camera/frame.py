"""An image with its time, and where such come from."""

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Protocol

from .detection import Image
from .tally import Tally


@dataclass(frozen=True, eq=False)
class Frame:
    """One image of a source, or why there is none."""

    utime: int
    """µs, the source's stamp."""
    name: str
    """For words about it: a file's name, or its number."""
    image: Image | None = None
    """(h, w, 3) uint8, blue, green, red."""
    reason: str = ""
    """Why there is no image, as it is counted."""
    words: str = ""
    """The same in words."""


class Source(Protocol):
    """Where a camera's images come from."""

    rate_hz: float
    """About how many images there are a second, NaN unknown."""

    @property
    def begin(self) -> int | None:
        """Stamp of its first image, µs; None: it gives them as they are taken."""
        ...

    def frames(self, tally: Tally) -> Iterator[Frame]:
        """Yield what is read; what cannot be used has a reason. The tally is told of the rest."""
        ...

    def close(self) -> None:
        """Make `frames` end."""
        ...
