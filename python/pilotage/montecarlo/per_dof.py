"""NEES or NIS per degree of freedom, with the band in which it falls if the filter is consistent.

Source: Y. Bar-Shalom, X. R. Li, T. Kirubarajan, *Estimation with Applications to Tracking and
Navigation*, 2001, section 5.4.
"""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..evaluate import mean_square_band


@dataclass(frozen=True)
class PerDof:
    """Sums over many runs, over their degrees of freedom: 1 where the filter tells the truth.

    Attributes
    ----------
    time_s : (k,)
        Since the beginning of the drive.
    over_time : (k,)
        NaN where nothing is known.
    low, high : (k,)
        In which 95 % of them fall if the filter is consistent, by the count of what is known then.
    mean : float
        Over all times and runs.
    band : (2,)
        In which 95 % of such means fall, if what was summed is independent: innovations are, the
        errors of a run at different times are not.
    """

    time_s: NDArray[np.float64]
    over_time: NDArray[np.float64]
    low: NDArray[np.float64]
    high: NDArray[np.float64]
    mean: float
    band: tuple[float, float]

    @classmethod
    def of(cls, time_s: NDArray[np.float64], total: NDArray[Any], dof: NDArray[Any]) -> "PerDof":
        """Divide sums (k,) by their degrees of freedom (k,), 0 where nothing is known."""
        low, high = np.array([_band(count) for count in dof]).T
        mean = float(_over(total.sum(), dof.sum()))
        return cls(time_s, _over(total, dof), low, high, mean, _band(dof.sum()))

    @property
    def inside(self) -> float:
        """Share, 0 to 1, of the times at which anything is known that are within the band."""
        known = np.isfinite(self.over_time)
        within = (self.low <= self.over_time) & (self.over_time <= self.high)
        return float(within[known].mean()) if known.any() else np.nan


def _over(total: NDArray[Any], dof: NDArray[Any]) -> NDArray[np.float64]:
    return np.where(dof > 0, total / np.maximum(dof, 1), np.nan)


def _band(dof: float) -> tuple[float, float]:
    return mean_square_band(1, count=int(dof)) if dof else (np.nan, np.nan)
