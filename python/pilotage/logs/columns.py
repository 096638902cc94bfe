"""Columns of numbers to stamps, ids, truth and maps: the conversions that the readers share."""

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import MarkerMap, read_table
from ..evaluate import TRAJECTORY, wrap_angle


def read_columns(path: Path, columns: dict[str, int]) -> dict[str, NDArray[np.float64]]:
    """Columns of a text table, by name and number (from 0)."""
    rows = read_table(str(path), list(columns.values()))
    return {name: np.ascontiguousarray(rows[:, i]) for i, name in enumerate(columns)}


def require_finite(values: ArrayLike, where: object, name: str) -> NDArray[np.float64]:
    """The values, or a ValueError that names the first one that is not a finite number."""
    array = np.asarray(values, dtype=np.float64)
    _refuse(~np.isfinite(array), array, where, name, "a finite number")
    return array


def microseconds(seconds: ArrayLike, where: object) -> NDArray[np.int64]:
    """Stamps in whole µs from seconds, to the nearest."""
    return whole_steps(require_finite(seconds, where, "time"), 1e6, where, "time")


def whole_steps(
    values: NDArray[np.float64], per_unit: float, where: object, name: str
) -> NDArray[np.int64]:
    """The values in steps, to the nearest, or a ValueError that names the first that is too big."""
    with np.errstate(over="ignore"):
        steps = np.rint(values * per_unit)
    _refuse(~(np.abs(steps) < 2.0**62), values, where, name, "a smaller number")
    return steps.astype(np.int64)


def whole_numbers(values: ArrayLike, where: object, name: str) -> NDArray[np.int32]:
    """The values as ids, or a ValueError that names the first one that cannot be one."""
    array = np.asarray(values, dtype=np.float64)
    fits = (array == np.rint(array)) & (np.abs(array) < 2**31)
    _refuse(~fits, array, where, name, "a whole number")
    return array.astype(np.int32)


def held(rates: NDArray[np.float64]) -> NDArray[np.float64]:
    """Rates that hold from their row to the next, as velocity_t states them: since the row before.

    The first row only opens the first interval; the last row's rate is never driven.
    """
    return np.concatenate([rates[:1], rates[:-1]])


def trajectory(
    utime: NDArray[np.int64], x: ArrayLike, y: ArrayLike, heading: ArrayLike
) -> NDArray[Any]:
    """`TRAJECTORY` rows, heading wrapped; a row with a value that is not finite is left out."""
    known = np.isfinite(x) & np.isfinite(y) & np.isfinite(heading)
    rows = np.empty(np.count_nonzero(known), dtype=TRAJECTORY)
    for name, column in (("utime", utime), ("x", x), ("y", y)):
        rows[name] = np.asarray(column)[known]
    rows["heading"] = wrap_angle(np.asarray(heading)[known])
    return rows


def ground_map(
    where: object,
    ids: NDArray[np.int32],
    x: NDArray[np.float64],
    y: NDArray[np.float64],
    sigma: float | NDArray[np.float64] = 0.0,
) -> MarkerMap:
    """Markers on the ground, z = 0; an error names the place that they came from."""
    try:
        return MarkerMap(ids, np.column_stack([x, y, np.zeros_like(x)]), sigma)
    except ValueError as error:
        raise ValueError(f"{where}: {error}") from error


def order_notes(where: object, utime: NDArray[np.int64]) -> list[str]:
    """A note if the rows are not in order of time, which the recording puts them in."""
    back = np.flatnonzero(np.diff(utime) < 0)
    if not back.size:
        return []
    first = back[0]
    return [
        f"{where}: time goes back at {back.size} data rows, first at row {first + 2} by "
        f"{(utime[first] - utime[first + 1]) * 1e-6:.6g} s; its rows were put in order of time."
    ]


def _refuse(
    bad: NDArray[np.bool_], values: NDArray[np.float64], where: object, name: str, expected: str
) -> None:
    rows = np.flatnonzero(bad)
    if rows.size:
        raise ValueError(
            f"{where}: data row {rows[0] + 1}: {name} is {values[rows[0]]:g}, expected {expected}"
        )
