"""Centres of areas: of polygons, and of what a body changes in a picture."""

import numpy as np
from numpy.typing import NDArray


def polygon_centroid(corners: NDArray[np.float64]) -> NDArray[np.float64]:
    """(2,) centre of the area within corners (k, 2)."""
    start = corners.mean(axis=0)
    (x, y), (u, v) = (corners - start).T, (np.roll(corners, -1, axis=0) - start).T
    twice = x * v - u * y
    return start + np.array([(twice * (x + u)).sum(), (twice * (y + v)).sum()]) / (3 * twice.sum())


def centroid(weight: NDArray[np.float64]) -> NDArray[np.float64]:
    """(2,) centre u, v of weights (h, w) at pixels."""
    rows, columns = np.indices(weight.shape)
    return np.array([(columns * weight).sum(), (rows * weight).sum()]) / weight.sum()
