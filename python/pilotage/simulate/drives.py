"""How the robot moves: piecewise constant speed and turn rate, and the true poses that follow."""

from collections.abc import Callable
from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from .. import ArcUnicycle
from ..evaluate.trajectory import trajectory
from ..fields import within

STEP_US = 10_000
"""Between motion samples, µs."""
HELD_STEPS = 25
"""For so many steps the spiral's rates hold."""
OVALS = 6
STANDS_FIRST_S = 3.0
"""Before the rounds begin."""
HALF_LAP = np.array(
    [
        (5.0, 1.0, 0.0),
        (8.0, 0.8, np.pi / 6),
        (11.0, 0.0, 0.0),
        (15.0, 0.9, 0.0),
        (17.0, 0.8, -np.pi / 8),
        (21.0, 0.8, 3 * np.pi / 16),
        (22.5, 1.0, 0.0),
    ]
)
"""Of the rounds; two close a lap. End [s], speed [m/s] and turn rate [rad/s] of each part."""
RAMP_STEPS = 50
TURNS_S, FIRST_TURN_RAD = 2.0, -1.33
"""On the spot, before it begins to weave."""
WEAVE_S, WEAVES_RAD_S = 8.0, 0.5
_MODEL = ArcUnicycle()


@dataclass(frozen=True)
class Drive:
    """True motion: rates that hold over each step, and the pose at each end of it.

    Attributes
    ----------
    utime : (n + 1,) int, µs
    v, omega : (n,) float
        Speed [m/s] and turn rate [rad/s] between the stamps.
    pose : (n + 1, 3) float
        x, y [m], heading [rad] at the stamps.
    """

    utime: NDArray[np.int64]
    v: NDArray[np.float64]
    omega: NDArray[np.float64]
    pose: NDArray[np.float64]

    def at(self, utime: NDArray[np.int64]) -> NDArray[np.float64]:
        """Return the true poses (n, 3) at any times (n,) of the drive."""
        i = np.minimum(np.searchsorted(self.utime, utime, side="right") - 1, len(self.v) - 1)
        dt = (utime - self.utime[i]) * 1e-6
        return _MODEL.step_each(self.pose[i], np.column_stack([self.v[i] * dt, self.omega[i] * dt]))

    def displaced(self, k: int, pose: NDArray[np.float64]) -> "Drive":
        """Return the same motion, but from the k-th stamp on it goes on from another pose (3,)."""
        onward = _MODEL.path(pose, self.increments[k:])
        return replace(self, pose=np.concatenate([self.pose[:k], onward]))

    def truth(self) -> NDArray[np.void]:
        """Return the poses at the stamps, rows of `evaluate.TRAJECTORY`."""
        return trajectory(self.utime, self.pose)

    @property
    def increments(self) -> NDArray[np.float64]:
        """(n, 2) distance [m] and turn [rad] between the stamps."""
        dt = np.diff(self.utime) * 1e-6
        return np.column_stack([self.v * dt, self.omega * dt])


def drive(
    start: NDArray[np.float64],
    v: NDArray[np.float64],
    omega: NDArray[np.float64],
    step_us: int = STEP_US,
) -> Drive:
    """Step the core's motion model through the rates, `step_us` each."""
    utime = np.arange(len(v) + 1, dtype=np.int64) * step_us + 1_000_000
    pose = _MODEL.path(start, np.column_stack([v, omega]) * (step_us * 1e-6))
    return Drive(utime, v, omega, pose)


def spiral(duration_s: float) -> Drive:
    """Oval laps about the origin, ever wider, at the uneven speed of a mower driven by hand."""
    n = round(duration_s * 1e6 / STEP_US)
    t = np.arange(n) * (STEP_US * 1e-6)
    v = 1.4 + 0.25 * np.sin(0.11 * t) + 0.1 * np.sin(0.5 * t)
    v[t < 1.0] = 0.0  # it stands at first
    radius = 4.0 + 16.0 * t / 549.0
    omega = np.empty(n)
    heading = 0.0
    for first in range(0, n, HELD_STEPS):
        held = slice(first, first + HELD_STEPS)
        v[held] = v[first]
        # A bend that depends on the heading alone keeps the ovals where they are.
        omega[held] = v[first] / radius[first] * (1 + 0.4 * np.cos(2 * heading))
        heading += omega[first] * HELD_STEPS * (STEP_US * 1e-6)
    return drive(np.array([0.0, -1.3 * radius[0], 0.0]), v, omega)


def inward_spiral(duration_s: float) -> Drive:
    """Six ovals, ever narrower and slower, from 34 m by 52 m to a third: a lawn mown inwards."""
    t = np.arange(round(duration_s * 1e6 / STEP_US) + 2) * (STEP_US * 1e-6 / duration_s)
    angle, size = 2 * np.pi * OVALS * t, 1.0 - 0.68 * t
    xy = size[:, None] * np.column_stack([17.0 * np.cos(angle), 26.0 * np.sin(angle)])
    along = np.diff(xy, axis=0)
    heading = np.unwrap(np.arctan2(along[:, 1], along[:, 0]))
    v, omega = np.hypot(*along[:-1].T), np.diff(heading)
    return drive(np.append(xy[0], heading[0]), *np.stack([v, omega]) / (STEP_US * 1e-6))


def circle(duration_s: float, radius_m: float = 1.5, speed_m_s: float = 0.5) -> Drive:
    """Round the middle of the field."""
    within("radius_m", radius_m, 1e-3)
    n = round(duration_s * 1e6 / STEP_US)
    start = np.array([radius_m, 0.0, np.pi / 2])
    return drive(start, np.full(n, speed_m_s), np.full(n, speed_m_s / radius_m))


def figure_eight(duration_s: float, radius_m: float = 2.5, speed_m_s: float = 0.8) -> Drive:
    """One circle to the left, one to the right, side by side."""
    within("radius_m", radius_m, 1e-3)
    within("speed_m_s", speed_m_s, 1e-3)
    t = np.arange(round(duration_s * 1e6 / STEP_US)) * (STEP_US * 1e-6)
    lap_s = 2 * np.pi * radius_m / speed_m_s
    side = np.where((t // lap_s) % 2 == 0, 1.0, -1.0)
    omega = side * speed_m_s / radius_m
    start = np.array([0.0, 0.0, np.pi / 2])
    return drive(start, np.full(len(t), speed_m_s), omega)


def rounds(duration_s: float) -> Drive:
    """Round a yard: straights, bends to both sides, and a stop of three seconds every half lap."""
    t = np.arange(round(duration_s * 1e6 / STEP_US)) * (STEP_US * 1e-6)
    ends, v, omega = HALF_LAP.T
    in_half_lap = np.maximum(t - STANDS_FIRST_S, 0.0) % ends[-1]
    segment = np.searchsorted(ends, in_half_lap, side="right")
    rates = np.stack([v[segment], omega[segment]]) * (t >= STANDS_FIRST_S)
    # Over half a second, since no robot changes its speed at once.
    ramp = np.ones(RAMP_STEPS) / RAMP_STEPS
    v, omega = (np.convolve(rate, ramp)[: len(t)] for rate in rates)
    return drive(np.array([-4.0, -3.5, 0.0]), v, omega)


def weaving(duration_s: float, radius_m: float = 1.9, speed_m_s: float = 0.22) -> Drive:
    """Round the ring of markers, weaving so that a camera ahead sweeps over them."""
    t = np.arange(round(duration_s * 1e6 / STEP_US)) * (STEP_US * 1e-6)
    aside = WEAVES_RAD_S * np.cos(2 * np.pi * (t - TURNS_S) / WEAVE_S)
    omega = np.where(t < TURNS_S, FIRST_TURN_RAD / TURNS_S, speed_m_s / radius_m + aside)
    return drive(np.array([-2.0, -0.5, 0.0]), np.where(t < TURNS_S, 0.0, speed_m_s), omega)


DRIVES: dict[str, Callable[..., Drive]] = {
    "spiral": spiral,
    "circle": circle,
    "figure-eight": figure_eight,
    "rounds": rounds,
    "weaving": weaving,
    "inward-spiral": inward_spiral,
}
"""By the name that a scenario file calls them."""
