"""What a Gaussian range and bearing are in the plane, exactly."""

import numpy as np
from numpy.typing import NDArray


def polar_moments(
    mean: NDArray[np.float64], sigma: NDArray[np.float64]
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Return mean (2,) and covariance (2, 2) of (r cos b, r sin b), r and b independent.

    They follow from E exp(i k b) = exp(i k mean - k² sigma² / 2), k = 1 and 2.

    Parameters
    ----------
    mean, sigma : (2,) float
        Of range [m] and bearing [rad].
    """
    first = np.exp(1j * mean[1] - sigma[1] ** 2 / 2.0)
    second = np.exp(2j * mean[1] - 2.0 * sigma[1] ** 2)
    centre = mean[0] * np.array([first.real, first.imag])
    power = mean[0] ** 2 + sigma[0] ** 2
    square = [[1.0 + second.real, second.imag], [second.imag, 1.0 - second.real]]
    return centre, power / 2.0 * np.array(square) - np.outer(centre, centre)
