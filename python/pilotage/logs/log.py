"""What every reader returns."""

from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from .. import MarkerMap, Recording
from ..lcmtypes import marker_frame_t


@dataclass(frozen=True)
class Log:
    """A recording with what is known beside it.

    Attributes
    ----------
    kind : str
        Name of the format: ``mower``, ``mrclam``, ``woods``, ``plaza`` or ``lcm``.
    recording : Recording
        What the robot measured, as LCM messages in order of time: ENCODERS and GYRO, or VELOCITY,
        and MARKERS.
    truth : structured array (n,) or None
        Rows of `evaluate.TRAJECTORY`: ``utime`` µs, ``x``, ``y`` m, ``heading`` rad, all finite.
    map : MarkerMap or None
        The surveyed markers where the format has them.
    notes : tuple of str
        What a user should know of the conversion, a sentence each.
    """

    kind: str
    recording: Recording
    truth: NDArray[Any] | None
    map: MarkerMap | None
    notes: tuple[str, ...] = ()


def without_ids(log: Log) -> Log:
    """Return the log as of a sensor that knows no ids: each sighting has id -1.

    It shows what association costs where the truth of it is known.
    """
    frame_t: Any = marker_frame_t  # generated without types
    fingerprint = frame_t().encode()[:8]
    recording = Recording()
    for i in range(len(log.recording)):
        received, channel, data = log.recording[i]
        if data[:8] == fingerprint:
            frame = frame_t.decode(data)
            for sighting in frame.sightings:
                sighting.id = -1
            data = frame.encode()
        recording.add(received, channel, data)
    return replace(log, recording=recording)


def write_lcmlog(log: Log, path: str | Path) -> None:
    """Write the recording as an LCM log file, with the truth as reference_t on channel REFERENCE.

    The truth is added to ``log.recording``, unless that has reference_t already.
    """
    if log.truth is not None and len(log.recording.reference()) == 0:
        truth = log.truth
        log.recording.add_reference(
            "REFERENCE", truth["utime"], truth["x"], truth["y"], truth["heading"]
        )
        log.recording.sort()
    log.recording.save(str(path))
