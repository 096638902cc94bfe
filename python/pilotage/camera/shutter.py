"""When what an image shows was there."""

from dataclasses import dataclass

from ..fields import within
from .detection import Array


@dataclass(frozen=True)
class Shutter:
    """How far an image's stamp is from its capture."""

    exposure_offset_s: float = 0.0
    """By which the middle of the exposure is before the stamp: half the exposure, and for a video
    device the way through cable and driver. Of a rolling shutter that of the middle row."""
    readout_s: float = 0.0
    """Of a rolling shutter: from the first row to the last; 0: all rows at once."""

    def __post_init__(self) -> None:
        within("exposure_offset_s", self.exposure_offset_s, -10.0, 10.0)
        within("readout_s", self.readout_s, 0.0, 1.0)

    def capture(self, utime: int, pixels: Array, height: int) -> int:
        """Return the time [µs] at which pixels (n, 2) of an image so many rows high were taken.

        A message has one time: with a rolling shutter it is the mean of its markers'.
        """
        offset_s = -self.exposure_offset_s
        if len(pixels) > 0:
            offset_s += self.readout_s * (float(pixels[:, 1].mean()) / (height - 1) - 0.5)
        return utime + round(offset_s * 1e6)
