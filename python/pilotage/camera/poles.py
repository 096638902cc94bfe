"""Coloured vertical poles, as Sousa and Costa's: bearing of the centre line, distance by height."""

import math
from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np

from .. import CameraModel
from ..fields import within
from .blobs import EDGE_PX, Blob, Coverage, blobs, coverage
from .colour import Colour, hue_saturation_value
from .detection import Array, Detection, Image, check_size

LINE_SAMPLING_PX = 0.02
"""What a pixel's finite size leaves of error in a centre line, measured without noise."""
END_SAMPLING_PX = 0.15
"""Likewise in an end's row, and what a picture's compression does to it."""
FRINGE, FRINGE_PX = 0.3, 8
"""A blob beside a pole of another colour is its fringe if it has less than so much of its width.

Compressed pictures hold colours in blocks of some pixels: beside a red pole there is an orange rim.
"""
STRIP_ROWS = 24
"""Of a pole that are held against one background: it reaches from the grass into the sky."""
THINNEST_PX = 0.5
"""A row with less of the pole is none of it."""
INSIDE_ROWS = 8
"""By which it is judged how light the pole itself is beside its end."""
UNKNOWN_RAD = 1.0
"""Sigma of the foot's elevation where the foot is not in view."""


@dataclass(frozen=True)
class End:
    """Top or bottom of a blob."""

    pixel: Array
    """(2,) px, on the centre line."""
    sigma_px: float
    """Of its row."""


@dataclass(frozen=True)
class PoleDetector:
    """Finds upright blobs of some colours; the label of a pole is that of its colour.

    A pole's surveyed point is its foot on the ground. The camera's roll may be some degrees.
    """

    camera: CameraModel
    height_m: float
    """Of the poles."""
    colours: Mapping[int, Colour]
    """By label."""
    radius_m: float = 0.0
    """Of the poles: what is seen of their ends is nearer than their axis."""
    min_area_px: float = 30.0
    min_aspect: float = 2.0
    """Smallest height of a blob over its width."""

    def __post_init__(self) -> None:
        within("height_m", self.height_m, 1e-3, 100.0)
        within("radius_m", self.radius_m, 0.0, 10.0)
        within("min_area_px", self.min_area_px, 1.0)
        within("min_aspect", self.min_aspect, 0.0)

    def detect(self, image: Image) -> list[Detection]:
        """Return the poles of an image (h, w, 3) whose left and right sides are in view."""
        check_size(image, self.camera.size)
        hsv = hue_saturation_value(image)
        found = (
            self._measure(image, blob, label)
            for label, colour in self.colours.items()
            for blob in blobs(colour.mask(hsv), self.min_area_px)
        )
        poles = [detection for detection in found if detection is not None]
        return [one for one in poles if not any(_is_fringe(one, other) for other in poles)]

    def _measure(self, image: Image, blob: Blob, label: int) -> Detection | None:
        _, top, width, height = blob.box
        on_left, on_top, on_right, on_bottom = blob.touches(self.camera.size)
        if on_left or on_right or height < self.min_aspect * width:
            return None
        # The ends of a thick pole are round.
        rim = EDGE_PX + 1 + width // 4
        first, last = top + rim, top + height - rim
        line = self._line(image, blob, first, last)
        if line is None:
            return None
        upper = None if on_top else _end(image, blob, first, -1)
        lower = None if on_bottom else _end(image, blob, last - 1, 1)
        return self._detection(label, line, upper, lower, _box(blob))

    def _line(self, image: Image, blob: Blob, first: int, last: int) -> tuple[float, float] | None:
        """Return azimuth [rad] and variance [rad^2] of the centre line between two rows."""
        if last - first < INSIDE_ROWS // 2:
            return None
        strips = np.array_split(np.arange(first, last), max((last - first) // STRIP_ROWS, 1))
        found = [coverage(image, blob.rows(int(rows[0]), int(rows[-1]) + 1)) for rows in strips]
        tried = [self._azimuth(seen) for seen in found if seen is not None]
        parts = [part for part in tried if part is not None]
        if not parts:
            return None
        azimuth, variance, floor = np.transpose(parts)
        weight = 1 / variance
        total = float(weight.sum())
        return float(azimuth @ weight) / total, 1 / total + float(floor.mean())

    def _azimuth(self, seen: Coverage) -> tuple[float, float, float] | None:
        """Return azimuth [rad] midway between the two sides, its variance and that of sampling."""
        whole = seen.alpha.sum(axis=1) > THINNEST_PX
        if not whole.any():
            return None
        alpha, sigma, v = seen.alpha[whole], seen.sigma[whole], seen.v[whole]
        wide = alpha.sum(axis=1)
        middle = alpha @ seen.u / wide
        noise = (((seen.u - middle[:, None]) * sigma) ** 2).sum(axis=1) / wide**2
        sides = [np.column_stack([middle + half * wide, v]) for half in (-0.5, 0.5)]
        # A side's azimuth and not its pixel: in those the axis is not midway in a wide pole.
        azimuth = np.mean([self.camera.angles(side)[:, 0] for side in sides], axis=0)
        covariance = np.zeros((len(noise), 2, 2))
        covariance[:, 0, 0] = noise
        variance = self.camera.angle_covariance(sides[0], covariance)[:, 0, 0]
        floor = LINE_SAMPLING_PX**2 * np.mean(variance / noise)
        return float(azimuth.mean()), float(variance.mean() / len(variance)), float(floor)

    def _detection(
        self,
        label: int,
        line: tuple[float, float],
        top: End | None,
        bottom: End | None,
        outline: Array,
    ) -> Detection | None:
        """Put together what the centre line and the ends that are in view tell."""
        azimuth, variance = line
        distance, slant, sigma = 1.0, math.nan, math.nan
        down, sigma_down = self._elevation(bottom, azimuth)
        if top is not None and bottom is not None:
            up, sigma_up = self._elevation(top, azimuth)
            if not up > down:
                return None
            distance, slant = self._distance(up, down)
            by_up, by_down = (
                (self._distance(up + a, down + b)[1] - slant) / 1e-6
                for a, b in ((1e-6, 0.0), (0.0, 1e-6))
            )
            sigma = math.hypot(by_up * sigma_up, by_down * sigma_down)
        ahead = np.array([math.cos(azimuth), math.sin(azimuth)])
        foot = np.append(distance * ahead, (distance - self.radius_m) * math.tan(down))
        pixel = self.camera.project(foot[None])[0]
        covariance = _in_pixels(self.camera, pixel, np.diag([variance, sigma_down**2]))
        return Detection(
            pixel,
            covariance,
            label=label,
            range_m=slant,
            sigma_range_m=sigma,
            has_elevation=False,
            outline=outline,
        )

    def _elevation(self, end: End | None, azimuth: float) -> tuple[float, float]:
        """Return elevation and sigma [rad] of an end."""
        if end is None:
            return 0.0, UNKNOWN_RAD
        # In its row, the centre line is where its azimuth is: a few rows inside it was elsewhere.
        elevation = self.camera.angles(end.pixel[None])[0, 1]
        line = np.array([math.cos(azimuth), math.sin(azimuth), math.tan(elevation)])
        pixel = np.array([self.camera.project(line[None])[0, 0], end.pixel[1]])
        noise = np.diag([0.0, end.sigma_px**2])[None]
        variance = self.camera.angle_covariance(pixel[None], noise)[0, 1, 1]
        return float(self.camera.angles(pixel[None])[0, 1]), math.sqrt(variance)

    def _distance(self, up: float, down: float) -> tuple[float, float]:
        """Return distance to the axis and slant range to the foot [m] by the ends' elevations."""
        # The foot's near rim is seen; of the top the near one from below, the far one from above.
        high, low = math.tan(up), math.tan(down)
        distance = (self.height_m + self.radius_m * (abs(high) - low)) / (high - low)
        return distance, math.hypot(distance, (distance - self.radius_m) * low)


def _is_fringe(one: Detection, other: Detection) -> bool:
    """Tell whether a blob is the rim of another one of another colour."""
    (low, high), (other_low, other_high) = (
        (blob.outline.min(axis=0), blob.outline.max(axis=0)) for blob in (one, other)
    )
    narrow = high[0] - low[0] + 1 < FRINGE * (other_high[0] - other_low[0] + 1)
    beside = (low <= other_high + FRINGE_PX).all() and (high >= other_low - FRINGE_PX).all()
    return one.label != other.label and narrow and bool(beside)


def _end(image: Image, blob: Blob, inside: int, outward: int) -> End | None:
    """Find where a blob ends upwards (-1) or downwards (1) of a row that is well inside of it.

    Held against the background there: a pole reaches from the grass into the sky.
    """
    reach = 2 * blob.box[3]
    span = sorted((inside - outward * (INSIDE_ROWS - 1), inside + outward * reach))
    part = blob.rows(span[0], span[1] + 1)
    seen = coverage(image, part)
    if seen is None:
        return None
    # From the inside outwards.
    v, alpha, sigma = seen.v[::outward], seen.alpha[::outward], seen.sigma[::outward]
    body = alpha[:INSIDE_ROWS].sum(axis=0)
    middle, width = float(seen.u @ body / body.sum()), float(body.sum() / INSIDE_ROWS)
    # A thin pole shows in all columns; of a thick one the middle counts, for its rim is round.
    near = np.abs(seen.u - middle) <= (width + EDGE_PX if width < 6 else max(0.08 * width, 1.0))
    light, noise = alpha[:, near].sum(axis=1), (sigma[:, near] ** 2).sum(axis=1)
    plain = light[:INSIDE_ROWS].mean()
    if not plain > 0:
        return None
    beyond = light[INSIDE_ROWS:].sum() / plain
    variance = noise[INSIDE_ROWS:].sum() + beyond**2 * noise[:INSIDE_ROWS].sum() / INSIDE_ROWS**2
    row = v[INSIDE_ROWS - 1] + outward * (0.5 + beyond)
    return End(np.array([middle, row]), math.hypot(math.sqrt(variance) / plain, END_SAMPLING_PX))


def _in_pixels(camera: CameraModel, pixel: Array, covariance: Array) -> Array:
    """Return the covariance (2, 2) px^2 at a pixel that has this one (2, 2) rad^2 in angles."""
    step = 0.1
    angles = camera.angles(pixel + step * np.array([[1, 0], [-1, 0], [0, 1], [0, -1.0]]))
    back = np.linalg.inv(np.column_stack([angles[0] - angles[1], angles[2] - angles[3]])) * 2 * step
    return back @ covariance @ back.T


def _box(blob: Blob) -> Array:
    left, top, width, height = blob.box
    right, bottom = left + width - 1, top + height - 1
    return np.array([[left, top], [right, top], [right, bottom], [left, bottom]], dtype=np.float64)
