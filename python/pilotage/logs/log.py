"""What every reader returns."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from numpy.typing import NDArray

from .. import MarkerMap, Recording


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
