"""A body that pitches and rolls, as on rough ground."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from ..evaluate import wrap_angle
from ..fields import within
from .drives import Drive
from .wander import gauss_markov


@dataclass(frozen=True)
class Tilt:
    """Pitch and roll, each a Gauss-Markov process about level ground."""

    rms_rad: float
    """Of each of the two."""
    tau_s: float = 0.0
    """Correlation time; 0: new at every motion sample."""

    def __post_init__(self) -> None:
        within("rms_rad", self.rms_rad, 0.0, 1.0)
        within("tau_s", self.tau_s, 0.0)

    def angles(self, drive: Drive, rng: np.random.Generator) -> NDArray[np.float64]:
        """(n + 1, 2) pitch (nose down) and roll (right side down) [rad] at the drive's stamps."""
        step_s = float(drive.utime[1] - drive.utime[0]) * 1e-6
        return gauss_markov(self.rms_rad, self.tau_s, step_s, (len(drive.utime), 2), rng)


def tilted(
    level: NDArray[np.float64], angles: NDArray[np.float64], yaw_rad: float
) -> NDArray[np.float64]:
    """Turn lines of sight into the axes of a tilted body, exactly; the sensor stays in its place.

    Parameters
    ----------
    level : (f, m, 3)
        Bearing, elevation [rad] and range [m] of m markers in f frames, as on level ground.
    angles : (f, 2)
        Pitch and roll [rad]: the body is pitched about its left axis, then rolled about its own
        forward axis.
    yaw_rad : float
        Of the sensor in the robot.
    """
    (sin_p, cos_p), (sin_r, cos_r) = (
        (np.sin(angle)[:, None], np.cos(angle)[:, None]) for angle in angles.T
    )
    bearing, elevation = level[..., 0] + yaw_rad, level[..., 1]
    x = np.cos(elevation) * np.cos(bearing)
    y = np.cos(elevation) * np.sin(bearing)
    z = np.sin(elevation)
    x, z = cos_p * x - sin_p * z, sin_p * x + cos_p * z
    y, z = cos_r * y + sin_r * z, cos_r * z - sin_r * y
    seen = level.copy()
    seen[..., 0] = wrap_angle(np.arctan2(y, x) - yaw_rad)
    seen[..., 1] = np.arctan2(z, np.hypot(x, y))
    return seen
