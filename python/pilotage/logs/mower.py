"""The first paper's text files: pose log, angles to markers, marker map.

E. Kiriy and M. Buehler, "Three-state Extended Kalman Filter for Mobile Robot Localization", 2002;
the columns are those of the listing in its appendix.
"""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

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
    whole_steps,
)
from .log import Log

KIND = "mower"
LOOKED_FOR = "a folder with *poselog*.txt, *angles*.txt and *map*.txt"

POSE_COLUMNS = {"time": 2, "x": 18, "y": 19, "heading": 20}
FILES = (Path("poselog"), Path("angles"), Path("map"))
TICK_M = 1e-6
"""Metres per encoder tick in the recording: fine enough to lose nothing of any wheel's travel."""


def recognises(path: Path) -> bool:
    """Whether this is such a folder, be it complete or not."""
    return path.is_dir() and any(path.glob("*poselog*.txt"))


@dataclass(frozen=True)
class Triple:
    """The three files as they are: n rows of the pose log, k sightings, m markers.

    Attributes
    ----------
    time : (n,) float, s
    motion : (n, 3) float
        Left and right wheel travel since the previous row [m], gyro rate [rad/s].
    truth : (n, 3) float
        x, y [m], heading [rad] as it accumulates.
    sighting_time : (k,) float, s
    sighting_id : (k,) int
    sighting : (k, 2) float
        Azimuth and elevation [rad].
    marker_id : (m,) int
    marker_position : (m, 2) float, m
    """

    time: NDArray[np.float64]
    motion: NDArray[np.float64]
    truth: NDArray[np.float64]
    sighting_time: NDArray[np.float64]
    sighting_id: NDArray[np.int32]
    sighting: NDArray[np.float64]
    marker_id: NDArray[np.int32]
    marker_position: NDArray[np.float64]


def read_triple(folder: Path) -> Triple:
    """Read the files without converting anything."""
    poselog, angles, markers = _the_files(folder)
    row = read_columns(poselog, {"left": 3, "right": 4, "gyro": 8, **POSE_COLUMNS})
    if row["time"].size == 0:
        raise ValueError(f"{poselog}: holds no rows")
    seen = read_columns(angles, {"time": 0, "id": 1, "azimuth": 2, "elevation": 3})
    marker = read_columns(markers, {"id": 0, "x": 1, "y": 2})
    return Triple(
        time=row["time"],
        motion=np.column_stack([row["left"], row["right"], row["gyro"]]),
        truth=np.column_stack([row["x"], row["y"], row["heading"]]),
        sighting_time=seen["time"],
        sighting_id=whole_numbers(seen["id"], angles, "marker id"),
        sighting=np.column_stack([seen["azimuth"], seen["elevation"]]),
        marker_id=whole_numbers(marker["id"], markers, "marker id"),
        marker_position=np.column_stack([marker["x"], marker["y"]]),
    )


def read_poses(poselog: Path) -> NDArray[Any]:
    """Read the poses of a pose log alone, as rows of `evaluate.TRAJECTORY`."""
    row = read_columns(poselog, POSE_COLUMNS)
    utime = microseconds(row["time"], poselog)
    return trajectory(utime, row["x"], row["y"], row["heading"])


def read(folder: Path) -> Log:
    """Encoders and gyro at every row of the pose log, sightings by the sensor ``camera``.

    The wheels' travels become absolute ticks of `TICK_M`. Stamps are kept as they are, jitter and
    repetitions included. Ids count from 0, in the angles as in the map.
    """
    return as_log(read_triple(folder), _the_files(folder))


def as_log(triple: Triple, files: tuple[Path, Path, Path] = FILES) -> Log:
    """Return what `read` makes of the files' content; `files` is what errors and notes name."""
    poselog, angles, markers = files
    recording = Recording()
    utime = microseconds(triple.time, poselog)
    left, right, rate = triple.motion.T
    recording.add_gyro("GYRO", utime, rate)
    recording.add_encoders(
        "ENCODERS",
        utime,
        _ticks(left, poselog, "left wheel travel"),
        _ticks(right, poselog, "right wheel travel"),
    )
    sighted = microseconds(triple.sighting_time, angles)
    azimuth, elevation = triple.sighting.T
    not_measured = np.full(sighted.size, np.nan)
    recording.add_sightings(
        "MARKERS", "camera", sighted, triple.sighting_id, azimuth, elevation, not_measured
    )
    recording.sort()
    return Log(
        kind=KIND,
        recording=recording,
        truth=trajectory(utime, *triple.truth.T),
        map=ground_map(markers, triple.marker_id, *triple.marker_position.T),
        notes=(*order_notes(poselog, utime), *order_notes(angles, sighted)),
    )


def _the_files(folder: Path) -> tuple[Path, Path, Path]:
    return (
        _the_file(folder, "*poselog*.txt"),
        _the_file(folder, "*angles*.txt"),
        _the_file(folder, "*map*.txt"),
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
    with np.errstate(over="ignore"):
        total = np.cumsum(require_finite(travel, where, name))
    return whole_steps(total, 1 / TICK_M, where, name)
