"""Small exact pictures of discs, poles and tags: what a camera's pixels would hold, by rays."""

from collections.abc import Callable

import cv2
import numpy as np

GRASS = (60.0, 130.0, 70.0)
RED = (45.0, 40.0, 200.0)
SKY = (200.0, 170.0, 150.0)

Paint = Callable[[np.ndarray, np.ndarray], None]
"""Changes the colours (n, 3) of those of the unit rays (n, 3) that hit the thing."""


def draw(camera, *paints: Paint, ground=GRASS, sky=SKY, samples: int = 8) -> np.ndarray:
    """Return the (h, w, 3) float image: every pixel the mean of samples x samples rays."""
    width, height = camera.size
    fine = (np.arange(samples) + 0.5) / samples - 0.5
    rows = []
    for v in range(height):
        vv, uu = np.meshgrid(v + fine, (np.arange(width)[:, None] + fine).ravel(), indexing="ij")
        rays = camera.rays(np.column_stack([uu.ravel(), vv.ravel()]))
        colours = np.where(rays[:, 2:] < 0, np.array(ground), np.array(sky))
        for paint in paints:
            paint(rays, colours)
        rows.append(colours.reshape(samples, width, samples, 3).mean(axis=(0, 2)))
    return np.stack(rows)


def disc(centre, radius: float, colour=RED) -> Paint:
    """Lies level, its centre (3,) in the level sensor frame."""
    centre = np.asarray(centre, dtype=float)

    def paint(rays, colours):
        with np.errstate(divide="ignore", invalid="ignore"):
            scale = centre[2] / rays[:, 2]
            away = np.hypot(*(scale[:, None] * rays - centre)[:, :2].T)
        colours[(scale > 0) & (away < radius)] = colour

    return paint


def pole(foot, height: float, radius: float, colour=RED) -> Paint:
    """A vertical cylinder, its foot's centre (3,) in the level sensor frame."""
    foot = np.asarray(foot, dtype=float)

    def paint(rays, colours):
        flat = (rays[:, :2] ** 2).sum(axis=1)
        along = rays[:, :2] @ foot[:2]
        inside = along**2 - flat * ((foot[:2] ** 2).sum() - radius**2)
        near = (along - np.sqrt(np.maximum(inside, 0))) / flat
        z = near * rays[:, 2] - foot[2]
        side = (inside > 0) & (near > 0) & (z > 0) & (z < height)
        colours[side] = colour
        if foot[2] + height < 0:
            disc(foot + np.array([0, 0, height]), radius, colour)(rays, colours)

    return paint


def tag(centre, rotation, size: float, dictionary: int, number: int) -> Paint:
    """A tag with a white margin of one module.

    Its centre (3,) and rotation (3, 3) are in the level sensor frame: the columns are the tag's x
    to the right as one reads it, y up and z towards the reader; `size` is its black square's.
    """
    centre = np.asarray(centre, dtype=float)
    bits = cv2.aruco.getPredefinedDictionary(dictionary)
    modules = bits.markerSize + 2
    cells = np.full((modules + 2, modules + 2), 255, np.uint8)
    cells[1:-1, 1:-1] = bits.generateImageMarker(number, modules)

    def paint(rays, colours):
        normal = rotation[:, 2]
        with np.errstate(divide="ignore", invalid="ignore"):
            scale = (centre @ normal) / (rays @ normal)
        at = (scale[:, None] * rays - centre) @ rotation[:, :2] / size * modules
        column = np.floor(at[:, 0] + len(cells) / 2)
        row = np.floor(len(cells) / 2 - at[:, 1])
        hit = (scale > 0) & (np.minimum(row, column) >= 0) & (np.maximum(row, column) < len(cells))
        shade = cells[row[hit].astype(int), column[hit].astype(int)].astype(float)
        colours[hit] = (20 + shade / 255 * 200)[:, None]

    return paint


def facing(yaw: float, tilt: float = 0.0) -> np.ndarray:
    """Rotation (3, 3) of a tag whose normal points along yaw, tilted up by `tilt`."""
    normal = np.array([np.cos(yaw) * np.cos(tilt), np.sin(yaw) * np.cos(tilt), np.sin(tilt)])
    across = np.array([-np.sin(yaw), np.cos(yaw), 0.0])
    return np.column_stack([across, np.cross(normal, across), normal])


def seen(picture: np.ndarray, blur: float = 0.7, noise: float = 0.0, rng=None) -> np.ndarray:
    """Return the (h, w, 3) uint8 image through a lens's blur [px] and with a sensor's noise."""
    if blur > 0:
        picture = cv2.GaussianBlur(picture, (0, 0), blur)
    if noise > 0:
        picture = picture + noise * rng.standard_normal(picture.shape)
    return np.clip(np.rint(picture), 0, 255).astype(np.uint8)
