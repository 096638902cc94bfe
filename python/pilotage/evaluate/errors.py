"""Errors of an estimate against truth, row by row, without alignment."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .angles import wrap_angle
from .truth import MAX_GAP_S, interpolate


@dataclass(frozen=True)
class PoseErrors:
    """Estimate less truth; NaN where the truth is not known.

    Attributes
    ----------
    utime : (n,) int64, µs
    position : (n, 2) float, m
        Along x and y of frame map.
    heading : (n,) float, rad
        In (−π, π].
    """

    utime: NDArray[np.int64]
    position: NDArray[np.float64]
    heading: NDArray[np.float64]

    @property
    def distance(self) -> NDArray[np.float64]:
        """(n,) norm of the position error, m."""
        return np.asarray(np.hypot(self.position[:, 0], self.position[:, 1]))

    @property
    def pose(self) -> NDArray[np.float64]:
        """(n, 3) errors in x, y, heading: m, m, rad."""
        return np.column_stack([self.position, self.heading])


def pose_errors(
    poses: NDArray[Any], truth: NDArray[Any] | None, max_gap_s: float = MAX_GAP_S
) -> PoseErrors:
    """Subtract from every pose the truth interpolated onto its time.

    Parameters
    ----------
    poses, truth : structured arrays (n,), (m,)
        ``utime`` µs, ``x``, ``y`` m, ``heading`` rad. Without truth every error is NaN.
    max_gap_s : float, s
        See `interpolate`.
    """
    if truth is None:
        truth = poses[:0]
    true = interpolate(truth, poses["utime"], max_gap_s)
    return PoseErrors(
        utime=poses["utime"],
        position=np.column_stack([poses["x"] - true[:, 0], poses["y"] - true[:, 1]]),
        heading=wrap_angle(poses["heading"] - true[:, 2]),
    )
