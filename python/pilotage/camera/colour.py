"""A colour of markers, as a range of hue, saturation and value."""

from dataclasses import dataclass

import cv2
import numpy as np

from ..fields import within
from .detection import Image


@dataclass(frozen=True)
class Colour:
    """A range in the HSV cone; the hue goes round, so that red is from 340 to 20 degrees."""

    hue_deg: tuple[float, float]
    saturation: tuple[float, float] = (0.45, 1.0)
    value: tuple[float, float] = (0.2, 1.0)

    def __post_init__(self) -> None:
        for name, top in (("hue_deg", 360.0), ("saturation", 1.0), ("value", 1.0)):
            for number in getattr(self, name):
                within(name, number, 0.0, top)

    def mask(self, hsv: Image) -> Image:
        """Return (h, w) uint8, 255 where an image of `hue_saturation_value` is of this colour."""
        # OpenCV's bytes: hue in steps of 2 degrees, the others in steps of 1/255.
        low, high = (round(hue / 2) for hue in self.hue_deg)
        spans = [(low, high)] if low <= high else [(low, 180), (0, high)]
        rest = np.rint(255 * np.array([self.saturation, self.value])).astype(int)
        masks = [
            cv2.inRange(hsv, (a, *rest[:, 0].tolist()), (b, *rest[:, 1].tolist())) for a, b in spans
        ]
        mask: Image = np.bitwise_or.reduce(masks)
        return mask


COLOURS = {
    "red": Colour((340, 20)),
    "orange": Colour((15, 40)),
    "yellow": Colour((40, 70)),
    "green": Colour((80, 160)),
    "cyan": Colour((165, 195)),
    "blue": Colour((200, 260)),
    "magenta": Colour((280, 335)),
}
"""Of markers painted in a plain colour, in fair light."""


def hue_saturation_value(image: Image) -> Image:
    """Return an image (h, w, 3) of blue, green, red as hue, saturation, value in OpenCV's bytes."""
    hsv: Image = cv2.cvtColor(image, cv2.COLOR_BGR2HSV)
    return hsv
