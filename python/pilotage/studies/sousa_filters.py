"""The filter of Sousa, Costa, Moreira and Carvalho, and the localizer on the same sightings.

The paper numbers two equations 13; here 13' is that of the noise.
"""

from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import (
    Config,
    Ekf3,
    LinearizedVelocity,
    MarkerMap,
    Policy,
    RelativePosition,
    relative_position_noise,
    replay,
)
from ..evaluate import TRAJECTORY
from ..lcmtypes import status_t
from ..simulate.pole_runs import CAMERA, World
from ..simulate.poles import PERIOD_US, SENSOR

START_VARIANCE = 1e-3  # P(0) = 1e-3 I
PROCESS_NOISE = np.full(3, 2e-5)  # Q = 2e-5 I a step: m², m², rad²
POSES = np.dtype([*TRAJECTORY.descr, ("covariance", "f8", (3, 3)), ("status", "i1")])


def noise(relative: NDArray[np.float64]) -> NDArray[np.float64]:
    """R(k) [m²] of a pole there, eqs. 13' to 16 with eq. 15 transposed as it should be."""
    return relative_position_noise(relative, CAMERA.sigma_per_m, CAMERA.sigma_bearing_rad)


def printed_noise(relative: NDArray[np.float64]) -> NDArray[np.float64]:
    """R(k) with eq. 15 as printed: that of the pole's mirror image about the robot's axis."""
    return noise(relative * (1.0, -1.0))


def papers(
    world: World,
    policy: Policy | None = None,
    noise: Callable[[NDArray[np.float64]], NDArray[np.float64]] = noise,
) -> NDArray[Any]:
    """Return the poses (n + 1,) of the paper's filter, section 3. It always thinks it is right."""
    drive, seen, labels = world.drive, world.seen, world.poles.labels
    ekf = Ekf3(world.told, START_VARIANCE * np.eye(3))
    motion = LinearizedVelocity(PERIOD_US * 1e-6)
    models = [RelativePosition(pole[:2]) for pole in world.poles.positions]
    measured = seen.relative
    of_step = np.searchsorted(seen.step, np.arange(len(drive.utime) + 1))
    poses = np.empty(len(drive.utime), POSES)
    poses["utime"], poses["status"] = drive.utime, status_t.OK
    for k in range(len(drive.utime)):
        if k > 0:  # eqs. 4 to 7 and 10
            u = [drive.v[k - 1], drive.omega[k - 1]]
            ekf.predict(motion, u, np.zeros((2, 2)), PROCESS_NOISE)
        for i in range(of_step[k], of_step[k + 1]):
            of = [seen.pole[i]]
            if world.colours_only:
                of = np.flatnonzero(labels == labels[seen.pole[i]]).tolist()
            expected = {j: models[j].predict(ekf.state[None])[0] for j in of}  # eq. 8
            j = min(of, key=lambda j: float(np.hypot(*(measured[i] - expected[j]))))
            r = noise(expected[j])  # in the direction of eq. 14, which is the state's
            ekf.update(models[j], measured[i], r, policy or Policy())  # eqs. 9, 11 to 13
        poses["x"][k], poses["y"][k], poses["heading"][k] = ekf.state
        poses["covariance"][k] = ekf.covariance
    return poses


def ours(world: World, told: bool = True) -> NDArray[Any]:
    """Return the localizer's poses: all as by default but for map, sensor and, if told, start."""
    config = Config()
    config.map = world.poles
    config["motion.source"] = "velocity"
    config[f"sensors.{SENSOR}.sigma_bearing_rad"] = CAMERA.sigma_bearing_rad
    config[f"sensors.{SENSOR}.sigma_range_per_m"] = CAMERA.sigma_per_m
    config[f"sensors.{SENSOR}.sigma_range_m"] = 0.01
    if told:
        for name, value in zip(("x_m", "y_m", "heading_rad"), world.told, strict=True):
            config[f"initial.{name}"] = float(value)
        for name in ("sigma_position_m", "sigma_heading_rad"):
            config[f"initial.{name}"] = START_VARIANCE**0.5
    recording = world.seen.record(world.drive, world.poles, world.colours_only)
    poses: NDArray[Any] = replay(config, recording).poses
    return poses


FILTERS: dict[str, Callable[[World], NDArray[Any]]] = {
    "the paper's": papers,
    "ours": ours,
    "ours, told nothing": partial(ours, told=False),
    "eq. 15 as printed": partial(papers, noise=printed_noise),
    "gate at 0.999": partial(papers, policy=Policy.gate(0.001)),
    "Student-t of 4": partial(papers, policy=Policy.student_t()),
}


def told_by(poles: MarkerMap, place: tuple[float, float]) -> NDArray[np.float64]:
    """(k + 1, 2, 2) covariance of a position [m²], heading known, by each pole and by all."""
    pose = np.array([*place, 0.0])
    models = [RelativePosition(pole[:2]) for pole in poles.positions]
    covariances = []
    for seen in [*([model] for model in models), models]:
        ekf = Ekf3(pose, np.diag([1e4, 1e4, 1e-12]))
        for model in seen:
            relative = model.predict(pose[None])[0]
            ekf.update(model, relative, noise(relative))
        covariances.append(ekf.covariance[:2, :2])
    return np.array(covariances)
