"""Sightings that say their marker's label, which `Recording.add_sightings` does not take."""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import Recording
from ..lcmtypes import marker_frame_t, marker_sighting_t
from .streams import Stream

FRAME_T: Any = marker_frame_t  # generated without types
SIGHTING_T: Any = marker_sighting_t


def add_labelled(
    recording: Recording, channel: str, sensor: str, seen: Stream, labels: NDArray[np.int32]
) -> None:
    """Encode marker_frame_t with a label (n,) for each row, -1 none.

    As with `Recording.add_sightings`, rows that follow each other with equal utime, time of arrival
    and seq make one frame.
    """
    header = np.stack([seen.utime, seen.received, seen.seq])
    starts = np.flatnonzero(np.diff(header, axis=1).any(axis=0)) + 1
    for rows in np.split(np.arange(len(seen)), starts):
        if len(rows):
            frame = FRAME_T()
            utime, received, frame.seq = header[:, rows[0]].tolist()
            frame.utime, frame.sensor, frame.n = utime, sensor, len(rows)
            frame.sightings = [_sighting(seen, row, labels) for row in rows]
            recording.add(received, channel, frame.encode())


def _sighting(seen: Stream, row: int, labels: NDArray[np.int32]) -> Any:
    sighting = SIGHTING_T()
    sighting.id, sighting.label = int(seen.id[row]), int(labels[row])
    sighting.bearing, sighting.elevation, sighting.range = seen.value[row].tolist()
    sighting.sigma_bearing = sighting.sigma_elevation = sighting.sigma_range = np.nan
    return sighting
