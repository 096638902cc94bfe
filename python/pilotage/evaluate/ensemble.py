"""One moment of many runs: errors of the pose beside the covariances that were stated with them."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .consistency import ellipse_scale, mahalanobis_squared

IMPROBABLE = 1e-6
IMPROBABLE_SIGMAS = 4.8916  # of one Gaussian, to both sides


@dataclass(frozen=True)
class Ensemble:
    """Error (n, 3) in m, m and rad, and stated covariance (n, 3, 3)."""

    error: NDArray[np.float64]
    covariance: NDArray[np.float64]

    @property
    def position_m(self) -> float:
        """The rms error."""
        return float(np.sqrt(np.square(self.error[:, :2]).sum(axis=1).mean()))

    @property
    def stated_m(self) -> float:
        """What the rms error should be by the covariance."""
        return float(np.sqrt(np.trace(self.covariance[:, :2, :2], axis1=1, axis2=2).mean()))

    @property
    def heading_deg(self) -> float:
        """The rms error."""
        return float(np.degrees(np.sqrt(np.square(self.error[:, 2]).mean())))

    @property
    def stated_deg(self) -> float:
        """What the rms error should be by the covariance."""
        return float(np.degrees(np.sqrt(self.covariance[:, 2, 2].mean())))

    def in_ellipse(self, probability: float) -> float:
        """Part of the true positions inside the ellipse of a probability.

        NaN where the ellipse has no area.
        """
        return float(np.mean(self._in_ellipse(probability)))

    def in_cone(self, k: float = 2.0) -> float:
        """Part of the true headings within ±kσ; NaN where σ is 0."""
        return float(np.mean(self._in_cone(k)))

    @property
    def lost(self) -> float:
        """Part of the runs whose position or heading has one chance in a million by its covariance.

        NaN where the covariance says that there is no chance.
        """
        kept = self._in_ellipse(1.0 - IMPROBABLE) * self._in_cone(IMPROBABLE_SIGMAS)
        return 1.0 - float(np.mean(kept))

    def _in_ellipse(self, probability: float) -> NDArray[np.float64]:
        """1 or 0 for each run, or NaN."""
        distance = mahalanobis_squared(self.error[:, :2], self.covariance[:, :2, :2])
        inside = distance <= ellipse_scale(probability) ** 2
        return np.where(np.isnan(distance), np.nan, inside)

    def _in_cone(self, k: float) -> NDArray[np.float64]:
        sigma = np.sqrt(self.covariance[:, 2, 2])
        inside = np.abs(self.error[:, 2]) <= k * sigma
        return np.where(sigma > 0.0, inside, np.nan)
