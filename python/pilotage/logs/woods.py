"""Lost in the Woods: T. D. Barfoot, course AER1513 "State Estimation for Aerospace Vehicles"."""

from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .. import Recording
from .columns import ground_map, held, microseconds, order_notes, trajectory
from .log import Log
from .matlab import is_matlab, load_variables, variable_names

KIND = "woods"
LOOKED_FOR = "a .mat file with the variables r, b, l, v, om (Lost in the Woods)"

_VECTORS = ("t", "v", "om", "x_true", "y_true", "th_true", "true_valid")


def recognises(path: Path) -> bool:
    """Whether this is such a file, be it complete or not."""
    return is_matlab(path) and {"r", "b", "l"} <= variable_names(path)


def read(path: Path) -> Log:
    """Velocities and the sightings of the sensor ``laser`` (range and bearing); ids from 1.

    A velocity holds from its own row to the next. The file's ``d``, how far the laser sits ahead of
    the centre, belongs to the configuration (``sensors.laser.x_m``).
    """
    data = load_variables(path, (*_VECTORS, "r", "b", "l"))
    t, v, omega, x, y, heading, valid = (data[name].ravel() for name in _VECTORS)
    ranges, bearings, landmarks = data["r"], data["b"], data["l"]
    for name in _VECTORS:
        _require_shape(path, name, data[name].ravel(), (t.size,))
    _require_shape(path, "l", landmarks, (len(landmarks), 2))
    for name in ("r", "b"):
        _require_shape(path, name, data[name], (t.size, len(landmarks)))

    recording = Recording()
    utime = microseconds(t, f"{path}: t")
    recording.add_velocity("VELOCITY", utime, held(v), held(omega))
    row, column = np.nonzero(ranges != 0)  # 0 where a landmark was not seen
    recording.add_sightings(
        "MARKERS",
        "laser",
        utime[row],
        column + 1,
        bearings[row, column],
        np.full(row.size, np.nan),
        ranges[row, column],
    )
    recording.sort()
    ids = np.arange(1, len(landmarks) + 1, dtype=np.int32)
    known = valid != 0
    return Log(
        kind=KIND,
        recording=recording,
        truth=trajectory(utime[known], x[known], y[known], heading[known]),
        map=ground_map(f"{path}: l", ids, landmarks[:, 0], landmarks[:, 1]),
        notes=tuple(order_notes(f"{path}: t", utime)),
    )


def _require_shape(
    path: Path, name: str, array: NDArray[np.float64], shape: tuple[int, ...]
) -> None:
    if array.shape != shape:
        raise ValueError(f"{path}: variable {name} has shape {array.shape}, expected {shape}")
