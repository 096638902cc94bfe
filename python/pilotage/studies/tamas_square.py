"""The filters of Tamas et al. 2008 on their square, each in terms of the core's models."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import (
    DifferentialDrive,
    Ekf3,
    LinearKalman,
    MoveAndTurn,
    SkidSteer,
    Ukf3,
    WallMap,
    WallRange,
)
from ..evaluate import mahalanobis_squared, wrap_angle
from ..simulate.infrared import LogCurve
from ..simulate.skid_steer import BEAMS, DT_S, WALLS, Lap, SkidSteered

Array = NDArray[np.float64]
Sigma = Callable[[Array], Array]


@dataclass(frozen=True)
class Known:
    """What an engineer has measured of the robot beforehand.

    Attributes
    ----------
    coefficients : (3, 2) float
        Of eq. 30, by least squares.
    infrared : one LogCurve for each of `BEAMS`
        Figure 4.
    """

    coefficients: Array
    infrared: tuple[LogCurve, ...]

    @property
    def track_width_m(self) -> float:
        """W that turns eq. 33 by as much as eq. 30 turns on the spot."""
        return 2.0 / float(self.coefficients[2] @ [1.0, -1.0])

    @property
    def slip_angle_rad(self) -> float:
        """Of the course from the heading, straight on: beta of eqs. 36 and 37."""
        forward, leftward, _ = self.coefficients.sum(axis=1)
        return float(np.arctan2(leftward, forward))


def turn_then_move(start: Array, distance: Array, turn: Array, slip_rad: float = 0.0) -> Array:
    """Step eqs. 31 to 33 in their printed order: the new heading first, all the way along it."""
    steps = np.zeros((len(turn), 2, 2))
    steps[:, 0, 1], steps[:, 1, 0] = turn, distance
    return MoveAndTurn(slip_rad).path(start, steps.reshape(-1, 2))[::2]


def odometry(lap: Lap, track_width_m: float, every: int = 1) -> Array:
    """Eqs. 31 to 35 without the arctan, along the mid heading."""
    return DifferentialDrive(track_width_m).path(lap.pose[0], _travel(lap, every)[:, ::-1])


def printed_odometry(lap: Lap, track_width_m: float, every: int, arctan: bool) -> Array:
    """Eqs. 31 to 35 in their printed order, with or without the arctan."""
    right, left = _travel(lap, every).T
    turn = (right - left) / track_width_m
    turn = np.arctan(turn) if arctan else turn
    return turn_then_move(lap.pose[0], (right + left) / 2.0, turn)


def _travel(lap: Lap, every: int) -> Array:
    """(k, 2) right and left travel [m] of wheels that are read every so many steps."""
    return DT_S * np.add.reduceat(lap.wheels, np.arange(0, len(lap.wheels), every))


def skid_steer(lap: Lap, known: Known) -> Array:
    """Eqs. 29 and 30."""
    return SkidSteer(known.coefficients, DT_S).path(lap.pose[0], lap.wheels)


def gyro_and_compass(lap: Lap, known: Known, robot: SkidSteered) -> Array:
    """Eqs. 36 and 37, their heading by a linear filter (eqs. 3 to 11) of heading and gyro bias."""
    a, q = np.array([[1.0, -DT_S], [0.0, 1.0]]), np.diag([(robot.gyro_rad_s * DT_S) ** 2, 0.0])
    r = [[robot.compass_rad**2 + robot.indoor_rad**2 / 2.0]]
    lkf = LinearKalman([lap.pose[0, 2], 0.0], np.diag([1e-6, robot.gyro_bias_rad_s**2]))
    headings = [lkf.state[0]]
    for rate, read in zip(lap.gyro, lap.compass, strict=True):
        lkf.predict(a, [rate * DT_S, 0.0], q)
        heading = lkf.state[0]
        lkf.update([heading + wrap_angle(read - heading)], [[1.0, 0.0]], r)
        headings.append(lkf.state[0])
    speed = lap.wheels @ known.coefficients[0]
    return turn_then_move(lap.pose[0], speed * DT_S, np.diff(headings), known.slip_angle_rad)


def linear_position(lap: Lap, known: Known, robot: SkidSteered, along: Array) -> Array:
    """Fuse x and y alone by the linear filter, moved as a path (n + 1, 3) that knows the heading.

    While the robot stands along an axis a range is linear in x and y; else there is none.
    """
    walls = WallMap(WALLS)
    q = np.eye(2) * (np.max(robot.slip[:2]) * DT_S) ** 2
    lkf, positions = LinearKalman(lap.pose[0, :2], np.eye(2) * 1e-6), [lap.pose[0, :2]]
    for step, heading, sonar in zip(
        np.diff(along[:, :2], axis=0), along[1:, 2], lap.sonar, strict=True
    ):
        lkf.predict(np.eye(2), step, q)
        axis = np.round(heading / (np.pi / 2.0)) * (np.pi / 2.0)
        for beam in np.flatnonzero(np.isfinite(sonar)):
            model, at = WallRange(walls, BEAMS[beam]), np.append(lkf.state, axis)
            predicted, h, _ = model.linearize(at)
            z = sonar[beam] - predicted + h[:, :2] @ lkf.state
            lkf.update(z, h[:, :2], [[robot.sonar_sigma(sonar[beam]) ** 2]])
        positions.append(lkf.state)
    return np.column_stack([positions, along[:, 2]])


def fuse(
    kind: type[Ekf3] | type[Ukf3],
    lap: Lap,
    known: Known,
    robot: SkidSteered,
    sonar: Sigma,
    corners: bool,
    infrared: bool,
) -> tuple[Array, Array]:
    """Move by eq. 30 and correct by the ranges to the walls.

    Parameters
    ----------
    sonar : callable
        Standard deviation of ranges: R.
    corners : bool
        Whether Q knows how much more the robot slips while it turns.
    infrared : bool
        Whether the infrared pairs take part.

    Returns
    -------
    pose : (n + 1, 3) float
    nees : (n + 1,) float
        Squared Mahalanobis distance of the error, 3 on average where covariance and error agree.
    """
    walls, model = WallMap(WALLS), SkidSteer(known.coefficients, DT_S)
    beams = [WallRange(walls, beam) for beam in BEAMS]
    gamma = np.eye(2) * robot.wheel_m_s**2
    calm, rough = (_process_noise(slip) for slip in (robot.slip, robot.slip_turning))
    rng_sigma = sonar(lap.sonar)
    light = np.column_stack(
        [c.distance(v) for c, v in zip(known.infrared, lap.infrared.T, strict=True)]
    )
    light_sigma = np.column_stack(
        [c.sigma(d) for c, d in zip(known.infrared, light.T, strict=True)]
    )
    readings = np.concatenate([lap.sonar, light], axis=1)
    sigmas = np.concatenate([rng_sigma, light_sigma], axis=1)
    used = np.isfinite(readings)
    used[:, 4:] &= infrared

    ekf = kind(lap.pose[0], np.diag([1e-6, 1e-6, 1e-6]))
    states, covariances = [ekf.state], [ekf.covariance]
    for k, wheels in enumerate(lap.wheels):
        ekf.predict(model, wheels, gamma, rough if corners and lap.turning[k] else calm)
        for i in np.flatnonzero(used[k]):
            ekf.update(beams[i % 4], [readings[k, i]], [[sigmas[k, i] ** 2]])
        states.append(ekf.state)
        covariances.append(ekf.covariance)
    error = np.array(states) - lap.pose
    error[:, 2] = wrap_angle(error[:, 2])
    return np.array(states), mahalanobis_squared(error, np.array(covariances))


def _process_noise(slip: tuple[float, float, float]) -> Array:
    """(3,) of a step: along the floor as much as in its worse direction, whatever the heading."""
    sideways = max(slip[:2])
    return np.square(np.array([sideways, sideways, slip[2]]) * DT_S)
