"""Angles over arrays, for comparing trajectories."""

import numpy as np
from numpy.typing import ArrayLike, NDArray


def wrap_angle(angle: ArrayLike) -> NDArray[np.float64]:
    """Wrap into (−π, π].

    Parameters
    ----------
    angle : array_like, rad
        Any shape. An angle that is in (−π, π] already comes back bit for bit; NaN stays NaN.
    """
    turn = 2.0 * np.pi
    near = np.fmod(np.asarray(angle, dtype=np.float64), turn)  # exact, be it ever so large
    near = near - turn * np.rint(near / turn)
    # Rounding may leave it a step outside, and −π belongs to the other side.
    return np.asarray(near + turn * (near <= -np.pi) - turn * (near > np.pi))
