"""Trajectories in text files: TUM (the common tongue of such files) and CSV with a header."""

import csv
import warnings
from pathlib import Path
from typing import Any, TextIO

import numpy as np
from numpy.typing import NDArray

TRAJECTORY = np.dtype([("utime", "i8"), ("x", "f8"), ("y", "f8"), ("heading", "f8")])
"""A row of a trajectory: µs, m, m, rad in (−π, π]."""


def trajectory(utime: NDArray[np.int64], pose: NDArray[np.float64]) -> NDArray[Any]:
    """Make a `TRAJECTORY` array of stamps (n,) and poses (n, 3)."""
    rows = np.empty(len(utime), TRAJECTORY)
    rows["utime"] = utime
    for name, column in zip(("x", "y", "heading"), pose.T, strict=True):
        rows[name] = column
    return rows


def read_trajectory(path: str | Path) -> NDArray[Any]:
    """Read a `TRAJECTORY` array from a ``.csv`` or, whatever else it is called, a TUM file."""
    return read_csv(path) if Path(path).suffix == ".csv" else read_tum(path)


def read_csv(path: str | Path) -> NDArray[Any]:
    """Read the columns utime, x, y, heading of a CSV file; others may stand beside them.

    Raises
    ------
    ValueError
        If a column is missing or a row cannot be read; names the file.
    """
    with open(path, newline="", encoding="utf-8") as file:
        header = next(csv.reader(file), [])
        names = [name.strip() for name in header]
        for name in TRAJECTORY.names or ():
            if name not in names:
                raise ValueError(f"{path}: no column '{name}' in its first line, which has {names}")
        columns = [names.index(name) for name in TRAJECTORY.names or ()]
        return _read(path, file, dtype=TRAJECTORY, delimiter=",", usecols=columns, ndmin=1)


def read_tum(path: str | Path) -> NDArray[Any]:
    """Read a TUM file: ``t x y z qx qy qz qw`` a line, t in s, lines with # are comments.

    Raises
    ------
    ValueError
        If a row cannot be read; names the file.
    """
    with open(path, encoding="utf-8") as file:
        t, x, y, _, qx, qy, qz, qw = _read(path, file, usecols=range(8), ndmin=2).T
    rows = np.empty(t.size, dtype=TRAJECTORY)
    rows["utime"] = np.rint(t * 1e6)
    rows["x"], rows["y"] = x, y
    rows["heading"] = np.arctan2(2.0 * (qw * qz + qx * qy), 1.0 - 2.0 * (qy**2 + qz**2))
    return rows


def _read(path: str | Path, file: TextIO, **how: Any) -> NDArray[Any]:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # of an empty file, which is an error here
            rows = np.loadtxt(file, **how)
    except ValueError as error:
        raise ValueError(f"{path}: {error}") from error
    if rows.size == 0:
        raise ValueError(f"{path}: holds no rows")
    return rows
