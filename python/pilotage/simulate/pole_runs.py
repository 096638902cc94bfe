"""The simulations of section 4 of Sousa and others, and a circle like that of section 5.

The text does not say where the poles stand, what is in view when, and how large the bump is.
"""

from collections.abc import Callable
from dataclasses import dataclass
from functools import partial

import numpy as np
from numpy.typing import NDArray

from .. import MarkerMap
from .chances import Kidnap
from .drives import Drive, drive
from .poles import PERIOD_US, PoleCamera, Seen, ahead, at_once, corner_poles, first_poles, in_turn

CAMERA = PoleCamera()
LASTS_S = 20.0
BUMP_M, BUMP_RAD = 1.0, 0.5
BUMP_NEAR = (3.0, 1.0)
BEFORE_S, AFTER_S = 8.0, 6.0
"""The bump comes within the one, and the run goes on for the other."""


@dataclass(frozen=True)
class World:
    """What was true, what was seen of it, and what a filter is told.

    Attributes
    ----------
    poles : MarkerMap
        That the filter knows.
    told : (3,) float
        Where the robot is said to start: x, y [m], heading [rad].
    colours_only : bool
        Whether it is not told which pole it sees.
    struck : int
        Index of the drive's stamp at which the bump came; 0 where none did.
    """

    drive: Drive
    poles: MarkerMap
    seen: Seen
    told: NDArray[np.float64]
    colours_only: bool
    struck: int


@dataclass(frozen=True)
class PoleRun:
    """What happens in a run."""

    moves: Callable[[np.random.Generator], tuple[Drive, int]]
    """Returns the drive and the index of the stamp at which a bump struck."""
    view: Callable[[Drive, MarkerMap], NDArray[np.bool_]]
    told: tuple[float, float, float] | None = None
    """None: the truth."""
    poles: int = 2
    """So many of the corner poles, the first ones, are in the map."""
    colours_only: bool = False

    def world(self, rng: np.random.Generator) -> World:
        """Draw one."""
        field = corner_poles()
        moved, struck = self.moves(rng)
        seen = CAMERA.see(moved, field, self.view(moved, field), rng)
        told = moved.pose[0] if self.told is None else np.array(self.told)
        known = first_poles(field, self.poles)
        return World(moved, known, seen, told, self.colours_only, struck)


def stopped(_: np.random.Generator) -> tuple[Drive, int]:
    """Section 4.1."""
    rest = np.zeros(_steps(LASTS_S))
    return drive(np.array([4.0, 0.0, 0.0]), rest, rest, PERIOD_US), 0


def moving(rng: np.random.Generator, x: float = 0.0, lasts_s: float = LASTS_S) -> tuple[Drive, int]:
    """Section 4.2: the speeds are drawn anew in each step, and odometry measures them."""
    n = _steps(lasts_s)
    v, omega = rng.normal(1.0, 1.0, n), rng.normal(0.5, 0.5, n)
    return drive(np.array([x, -2.0, 0.0]), v, omega, PERIOD_US), 0


def bumped(rng: np.random.Generator) -> tuple[Drive, int]:
    """Section 4.3: the same circle, moved so that it leads through (3, 1) m."""
    moved, _ = moving(rng, 3.0 - 3.0**0.5, BEFORE_S + AFTER_S)
    off = moved.pose[: _steps(BEFORE_S), :2] - BUMP_NEAR
    struck = int(np.argmin(np.hypot(*off.T)))
    at_s, end = struck * PERIOD_US * 1e-6, struck + _steps(AFTER_S)
    bump = Kidnap((at_s, at_s), (BUMP_M, BUMP_M), (BUMP_RAD, BUMP_RAD))
    moved, _ = bump.strike(moved, corner_poles(), rng)
    return Drive(moved.utime[: end + 1], moved.v[:end], moved.omega[:end], moved.pose[: end + 1]), (
        struck
    )


def circling(_: np.random.Generator) -> tuple[Drive, int]:
    """Like figure 9: a lap round the middle of the field."""
    n = _steps(LASTS_S)
    v, omega = np.full(n, 0.5), np.full(n, 1.0 / 3.0)
    return drive(np.array([0.0, -1.5, 0.0]), v, omega, PERIOD_US), 0


def static_errors(
    rng: np.random.Generator, places: int = 10, measurements: int = 1000
) -> NDArray[np.float64]:
    """(measurements, 2) errors of a pole's distance, as a part of it, and of its bearing [rad]."""
    field = corner_poles()
    stands = np.column_stack([rng.uniform((-4.5, -2.0), (4.5, 2.0), (places, 2)), np.zeros(places)])
    pose = np.repeat(stands, measurements // places, axis=0)
    pose = np.concatenate([pose[:1], pose])
    utime = np.arange(len(pose), dtype=np.int64) * PERIOD_US
    standing = Drive(utime, np.zeros(measurements), np.zeros(measurements), pose)
    one = at_once(standing, field, 1)
    seen = CAMERA.see(standing, field, one, rng)
    exact = PoleCamera(0.0, 0.0).see(standing, field, one, rng)
    return np.column_stack([seen.distance / exact.distance - 1.0, seen.bearing - exact.bearing])


def _steps(time_s: float) -> int:
    return round(time_s * 1e6 / PERIOD_US)


RUNS: dict[str, PoleRun] = {
    "stopped, in turn": PoleRun(stopped, in_turn, (0.0, 0.0, 0.0)),
    "stopped, both": PoleRun(stopped, at_once, (0.0, 0.0, 0.0)),
    "moving, in turn": PoleRun(moving, in_turn, (0.0, 0.0, 0.0)),
    "moving, both": PoleRun(moving, at_once, (0.0, 0.0, 0.0)),
    "moving, told right": PoleRun(moving, in_turn),
    "circle, by colour": PoleRun(circling, ahead, (0.5, -1.2, 0.3), 4, True),
    "bump, in turn": PoleRun(bumped, in_turn),
    "bump, both": PoleRun(bumped, at_once),
    "bump, both of four": PoleRun(bumped, at_once, None, 4),
    "bump, four in turn": PoleRun(bumped, partial(in_turn, count=4), None, 4),
    "bump, all four": PoleRun(bumped, partial(at_once, count=4), None, 4),
}
