"""Ellipses that hold the position with a given probability."""

import numpy as np
from numpy.typing import NDArray

from ..evaluate import ellipse_axes, ellipse_scale

PROBABILITY = 0.95
MAGNIFICATIONS = (1, 2, 5, 10, 20, 50, 100)


def ellipses(
    centre: NDArray[np.float64],
    covariance: NDArray[np.float64],
    probability: float = PROBABILITY,
    corners: int = 64,
) -> NDArray[np.float64]:
    """Compute outlines as polygons.

    Parameters
    ----------
    centre : (n, 2), m
    covariance : (n, 2, 2), m²; may be singular
    probability : float
        That a plane Gaussian lies inside.
    corners : int

    Returns
    -------
    (n, corners, 2), m
    """
    radii, axes = ellipse_axes(covariance, probability)
    angle = np.linspace(0.0, 2.0 * np.pi, corners, endpoint=False)
    circle = np.stack([np.cos(angle), np.sin(angle)])
    outline = (axes * radii[:, None, :]) @ circle
    return np.asarray(centre[:, None, :] + outline.transpose(0, 2, 1))


def magnification(radius: float, visible: float) -> int:
    """Choose how many times larger to draw an ellipse so that its radius is visible."""
    if radius == 0.0:
        return 1
    fits = [factor for factor in MAGNIFICATIONS if factor * radius >= visible]
    return fits[0] if fits else MAGNIFICATIONS[-1]


def ellipse_label(times: int = 1, probability: float = PROBABILITY) -> str:
    """Say what the ellipse is, with its probability and its size in standard deviations."""
    text = f"{100.0 * probability:.3g} % position ellipse ({ellipse_scale(probability):.4f} σ"
    return text + (f", drawn {times}×)" if times > 1 else ")")
