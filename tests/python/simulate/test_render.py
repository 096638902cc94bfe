"""The picture's geometry against OpenCV's own projection, to hundredths of a pixel."""

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray
from support.cv_camera import CvCamera
from support.outlines import centroid, polygon_centroid

from pilotage.simulate.appearance import Body, Disc, Pole, Tag
from pilotage.simulate.render import Renderer, World
from pilotage.simulate.surroundings import Surroundings

BLACK = (0.0, 0.0, 0.0)
DARK = Surroundings(BLACK, 0.0, 0.0, BLACK, BLACK, BLACK, 0.0, 0.0)
SIZE, MATRIX = (640, 480), (520.0, 515.0, 322.3, 236.8)
BARREL = (-0.28, 0.09, 1e-3, -7e-4, 0.0)
RATIONAL = (0.6, -0.2, 1e-3, -7e-4, 0.01, 0.9, -0.1, 0.0)
MOUNTING = (0.4, -0.1, 1.2, 0.3)
POSE = np.array([3.0, -2.0, 0.7])


def camera(distortion: tuple[float, ...] = BARREL) -> CvCamera:
    """A camera that looks down and is not level."""
    return CvCamera(SIZE, MATRIX, distortion, roll_rad=0.05, pitch_rad=0.35)


def renderer(*bodies: Body, distortion: tuple[float, ...] = BARREL) -> Renderer:
    return Renderer(camera(distortion), MOUNTING, World(bodies, DARK))


def seen_at(points: NDArray[np.float64], distortion: tuple[float, ...] = BARREL) -> NDArray:
    """(n, 2) pixels of points in frame map."""
    eye, rotation = renderer(distortion=distortion).sight(POSE)
    return camera(distortion).project((points - eye) @ rotation)


def on_ground(ahead: float, left: float) -> tuple[float, float, float]:
    """A place before the camera."""
    eye, rotation = renderer().sight(POSE)
    x, y, _ = eye + rotation @ (ahead, left, 0.0)
    return float(x), float(y), 0.0


def ring(place: tuple[float, float, float], radius: float) -> NDArray[np.float64]:
    angle = np.linspace(0, 2 * np.pi, 2000, endpoint=False)
    circle = np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])
    return np.array(place) + radius * circle


@pytest.mark.parametrize("distortion", [(), BARREL, RATIONAL], ids=["none", "five", "eight"])
@pytest.mark.parametrize("place", [(1.6, 0.3), (2.7, -1.1), (4.0, 1.5), (7.9, -2.7), (10.0, 3.0)])
def test_the_centre_of_a_disc_is_right(place, distortion) -> None:
    disc = Disc(on_ground(*place), 0.15, (0.0, 0.0, 200.0))
    picture = renderer(disc, distortion=distortion).draw(POSE)
    expected = polygon_centroid(seen_at(ring(disc.position, disc.radius_m), distortion))
    np.testing.assert_allclose(centroid(picture[..., 2]), expected, atol=0.02)


def test_the_area_of_a_disc_is_right() -> None:
    disc = Disc(on_ground(3.0, 0.2), 0.15, (0.0, 0.0, 200.0))
    edge = seen_at(ring(disc.position, disc.radius_m)).astype(np.float32)
    area = renderer(disc).draw(POSE)[..., 2].sum() / 200.0
    assert area == pytest.approx(cv2.contourArea(edge), rel=2e-3)
