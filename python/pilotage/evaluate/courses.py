"""How the errors of many runs go over time, and how long they take to become small."""

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .errors import pose_errors
from .honesty import beyond


@dataclass(frozen=True)
class Courses:
    """Errors of r runs at n times, the same steps after a first one in each.

    Attributes
    ----------
    time_s : (n,) float
        Since the first.
    distance, heading : (r, n) float, m and rad
        Size of the error; NaN without a pose.
    wrong : (r, n) bool
        Whether it was said to be OK with an error outside the covariance.
    status : (r, n) int
        0 without a pose.
    """

    time_s: NDArray[np.float64]
    distance: NDArray[np.float64]
    heading: NDArray[np.float64]
    wrong: NDArray[np.bool_]
    status: NDArray[np.int64]

    @classmethod
    def of(cls, runs: Sequence[tuple[NDArray[Any], NDArray[Any], int]], ok: int) -> "Courses":
        """Compare poses with truths, each from an index of the truth on.

        Parameters
        ----------
        runs : sequence of (poses, truth, first)
            Rows like `Run.poses`, rows of `TRAJECTORY` at the same times and more, and the index.
        ok : int
            The status that says OK.
        """
        return cls.joined([cls._one(*run, ok) for run in runs])

    @classmethod
    def joined(cls, parts: Sequence["Courses"]) -> "Courses":
        """Put runs of the same times together."""
        names = ("distance", "heading", "wrong", "status")
        rows = (np.concatenate([getattr(part, name) for part in parts]) for name in names)
        return cls(parts[0].time_s, *rows)

    @classmethod
    def _one(cls, poses: NDArray[Any], truth: NDArray[Any], first: int, ok: int) -> "Courses":
        errors = pose_errors(poses, truth)
        at = np.searchsorted(truth["utime"], poses["utime"])
        columns = (
            (np.nan, errors.distance),
            (np.nan, np.abs(errors.heading)),
            (False, (poses["status"] == ok) & beyond(errors, poses["covariance"])),
            (0, poses["status"].astype(np.int64)),
        )
        rows = []
        for missing, values in columns:
            row = np.full((1, len(truth)), missing)
            row[0, at] = values
            rows.append(row[:, first:])
        return cls((truth["utime"][first:] - truth["utime"][first]) * 1e-6, *rows)

    @property
    def end_m(self) -> float:
        """RMS position error at the last time."""
        return float(np.sqrt(np.nanmean(self.distance[:, -1] ** 2)))

    @property
    def end_deg(self) -> float:
        """RMS heading error at the last time."""
        return float(np.degrees(np.sqrt(np.nanmean(self.heading[:, -1] ** 2))))

    def settling_s(self, limit_m: float) -> NDArray[np.float64]:
        """(r,) time from which on the position error stays below the limit.

        Infinite where its last value is not below it; an error that is not known is not.
        """
        above = ~(self.distance < limit_m)
        settled = np.where(above.any(axis=1), above.shape[1] - above[:, ::-1].argmax(axis=1), 0)
        return np.append(self.time_s, np.inf)[settled]

    def settled_within(self, limit_m: float, time_s: float) -> float:
        """Share of the runs whose error stays below the limit from that time on."""
        return float(np.mean(self.settling_s(limit_m) <= time_s))

    def ends_as(self, status: int) -> float:
        """Share of the runs with that status at the last time."""
        return float(np.mean(self.status[:, -1] == status))

    def summary(self, limit_m: float, time_s: float) -> dict[str, float | None]:
        """Return figures for a results.json; what never comes is None."""
        settled = float(np.median(self.settling_s(limit_m)))
        return {
            "runs": len(self.distance),
            "end_rms_m": self.end_m,
            "end_rms_deg": self.end_deg,
            "settled_share": self.settled_within(limit_m, time_s),
            "median_settling_s": settled if np.isfinite(settled) else None,
            "sure_and_wrong_share": float(self.wrong.mean()),
        }
