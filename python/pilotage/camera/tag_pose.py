"""Where a square tag is from its four corners, and where the sensor is from a surveyed one."""

import math
from dataclasses import dataclass
from typing import TYPE_CHECKING

import cv2
import numpy as np

from .detection import Array

if TYPE_CHECKING:
    from .. import CameraModel

ITERATIONS = 5
STEP_PX = 0.1
"""Of the differences that carry corners' noise over."""


@dataclass(frozen=True, eq=False)
class TagPose:
    """A tag in the level sensor frame, its origin at its centre.

    The tag's x is to the right as one reads it, y up, z towards the reader.
    """

    rotation: Array
    """(3, 3) from the tag's frame."""
    translation: Array
    """(3,) m."""
    covariance: Array
    """(6, 6) of a small turn about the sensor's axes [rad] and of the translation [m]."""
    error_px: float
    """Root mean square over the corners' coordinates of what is left in the image."""

    @property
    def range_m(self) -> float:
        """From the sensor to the tag's centre."""
        return float(np.linalg.norm(self.translation))

    @property
    def sigma_range_m(self) -> float:
        """Standard deviation of the range."""
        ray = self.translation / self.range_m
        return math.sqrt(ray @ self.covariance[3:, 3:] @ ray)

    def sensor_in_map(self, position: Array, yaw_rad: float) -> tuple[Array, Array]:
        """Go the chain map <- tag <- sensor: what a `pose_fix_t` says.

        The tag hangs upright on a wall, but which of its edges is up does not matter: that one is
        taken with which the sensor is upright.

        Parameters
        ----------
        position : (3,) of the tag's centre in frame map [m]
        yaw_rad : direction in frame map that the tag looks in, that is of its normal

        Returns
        -------
        x [m], y [m], heading [rad] of the sensor, and their covariance (3, 3) to first order
        """
        c, s = math.cos(yaw_rad), math.sin(yaw_rad)
        hung = np.array([[-s, 0.0, c], [c, 0.0, s], [0.0, 1.0, 0.0]])
        turns = [hung @ _quarter_turns(k) @ self.rotation.T for k in range(4)]
        turn = max(turns, key=lambda one: float(one[2, 2]))
        x, y, _ = position - turn @ self.translation
        ahead = turn[:, 0]
        # A small turn w about the sensor's axes makes turn (1 - [w]) of the rotation.
        moved = np.hstack([-turn @ _cross(self.translation), -turn])
        turned = turn @ _cross(np.array([1.0, 0.0, 0.0]))
        flat = ahead[0] ** 2 + ahead[1] ** 2
        jacobian = np.zeros((3, 6))
        jacobian[:2] = moved[:2]
        jacobian[2, :3] = (ahead[0] * turned[1] - ahead[1] * turned[0]) / flat
        pose = np.array([x, y, math.atan2(ahead[1], ahead[0])])
        return pose, jacobian @ self.covariance @ jacobian.T


def tag_poses(
    camera: "CameraModel", corners: Array, covariance: Array, size_m: float
) -> list[TagPose]:
    """Return the two poses in which a square may look like this, the one that fits better first.

    A square that is small or seen from the front looks alike when it is turned the other way about
    the line of sight: "Infinitesimal plane-based pose estimation" (Collins and Bartoli, 2014) gives
    both, and each is then moved to where it is likeliest by the corners' covariance.

    Parameters
    ----------
    corners : (4, 2) px, as `cv2.aruco` orders them: clockwise from the top left as one reads it
    covariance : (8, 8) px^2
    """
    points = size_m / 2 * np.array([[-1, 1, 0], [1, 1, 0], [1, -1, 0], [-1, -1, 0.0]])
    seen, jacobian = _plane(camera, corners)
    information = np.linalg.inv(jacobian @ covariance @ jacobian.T).astype(np.float64)
    _, turns, places, _ = cv2.solvePnPGeneric(
        points, seen, np.eye(3), None, flags=cv2.SOLVEPNP_IPPE_SQUARE
    )
    found = []
    for turn, place in zip(turns, places, strict=True):
        start = cv2.Rodrigues(turn)[0], place.ravel()
        rotation, translation, spread = _likeliest(points, seen, information, *start)
        level = np.kron(np.eye(2), camera.rotation)
        rotation, translation = camera.rotation @ rotation, camera.rotation @ translation
        left = camera.project(points @ rotation.T + translation) - corners
        error = float(np.sqrt(np.mean(left**2)))
        if math.isfinite(error):
            found.append(TagPose(rotation, translation, level @ spread @ level.T, error))
    return sorted(found, key=lambda pose: pose.error_px)


def _plane(camera: "CameraModel", corners: Array) -> tuple[Array, Array]:
    """Return corners (4, 2) on the plane at 1 before the camera, and Jacobian (8, 8) by pixels."""
    steps = STEP_PX * np.array([[0, 0], [1, 0], [-1, 0], [0, 1], [0, -1.0]])
    rays = camera.rays((corners + steps[:, None]).reshape(-1, 2)) @ camera.rotation
    at, right, left, down, up = (rays[:, :2] / rays[:, 2:]).reshape(5, 4, 2)
    jacobian = np.zeros((4, 2, 4, 2))
    each = np.arange(4)
    jacobian[each, :, each, 0] = (right - left) / (2 * STEP_PX)
    jacobian[each, :, each, 1] = (down - up) / (2 * STEP_PX)
    return at, jacobian.reshape(8, 8)


def _likeliest(
    points: Array, seen: Array, information: Array, rotation: Array, translation: Array
) -> tuple[Array, Array, Array]:
    """Take Gauss and Newton's steps from a pose; return it with its covariance (6, 6)."""
    for _ in range(ITERATIONS):
        arm = points @ rotation.T
        x, y, z = (arm + translation).T
        by_place = np.zeros((4, 2, 3))
        by_place[:, 0, 0] = by_place[:, 1, 1] = 1 / z
        by_place[:, :, 2] = -np.column_stack([x, y]) / z[:, None] ** 2
        by_turn = -by_place @ _cross(arm)
        jacobian = np.concatenate([by_turn, by_place], axis=2).reshape(8, 6)
        residual = (seen - np.column_stack([x, y]) / z[:, None]).ravel()
        weighted = jacobian.T @ information
        covariance = np.linalg.inv(weighted @ jacobian)
        step = covariance @ weighted @ residual
        rotation = cv2.Rodrigues(step[:3])[0] @ rotation
        translation = translation + step[3:]
        if np.abs(step).max() < 1e-9:
            break
    return rotation, translation, covariance


def _cross(a: Array) -> Array:
    """Return the matrices (..., 3, 3) of the products a x, of a (..., 3)."""
    matrix = np.zeros((*a.shape, 3))
    for row, column, of, sign in ((0, 1, 2, -1), (0, 2, 1, 1), (1, 2, 0, -1)):
        matrix[..., row, column] = sign * a[..., of]
        matrix[..., column, row] = -sign * a[..., of]
    return matrix


def _quarter_turns(count: int) -> Array:
    """Return a rotation about z by so many right angles."""
    c, s = ((1, 0), (0, 1), (-1, 0), (0, -1))[count]
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
