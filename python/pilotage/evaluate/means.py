"""Means of what is known."""

from typing import Any

import numpy as np
from numpy.typing import NDArray


def mean_of_known(values: NDArray[np.float64], axis: int | None = None) -> Any:
    """Return the mean of all that is not NaN, or along an axis; NaN where nothing is known."""
    known = ~np.isnan(values)
    count = known.sum(axis=axis)
    total = np.where(known, values, 0.0).sum(axis=axis)
    return np.where(count > 0, total / np.maximum(count, 1), np.nan)[()]


def root_mean_square(values: NDArray[np.float64], axis: int | None = None) -> Any:
    """Return the root of the mean square of all that is not NaN, or along an axis."""
    return np.sqrt(mean_of_known(np.square(values), axis))
