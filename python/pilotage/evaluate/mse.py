"""Mean squared errors of each state, as tables of filter comparisons have them."""

import numpy as np
from numpy.typing import NDArray

from .angles import wrap_angle


def mean_squared_errors(
    estimate: NDArray[np.float64], truth: NDArray[np.float64], parts: int = 1
) -> NDArray[np.float64]:
    """Average squared errors over parts of equal length of a trajectory, the start left out.

    Parameters
    ----------
    estimate, truth : (parts * k + 1, 3) float
        x, y [m] and heading [rad].

    Returns
    -------
    (parts, 3) float, m², m², rad²
    """
    error = (estimate - truth)[1:]
    error[:, 2] = wrap_angle(error[:, 2])
    return np.asarray((error**2).reshape(parts, -1, 3).mean(axis=1))


def spread(values: NDArray[np.float64], of: int = 1) -> tuple[float, float]:
    """Return between which the middle 90 % of the means of so many runs lie; values (runs,)."""
    of = min(of, len(values))
    whole = len(values) // of * of
    low, high = np.percentile(values[:whole].reshape(-1, of).mean(axis=1), (5.0, 95.0))
    return float(low), float(high)
