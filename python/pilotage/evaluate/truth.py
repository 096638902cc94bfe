"""Truth at the times of an estimate."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .angles import wrap_angle

MAX_GAP_S = 0.5
"""Truth is not interpolated between rows that lie further apart than this, s."""


def interpolate(
    truth: NDArray[Any], utime: ArrayLike, max_gap_s: float = MAX_GAP_S
) -> NDArray[np.float64]:
    """Truth at given times: position along the line, heading along the shorter arc.

    Parameters
    ----------
    truth : structured array (m,)
        ``utime`` µs, ``x``, ``y`` m, ``heading`` rad, in any order of time. A value that is not
        finite is not known there; where a stamp repeats, its last row stands at that time.
    utime : (n,) int, µs
        Times asked for; they may repeat.
    max_gap_s : float, s
        Between rows further apart than this nothing is known.

    Returns
    -------
    (n, 3) float
        x, y, heading in m, m, rad; NaN where not known. Nothing is extrapolated.
    """
    at = np.asarray(utime, dtype=np.int64)
    pose = np.full((at.size, 3), np.nan)
    if truth.size == 0:
        return pose
    truth = truth[np.argsort(truth["utime"], kind="stable")]
    stamps = truth["utime"]

    before = np.searchsorted(stamps, at, side="right") - 1
    after = np.searchsorted(stamps, at, side="left")
    inside = np.flatnonzero((before >= 0) & (after < stamps.size))
    before, after = before[inside], after[inside]
    # On a stamp that row alone counts, so that a bad or distant neighbour does not spoil it.
    after = np.where(stamps[before] == at[inside], before, after)

    gap = stamps[after] - stamps[before]
    near = gap <= max_gap_s * 1e6
    inside, before, after, gap = inside[near], before[near], after[near], gap[near]
    weight = (at[inside] - stamps[before]) / np.maximum(gap, 1)

    for column, name in enumerate(("x", "y", "heading")):
        known = np.where(np.isfinite(truth[name]), truth[name], np.nan)
        step = known[after] - known[before]
        if name == "heading":
            step = wrap_angle(step)
        pose[inside, column] = known[before] + weight * step
    pose[:, 2] = wrap_angle(pose[:, 2])
    return pose
