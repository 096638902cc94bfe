"""What a mounting makes of pixels: residuals, Jacobian, fit and covariance."""

from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares

from .. import CameraModel
from ..camera.detection import Array
from ..evaluate.truth import interpolate
from ..simulate.view import sight
from .sightings import Sightings

NAMES = ("x_m", "y_m", "z_m", "roll_rad", "pitch_rad", "yaw_rad", "latency_s")
PRIOR = np.array([1.0, 1.0, 1.0, 0.5, 0.5, 0.5, 0.5])
"""Standard deviations of the start, m, rad, s: so wide that only what no drive tells is held."""
STEP = 1e-3
"""Of the differences that the Jacobian is made of, m, rad, s."""
ROBUST = 2.0
"""Standard deviations beyond which a residual counts as an outlier's in a robust fit."""
FAR = 1e3
"""Residual of what the camera cannot see from there, in standard deviations."""


class Problem:
    """Residuals of sightings of known markers by the mounting.

    Parameters
    ----------
    poses : structured (m,) of utime, x, y, heading
    points : (n, 3) m
        Surveyed, of each sighting's marker.
    """

    def __init__(
        self, camera: CameraModel, poses: NDArray[Any], seen: Sightings, points: Array
    ) -> None:
        self._camera, self._poses, self._seen, self._points = camera, poses, seen, points
        self._times, self._frame = np.unique(seen.utime, return_inverse=True)

    def residuals(self, values: Array) -> Array:
        """(n, 2) px, seen less projected; NaN where the camera cannot see it from there."""
        camera = mounted(self._camera, values)
        shift = round(1e6 * values[6])
        eyes, turns = [], []
        for pose in interpolate(self._poses, self._times - shift):
            eye, turn = sight((*values[:3], values[5]), pose)
            eyes.append(eye)
            turns.append(turn)
        arm = self._points - np.array(eyes)[self._frame]
        level = np.einsum("ni,nij->nj", arm, np.array(turns)[self._frame])
        return np.asarray(self._seen.pixel - camera.project(level))

    def fit(self, start: Array, free: NDArray[np.bool_], robust: bool) -> Array:
        """Return the values (7,) that fit best, from a start."""
        which = np.flatnonzero(free)

        def whole(part: Array) -> Array:
            values = start.copy()
            values[which] += part
            return values

        found = least_squares(
            lambda part: self._weighted(whole(part), start, which),
            np.zeros(len(which)),
            jac=lambda part: self.jacobian(whole(part), start, which),
            x_scale=0.01 * PRIOR[which],
            loss="cauchy" if robust else "linear",
            f_scale=ROBUST,
        )
        return whole(found.x)

    def _weighted(self, values: Array, start: Array, which: NDArray[np.intp]) -> Array:
        left = self.residuals(values) / self._seen.sigma
        prior = (values - start)[which] / PRIOR[which]
        return np.concatenate([np.nan_to_num(left.ravel(), nan=FAR), prior])

    def jacobian(self, values: Array, start: Array, which: NDArray[np.intp]) -> Array:
        """(2 n + k, k) of the weighted residuals and the k priors, by differences."""
        columns = []
        for index in which:
            step = np.zeros(7)
            step[index] = STEP
            sides = (self._weighted(values + sign * step, start, which) for sign in (1, -1))
            up, down = sides
            columns.append((up - down) / (2 * STEP))
        return np.array(columns).T

    def covariance(self, values: Array, start: Array, which: NDArray[np.intp]) -> Array:
        """(k, k), by the Jacobian and by how residuals scatter from picture to picture.

        What is wrong in all of a picture, as its pose may be, is so counted once a picture.
        """
        jacobian = self.jacobian(values, start, which)
        left = self._weighted(values, start, which)
        count = 2 * len(self._seen)
        scale2 = (left[:count] ** 2).sum() / max(count - len(which), 1)
        pull = jacobian[:count] * left[:count, None] / scale2
        frames = np.zeros((len(self._times), len(which)))
        np.add.at(frames, np.repeat(self._frame, 2), pull)
        prior = jacobian[count:].T @ jacobian[count:]
        inverse = np.linalg.inv(jacobian[:count].T @ jacobian[:count] / scale2 + prior)
        share = len(frames) / max(len(frames) - 1, 1)
        return np.asarray(inverse @ (share * frames.T @ frames + prior) @ inverse)


def mounted(camera: CameraModel, values: Array) -> CameraModel:
    """Return the camera with roll and pitch of the values (7,)."""
    return CameraModel(
        camera.size, camera.matrix, list(camera.distortion), float(values[3]), float(values[4])
    )
