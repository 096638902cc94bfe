"""Cameras of the detectors' tests, and what may be asked of covariances."""

from dataclasses import dataclass

import numpy as np

from pilotage import CameraModel

BARREL = (-0.25, 0.08, 0.001, -0.0005, 0.0)


@dataclass(frozen=True)
class Optics:
    """A camera of 640 by 480 pixels, and windows cut out of its image."""

    distortion: tuple[float, ...] = BARREL
    roll_rad: float = 0.02
    pitch_rad: float = 0.15

    def window(self, low, high) -> CameraModel:
        """The camera that sees only the pixels from low (2,) to high (2,), counted from there."""
        low, high = np.floor(low).astype(int), np.ceil(high).astype(int)
        size = tuple(int(n) for n in high - low + 1)
        matrix = (500.0, 505.0, 318.0 - low[0], 242.0 - low[1])
        return CameraModel(size, matrix, self.distortion, self.roll_rad, self.pitch_rad)

    @property
    def whole(self) -> CameraModel:
        return self.window((0, 0), (639, 479))

    def around(self, points, margin: int = 14) -> CameraModel:
        """The window about what shows of points (n, 3) in the level sensor frame."""
        pixels = self.whole.project(points)
        return self.window(pixels.min(axis=0) - margin, pixels.max(axis=0) + margin)


def sizes_by_truth(errors, stated) -> np.ndarray:
    """Variances as stated over the true ones, in the directions where they differ most.

    errors : (runs, n); stated : (n, n)
    """
    return np.linalg.eigvals(np.linalg.solve(np.cov(np.transpose(errors)), stated)).real
