"""The ranging-radio data sets Plaza and Gesling.

J. Djugash, B. Hamner, S. Roth, "Navigating with Ranging Radios: Five Data Sets with Ground Truth",
J. Field Robotics 26(9), 2009.
"""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import Recording
from .columns import ground_map, microseconds, order_notes, trajectory, whole_numbers
from .log import Log
from .matlab import is_matlab, load_variables, variable_names

KIND = "plaza"
LOOKED_FOR = "a .mat file with the variables GT, DR, TD, TL (Plaza)"

_COLUMNS = {"GT": 4, "DR": 3, "TD": 4, "TL": 3}


def recognises(path: Path) -> bool:
    """Whether this is such a file, be it complete or not."""
    return is_matlab(path) and {"TD", "TL"} <= _variables(path).keys()


def read(path: Path) -> Log:
    """Velocities from the increments of DR, ranges to the beacons by the sensor ``radio``.

    An increment belongs to the interval that ends at its stamp: the heading's is GT's difference
    over that interval. Of the first one only the end is known, so its row opens the second interval
    and its motion, of one period, is left to the uncertainty of the start. Ranges between beacons,
    where a file has them, are left out. In some runs GT's heading points against the direction of
    travel; there it is turned by 180 degrees.
    """
    gt, dr, td, tl = _load(path)
    if len(dr) < 2:
        raise ValueError(f"{path}: DR has {len(dr)} rows, expected 2 or more")
    utime = microseconds(dr[:, 0], f"{path}: DR")
    interval_s = np.diff(utime) * 1e-6
    if (late := np.flatnonzero(interval_s <= 0)).size:
        raise ValueError(
            f"{path}: DR: data row {late[0] + 2}: time does not increase, so its motion has no "
            f"duration"
        )
    interval_s = np.concatenate([[np.median(interval_s)], interval_s])

    recording = Recording()
    recording.add_velocity("VELOCITY", utime, dr[:, 1] / interval_s, dr[:, 2] / interval_s)
    beacons = whole_numbers(tl[:, 0], f"{path}: TL", "beacon")
    by_robot = ~np.isin(td[:, 1], beacons)
    sighted = microseconds(td[by_robot, 0], f"{path}: TD")
    unmeasured = np.full(sighted.size, np.nan)
    recording.add_sightings(
        "MARKERS",
        "radio",
        sighted,
        whole_numbers(td[by_robot, 2], f"{path}: TD", "beacon"),
        unmeasured,
        unmeasured,
        td[by_robot, 3],
    )
    recording.sort()

    notes = order_notes(f"{path}: TD", sighted)
    if not by_robot.all():
        notes.append(f"{path}: TD: {(~by_robot).sum()} ranges between beacons were left out.")
    truth = trajectory(microseconds(gt[:, 0], f"{path}: GT"), gt[:, 1], gt[:, 2], gt[:, 3])
    if _distance_ahead(truth) * dr[:, 1].sum() < 0:
        truth = trajectory(truth["utime"], truth["x"], truth["y"], truth["heading"] + np.pi)
        notes.append(f"{path}: GT's heading points against its direction of travel; it was turned.")
    return Log(
        kind=KIND,
        recording=recording,
        truth=truth,
        map=ground_map(f"{path}: TL", beacons, tl[:, 1], tl[:, 2]),
        notes=tuple(notes),
    )


def _variables(path: Path) -> dict[str, str]:
    """Name in the file by its own name: a file may name the run before it, as in Gesling1_GT."""
    return {name.rpartition("_")[2]: name for name in variable_names(path)}


def _load(path: Path) -> list[NDArray[np.float64]]:
    in_file = _variables(path)
    names = [in_file.get(name, name) for name in _COLUMNS]
    data = load_variables(path, names)
    for name, columns in zip(names, _COLUMNS.values(), strict=True):
        if data[name].shape[1] != columns:
            raise ValueError(
                f"{path}: variable {name} has shape {data[name].shape}, expected (n, {columns})"
            )
    return [data[name] for name in names]


def _distance_ahead(truth: NDArray[Any]) -> float:
    """How far the truth drives along its own heading, m."""
    heading = truth["heading"][:-1]
    ahead = np.diff(truth["x"]) * np.cos(heading) + np.diff(truth["y"]) * np.sin(heading)
    return float(ahead.sum())
