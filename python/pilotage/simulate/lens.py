"""Where every part of every pixel of a camera looks."""

from functools import cache

import cv2
import numpy as np
from numpy.typing import NDArray

from .. import CameraModel

Box = tuple[int, int, int, int]
"""First column, first row, one past the last column, one past the last row."""
MARGIN = 2
"""Of rays round the picture, px: those of parts of a pixel lie between those of two pixels."""


class Lens:
    """The rays of a camera, computed once, in the level frame of the sensor.

    Between the centres of pixels they are interpolated linearly, which errs by less than 1e-3 px
    for a lens that bends less than a few thousandths of a pixel from one pixel to the next.
    """

    def __init__(self, model: CameraModel) -> None:
        self.model = model
        self.width, self.height = model.size
        columns, rows = np.meshgrid(
            np.arange(-MARGIN, self.width + MARGIN), np.arange(-MARGIN, self.height + MARGIN)
        )
        pixels = np.column_stack([columns.ravel(), rows.ravel()]).astype(np.float64)
        self._rays = model.rays(pixels).reshape(*columns.shape, 3).astype(np.float32)
        central = self._rays[MARGIN:-MARGIN, MARGIN:-MARGIN].copy()
        self.blind = ~np.isfinite(central).all(axis=2)
        """(h, w) whether a pixel's centre sees nothing: the lens ends before."""
        central[self.blind] = (0.0, 0.0, 1.0)
        self.central = central
        """(h, w, 3) float32, of the pixels' centres."""

    def parts(
        self, rows: NDArray[np.intp], columns: NDArray[np.intp], n: int
    ) -> NDArray[np.float32]:
        """(k, n * n, 3) rays of the n by n parts of pixels (k,)."""
        step = np.arange(-1, 2)
        around = self._rays[
            rows[:, None, None] + step[:, None] + MARGIN, columns[:, None, None] + step + MARGIN
        ]
        rays: NDArray[np.float32] = _shares(n) @ around.reshape(-1, 9, 3)
        return rays

    def box(self, points: NDArray[np.float64]) -> Box | None:
        """Return the pixels in which a body may be that these points (k, 3) m enclose densely.

        Points of which some have no pixel may be anywhere: then all of the picture.
        """
        pixels = self.model.project(points)
        there = np.isfinite(pixels).all(axis=1)
        if not there.any():
            return None
        if not there.all():
            return 0, 0, self.width, self.height
        limit = (self.width, self.height)
        low = np.clip(np.floor(pixels.min(axis=0)) - 1, 0, limit)
        high = np.clip(np.ceil(pixels.max(axis=0)) + 2, 0, limit)
        if (low >= high).any():
            return None
        return int(low[0]), int(low[1]), int(high[0]), int(high[1])


def turned(rays: NDArray[np.float32], rotation: NDArray[np.float64]) -> NDArray[np.float32]:
    """(rows, columns, 3) rays by a rotation (3, 3)."""
    result: NDArray[np.float32] = cv2.transform(rays, rotation)
    return result


@cache
def _shares(n: int) -> NDArray[np.float32]:
    """(n * n, 9) weights of a pixel and those around it for the middle of each of its parts.

    The parts are a little askew, so that an edge along rows or columns does not pass all of a row
    of them at once.
    """
    i, j = np.indices((n, n)).reshape(2, -1)
    v, u = (
        np.stack([np.maximum(-off, 0.0), 1.0 - np.abs(off), np.maximum(off, 0.0)], axis=1)
        for off in ((i + (j + 0.5) / n) / n - 0.5, (j + (i + 0.5) / n) / n - 0.5)
    )
    return np.asarray(v[:, :, None] * u[:, None, :], np.float32).reshape(n * n, 9)
