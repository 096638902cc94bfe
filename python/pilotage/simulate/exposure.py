"""What a sensor makes of the light: blur, gain, noise, eight bits."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..fields import within

WHITE = 255.0


@dataclass(frozen=True)
class Exposure:
    """How a camera takes a picture; the defaults change nothing but round to eight bits."""

    noise: float = 0.0
    """Standard deviation in every channel of every pixel, of 255."""
    blur_px: float = 0.0
    """Standard deviation of the lens's and the focus's Gaussian blur."""
    gain: float = 1.0
    """On the light; what is above 255 stays there."""
    exposure_s: float = 0.0
    """For how long the light comes in, about the stamp: what moves is smeared."""

    def __post_init__(self) -> None:
        within("noise", self.noise, 0.0, 100.0)
        within("blur_px", self.blur_px, 0.0, 20.0)
        within("gain", self.gain, 0.01, 100.0)
        within("exposure_s", self.exposure_s, 0.0, 1.0)

    def develop(self, light: NDArray[np.float32], rng: np.random.Generator) -> NDArray[np.uint8]:
        """(h, w, 3) uint8 of light (h, w, 3), blue, green, red, 0 to 255."""
        picture: NDArray[Any] = light
        if self.blur_px > 0.0:
            import cv2

            picture = cv2.GaussianBlur(picture, (0, 0), self.blur_px)
        if self.gain != 1.0:
            picture = picture * np.float32(self.gain)
        if self.noise > 0.0:
            grains = rng.standard_normal(picture.shape, dtype=np.float32)
            picture = np.minimum(picture, np.float32(WHITE)) + np.float32(self.noise) * grains
        return np.asarray(np.clip(np.rint(picture), 0.0, WHITE), np.uint8)
