"""From pixels to the angles of a sighting, with what is not known of how the camera is mounted."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from .. import CameraModel
from ..fields import within
from .detection import Array, Detection


@dataclass(frozen=True)
class MountingNoise:
    """How well the camera's roll, pitch and yaw on the robot are known, and hold as it drives.

    It is one error for all that is in a frame; the filter takes it for one of each sighting.
    """

    sigma_roll_rad: float = 0.0
    sigma_pitch_rad: float = 0.0
    sigma_yaw_rad: float = 0.0

    def __post_init__(self) -> None:
        for name, sigma in vars(self).items():
            within(name, sigma, 0.0, 1.0)

    def pixel_covariance(self, camera: CameraModel, pixels: Array) -> Array:
        """Return what it adds to the covariance (n, 2, 2) px^2 of where markers show."""
        if not any(vars(self).values()):
            return np.zeros((len(pixels), 2, 2))
        rays, step = camera.rays(pixels), 1e-4
        moved = [
            [camera.project(rays + side * step * swing) for side in (1, -1)]
            for swing in _swing(camera, rays)
        ]
        return self._spread(np.stack([(a - b) / (2 * step) for a, b in moved], axis=2))

    def heading_variance(self, camera: CameraModel) -> float:
        """Return what it adds to the variance [rad^2] of the sensor's heading by a tag."""
        return float((self._sigmas() ** 2) @ _axes(camera)[:, 2] ** 2)

    def _spread(self, jacobian: Array) -> Array:
        """Carry the three variances over by a Jacobian (n, 2, 3)."""
        covariance: Array = (jacobian * self._sigmas() ** 2) @ jacobian.transpose(0, 2, 1)
        return covariance

    def _sigmas(self) -> Array:
        return np.array([self.sigma_roll_rad, self.sigma_pitch_rad, self.sigma_yaw_rad])


def _axes(camera: CameraModel) -> Array:
    """Return those (3, 3) of roll, pitch and yaw in the level sensor frame, a row each."""
    # R = Ry(pitch) Rx(roll): rolled about the optical axis, pitched about y, turned about z.
    return np.array([camera.rotation[:, 2], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]])


def _swing(camera: CameraModel, rays: Array) -> Array:
    """Return how rays (n, 3) move (3, n, 3) with a small roll, pitch, yaw."""
    return np.cross(_axes(camera)[:, None], rays)


def angles(
    camera: CameraModel, detections: Sequence[Detection], mounting: MountingNoise
) -> tuple[Array, Array]:
    """Return azimuth and elevation (n, 2) rad of detections and their covariance (n, 2, 2) rad^2.

    By the Jacobian of the projection, from pixel noise and mounting noise. The elevation is NaN
    where the detection has none.
    """
    pixels = np.array([one.pixel for one in detections]).reshape(-1, 2)
    noise = np.array([one.covariance for one in detections]).reshape(-1, 2, 2)
    noise = noise + mounting.pixel_covariance(camera, pixels)
    covariance = camera.angle_covariance(pixels, noise)
    value = camera.angles(pixels)
    level = np.array([not one.has_elevation for one in detections], dtype=bool)
    value[level, 1] = np.nan
    covariance[level, 1, :] = covariance[level, :, 1] = np.nan
    return value, covariance
