"""Pictures of calibration boards, by the rays of `pilotage.CameraModel`."""

from functools import cached_property

import cv2
import numpy as np

from pilotage import CameraModel

TEXELS = 24
"""Of a square's side."""
PARTS = 3
"""Into which a pixel's side is divided."""


class BoardCamera:
    """A camera of 320 by 240 pixels, or others, that looks at boards."""

    def __init__(
        self,
        size=(320, 240),
        matrix=(260.0, 262.0, 158.0, 121.0),
        distortion=(-0.2, 0.05, 0.001, -0.0005),
    ) -> None:
        self.model = CameraModel(size, matrix, list(distortion))

    @cached_property
    def _rays(self) -> np.ndarray:
        """(h, w, parts, 3) in OpenCV's camera frame."""
        width, height = self.model.size
        fine = (np.arange(PARTS) + 0.5) / PARTS - 0.5
        v, u, dv, du = np.meshgrid(np.arange(height), np.arange(width), fine, fine, indexing="ij")
        pixels = np.column_stack([(u + du).ravel(), (v + dv).ravel()])
        return (self.model.rays(pixels) @ self.model.rotation).reshape(height, width, -1, 3)

    def look(self, texture, square_m, turn, place, noise=2.0, rng=None) -> np.ndarray:
        """Return the picture (h, w) uint8 of a board whose first inner corner is its origin.

        texture : (k, m) of TEXELS a square, with a margin of one square
        turn, place : (3,) rotation vector and m, as `cv2.projectPoints` has them
        """
        rotation = cv2.Rodrigues(np.asarray(turn, dtype=float))[0]
        rays = self._rays @ rotation
        origin = -rotation.T @ np.asarray(place, dtype=float)
        with np.errstate(divide="ignore", invalid="ignore"):
            scale = -origin[2] / rays[..., 2]
        at = (origin[:2] + scale[..., None] * rays[..., :2]) / square_m * TEXELS
        column, row = (
            np.floor(at + 2 * TEXELS).astype(int)[..., 0],
            np.floor(at + 2 * TEXELS).astype(int)[..., 1],
        )
        inside = (scale > 0) & (row >= 0) & (column >= 0)
        inside &= (row < texture.shape[0]) & (column < texture.shape[1])
        light = np.full(inside.shape, 120.0)
        light[inside] = texture[row[inside], column[inside]]
        picture = cv2.GaussianBlur(light.mean(axis=2), (0, 0), 0.6)
        if rng is not None:
            picture = picture + noise * rng.standard_normal(picture.shape)
        return np.clip(np.rint(picture), 0, 255).astype(np.uint8)


def chessboard(columns: int, rows: int) -> np.ndarray:
    """Texture of a board with so many inner corners, and a white margin."""
    squares = np.indices((rows + 1, columns + 1)).sum(axis=0) % 2
    return np.kron(np.pad(30 + 200 * squares, 1, constant_values=230), np.ones((TEXELS, TEXELS)))


def charuco(columns: int, rows: int, tag_share: float, dictionary: int) -> np.ndarray:
    """Texture of a board of so many squares, and a white margin."""
    board = cv2.aruco.CharucoBoard(
        (columns, rows), 1.0, tag_share, cv2.aruco.getPredefinedDictionary(dictionary)
    )
    image = board.generateImage((columns * TEXELS, rows * TEXELS))
    return np.pad(30 + 200 / 255 * image, TEXELS, constant_values=230.0)


def stances(count: int, middle, rng, far=(5.0, 9.0), tilt=0.6):
    """Yield rotation vectors and places [squares] of boards all over a picture, tilted."""
    for k in range(count):
        turn = rng.uniform(-tilt, tilt, 3) * (1, 1, 0.5)
        distance = rng.uniform(*far)
        corner = np.array([(-1) ** k, (-1) ** (k // 2)]) * rng.uniform(0.05, 0.2, 2)
        rotation = cv2.Rodrigues(turn)[0]
        place = np.array([*(corner * distance), distance]) - rotation @ np.array([*middle, 0.0])
        yield turn, place
