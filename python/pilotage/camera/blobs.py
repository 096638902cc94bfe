"""Blobs of one colour, and how much of each pixel about them is marker."""

from collections.abc import Iterator
from dataclasses import dataclass

import cv2
import numpy as np
from numpy.typing import NDArray

from .detection import Array, Image

EDGE_PX = 2
"""A pixel this far inside a blob's edge is all marker, one this far outside is none."""
RING_PX = 4
"""The background is looked at from the edge's end to this much further."""
ROUNDING = 1 / 12
"""Variance of rounding to whole levels."""


@dataclass(frozen=True)
class Blob:
    """One connected piece of a mask, its holes filled, with some of its surroundings."""

    box: tuple[int, int, int, int]
    """left, top, width, height of the piece itself, px."""
    window: tuple[slice, slice]
    """Rows and columns of the image that the arrays below are of."""
    filled: NDArray[np.uint8]
    others: NDArray[np.uint8]
    """What else the mask has in the window."""

    @property
    def area(self) -> int:
        """Its pixels."""
        return int(np.count_nonzero(self.filled))

    def rows(self, first: int, last: int) -> "Blob":
        """Return what of it lies in the image's rows from first to before last."""
        rows, columns = self.window
        first, last = max(first, rows.start), min(last, rows.start + len(self.filled))
        cut = slice(first - rows.start, last - rows.start)
        return Blob(self.box, (slice(first, last), columns), self.filled[cut], self.others[cut])

    def touches(self, size: tuple[int, int]) -> tuple[bool, bool, bool, bool]:
        """Whether it reaches the left, top, right, bottom border, where its edge is not seen."""
        left, top, width, height = self.box
        right, bottom = size[0] - left - width, size[1] - top - height
        return left < EDGE_PX, top < EDGE_PX, right < EDGE_PX, bottom < EDGE_PX


def blobs(mask: Image, min_area_px: float) -> Iterator[Blob]:
    """Find the pieces of a mask (h, w) that have at least so many pixels."""
    margin = 2 * EDGE_PX + RING_PX + 1
    # Noise tears what is hardly a pixel thick.
    whole: Image = cv2.morphologyEx(mask, cv2.MORPH_CLOSE, np.ones((3, 3), np.uint8))
    for contour in cv2.findContours(whole, cv2.RETR_EXTERNAL, cv2.CHAIN_APPROX_NONE)[0]:
        left, top, width, height = cv2.boundingRect(contour)
        if width * height < min_area_px:
            continue
        u, v = max(left - margin, 0), max(top - margin, 0)
        window = (slice(v, top + height + margin), slice(u, left + width + margin))
        filled = np.zeros_like(whole[window])
        cv2.drawContours(filled, [contour], -1, 255, cv2.FILLED, offset=(-u, -v))
        if np.count_nonzero(filled) >= min_area_px:
            others = whole[window] & ~filled
            yield Blob((left, top, width, height), window, filled, others)


@dataclass(frozen=True)
class Coverage:
    """How much of each pixel is marker."""

    u: Array
    """(w,) px of the columns."""
    v: Array
    """(h,) px of the rows."""
    alpha: Array
    """(h, w), 1 marker, 0 background. Noise leaves [0, 1]: cut off there it would move the edge."""
    sigma: Array
    """(h, w) of `alpha`, 0 where it is known."""

    def centroid(self) -> tuple[Array, Array, Array]:
        """Return centre (2,) px, its covariance (2, 2) px^2 and second moments (2, 2) px^2."""
        u, v = np.meshgrid(self.u, self.v)
        pixels = np.column_stack([u.ravel(), v.ravel()])
        weight = self.alpha.ravel()
        area = weight.sum()
        centre = weight @ pixels / area
        arm = pixels - centre
        pull = arm * self.sigma.ravel()[:, None]
        return centre, pull.T @ pull / area**2, (arm * weight[:, None]).T @ arm / area


def coverage(image: Image, blob: Blob, outline: Array | None = None) -> Coverage | None:
    """Tell how much of each pixel is marker, by its colour between marker and background.

    The noise is that of the background about the blob. None where no background is
    to be seen, or the blob does not stand out from it.
    With an outline (k, 2) px it is looked at inside of that too: the ends of a blob that is hardly
    a pixel thick are too pale for its mask.
    """
    core = cv2.erode(blob.filled, _round(EDGE_PX)) > 0
    place = blob.filled.copy()
    if outline is not None:
        corner = (blob.window[1].start, blob.window[0].start)
        cv2.fillPoly(place, [np.rint(outline - corner).astype(np.int32)], 255)
    near = cv2.dilate(place, _round(EDGE_PX)) > 0
    wide = cv2.dilate(place, _round(EDGE_PX + 1)) > 0
    far = cv2.dilate(place, _round(EDGE_PX + RING_PX)) > 0
    foreign = cv2.dilate(blob.others, _round(EDGE_PX)) > 0
    ring = far & ~wide & ~foreign
    if np.count_nonzero(ring) < 8:
        return None
    colours = image[blob.window].astype(np.float64)
    background = np.median(colours[ring], axis=0)
    step = colours[core if core.any() else blob.filled > 0].mean(axis=0) - background
    contrast = step @ step
    if contrast == 0:
        return None
    alpha = (colours - background) @ step / contrast
    variance = np.mean(alpha[ring] ** 2) + ROUNDING / contrast
    alpha[core] = 1.0
    alpha[~near | foreign] = 0.0
    if alpha.sum() < blob.area / 4:
        return None
    sigma = np.where(near & ~core & ~foreign, np.sqrt(variance), 0.0)
    rows, columns = blob.window
    return Coverage(
        columns.start + np.arange(alpha.shape[1], dtype=np.float64),
        rows.start + np.arange(alpha.shape[0], dtype=np.float64),
        alpha,
        sigma,
    )


def _round(radius: int) -> NDArray[np.uint8]:
    size = 2 * radius + 1
    kernel: NDArray[np.uint8] = cv2.getStructuringElement(cv2.MORPH_ELLIPSE, (size, size))
    return kernel
