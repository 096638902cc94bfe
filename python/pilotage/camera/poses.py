"""Where the robot was when an image was taken."""

from bisect import bisect_left
from collections import deque
from pathlib import Path
from threading import Lock
from time import monotonic
from typing import Any

import numpy as np
from numpy.typing import NDArray

from ..evaluate import read_trajectory
from ..evaluate.truth import MAX_GAP_S
from ..logs import mower, read
from ..logs.poses import recorded_poses
from .detection import Array

KEPT = 2000
"""Poses that are remembered, ten seconds at 200 Hz."""

FRESH_S = 1.0
"""A pose that was heard longer ago is not the newest of a drive that goes on."""


class Poses:
    """The newest poses; they may come while others ask."""

    def __init__(self, rows: NDArray[Any] | None = None, kept: int | None = KEPT):
        """Begin with rows of `evaluate.TRAJECTORY`, in order of time."""
        self._lock = Lock()
        self._heard = 0.0
        self._utime: deque[int] = deque(maxlen=kept)
        self._pose: deque[tuple[float, float, float]] = deque(maxlen=kept)
        for row in rows if rows is not None else ():
            self.add(int(row["utime"]), (float(row["x"]), float(row["y"]), float(row["heading"])))

    def add(self, utime: int, pose: tuple[float, float, float]) -> None:
        """Append one; after a clock that was set back those before it are forgotten."""
        with self._lock:
            if self._utime and utime < self._utime[-1]:
                self._utime.clear()
                self._pose.clear()
            self._heard = monotonic()
            self._utime.append(utime)
            self._pose.append(pose)

    @property
    def newest(self) -> int | None:
        """Time of the newest, µs; None if there is none or it was heard long ago."""
        with self._lock:
            fresh = self._utime and monotonic() - self._heard < FRESH_S
            return self._utime[-1] if fresh else None

    def at(self, utime: int, or_before: bool = False) -> Array | None:
        """Return the first pose (3,) [m, m, rad] at a time or after it, as the first paper has it.

        With `or_before` the newest one if all are older. None where none is within `MAX_GAP_S`.
        """
        with self._lock:
            row = bisect_left(self._utime, utime)
            if or_before:
                row = min(row, len(self._utime) - 1)
            if not 0 <= row < len(self._utime):
                return None
            if abs(self._utime[row] - utime) > MAX_GAP_S * 1e6:
                return None
            return np.array(self._pose[row])


def read_poses(path: Path) -> tuple[Poses, str]:
    """Read a log of poses, and say what was taken.

    An LCM log's are those that the node published, else its reference_t; ``.csv`` and ``.tum`` are
    trajectories as `pilotage replay` writes them, ``.txt`` is the first paper's pose log; of any
    other recording the truth is taken.

    Raises
    ------
    ValueError
        If there are none in it.
    """
    if path.suffix in (".csv", ".tum"):
        rows, what = read_trajectory(path), "rows"
    elif path.suffix == ".txt":
        rows, what = mower.read_poses(path), "rows"
    else:
        log = read(path)
        published = recorded_poses(log.recording)
        if published is not None:
            rows, what = published, "poses of a node"
        elif log.truth is not None:
            rows, what = log.truth, "true poses"
        else:
            raise ValueError(f"{path}: holds neither pose_t nor reference_t")
    rows = rows[np.argsort(rows["utime"], kind="stable")]
    return Poses(rows, kept=None), f"{path}: {len(rows)} {what}"
