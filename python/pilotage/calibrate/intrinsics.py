"""A camera's matrix and lens from views of a board, and how sure they are."""

from collections.abc import Sequence
from dataclasses import dataclass

import cv2
import numpy as np

from ..camera.detection import Array
from .boards import View

FEWEST_VIEWS = 3
LENSES = {
    0: "none",
    4: "k1 k2 p1 p2",
    5: "k1 k2 p1 p2 k3",
    8: "k1 k2 p1 p2 k3 k4 k5 k6",
}
"""Numbers of distortion coefficients, in OpenCV's order."""
_FIXED = (
    cv2.CALIB_FIX_K1 | cv2.CALIB_FIX_K2 | cv2.CALIB_ZERO_TANGENT_DIST | cv2.CALIB_FIX_K3,
    cv2.CALIB_FIX_K3,
    0,
    cv2.CALIB_RATIONAL_MODEL,
)


@dataclass(frozen=True, eq=False)
class Intrinsics:
    """What a calibration found.

    Attributes
    ----------
    size : (w, h) px
    matrix : fx, fy, cx, cy, px
    distortion : (0, 4, 5 or 8)
    covariance : (4 + k, 4 + k)
        Of matrix and distortion, by the Jacobian of the projection and the residuals' scatter.
    views : sequence of View
    residuals : a (n, 2) array a view, px
        Found less projected.
    tilts_rad : (v,)
        Of each view's board, from facing the camera.
    """

    size: tuple[int, int]
    matrix: tuple[float, float, float, float]
    distortion: Array
    covariance: Array
    views: Sequence[View]
    residuals: Sequence[Array]
    tilts_rad: Array

    @property
    def names(self) -> list[str]:
        """Of the parameters, in the covariance's order."""
        lens = LENSES[len(self.distortion)].split() if len(self.distortion) else []
        return ["fx", "fy", "cx", "cy", *lens]

    @property
    def values(self) -> Array:
        """Of the parameters, in that order."""
        return np.concatenate([self.matrix, self.distortion])

    @property
    def sigmas(self) -> Array:
        """Standard deviations of the parameters."""
        return np.sqrt(self.covariance.diagonal())

    @property
    def rms_px(self) -> float:
        """Root mean square of the distance between corners as found and as projected."""
        return rms(np.concatenate(list(self.residuals)))


def rms(residuals: Array) -> float:
    """Root mean square of the length of residuals (n, 2)."""
    return float(np.sqrt((residuals**2).sum(axis=1).mean()))


def calibrate(views: Sequence[View], size: tuple[int, int], coefficients: int = 5) -> Intrinsics:
    """Fit matrix, distortion and every view's pose by OpenCV, as Zhang (2000).

    Parameters
    ----------
    size : (w, h) px of the pictures
    coefficients : of the distortion: 0, 4, 5 or 8

    Raises
    ------
    ValueError
        If there are fewer than three views, or they do not determine the camera.
    """
    if coefficients not in LENSES:
        raise ValueError(f"{coefficients} distortion coefficients, expected one of 0, 4, 5, 8")
    if len(views) < FEWEST_VIEWS:
        raise ValueError(
            f"the board was found in {len(views)} pictures, at least {FEWEST_VIEWS} are needed and "
            "10 to 20 are good: from all sides, tilted, up to the picture's corners"
        )
    points = [view.points.astype(np.float32) for view in views]
    pixels = [view.pixels.astype(np.float32) for view in views]
    try:
        _, matrix, lens, turns, places = cv2.calibrateCamera(
            points, pixels, size, None, None, flags=_FIXED[list(LENSES).index(coefficients)]
        )
    except cv2.error as error:
        raise ValueError(
            f"OpenCV cannot calibrate with these views ({error.err}): is every board flat, and "
            "tilted in some of them"
        ) from error
    lens = np.ravel(lens)[:coefficients].astype(np.float64)
    count = 4 + coefficients
    shared = np.zeros((count, count))
    residuals, tilts = [], []
    for view, turn, place in zip(views, turns, places, strict=True):
        shown, jacobian = cv2.projectPoints(view.points, turn, place, matrix, lens)
        by_pose, by_camera = jacobian[:, :6], jacobian[:, 6 : 6 + count]
        # What a view says of the camera, its own pose unknown: Schur's complement.
        mixed = by_pose.T @ by_camera
        shared += by_camera.T @ by_camera - mixed.T @ np.linalg.solve(by_pose.T @ by_pose, mixed)
        residuals.append(view.pixels - shown.reshape(-1, 2))
        tilts.append(np.arccos(min(abs(cv2.Rodrigues(turn)[0][2, 2]), 1.0)))
    every = np.concatenate(residuals)
    free = every.size - count - 6 * len(views)
    covariance = np.linalg.inv(shared) * (every**2).sum() / max(free, 1)
    if not (np.isfinite(covariance).all() and (covariance.diagonal() > 0).all()):
        raise ValueError("these views do not determine the camera: tilt the board, and move it")
    fx, fy, cx, cy = (float(matrix[i]) for i in ((0, 0), (1, 1), (0, 2), (1, 2)))
    return Intrinsics(size, (fx, fy, cx, cy), lens, covariance, views, residuals, np.array(tilts))
