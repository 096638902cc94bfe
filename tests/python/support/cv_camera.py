"""OpenCV's own camera, with what `pilotage.CameraModel` answers: an oracle for it."""

import cv2
import numpy as np
from numpy.typing import NDArray

LEFT_UP_FRONT = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]])
"""From x forward, y left, z up to OpenCV's x right, y down, z forward."""


class CvCamera:
    """Projection by `cv2.projectPoints` and rays by `cv2.undistortPointsIter`."""

    def __init__(
        self,
        size: tuple[int, int],
        matrix: tuple[float, float, float, float],
        distortion: tuple[float, ...] = (),
        roll_rad: float = 0.0,
        pitch_rad: float = 0.0,
    ) -> None:
        self.size = size
        fx, fy, cx, cy = matrix
        self.matrix = np.array([[fx, 0.0, cx], [0.0, fy, cy], [0.0, 0.0, 1.0]])
        self.distortion = np.array(distortion or (0.0,) * 5)
        about_x = cv2.Rodrigues(np.array([roll_rad, 0.0, 0.0]))[0]
        about_y = cv2.Rodrigues(np.array([0.0, pitch_rad, 0.0]))[0]
        self.optical_of_level = LEFT_UP_FRONT @ (about_y @ about_x).T

    def project(self, points: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, 2) pixels of points (n, 3) m, x forward, y left, z up; NaN behind the camera."""
        points = np.asarray(points, float).reshape(-1, 3)
        zero = np.zeros(3)
        turn = cv2.Rodrigues(self.optical_of_level)[0]
        pixels = cv2.projectPoints(points, turn, zero, self.matrix, self.distortion)[0][:, 0]
        pixels[points @ self.optical_of_level[2] <= 0.0] = np.nan
        return pixels

    def rays(self, pixels: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n, 3) unit vectors towards pixels (n, 2)."""
        many = (cv2.TERM_CRITERIA_COUNT | cv2.TERM_CRITERIA_EPS, 200, 1e-12)
        pixels = np.asarray(pixels, float).reshape(-1, 1, 2)
        undistort = getattr(cv2, "undistortPointsIter", None)
        if undistort is not None:
            flat = undistort(pixels, self.matrix, self.distortion, None, None, many)[:, 0]
        else:
            flat = cv2.undistortPoints(
                pixels, self.matrix, self.distortion, None, None, None, many
            )[:, 0]
        rays = np.column_stack([flat, np.ones(len(flat))]) @ self.optical_of_level
        return rays / np.linalg.norm(rays, axis=1, keepdims=True)
