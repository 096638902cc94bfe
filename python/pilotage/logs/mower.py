"""The first paper's text files: pose log, angles to markers, marker map.

E. Kiriy and M. Buehler, "Three-state Extended Kalman Filter for Mobile Robot Localization", 2002;
the columns are those of the listing in its appendix.
"""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .. import Recording
from .columns import (
    ground_map,
    microseconds,
    order_notes,
    read_columns,
    require_finite,
    trajectory,
    whole_numbers,
)
from .log import Log

KIND = "mower"
LOOKED_FOR = "a folder with *poselog*.txt, *angles*.txt and *map*.txt"

TICK_M = 1e-6
"""Metres per encoder tick in the recording: fine enough to lose nothing of any wheel's travel."""


def recognises(path: Path) -> bool:
    """Whether this is such a folder, be it complete or not."""
    return path.is_dir() and any(path.glob("*poselog*.txt"))


def read(folder: Path) -> Log:
    """Encoders and gyro at every row of the pose log, sightings by the sensor ``camera``.

    The wheels' travels become absolute ticks of `TICK_M`. Stamps are kept as they are, jitter and
    repetitions included. Ids count from 0, in the angles as in the map.
    """
    poselog, angles, markers = (
        _the_file(folder, pattern) for pattern in ("*poselog*.txt", "*angles*.txt", "*map*.txt")
    )
    row = read_columns(
        poselog, {"time": 2, "left": 3, "right": 4, "gyro": 8, "x": 18, "y": 19, "heading": 20}
    )
    if row["time"].size == 0:
        raise ValueError(f"{poselog}: holds no rows")
    seen = read_columns(angles, {"time": 0, "id": 1, "azimuth": 2, "elevation": 3})
    marker = read_columns(markers, {"id": 0, "x": 1, "y": 2})

    recording = Recording()
    utime = microseconds(row["time"], poselog)
    recording.add_gyro("GYRO", utime, row["gyro"])
    left, right = (_ticks(row[side], poselog, f"{side} wheel travel") for side in ("left", "right"))
    recording.add_encoders("ENCODERS", utime, left, right)
    sighted = microseconds(seen["time"], angles)
    recording.add_sightings(
        "MARKERS",
        "camera",
        sighted,
        whole_numbers(seen["id"], angles, "marker id"),
        seen["azimuth"],
        seen["elevation"],
        np.full(sighted.size, np.nan),
    )
    recording.sort()
    return Log(
        kind=KIND,
        recording=recording,
        truth=trajectory(utime, row["x"], row["y"], row["heading"]),
        map=ground_map(
            markers, whole_numbers(marker["id"], markers, "marker id"), marker["x"], marker["y"]
        ),
        notes=(*order_notes(poselog, utime), *order_notes(angles, sighted)),
    )


def _the_file(folder: Path, pattern: str) -> Path:
    found = sorted(folder.glob(pattern))
    if not found:
        raise FileNotFoundError(f"{folder}: no {pattern}; a {KIND} log is {LOOKED_FOR}")
    if len(found) > 1:
        names = ", ".join(path.name for path in found)
        raise ValueError(f"{folder}: {names} all match {pattern}; put each log in its own folder")
    return found[0]


def _ticks(travel: NDArray[np.float64], where: Path, name: str) -> NDArray[np.int64]:
    total = np.cumsum(require_finite(travel, where, name))
    return np.rint(total / TICK_M).astype(np.int64)
