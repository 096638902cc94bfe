"""OpenCV's own projection: an oracle for `pilotage.CameraModel` and what is drawn with it."""

import cv2
import numpy as np
from numpy.typing import NDArray

LEFT_UP_FRONT = np.array([[0.0, -1.0, 0.0], [0.0, 0.0, -1.0], [1.0, 0.0, 0.0]])
"""From x forward, y left, z up to OpenCV's x right, y down, z forward."""


class CvCamera:
    """Arguments are those of `pilotage.CameraModel`."""

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
