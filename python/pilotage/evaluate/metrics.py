"""The figures of merit of a run, as `metrics.json` holds them."""

import json
from collections.abc import Mapping
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .consistency import mahalanobis_squared
from .errors import PoseErrors, pose_errors
from .means import root_mean_square
from .run import RunLike
from .truth import MAX_GAP_S


@dataclass(frozen=True)
class Position:
    """Of the norm of the position error, m."""

    rmse_m: float
    mean_m: float
    std_m: float
    p95_m: float
    max_m: float

    @classmethod
    def of(cls, errors: PoseErrors) -> "Position | None":
        """Summarise the rows with a known position; None if there are none."""
        known = errors.distance[~np.isnan(errors.distance)]
        if known.size == 0:
            return None
        return cls(
            rmse_m=float(root_mean_square(known)),
            mean_m=float(known.mean()),
            std_m=float(known.std()),
            p95_m=float(np.percentile(known, 95.0)),
            max_m=float(known.max()),
        )


@dataclass(frozen=True)
class Heading:
    """Of the wrapped heading error, deg; the mean is signed."""

    rmse_deg: float
    mean_deg: float
    std_deg: float
    median_abs_deg: float

    @classmethod
    def of(cls, errors: PoseErrors) -> "Heading | None":
        """Summarise the rows with a known heading; None if there are none."""
        known = np.degrees(errors.heading[~np.isnan(errors.heading)])
        if known.size == 0:
            return None
        return cls(
            rmse_deg=float(root_mean_square(known)),
            mean_deg=float(known.mean()),
            std_deg=float(known.std()),
            median_abs_deg=float(np.median(np.abs(known))),
        )


@dataclass(frozen=True)
class Nees:
    """Normalised estimation error squared of the pose; its mean is `dof` for a true filter.

    `singular` counts the rows left out because their covariance is not positive definite.
    """

    mean: float
    dof: int
    singular: int

    @classmethod
    def of(cls, errors: PoseErrors, covariance: NDArray[np.float64]) -> "Nees | None":
        """Summarise the rows with a known pose, covariance (n, 3, 3); None if there are none."""
        known = ~np.isnan(errors.pose).any(axis=1)
        nees = mahalanobis_squared(errors.pose[known], covariance[known])
        regular = ~np.isnan(nees)
        if not regular.any():
            return None
        return cls(mean=float(nees[regular].mean()), dof=3, singular=int(nees.size - regular.sum()))


@dataclass(frozen=True)
class Nis:
    """Normalised innovation squared of a sensor's accepted sightings.

    `mean` and `dof` are means over `count` sightings, None if there are none; a true filter has
    equal ones.
    """

    mean: float | None
    dof: float | None
    count: int

    @classmethod
    def of(cls, reports: NDArray[Any], sensor: int) -> "Nis":
        """Summarise the accepted reports of the sensor of that index."""
        fused = reports[(reports["sensor"] == sensor) & reports["accepted"].astype(bool)]
        if fused.size == 0:
            return cls(mean=None, dof=None, count=0)
        return cls(
            mean=float(fused["nis"].mean()), dof=float(fused["dof"].mean()), count=int(fused.size)
        )


@dataclass(frozen=True)
class Counts:
    """Of measured components, as the engine counted them."""

    samples: int
    accepted: int
    rejected: dict[str, int]

    @classmethod
    def of(cls, counts: Mapping[str, Any]) -> "Counts":
        """Take those of a run."""
        return cls(
            samples=int(counts["samples"]),
            accepted=int(counts["accepted"]),
            rejected={reason: int(n) for reason, n in counts["rejected"].items()},
        )


@dataclass(frozen=True)
class Metrics:
    """Over all rows that have truth, from the first, without alignment; None without truth."""

    position: Position | None
    heading: Heading | None
    nees: Nees | None
    nis: dict[str, Nis]
    counts: Counts
    duration_s: float
    messages_per_s: float | None

    def to_dict(self) -> dict[str, Any]:
        """Return the content of `metrics.json`."""
        content = asdict(self)
        if content["nees"] is not None:
            del content["nees"]["singular"]  # for the table; the file's keys are agreed upon
        return content

    def save(self, path: str | Path) -> None:
        """Write `metrics.json`."""
        text = json.dumps(self.to_dict(), indent=2, allow_nan=False)
        Path(path).write_text(text + "\n", encoding="utf-8")


def compute_metrics(
    run: RunLike, truth: NDArray[Any] | None, max_gap_s: float = MAX_GAP_S
) -> Metrics:
    """Compare a run with truth.

    Parameters
    ----------
    run : RunLike
    truth : structured array (m,) with utime µs, x, y m, heading rad, or None
    max_gap_s : float, s
        See `interpolate`.
    """
    errors = pose_errors(run.poses, truth, max_gap_s)
    utime = run.poses["utime"]
    return Metrics(
        position=Position.of(errors),
        heading=Heading.of(errors),
        nees=Nees.of(errors, run.poses["covariance"]),
        nis={name: Nis.of(run.reports, index) for index, name in enumerate(run.sensors)},
        counts=Counts.of(run.counts),
        duration_s=float(utime[-1] - utime[0]) * 1e-6 if utime.size else 0.0,
        messages_per_s=run.counts["messages"] / run.wall_s if run.wall_s > 0.0 else None,
    )
