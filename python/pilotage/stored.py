"""A run read back from the folder that `results` left."""

import csv
import json
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from . import MarkerMap, load_config
from .evaluate import read_csv

_POSES = np.dtype(
    [("utime", "i8"), ("x", "f8"), ("y", "f8"), ("heading", "f8"), ("covariance", "f8", (3, 3))]
)
_REPORTS = np.dtype(
    {
        "names": ["utime", "sensor", "frame_seq", "nis", "dof", "accepted", "reason"],
        "formats": ["i8", "i4", "i4", "f8", "i4", "?", "i4"],
    }
)
_TRIANGLE = range(4, 10)  # columns xx, xy, xh, yy, yh, hh of pose.csv
_ACCEPTED = "fused"


@dataclass(frozen=True)
class StoredRun:
    """What figures need of a run (`evaluate.RunLike`), with its truth and map."""

    poses: NDArray[Any]
    reports: NDArray[Any]
    sensors: list[str]
    reasons: list[str]
    counts: Mapping[str, Any]
    wall_s: float
    truth: NDArray[Any] | None
    map: MarkerMap


def is_stored(path: Path) -> bool:
    """Whether this is a folder that a run left."""
    return (path / "pose.csv").is_file() and (path / "config.yaml").is_file()


def read_stored(folder: Path) -> StoredRun:
    """Read poses, reports, configuration and, if there, the truth.

    Raises
    ------
    ValueError, OSError
        If a file is missing or damaged; names it.
    """
    config = load_config(str(folder / "config.yaml"))
    reports, reasons = _reports(folder / "reports.csv", config.sensors)
    truth = folder / "truth.csv"
    counts = json.loads((folder / "metrics.json").read_text(encoding="utf-8"))["counts"]
    return StoredRun(
        poses=_poses(folder / "pose.csv"),
        reports=reports,
        sensors=config.sensors,
        reasons=reasons,
        counts=counts,
        wall_s=0.0,
        truth=read_csv(truth) if truth.exists() else None,
        map=config.map,
    )


def _poses(path: Path) -> NDArray[Any]:
    trajectory = read_csv(path)
    poses = np.zeros(trajectory.size, dtype=_POSES)
    for name in ("utime", "x", "y", "heading"):
        poses[name] = trajectory[name]
    triangle = np.loadtxt(path, delimiter=",", skiprows=1, usecols=_TRIANGLE, ndmin=2)
    row, column = np.triu_indices(3)
    poses["covariance"][:, row, column] = poses["covariance"][:, column, row] = triangle
    return poses


def _reports(path: Path, sensors: list[str]) -> tuple[NDArray[Any], list[str]]:
    reasons = [_ACCEPTED]
    rows = []
    with path.open(newline="", encoding="utf-8") as file:
        for row in csv.DictReader(file):
            verdict = row["verdict"]
            if verdict not in reasons:
                reasons.append(verdict)
            rows.append(
                (
                    int(row["utime"]),
                    sensors.index(row["sensor"]),
                    int(row["frame_seq"]),
                    float(row["nis"]),
                    int(row["dof"]),
                    verdict == _ACCEPTED,
                    reasons.index(verdict),
                )
            )
    return np.array(rows, dtype=_REPORTS), reasons
