"""The posterior Cramér-Rao bound: no estimator has a smaller error on this drive.

Source: P. Tichavský, C. H. Muravchik, A. Nehorai, "Posterior Cramér-Rao Bounds for Discrete-Time
Nonlinear Filtering", IEEE Transactions on Signal Processing 46(5), 1998, eq. 21, with information
at the true pose, averaged over runs. The true motion is the same in all runs, so the average is
exact without drawing: a frame falls into a step with the probability that its rate says.

States: x, y [m], heading [rad], gyro bias [rad/s], distance scale. Outliers and tilt are left out:
they take information away, so the bound stays one.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import ArcUnicycle, MarkerMap, MarkerModel
from ..sensor_keys import COMPONENTS
from ..simulate import Scenario
from ..simulate.drives import Drive
from ..simulate.sensors import Camera

EXACT_M2 = 1e-14
"""Variance of a wheel that stands, so that its information is a number."""


@dataclass(frozen=True)
class Bound:
    """Smallest root mean square errors at the drive's stamps.

    Attributes
    ----------
    position_m : (n + 1,)
        Of the position error's norm.
    heading_rad : (n + 1,)
    """

    position_m: NDArray[np.float64]
    heading_rad: NDArray[np.float64]

    def every(self, steps: int) -> "Bound":
        """Return it at every so many stamps."""
        return Bound(self.position_m[::steps], self.heading_rad[::steps])

    @classmethod
    def of(cls, scenario: Scenario, markers: MarkerMap, drive: Drive) -> "Bound":
        """Compute the bound of a drive that is the same in all runs, from a known start."""
        position, heading = scenario.prior()
        start = scenario.start.error_factor * np.array([position, position, heading])
        known = [scenario.gyro.bias_sigma_rad_s, scenario.encoders.scale_sigma]
        prior = np.diag(np.append(start, known) ** 2)
        transition, noise, calibration = motion(scenario, drive)
        information = np.zeros((len(drive.utime), 5, 5))
        information[1:, 3:, 3:] = calibration
        for camera in scenario.cameras:
            information[:, :3, :3] += sightings(camera, markers, drive)
        covariance = recursion(prior, transition, noise, information)
        variance = np.diagonal(covariance, axis1=1, axis2=2)
        return cls(np.sqrt(variance[:, 0] + variance[:, 1]), np.sqrt(variance[:, 2]))


def recursion(
    prior: NDArray[np.float64],
    transition: NDArray[np.float64],
    noise: NDArray[np.float64],
    information: NDArray[np.float64],
) -> NDArray[np.float64]:
    """Carry the bound on, as a covariance, so that states may be known exactly and noise singular.

    Parameters
    ----------
    prior : (k, k)
        Covariance before the first stamp's information.
    transition, noise : (n, k, k)
        A and Q of each step.
    information : (n + 1, k, k)
        What is learnt at each stamp.

    Returns
    -------
    (n + 1, k, k)
    """
    bound = np.empty_like(information)
    unity = np.eye(len(prior))
    for i, learnt in enumerate(information):
        if i > 0:
            prior = transition[i - 1] @ bound[i - 1] @ transition[i - 1].T + noise[i - 1]
        posterior = np.linalg.solve(unity + prior @ learnt, prior)
        bound[i] = (posterior + posterior.T) / 2.0
    return bound


def motion(
    scenario: Scenario, drive: Drive
) -> tuple[NDArray[np.float64], NDArray[np.float64], NDArray[np.float64]]:
    """What wheels and gyro together tell of each step, and of bias and scale.

    The readings of a step (left and right travel, gyro's turn) are C u + G c + noise, with u the
    step's distance and turn and c = (bias, distance scale). Of u follows the best estimate given c
    with its covariance; what the three readings say of each other is information about c.

    Returns
    -------
    transition, noise : (n, 5, 5)
    calibration : (n, 2, 2)
        Information about bias and scale.
    """
    encoders, gyro, model = scenario.encoders, scenario.gyro, ArcUnicycle()
    u, dt = drive.increments, np.diff(drive.utime) * 1e-6
    n, travel = len(u), encoders.travel(drive)
    variance = np.column_stack([encoders.variance(travel), gyro.noise_rad_per_sqrt_s**2 * dt])
    weight = 1.0 / np.maximum(variance, EXACT_M2)
    half = encoders.track_width_m / 2
    c = np.array([[1.0, -half], [1.0, half], [0.0, 1.0]])
    g = np.zeros((n, 3, 2))
    g[:, 2, 0] = dt
    g[:, :2, 1] = -travel
    gamma = np.linalg.inv(np.einsum("ri,nr,rj->nij", c, weight, c))
    gain = np.einsum("nij,rj,nr->nir", gamma, c, weight)
    by_calibration = -gain @ g
    left = g + c @ by_calibration  # of the readings, what no u explains
    calibration = np.einsum("nri,nr,nrj->nij", left, weight, left)

    transition = np.tile(np.eye(5), (n, 1, 1))
    noise = np.zeros((n, 5, 5))
    for i in range(n):
        _, a, b = model.linearize(drive.pose[i], u[i])
        transition[i, :3, :3] = a
        transition[i, :3, 3:] = b @ by_calibration[i]
        noise[i, :3, :3] = b @ gamma[i] @ b.T
    noise[:, 3, 3] = gyro.walk_rad_s_per_sqrt_s**2 * dt
    return transition, noise, calibration


def sightings(camera: Camera, markers: MarkerMap, drive: Drive) -> NDArray[np.float64]:
    """(n + 1, 3, 3) information about the pose that a sensor is expected to give in each step."""
    dt = np.diff(drive.utime, prepend=drive.utime[0]) * 1e-6
    frames = camera.rate_hz * (1.0 - camera.dropout) * dt
    in_view = camera.in_view(camera.look_at_all(drive, markers, drive.utime))
    weight = 1.0 / np.square([camera.sigma[COMPONENTS.index(c)] for c in camera.components])
    information = np.zeros((len(drive.utime), 3, 3))
    for m, position in enumerate(markers.positions):
        model = MarkerModel(position, list(camera.components), camera.mounting)
        for k in np.flatnonzero(in_view[:, m]):
            _, h, defined = model.linearize(drive.pose[k])
            if defined:
                information[k] += frames[k] * h.T @ (weight[:, None] * h)
    return information
