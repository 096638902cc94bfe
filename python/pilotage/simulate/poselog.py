"""A drive as the first paper's on-board computer logged it: late rows, repeated stamps, DGPS.

The sizes are those of the recording `mower-listing`, by its columns held against its truth.
"""

from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from ..evaluate import wrap_angle
from ..logs.mower import Triple
from .drives import STEP_US, Drive
from .measuring import Measured
from .sensors import Camera

LATE_ROWS = 0.26
"""Part of the rows that is not stamped when it was measured."""
STAMP_SIGMA_S = 0.004
"""By how much not."""
STAMP_S = 1e-3
"""Resolution of the stamps."""
TRUTH_SIGMA_M = 0.005
"""Of the reference's x and y, new in every row."""


def slow_clock(drive: Drive, behind_s: float) -> Drive:
    """Return the same way driven a little slower: who takes a row for 10 ms ends `behind_s` early.

    The paper's first footnote: a uniform time stamp lags by almost 5 s over 549 s.
    """
    nominal_s = len(drive.v) * STEP_US * 1e-6
    slower = (nominal_s + behind_s) / nominal_s
    begin = drive.utime[0]
    utime = begin + np.rint((drive.utime - begin) * slower).astype(np.int64)
    return replace(drive, utime=utime, v=drive.v / slower, omega=drive.omega / slower)


def poselog(
    measured: Measured,
    cameras: tuple[Camera, ...],
    m_per_tick: float,
    rng: np.random.Generator,
) -> Triple:
    """Write down what was measured as the paper's three files have it; angles are the robot's."""
    time = measured.drive.utime * 1e-6
    late = STAMP_SIGMA_S * rng.standard_normal(len(time)) * (rng.random(len(time)) < LATE_ROWS)
    stamp = np.maximum.accumulate(np.rint((time + late) / STAMP_S) * STAMP_S)
    ticks = measured.encoders.value
    travel = np.diff(ticks, axis=0, prepend=ticks[:1]) * m_per_tick
    truth = measured.drive.pose.copy()
    truth[:, :2] += TRUTH_SIGMA_M * rng.standard_normal((len(time), 2))
    truth[:, 2] = np.unwrap(truth[:, 2])
    seen = [measured.sightings[camera.name] for camera in cameras]
    yaw = np.concatenate(
        [np.full(len(s), c.mounting[3]) for s, c in zip(seen, cameras, strict=True)]
    )
    values = np.concatenate([s.value for s in seen])
    captured = np.concatenate([s.utime for s in seen]) * 1e-6
    order = np.argsort(captured, kind="stable")
    return Triple(
        time=stamp,
        motion=np.column_stack([travel, measured.gyro.value]),
        truth=truth,
        sighting_time=captured[order],
        sighting_id=np.concatenate([s.id for s in seen])[order],
        sighting=np.column_stack([wrap_angle(values[:, 0] + yaw), values[:, 1]])[order],
        marker_id=measured.markers.ids,
        marker_position=measured.markers.positions[:, :2],
    )


def at_most_one(triple: Triple, window_s: tuple[float, float]) -> Triple:
    """Return the log with the first sighting alone of those within a window since its start."""
    since = triple.sighting_time - triple.time[0]
    inside = np.flatnonzero((since >= window_s[0]) & (since < window_s[1]))
    return without_sightings(triple, inside[1:])


def without_sightings(triple: Triple, rows: NDArray[np.intp]) -> Triple:
    """Return the log without some rows of its angles."""
    return replace(
        triple,
        sighting_time=np.delete(triple.sighting_time, rows),
        sighting_id=np.delete(triple.sighting_id, rows),
        sighting=np.delete(triple.sighting, rows, axis=0),
    )


def in_step(triple: Triple) -> Triple:
    """Return the log with a uniform stamp of 10 ms a row, which the paper advises against."""
    rows = np.arange(len(triple.time))
    return replace(triple, time=triple.time[0] + rows * (STEP_US * 1e-6))


def at_rows(triple: Triple) -> Triple:
    """Return the log with every sighting dated by the first row at or after it (section 3.2)."""
    row = np.searchsorted(triple.time, triple.sighting_time, side="left")
    return replace(triple, sighting_time=triple.time[np.minimum(row, len(triple.time) - 1)])
