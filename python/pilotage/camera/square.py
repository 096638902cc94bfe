"""The corners of a dark square on a light margin, to hundredths of a pixel."""

from dataclasses import dataclass
from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from .blobs import ROUNDING
from .detection import Array, Image

if TYPE_CHECKING:
    from .. import CameraModel

END_PX = 3.0
"""So much of a side is left out at its ends, where the next one shows as well."""
REACH_PX = (2, 4)
"""A side is looked at from so far inside to so far outside, by what its border allows."""
FEWEST = 6
"""Places along a side."""
SAMPLING_PX = 0.02
"""What a pixel's finite size leaves of error in a corner, measured on renders without noise."""


@dataclass(frozen=True)
class Side:
    """One side, found as a straight line's offset from where it was believed to be."""

    normals: Array
    """(2, 2) outward unit normals at its two ends."""
    offsets: Array
    """(2,) px along them."""
    covariance: Array
    """(2, 2) px^2 of the offsets."""


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
    size = (grey.shape[1], grey.shape[0])
    for _ in range(2):
        sides = [_side(grey, np.roll(corners, -k, axis=0), modules, camera) for k in range(4)]
        found = [side for side in sides if side is not None]
        if len(found) < 4:
            return None
        spread = np.zeros((8, 8))
        covariance = np.zeros((8, 8))
        offsets = np.zeros(8)
        for k, side in enumerate(found):
            here, there = 2 * k, 2 * ((k + 1) % 4)
            # Two lines meet at each corner: that of its own side, and that of the one before.
            spread[here, here : here + 2] = side.normals[0]
            spread[there + 1, there : there + 2] = side.normals[1]
            ends = [here, there + 1]
            offsets[ends] = side.offsets
            covariance[np.ix_(ends, ends)] = side.covariance
        try:
            back = np.linalg.inv(spread)
        except np.linalg.LinAlgError:
            return None
        corners = corners + (back @ offsets).reshape(4, 2)
        if not ((corners >= 0) & (corners <= np.array(size) - 1)).all():
            return None
    return corners, back @ covariance @ back.T + SAMPLING_PX**2 * np.eye(8)


def _side(grey: Image, corners: Array, modules: int, camera: "CameraModel") -> Side | None:
    """Measure the side from the first of its square's corners to the second."""
    start, end, after, before = corners
    length = float(np.hypot(*(end - start)))
    count = int(length - 2 * END_PX) + 1
    if count < FEWEST:
        return None
    along = (end - start) / length
    outward = np.array([along[1], -along[0]])
    depth = min(outward @ (start - before), outward @ (end - after)) / modules
    reach = min(int(depth - 0.75), REACH_PX[1])
    if reach < REACH_PX[0]:
        return None
    s = np.linspace(END_PX / length, 1 - END_PX / length, count)
    place, normals = _line(camera, corners[:2], np.concatenate([[0.0], s, [1.0]]))
    normals *= np.sign(normals @ outward)[:, None]
    steps = np.arange(-reach, reach + 1.0)
    points = place[1:-1, None] + steps[:, None] * normals[1:-1, None]
    if not _inside(points, grey.shape):
        return None
    index, weight = _bilinear(points, grey.shape[1])
    light = (grey.ravel()[index] * weight).sum(axis=-1)
    edge_columns = slice(0, reach - 1), slice(reach + 2, None)
    dark, bright = (light[:, columns].mean() for columns in edge_columns)
    if bright - dark < 1:
        return None
    # The line that fits the light's edges: of each profile its length times the share that is dark.
    fit = np.linalg.pinv(np.column_stack([1 - s, s]))
    profile = len(steps) / 2 - ((light - dark) / (bright - dark)).sum(axis=1)
    # What a unit of light at each sample does to the two ends, also by the levels on both sides.
    pull = np.repeat(-fit[:, :, None], len(steps), axis=2)
    share = len(steps) / 2 * fit.sum(axis=1)
    for columns in edge_columns:
        pull[:, :, columns] += (share / light[:, columns].size)[:, None, None]
    pull /= bright - dark
    weights = np.stack(
        [np.bincount(index.ravel(), (one[..., None] * weight).ravel()) for one in pull]
    )
    nearest = grey.ravel()[np.take_along_axis(index, weight.argmax(-1)[..., None], -1)[..., 0]]
    level = np.concatenate([nearest[:, columns] for columns in edge_columns], axis=1)
    variance = _noise(level.astype(np.float64), s) + ROUNDING
    return Side(normals[[0, -1]], fit @ profile, variance * weights @ weights.T)


def _line(camera: "CameraModel", ends: Array, s: Array) -> tuple[Array, Array]:
    """Return places (n, 2) px along a line in space and unit normals (n, 2) to it in the image."""
    rays = camera.rays(ends)
    step = 1e-3
    both = np.concatenate([s - step, s + step, s])[:, None]
    a, b, place = np.split(camera.project(rays[0] + both * (rays[1] - rays[0])), 3)
    tangent = b - a
    tangent /= np.hypot(*tangent.T)[:, None]
    return place, np.column_stack([tangent[:, 1], -tangent[:, 0]])


def _inside(points: Array, shape: tuple[int, ...]) -> bool:
    u, v = points[..., 0], points[..., 1]
    return bool(
        (u >= 0).all() and (v >= 0).all() and (u < shape[1] - 1).all() and (v < shape[0] - 1).all()
    )


def _bilinear(points: Array, width: int) -> tuple[NDArray[np.int64], Array]:
    """Return indices (..., 4) into the flat image of the pixels about each, and weights."""
    corner = np.floor(points).astype(np.int64)
    u, v = np.moveaxis(points - corner, -1, 0)
    first = corner[..., 1] * width + corner[..., 0]
    index = first[..., None] + np.array([0, 1, width, width + 1])
    return index, np.stack([(1 - u) * (1 - v), u * (1 - v), (1 - u) * v, u * v], axis=-1)


def _noise(level: Array, s: Array) -> float:
    """Return the variance of light (n, k) about straight lines along the side."""
    design = np.column_stack([1 - s, s])
    residual = level - design @ (np.linalg.pinv(design) @ level)
    return float((residual**2).sum() / (level.size - 2 * level.shape[1]))
