"""A drive from point to point, as a user describes the way of a robot."""

import numpy as np
from numpy.typing import NDArray

from ..evaluate import wrap_angle
from ..fields import within
from .drives import STEP_US, Drive, drive

TURN_RAD_S = 0.8
"""On the spot, at every point where the way bends."""


def waypoints(
    duration_s: float, waypoints: list[tuple[float, float]], speed_m_s: float = 0.8
) -> Drive:
    """Drive straight from point to point and turn there, round and round until the time is up."""
    points = np.array(waypoints)
    if len(points) < 2:
        raise ValueError(f"waypoints are {len(points)}, expected two points or more")
    within("speed_m_s", speed_m_s, 1e-3, 1e3)
    legs = np.roll(points, -1, axis=0) - points
    length, direction = np.hypot(*legs.T), np.arctan2(legs[:, 1], legs[:, 0])
    if (length == 0.0).any():
        raise ValueError("two waypoints that follow each other are the same")
    turn = wrap_angle(np.roll(direction, -1) - direction)
    # How far it has come, and turned, at the beginning and at the end of each leg and turn.
    way = np.column_stack([length, np.zeros_like(length)]).ravel()
    bend = np.column_stack([np.zeros_like(turn), turn]).ravel()
    time_s = way / speed_m_s + np.abs(bend) / TURN_RAD_S
    laps = int(np.ceil(duration_s / time_s.sum()))
    ends = [_total(np.tile(of, laps)) for of in (time_s, way, bend)]
    at = np.arange(round(duration_s * 1e6 / STEP_US) + 1) * (STEP_US * 1e-6)
    driven, turned = (np.interp(at, ends[0], total) for total in ends[1:])
    rates = np.diff(np.stack([driven, turned])) / (STEP_US * 1e-6)
    return drive(np.array([*points[0], direction[0]]), *rates)


def _total(parts: NDArray[np.float64]) -> NDArray[np.float64]:
    return np.concatenate([[0.0], np.cumsum(parts)])
