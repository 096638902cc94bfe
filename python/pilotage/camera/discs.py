"""Coloured discs that lie on the ground, the markers of the first paper."""

import math
from dataclasses import dataclass

import cv2
import numpy as np

from .. import CameraModel
from ..fields import within
from .blobs import Blob, blobs, coverage
from .colour import COLOURS, Colour, hue_saturation_value
from .detection import Array, Detection, Image, check_size

SAMPLING_PX = 0.005
"""What a pixel's finite size leaves of error in a blob's centre, measured without noise."""
BLUR_PX2 = 0.5
"""What pixels and a lens add to a blob's second moments."""


@dataclass(frozen=True)
class DiscDetector:
    """Finds blobs of one colour that are as large and as long as a disc on the ground there.

    A disc is seen at a slant: the middle of its blob is nearer than the projection of its centre.
    The difference is that of a disc projected by the camera model, and is taken off.
    """

    camera: CameraModel
    height_m: float
    """Of the camera above the ground."""
    radius_m: float
    """Of the discs."""
    colour: Colour = COLOURS["red"]
    z_m: float = 0.0
    """Of the discs above the ground."""
    min_area_px: float = 9.0
    min_fill: float = 0.85
    """Smallest part of the ellipse with the blob's second moments that the blob fills."""
    size_ratio: float = 2.0
    """By which its axes may be longer or shorter than expected; the robot's tilt changes them."""

    def __post_init__(self) -> None:
        within("radius_m", self.radius_m, 1e-4, 10.0)
        within("min_area_px", self.min_area_px, 1.0)
        within("min_fill", self.min_fill, 0.0, 1.0)
        within("size_ratio", self.size_ratio, 1.0)
        if not self.z_m < self.height_m:
            raise ValueError(
                f"z_m of the discs is {self.z_m:g} and of the camera {self.height_m:g}: from there "
                "it does not see them; set the sensor's z_m"
            )

    def detect(self, image: Image) -> list[Detection]:
        """Return the discs of an image (h, w, 3), whole ones only."""
        check_size(image, self.camera.size)
        mask = self.colour.mask(hue_saturation_value(image))
        found = (self._measure(image, blob) for blob in blobs(mask, self.min_area_px))
        return [detection for detection in found if detection is not None]

    def _measure(self, image: Image, blob: Blob) -> Detection | None:
        if any(blob.touches(self.camera.size)):
            return None
        seen, disc = coverage(image, blob), None
        for _ in range(2):
            if disc is not None:
                seen = coverage(image, blob, disc.outline)
            if seen is None:
                return None
            middle, covariance, moments = seen.centroid()
            pixel = middle
            for _ in range(3):
                disc = self._disc_at(pixel)
                if disc is None:
                    return None
                pixel = middle - disc.offset
        if seen is None or disc is None:
            return None
        if not self._is_disc(seen.alpha.sum(), moments, disc.moments):
            return None
        return Detection(pixel, covariance + SAMPLING_PX**2 * np.eye(2), outline=disc.outline)

    def _is_disc(self, area: float, moments: Array, expected: Array) -> bool:
        """Tell by area and second moments whether a blob is an ellipse and as large as expected."""
        blur = BLUR_PX2 * np.eye(2)
        ratio = np.linalg.eigvals(np.linalg.solve(expected + blur, moments + blur)).real
        if ratio.max() > self.size_ratio**2 or ratio.min() < self.size_ratio**-2:
            return False
        # An ellipse's area is 4 pi times the root of the determinant of its second moments.
        sharp = np.maximum(np.linalg.eigvalsh(moments) - BLUR_PX2, 0.0)
        return bool(area >= self.min_fill * 4 * math.pi * math.sqrt(sharp.prod()))

    def _disc_at(self, pixel: Array) -> "_Disc | None":
        """Return a disc whose centre shows at a pixel, None where it would not be in view."""
        ray = self.camera.rays(pixel[None])[0]
        if not ray[2] < 0:
            return None
        centre = ray * (self.z_m - self.height_m) / ray[2]
        outline = self.camera.project(centre + self.radius_m * _CIRCLE)
        m = cv2.moments((outline - pixel).astype(np.float32))
        if not np.isfinite(outline).all() or m["m00"] == 0:
            return None
        offset = np.array([m["m10"], m["m01"]]) / m["m00"]
        moments = np.array([[m["mu20"], m["mu11"]], [m["mu11"], m["mu02"]]]) / m["m00"]
        return _Disc(outline, offset, moments)


@dataclass(frozen=True)
class _Disc:
    """A disc as the camera model projects it."""

    outline: Array
    """(k, 2) px."""
    offset: Array
    """(2,) px, the blob's middle less the projection of the disc's centre."""
    moments: Array
    """(2, 2) px^2, second ones of the blob."""


_TURN = np.linspace(0, 2 * np.pi, 48, endpoint=False)
_CIRCLE = np.column_stack([np.cos(_TURN), np.sin(_TURN), np.zeros_like(_TURN)])
