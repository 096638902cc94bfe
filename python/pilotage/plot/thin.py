"""Fewer points to draw, with no visible loss."""

import numpy as np
from numpy.typing import NDArray

Array = NDArray[np.float64]


def envelope(x: Array, y: Array, buckets: int = 1500) -> tuple[Array, Array]:
    """Keep the lowest and the highest point of each of `buckets` runs of equal length.

    A run that is all NaN stays NaN, so that a gap stays a gap. Series that are short enough come
    back as they are.
    """
    size = -(-y.size // buckets)
    if size <= 2:
        return x, y
    starts = np.arange(0, y.size, size)
    padded = np.full(starts.size * size, np.nan)
    padded[: y.size] = y
    runs = padded.reshape(-1, size)
    low = np.where(np.isnan(runs), np.inf, runs).argmin(axis=1)
    high = np.where(np.isnan(runs), -np.inf, runs).argmax(axis=1)
    index = (np.sort(np.stack([low, high], axis=1), axis=1) + starts[:, None]).ravel()
    return x[index], y[index]


def stride(count: int, limit: int) -> slice:
    """Step over `count` rows so that at most `limit` remain."""
    return slice(None, None, max(1, -(-count // limit)))
