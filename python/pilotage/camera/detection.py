"""What a detector finds in an image: the one contract of discs, poles and tags."""

import math
from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]
Image = NDArray[np.uint8]


@dataclass(frozen=True, eq=False)
class Detection:
    """One marker in an image.

    Pixels are OpenCV's: (0, 0) is the centre of the top left pixel, u to the right, v down. They
    are those of the image as it came, with the lens's distortion in them.
    """

    pixel: Array
    """(2,) px, where the marker's surveyed point shows, not the blob's middle."""
    covariance: Array
    """(2, 2) px^2 of `pixel`."""
    id: int = -1
    """The marker's number in the map, -1 unknown."""
    label: int = -1
    """Class of look-alike markers, a pole's colour; -1 none."""
    range_m: float = math.nan
    """From the sensor to the marker's point; NaN: not measured."""
    sigma_range_m: float = math.nan
    has_elevation: bool = True
    """False where the pixel tells the azimuth alone, as a pole's does: its range has its height."""
    outline: Array = field(default_factory=lambda: np.empty((0, 2)))
    """(k, 2) px, for drawing; a tag's are its four corners."""


class Detector(Protocol):
    """Finds the markers of one kind; it keeps nothing from one image to the next."""

    def detect(self, image: Image) -> Sequence[Detection]:
        """Return what is in an image.

        Parameters
        ----------
        image : (h, w, 3) uint8, blue, green, red, of the size that the camera was calibrated at
        """
        ...


def check_size(image: Image, size: tuple[int, int]) -> None:
    """Raise a ValueError unless an image is (h, w, 3) of the size (w, h) of the calibration."""
    if image.ndim != 3 or image.shape[2] != 3 or image.dtype != np.uint8:
        raise ValueError(
            f"an image is {image.shape} of {image.dtype}, expected (h, w, 3) of uint8: blue, "
            "green, red"
        )
    height, width = image.shape[:2]
    if (width, height) != tuple(size):
        raise ValueError(
            f"an image is {width} by {height} pixels, but the camera was calibrated at {size[0]} "
            f"by {size[1]}: set the camera to that size, or calibrate it at this one"
        )
