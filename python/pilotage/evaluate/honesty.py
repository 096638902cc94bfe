"""Whether a localizer says what is so: its state against its true error, over a run."""

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .consistency import mahalanobis_squared
from .errors import PoseErrors, pose_errors

BEYOND_SIGMA = 5.0
"""An error beyond so many sigma, and beyond the next two, is outside what was stated."""
BEYOND_M = 0.2
BEYOND_DEG = 2.0
STALE_S = 1.0
"""A pose is judged by the truth at its own time; one that no newer one followed for so long, s, is
the one in force, and judged by the truth of now."""
STEADY_S = 1.0
"""OK again is to be OK and right for so long, s."""


def beyond(errors: PoseErrors, covariance: NDArray[np.float64]) -> NDArray[np.bool_]:
    """(n,) whether errors are outside what the covariances (n, 3, 3) state."""
    d2 = mahalanobis_squared(errors.position, covariance[:, :2, :2])
    with np.errstate(invalid="ignore"):
        position = ~(d2 <= BEYOND_SIGMA**2) & (errors.distance > BEYOND_M)
        off = np.abs(errors.heading)
        heading = ~(off <= BEYOND_SIGMA * np.sqrt(covariance[:, 2, 2]))
        heading &= off > np.radians(BEYOND_DEG)
    return np.asarray(position | heading)


@dataclass(frozen=True)
class Timeline:
    """The state in force and the error of the pose in force, from each event to the next.

    Attributes
    ----------
    at : (n,) int, µs
        When a pose or, where poses stay out, a status arrived.
    ok : (n,) bool
        Whether the state said OK.
    distance : (n,) float, m
        Of the position from the true one, NaN where that is not known.
    beyond : (n,) bool
        Whether the error is outside what the covariance states.
    end : int, µs
        Of the run.
    """

    at: NDArray[np.int64]
    ok: NDArray[np.bool_]
    distance: NDArray[np.float64]
    beyond: NDArray[np.bool_]
    end: int

    @classmethod
    def of(
        cls,
        poses: NDArray[Any],
        arrived: NDArray[np.int64],
        pose_ok: NDArray[np.bool_],
        status_at: NDArray[np.int64],
        status_ok: NDArray[np.bool_],
        truth: NDArray[Any],
    ) -> "Timeline":
        """Hold poses (n,) with their arrivals, and statuses (m,) in between, against the truth."""
        newest = np.searchsorted(arrived, status_at, side="right") - 1
        stale = (newest >= 0) & (status_at - arrived[newest] > STALE_S * 1e6)
        held = poses[newest[stale]]
        held["utime"] = status_at[stale]
        rows = np.concatenate([poses, held])
        at = np.concatenate([arrived, status_at[stale]])
        ok = np.concatenate([pose_ok, status_ok[stale]])
        order = np.argsort(at, kind="stable")
        errors = pose_errors(rows[order], truth)
        covariance = rows["covariance"][order]
        end = int(truth["utime"][-1])
        return cls(at[order], ok[order], errors.distance, beyond(errors, covariance), end)

    def longest_s(self, what: NDArray[np.bool_]) -> float:
        """Return the longest time without a break in which `what` (n,) holds."""
        return float(max((end - start for start, end in self._spells(what)), default=0) * 1e-6)

    def share(self, what: NDArray[np.bool_], start: int, end: int) -> float:
        """Return the part of the time from `start` to `end` [µs] in which `what` (n,) holds."""
        edges = np.clip(np.append(self.at, self.end), start, end)
        return float(np.diff(edges)[what].sum() / (end - start))

    def at_time(self, what: NDArray[np.bool_], utime: int) -> bool:
        """Whether `what` (n,) holds at a time; before the first event nothing does."""
        i = int(np.searchsorted(self.at, utime, side="right")) - 1
        return bool(i >= 0 and what[i])

    def again_s(self, after: int) -> float:
        """Return the time from `after` to OK and right, to stay for a while; inf if it never is."""
        for start, end in self._spells(self.ok & ~self.beyond):
            start = max(start, after)
            if end - start >= STEADY_S * 1e6:
                return float(start - after) * 1e-6
        return float("inf")

    def _spells(self, what: NDArray[np.bool_]) -> NDArray[np.int64]:
        """(k, 2) beginnings and ends of the times in which `what` holds."""
        edges = np.flatnonzero(np.diff(np.concatenate([[False], what, [False]]).astype(np.int8)))
        return np.append(self.at, self.end)[edges].reshape(-1, 2)
