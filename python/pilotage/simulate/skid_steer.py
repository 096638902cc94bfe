"""A skid-steered robot on a square within four walls, and all that it measures on its way."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import PlanarVelocity, WallMap
from ..evaluate import wrap_angle
from .infrared import COLOURS, InfraredPair
from .waypoints import waypoints

DT_S = 0.1
ROOM = ((-0.5, -0.5), (2.5, -0.5), (2.5, 2.5), (-0.5, 2.5))
"""Corners of its walls, m; the square of 2 m stands in its middle."""
WALLS = np.array([(*a, *b) for a, b in zip(ROOM, ROOM[1:] + ROOM[:1], strict=True)])
"""(4, 4), as WallMap takes them."""
BEAMS = np.radians([0.0, 90.0, 180.0, -90.0])
"""Of the four infrared pairs; those of `SONAR_BEAMS` have an ultrasonic one as well."""
SONAR_BEAMS = (0, 3)


@dataclass(frozen=True)
class SkidSteered:
    """What moves it and what it measures; every number is ours, the paper gives none."""

    coefficients: tuple[tuple[float, float], ...] = ((0.50, 0.48), (0.02, -0.04), (1.66, -1.62))
    """Eq. 30: right and left wheel speed to forward, leftward [m/s] and yaw rate [rad/s]."""
    slip: tuple[float, float, float] = (0.005, 0.002, 0.01)
    """Standard deviation of the body's velocity about eq. 30 over a step, m/s, m/s, rad/s."""
    slip_turning: tuple[float, float, float] = (0.01, 0.02, 0.06)
    """The same while it turns on the spot."""
    wheel_m_s: float = 0.005
    camera: tuple[float, float, float] = (0.01, 0.01, 0.02)
    """Of the velocities that a camera above the floor measures, m/s, m/s, rad/s."""
    gyro_rad_s: float = 0.01
    gyro_bias_rad_s: float = 0.01
    """Standard deviation over the runs."""
    compass_rad: float = np.radians(3.0)
    indoor_rad: float = np.radians(10.0)
    """Largest deviation of the compass by iron, which changes over the room."""
    sonar_reach_m: tuple[float, float] = (0.1, 2.0)
    sonar_aligned_rad: float = np.radians(20.0)
    sonar_sigma_m: tuple[float, float] = (0.005, 0.01)
    """Of its ranges, and more a metre of them: the air's temperature, the wall's roughness."""
    infrared: tuple[InfraredPair, ...] = (
        InfraredPair(0.80, 2.00),
        InfraredPair(0.76, 2.10),
        InfraredPair(0.84, 1.90),
        InfraredPair(0.82, 2.05),
    )

    def body(
        self, wheels: NDArray[np.float64], turning: NDArray[np.bool_], rng: np.random.Generator
    ) -> NDArray[np.float64]:
        """(n, 3) velocity of the body under wheel speeds (n, 2), eq. 30 and its slip."""
        slip = np.where(turning[:, None], self.slip_turning, self.slip)
        moving = np.any(wheels != 0.0, axis=1)[:, None]
        exact = wheels @ np.transpose(self.coefficients)
        return np.asarray(exact + moving * slip * rng.standard_normal((len(wheels), 3)))

    def sonar_sigma(self, distance: NDArray[np.float64]) -> NDArray[np.float64]:
        """Return the standard deviation of ultrasonic ranges, m."""
        return self.sonar_sigma_m[0] + self.sonar_sigma_m[1] * distance

    def calibration_drive(
        self, steps: int, rng: np.random.Generator
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Drive with wheel speeds at random, followed by a camera that sees the body's velocity.

        Returns
        -------
        wheels : (n, 2) float, m/s
            As measured.
        body : (n, 3) float, m/s, m/s, rad/s
            As the camera sees it.
        """
        wheels = rng.uniform(-0.4, 0.4, (steps, 2))
        body = self.body(wheels, np.ones(steps, np.bool_), rng)
        body += self.camera * rng.standard_normal(body.shape)
        return wheels + self.wheel_m_s * rng.standard_normal(wheels.shape), body

    def wheels(self, v: NDArray[np.float64], omega: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, 2) right and left wheel speed that drive so fast and turn so fast."""
        forward, _, yaw = np.array(self.coefficients)
        return np.linalg.solve([forward, yaw], np.stack([v, omega])).T


@dataclass(frozen=True)
class Lap:
    """A drive, n steps of `DT_S`; what is measured stands at their ends.

    Attributes
    ----------
    pose : (n + 1, 3) float
        Truth: x, y [m], heading [rad], not wrapped.
    turning : (n,) bool
        At a corner, as commanded.
    wheels : (n, 2) float
        Measured right and left wheel speed, m/s.
    gyro, compass : (n,) float
        Yaw rate [rad/s] and heading [rad].
    sonar, infrared : (n, 4) float
        Range [m] and reading [V] along `BEAMS`, NaN where there is none.
    """

    pose: NDArray[np.float64]
    turning: NDArray[np.bool_]
    wheels: NDArray[np.float64]
    gyro: NDArray[np.float64]
    compass: NDArray[np.float64]
    sonar: NDArray[np.float64]
    infrared: NDArray[np.float64]


def square_lap(robot: SkidSteered, rng: np.random.Generator) -> Lap:
    """Drive round the square of 2 m by 2 m twice."""
    plan = waypoints(69.0, [(0.0, 0.0), (2.0, 0.0), (2.0, 2.0), (0.0, 2.0)], 0.3)
    held = round(DT_S * 1e6 / np.diff(plan.utime[:2])[0])
    v, omega = (rate.reshape(-1, held).mean(axis=1) for rate in (plan.v, plan.omega))
    turning = omega != 0.0
    wheels = robot.wheels(v, omega)
    body = robot.body(wheels, turning, rng)
    pose = PlanarVelocity(DT_S).path(plan.pose[0], body)
    pose[:, 2] = np.unwrap(pose[:, 2])
    at = pose[1:]
    n = len(at)

    indoor = np.sin(2.0 * np.pi * (at[:, 0] + at[:, 1]) / 3.0 + rng.uniform(0.0, 2.0 * np.pi))
    compass = wrap_angle(
        at[:, 2] + robot.indoor_rad * indoor + robot.compass_rad * rng.standard_normal(n)
    )
    gyro = body[:, 2] + robot.gyro_bias_rad_s * rng.standard_normal()
    gyro = gyro + robot.gyro_rad_s * rng.standard_normal(n)

    distance, incidence = look_at_walls(at)
    low, high = robot.sonar_reach_m
    heard = (distance >= low) & (distance <= high) & (incidence <= robot.sonar_aligned_rad)
    heard = heard & np.isin(np.arange(4), SONAR_BEAMS)
    sonar = np.where(heard, distance, np.nan)
    sonar = sonar + robot.sonar_sigma(sonar) * rng.standard_normal(sonar.shape)
    light = [
        pair.reading(d, angle, COLOURS["white"], rng)
        for pair, d, angle in zip(robot.infrared, distance.T, incidence.T, strict=True)
    ]
    return Lap(
        pose,
        turning,
        wheels + robot.wheel_m_s * rng.standard_normal(wheels.shape) * (wheels != 0.0),
        gyro,
        compass,
        sonar,
        np.column_stack(light),
    )


def look_at_walls(pose: NDArray[np.float64]) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Distance [m] and angle from the wall's normal [rad] (n, 4) of each beam from poses (n, 3)."""
    distance = WallMap(WALLS).cast(pose, BEAMS)
    direction = pose[:, 2:] + BEAMS
    across = np.stack([np.cos(direction), np.sin(direction)])
    met = pose[:, :2].T[:, :, None] + distance * across
    middle = np.mean(ROOM, axis=0)
    # Which pair of walls it is: the one that the point is furthest out towards.
    upright = np.abs(met[0] - middle[0]) > np.abs(met[1] - middle[1])
    return distance, np.arccos(np.minimum(np.abs(np.where(upright, *across)), 1.0))
