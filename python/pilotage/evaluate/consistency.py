"""Whether the filter's covariance tells the truth about its errors.

Source: Y. Bar-Shalom, X. R. Li, T. Kirubarajan, *Estimation with Applications to Tracking and
Navigation*, 2001, section 5.4.
"""

import math

import numpy as np
from numpy.typing import NDArray

# Of a correlation matrix; a smaller one leaves less than four digits of the result.
SMALLEST_PIVOT = 1e-12


def mahalanobis_squared(
    error: NDArray[np.float64], covariance: NDArray[np.float64]
) -> NDArray[np.float64]:
    """Return eᵀ P⁻¹ e row by row: the NEES of an error, the NIS of an innovation.

    P is brought to unit diagonal, so that metres and radians weigh alike in the test for
    singularity, and solved by elimination (L D Lᵀ) over all rows at once, not inverted.

    Parameters
    ----------
    error : (n, k)
    covariance : (n, k, k)

    Returns
    -------
    (n,)
        NaN where the error is not known, or the covariance is not positive definite.
    """
    variance = np.diagonal(covariance, axis1=1, axis2=2)
    sigma = np.sqrt(np.where(variance > 0.0, variance, np.nan))
    z = error / sigma
    rest = covariance / (sigma[:, :, None] * sigma[:, None, :])
    total = np.zeros(len(error))
    for j in range(error.shape[1]):
        pivot = np.where(rest[:, j, j] > SMALLEST_PIVOT, rest[:, j, j], np.nan)
        total += z[:, j] ** 2 / pivot
        factor = rest[:, j + 1 :, j] / pivot[:, None]
        z[:, j + 1 :] -= factor * z[:, j, None]
        rest[:, j + 1 :, j + 1 :] -= factor[:, :, None] * rest[:, j, None, j + 1 :]
    return total


def mean_square_band(dof: float, probability: float = 0.95, count: int = 1) -> tuple[float, float]:
    """Return the two-sided band for the mean of `count` independent NEES or NIS values.

    Parameters
    ----------
    dof : float
        Degrees of freedom of one value.
    probability : float
        Of the band, with equal tails.
    count : int
        Values in the mean; 1 gives the band of single values.
    """
    from scipy.special import gammaincinv  # the chi-square quantile, without all of scipy.stats

    ends = np.array([1.0 - probability, 1.0 + probability]) / 2.0
    low, high = 2.0 * gammaincinv(dof * count / 2.0, ends) / count
    return float(low), float(high)


def ellipse_scale(probability: float) -> float:
    """Return k so that the kσ ellipse of a plane Gaussian holds `probability`: 2.4477 for 95 %."""
    return math.sqrt(-2.0 * math.log1p(-probability))


def sigma_probability(k: float) -> float:
    """Return the probability within ±kσ of a scalar Gaussian: 95.4 % within 2σ."""
    return math.erf(k / math.sqrt(2.0))
