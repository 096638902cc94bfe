"""The first paper's wish for velocities in the state, and the pose alone with the same noise.

Encoders and gyro are measurements of speed and turn rate here, where the paper takes them as the
motion's input; both have the noise that the mower's configuration states, by distance and time.
"""

import numpy as np
from numpy.typing import NDArray

from .. import Config, ConstantVelocity, Ekf3, Ekf5, GyroDrive, WheelTravel, YawRate
from ..logs.mower import Triple
from ..simulate.mower import TICK_M
from .kiriy_listing import MEASUREMENT_NOISE, TRACK_WIDTH_M, marker_models, sightings_by_row

SPEED_WALK = 0.3  # m/s per √s: how a mower driven by hand changes its speed
RATE_WALK = 0.05  # rad/s per √s


def run(triple: Triple, config: Config, velocities: bool) -> NDArray[np.float64]:
    """Return (n, 3) x, y, heading of each row, or (n, 5) with speed [m/s] and turn rate [rad/s]."""
    n = len(triple.time)
    dt = float(triple.time[-1] - triple.time[0]) / (n - 1)
    way = np.abs(triple.motion[:, :2]).mean(axis=1)
    wheel = config["noise.wheel_m_per_sqrt_m"] ** 2 * way + TICK_M**2 / 6  # of a rounded total
    gyro = config["noise.gyro_rad_per_sqrt_s"] ** 2 / dt
    noise = np.zeros((n, 3, 3))  # of left, right and turn
    noise[:, 0, 0] = noise[:, 1, 1] = wheel
    noise[:, 2, 2] = gyro * dt**2
    grown = [config[f"noise.{key}_per_sqrt_m"] ** 2 for key in ("position_m", "heading_rad")]
    q = way[:, None] * np.array([grown[0], grown[0], grown[1], 0.0, 0.0])
    sigma = [config[f"initial.sigma_{key}"] for key in ("position_m", "position_m", "heading_rad")]
    markers, due = marker_models(triple), sightings_by_row(triple)

    ekf: Ekf3 | Ekf5
    if velocities:
        start = np.append(triple.truth[0], [0.0, 0.0])
        ekf = Ekf5(start, np.diag(np.square([*sigma, 1.0, 0.1])))
        motion, speeds, rate = ConstantVelocity(dt), WheelTravel(TRACK_WIDTH_M, dt), YawRate()
        steady, change = np.zeros(2), np.diag([SPEED_WALK**2, RATE_WALK**2]) / dt
    else:
        ekf = Ekf3(triple.truth[0], np.diag(np.square(sigma)))
        drive, inputs = GyroDrive(), triple.motion * (1.0, 1.0, dt)
    gyro_noise = np.array([[gyro]])
    estimates = np.empty((n, len(ekf.state)))
    for i in range(n):
        if isinstance(ekf, Ekf5):
            ekf.predict(motion, steady, change, q[i])
            ekf.update(speeds, triple.motion[i, :2], noise[i, :2, :2])
            ekf.update(rate, triple.motion[i, 2:], gyro_noise)
        else:
            ekf.predict(drive, inputs[i], noise[i], q[i, :3])
        for k in due.get(i, ()):
            ekf.update(markers[triple.sighting_id[k]], triple.sighting[k], MEASUREMENT_NOISE)
        estimates[i] = ekf.state
    return estimates
