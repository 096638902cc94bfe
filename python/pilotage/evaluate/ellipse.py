"""The ellipse that holds the position with a given probability."""

import numpy as np
from numpy.typing import NDArray

from .consistency import ellipse_scale


def ellipse_axes(
    covariance: NDArray[np.float64], probability: float
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Compute radii and directions.

    Parameters
    ----------
    covariance : (..., 2, 2), m²; may be singular
    probability : float
        That a plane Gaussian lies inside.

    Returns
    -------
    radii : (..., 2), m, minor and major
    axes : (..., 2, 2)
        The unit vector along each radius is a column.
    """
    variance, axes = np.linalg.eigh(covariance)
    return ellipse_scale(probability) * np.sqrt(np.maximum(variance, 0.0)), axes
