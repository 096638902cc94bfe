"""The corners of a dark square on a light margin, to hundredths of a pixel."""

import math
from collections.abc import Callable
from typing import TYPE_CHECKING

import numpy as np

from .blobs import ROUNDING
from .detection import Array, Image

if TYPE_CHECKING:
    from .. import CameraModel

END_PX = 3.0
"""So much of a side is left out at its ends, where the next one shows as well."""
REACH_PX = (2, 4)
"""A side is looked at from so far inside to so far outside, by what its border allows."""
CLEAR_PX = 1.5
"""Nearer than this to the border's end, what is beyond shows through the blur."""
NARROWEST_PX = 2.75
"""A border that is still one."""
BLUR_PX = 0.7
"""Standard deviation of what lens and pixel make of an edge."""
FEWEST = 6
"""Places along a side."""
PASSES = 3
"""Each looks where the last one found the sides: an edge half out of reach is not seen whole."""
FITTED = 2.7
"""Of the samples' freedom what a line takes: two, and more as neighbours share pixels."""
SAMPLING_PX = 0.01
"""What a pixel's finite size leaves of error in a corner, measured on renders without noise."""


def refine(
    grey: Image, corners: Array, modules: int, camera: "CameraModel"
) -> tuple[Array, Array] | None:
    """Move the corners to where the lines through the sides meet.

    `cv2.cornerSubPix` is off by some tenths of a pixel at the corner of a square: the image is
    round there. A side is straight in space, so as curved in the image as the camera model says,
    and where it lies follows from how much light there is from its inside to its outside.

    Parameters
    ----------
    grey : (h, w) uint8
    corners : (4, 2) px, clockwise as seen, off by less than a pixel
    modules : that the square's side has, of which the outermost are dark

    Returns
    -------
    corners (4, 2) px and covariance (8, 8) px^2 of u0, v0, u1, ... from the image's noise; None
    where the square is too small in the image or its sides are not to be seen
    """
    for _ in range(PASSES):
        sides = _sides(grey, corners, modules, camera)
        if sides is None:
            return None
        normals, offsets, covariance = sides
        # Two lines meet at each corner: the beginning of its own side, the end of the one before.
        spread = np.zeros((4, 2, 4, 2))
        each = np.arange(4)
        spread[each, 0, each] = normals[:, 0]
        spread[each, 1, (each + 1) % 4] = normals[:, 1]
        back = np.linalg.inv(spread.reshape(8, 8))
        corners = corners + (back @ offsets).reshape(4, 2)
    return corners, back @ covariance @ back.T + SAMPLING_PX**2 * np.eye(8)


def _sides(
    grey: Image, corners: Array, modules: int, camera: "CameraModel"
) -> tuple[Array, Array, Array] | None:
    """Measure the sides, the first of which goes from the first corner to the second.

    Returns
    -------
    outward unit normals (4, 2, 2) at the beginning and the end of each side, the sides' offsets
    (8,) px along them, and the covariance (8, 8) px^2 of these
    """
    along = np.roll(corners, -1, axis=0) - corners
    length = np.hypot(*along.T)
    outward = np.column_stack([along[:, 1], -along[:, 0]]) / length[:, None]
    opposite = np.roll(corners, -2, axis=0), np.roll(corners, -3, axis=0)
    depth = min(float(((corners - far) * outward).sum(axis=1).min()) for far in opposite)
    border = depth / modules
    reach = int(np.clip(border - CLEAR_PX, *REACH_PX))
    count = int(length.min() - 2 * END_PX) + 1
    if border < NARROWEST_PX or count < FEWEST:
        return None
    end = (END_PX / length)[:, None]
    s = end + (1 - 2 * end) * np.linspace(0, 1, count)
    place, normals = _lines(camera, corners, np.column_stack([np.zeros(4), s, np.ones(4)]))
    steps = np.arange(-reach, reach + 1.0)
    patch = _patch(grey, place[:, 1:-1, None] + steps[:, None] * normals[:, 1:-1, None])
    if patch is None:
        return None
    light, shares, by_pixels = patch
    rims = slice(0, reach - 1), slice(reach + 2, None)
    dark, bright = (light[..., rim].mean(axis=(1, 2)) for rim in rims)
    contrast = bright - dark
    if contrast.min() < 1:
        return None
    # The line that fits the light's edges: of each profile its length times the share that is dark.
    design = np.stack([1 - s, s], axis=-1)
    fit = np.linalg.solve(design.transpose(0, 2, 1) @ design, design.transpose(0, 2, 1))
    share = ((light - dark[:, None, None]) / contrast[:, None, None]).sum(axis=2)
    offsets = (fit @ (len(steps) / 2 - share)[..., None]).ravel()
    # What a unit of light at each sample does to them, also by the levels on both sides.
    pull = np.repeat(-fit[..., None], len(steps), axis=3)
    common = len(steps) / 2 * fit.sum(axis=2)[..., None, None]
    for rim in rims:
        pull[..., rim] += common / light[0, :, rim].size
    weights = by_pixels(pull / contrast[:, None, None, None])
    level, kept = (np.concatenate([a[..., rim] for rim in rims], axis=2) for a in (light, shares))
    uneven = level - design @ (fit @ level)
    variance = (uneven**2).sum() / kept.sum() / (1 - FITTED / count) + ROUNDING
    # Half of the modules beyond the border are bright, and each side has others.
    through = math.erfc((border - reach) / (math.sqrt(2) * BLUR_PX)) / 4
    beyond = through**2 * np.kron(np.eye(4), np.ones((2, 2)))
    return normals[:, [0, -1]], offsets, variance * weights @ weights.T + beyond


def _lines(camera: "CameraModel", corners: Array, s: Array) -> tuple[Array, Array]:
    """Return places (4, n, 2) px at s (4, n) along lines in space and their normals there."""
    rays = camera.rays(corners)[:, None]
    step = 1e-3
    both = np.stack([s, s - step, s + step])[..., None]
    points = rays + both * (np.roll(rays, -1, axis=0) - rays)
    place, before, after = camera.project(points.reshape(-1, 3)).reshape(3, *s.shape, 2)
    along = after - before
    normals = np.stack([along[..., 1], -along[..., 0]], axis=-1)
    return place, normals / np.linalg.norm(normals, axis=-1, keepdims=True)


def _patch(grey: Image, points: Array) -> tuple[Array, Array, Callable[[Array], Array]] | None:
    """Sample an image between its pixels, None where that would be outside of it.

    Returns
    -------
    light (4, n, m) at points (4, n, m, 2) px, their share of a pixel's variance, and what turns
    weights (4, 2, n, m) of the samples into weights (8, p) of the pixels that they are made of
    """
    low, high = points.min(axis=(0, 1, 2)), points.max(axis=(0, 1, 2))
    if not ((low >= 0).all() and (high < np.array(grey.shape[::-1]) - 1).all()):
        return None
    first, last = np.floor(low).astype(int), np.floor(high).astype(int) + 2
    patch = grey[first[1] : last[1], first[0] : last[0]]
    width = patch.shape[1]
    whole = np.floor(points - first).astype(np.int64)
    u, v = np.moveaxis(points - first - whole, -1, 0)
    corner = whole[..., 1] * width + whole[..., 0]
    index = np.stack([corner, corner + 1, corner + width, corner + width + 1])
    weight = np.stack([(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v])
    four = patch.ravel()[index]

    def by_pixels(pull: Array) -> Array:
        rows = [
            np.bincount(
                index[:, side].ravel(), (one * weight[:, side]).ravel(), minlength=patch.size
            )
            for side in range(4)
            for one in pull[side]
        ]
        return np.stack(rows)

    return (four * weight).sum(axis=0), (weight**2).sum(axis=0), by_pixels
