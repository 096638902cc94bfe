"""Small runs, made by hand, for evaluation and figures."""

from collections.abc import Sequence
from dataclasses import dataclass, field
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

POSE = np.dtype(
    [
        ("utime", "i8"),
        ("x", "f8"),
        ("y", "f8"),
        ("heading", "f8"),
        ("covariance", "f8", (3, 3)),
        ("v", "f8"),
        ("omega", "f8"),
        ("status", "i1"),
        ("resets", "i4"),
    ]
)
REPORT = np.dtype(
    [
        ("utime", "i8"),
        ("sensor", "i4"),
        ("frame_seq", "i4"),
        ("index", "i4"),
        ("id", "i4"),
        ("innovation", "f8", (3,)),
        ("sigma", "f8", (3,)),
        ("nis", "f8"),
        ("dof", "i4"),
        ("weight", "f8"),
        ("accepted", "?"),
        ("reason", "i4"),
        ("value", "f8"),
        ("limit", "f8"),
    ]
)
TRUTH = np.dtype([("utime", "i8"), ("x", "f8"), ("y", "f8"), ("heading", "f8")])


def poses(
    utime: ArrayLike,
    x: ArrayLike = 0.0,
    y: ArrayLike = 0.0,
    heading: ArrayLike = 0.0,
    covariance: ArrayLike | None = None,
) -> NDArray[Any]:
    """Rows of `Run.poses`; the covariance is the identity unless given."""
    rows = np.zeros(np.size(utime), dtype=POSE)
    rows["utime"], rows["x"], rows["y"], rows["heading"] = utime, x, y, heading
    rows["covariance"] = np.eye(3) if covariance is None else covariance
    return rows


def truth(
    utime: ArrayLike, x: ArrayLike = 0.0, y: ArrayLike = 0.0, heading: ArrayLike = 0.0
) -> NDArray[Any]:
    """Rows of a truth trajectory."""
    rows = np.zeros(np.size(utime), dtype=TRUTH)
    rows["utime"], rows["x"], rows["y"], rows["heading"] = utime, x, y, heading
    return rows


def reports(utime: ArrayLike, **columns: ArrayLike) -> NDArray[Any]:
    """Rows of `Run.reports`: accepted, one component, a frame each, unless columns say else."""
    rows = np.zeros(np.size(utime), dtype=REPORT)
    rows["utime"] = utime
    rows["frame_seq"] = np.arange(rows.size)
    rows["dof"], rows["accepted"], rows["weight"] = 1, True, 1.0
    for name, values in columns.items():
        rows[name] = values
    return rows


@dataclass
class Map:
    """As `pilotage.MarkerMap` shows itself."""

    ids: NDArray[np.int32]
    positions: NDArray[np.float64]


@dataclass
class Run:
    """As `pilotage.Run` shows itself."""

    poses: NDArray[Any]
    reports: NDArray[Any] = field(default_factory=lambda: reports([]))
    sensors: Sequence[str] = ("camera",)
    reasons: Sequence[str] = ("gate", "unknown marker")
    counts: dict[str, Any] = field(
        default_factory=lambda: {"messages": 0, "samples": 0, "accepted": 0, "rejected": {}}
    )
    wall_s: float = 0.0


def drive(rows: int = 400, seed: int = 1) -> tuple[Run, NDArray[Any], Map]:
    """A run of a circle in 40 s, its truth and a map: errors as large as the covariance says."""
    rng = np.random.default_rng(seed)
    utime = np.linspace(0, 40_000_000, rows).astype(np.int64)
    angle = np.linspace(0.0, 2.0 * np.pi, rows)
    true = truth(utime, 5.0 * np.cos(angle), 5.0 * np.sin(angle), angle - np.pi)
    sigma = np.array([0.1, 0.2, 0.05])
    dx, dy, turn = (sigma * rng.normal(size=(rows, 3))).T
    estimate = poses(
        utime, true["x"] + dx, true["y"] + dy, true["heading"] + turn, np.diag(sigma**2)
    )
    seen = reports(
        np.repeat(utime[::10], 2),
        frame_seq=np.repeat(np.arange(utime[::10].size), 2),
        nis=rng.chisquare(2, size=2 * utime[::10].size),
        dof=2,
    )
    seen["accepted"][::8] = False
    seen["nis"][::8] = 30.0
    markers = Map(np.array([3, 7], dtype=np.int32), np.array([[6.0, 0.0, 1.0], [-6.0, 2.0, 1.0]]))
    return Run(estimate, seen), true, markers
