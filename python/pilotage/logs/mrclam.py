"""The UTIAS multi-robot data sets (MRCLAM).

K. Leung, Y. Halpern, T. Barfoot, H. Liu, "The UTIAS Multi-Robot Cooperative Localization and
Mapping Dataset", Int. J. Robotics Research 30(8), 2011.
"""

import re
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .. import Recording
from .columns import (
    ground_map,
    held,
    microseconds,
    order_notes,
    read_columns,
    trajectory,
    whole_numbers,
)
from .log import Log

KIND = "mrclam"
LOOKED_FOR = "a folder with Barcodes.dat, Landmark_Groundtruth.dat and Robot<N>_Odometry.dat"

UNKNOWN_BARCODE = 1000
"""A barcode that Barcodes.dat does not list comes as the marker of this id plus the barcode."""


def recognises(path: Path) -> bool:
    """Whether this is such a folder, be it complete or not."""
    return path.is_dir() and ((path / "Barcodes.dat").exists() or bool(_robots(path)))


def read(folder: Path, robot: int | None = None) -> Log:
    """The velocities, sightings (sensor ``camera``: range and bearing) and truth of one robot.

    Velocities are commands that hold until the next row. The Measurement file's "subject" column
    holds barcodes; here a sighting's id is the subject's number. Subjects 1 to 5 are other robots
    and not in the map, nor is an unlisted barcode (`UNKNOWN_BARCODE`), so the localizer counts
    these sightings as unknown markers.

    Parameters
    ----------
    robot : int, optional
        Its number; may be left out where the folder has one robot only.
    """
    chosen = _choose(folder, robot)
    barcodes, landmarks, odometry, measurement, groundtruth = (
        _the_file(folder, name)
        for name in (
            "Barcodes.dat",
            "Landmark_Groundtruth.dat",
            f"Robot{chosen}_Odometry.dat",
            f"Robot{chosen}_Measurement.dat",
            f"Robot{chosen}_Groundtruth.dat",
        )
    )
    drive = read_columns(odometry, {"time": 0, "v": 1, "omega": 2})
    if drive["time"].size == 0:
        raise ValueError(f"{odometry}: holds no rows")
    seen = read_columns(measurement, {"time": 0, "barcode": 1, "range": 2, "bearing": 3})
    true = read_columns(groundtruth, {"time": 0, "x": 1, "y": 2, "heading": 3})
    landmark = read_columns(landmarks, {"id": 0, "x": 1, "y": 2, "sigma_x": 3, "sigma_y": 4})

    recording = Recording()
    utime = microseconds(drive["time"], odometry)
    recording.add_velocity("VELOCITY", utime, held(drive["v"]), held(drive["omega"]))
    sighted = microseconds(seen["time"], measurement)
    barcode = whole_numbers(seen["barcode"], measurement, "barcode")
    subject_of = _subjects(barcodes)
    beyond = (barcode < 0) | (barcode >= 2**31 - UNKNOWN_BARCODE)
    if beyond.any():
        row = int(np.argmax(beyond))
        raise ValueError(f"{measurement}: data row {row + 1}: no barcode is {barcode[row]}")
    ids = np.array([subject_of.get(b, UNKNOWN_BARCODE + b) for b in barcode.tolist()], np.int32)
    unmeasured = np.full(sighted.size, np.nan)
    recording.add_sightings(
        "MARKERS", "camera", sighted, ids, seen["bearing"], unmeasured, seen["range"]
    )
    recording.sort()
    with np.errstate(over="ignore"):  # the map refuses what is infinite
        sigma = np.sqrt((landmark["sigma_x"] ** 2 + landmark["sigma_y"] ** 2) / 2)
    return Log(
        kind=KIND,
        recording=recording,
        truth=trajectory(
            microseconds(true["time"], groundtruth), true["x"], true["y"], true["heading"]
        ),
        map=ground_map(
            landmarks,
            whole_numbers(landmark["id"], landmarks, "subject"),
            landmark["x"],
            landmark["y"],
            sigma,
        ),
        notes=(
            *order_notes(odometry, utime),
            *order_notes(measurement, sighted),
            *_unknown_notes(measurement, barcode[ids >= UNKNOWN_BARCODE]),
        ),
    )


def _robots(folder: Path) -> list[int]:
    names = (re.fullmatch(r"Robot(\d+)_Odometry\.dat", path.name) for path in folder.iterdir())
    return sorted(int(name[1]) for name in names if name)


def _choose(folder: Path, robot: int | None) -> int:
    robots = _robots(folder)
    if not robots:
        raise FileNotFoundError(f"{folder}: no Robot<N>_Odometry.dat; {KIND} data is {LOOKED_FOR}")
    there = f"{folder} has robot {', '.join(map(str, robots))}"
    if robot is None and len(robots) > 1:
        raise ValueError(f"{there}: say which one (robot=N, or --robot N)")
    if robot is not None and robot not in robots:
        raise ValueError(f"{there}, not {robot}")
    return robots[0] if robot is None else robot


def _the_file(folder: Path, name: str) -> Path:
    if not (folder / name).exists():
        raise FileNotFoundError(f"{folder}: no {name}")
    return folder / name


def _subjects(path: Path) -> dict[int, int]:
    rows = read_columns(path, {"subject": 0, "barcode": 1})
    subjects = whole_numbers(rows["subject"], path, "subject").tolist()
    barcodes = whole_numbers(rows["barcode"], path, "barcode").tolist()
    subject_of: dict[int, int] = {}
    for subject, barcode in zip(subjects, barcodes, strict=True):
        if barcode in subject_of:
            raise ValueError(
                f"{path}: barcode {barcode} stands for subjects {subject_of[barcode]} and {subject}"
            )
        subject_of[barcode] = subject
    return subject_of


def _unknown_notes(path: Path, barcode: NDArray[np.int32]) -> list[str]:
    if not barcode.size:
        return []
    names = ", ".join(str(b) for b in np.unique(barcode))
    return [
        f"{path}: {barcode.size} sightings of barcodes that Barcodes.dat does not list ({names}) "
        f"come as unknown markers {UNKNOWN_BARCODE} + barcode."
    ]
