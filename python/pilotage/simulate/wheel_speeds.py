"""Wheels that report their speeds at a fixed rate, as a simulated robot's joints do."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .drives import Drive


@dataclass(frozen=True)
class WheelSpeeds:
    """Speeds of the left and the right wheel, each the mean since the sample before.

    Attributes
    ----------
    sigma_m_s : float
        Of the white noise of every sample, whatever the rate.
    """

    track_width_m: float
    sigma_m_s: float
    rate_hz: float = 30.0

    @property
    def step_s(self) -> float:
        """Between samples."""
        return 1.0 / self.rate_hz

    @property
    def mixing(self) -> NDArray[np.float64]:
        """(2, 2) that makes speed [m/s] and yaw rate [rad/s] of the wheels' speeds."""
        return np.array([[0.5, 0.5], [-1.0 / self.track_width_m, 1.0 / self.track_width_m]])

    def stamps(self, drive: Drive) -> NDArray[np.int64]:
        """(n + 1,) times of the samples, from the drive's start on, µs."""
        n = int((drive.utime[-1] - drive.utime[0]) * 1e-6 * self.rate_hz)
        since = np.rint(np.arange(n + 1) * 1e6 * self.step_s).astype(np.int64)
        return np.asarray(drive.utime[0] + since)

    def report(self, drive: Drive, rng: np.random.Generator) -> NDArray[np.float64]:
        """(n, 2) speeds left and right [m/s] over the intervals that end at the later stamps."""
        stamps = self.stamps(drive)
        total = np.vstack([np.zeros(2), np.cumsum(drive.increments, axis=0)])
        come = np.column_stack([np.interp(stamps, drive.utime, way) for way in total.T])
        rates = np.diff(come, axis=0) / (np.diff(stamps) * 1e-6)[:, None]
        exact = np.linalg.solve(self.mixing, rates.T).T
        return np.asarray(exact + self.sigma_m_s * rng.standard_normal(exact.shape))

    def rate_covariance(self) -> NDArray[np.float64]:
        """(2, 2) covariance of speed and yaw rate of one sample."""
        return np.asarray(self.sigma_m_s**2 * self.mixing @ self.mixing.T)
