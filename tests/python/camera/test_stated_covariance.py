"""Stated covariances of angles against ten thousand noisy images."""

import numpy as np
import pytest

cv2 = pytest.importorskip("cv2")

from pilotage.camera.detection import Detection  # noqa: E402
from pilotage.camera.discs import DiscDetector  # noqa: E402
from pilotage.camera.mounting import MountingNoise, angles  # noqa: E402
from pilotage.camera.tags import TagDetector  # noqa: E402
from support.optics import Optics, sizes_by_truth  # noqa: E402
from support.pictures import disc, draw, facing, seen, tag  # noqa: E402

RUNS = 10_000
HEIGHT, RADIUS, SIZE = 0.5, 0.1, 0.15
TURN = np.linspace(0, 2 * np.pi, 40)
ROUND = np.column_stack([np.cos(TURN), np.sin(TURN), 0 * TURN])
SQUARE = SIZE / 2 * np.array([[-1, 1, 0], [1, 1, 0], [1, -1, 0], [-1, -1, 0.0]])


def of_runs(camera, detector, picture, noise, rng):
    """Angles (RUNS, 2) of the one detection, their mean stated covariance, and the detections."""
    found = []
    blurred = cv2.GaussianBlur(picture, (0, 0), 0.7)
    for _ in range(RUNS):
        found += detector.detect(seen(blurred, 0.0, noise, rng))
    assert len(found) == RUNS
    value, covariance = angles(camera, found, MountingNoise())
    return value, covariance.mean(axis=0), found


def test_of_discs():
    centre = np.array([2.6, 0.9, -HEIGHT])
    camera = Optics().around(centre + RADIUS * ROUND, margin=11)
    picture = draw(camera, disc(centre, RADIUS))
    detector = DiscDetector(camera, HEIGHT, RADIUS)
    value, stated, _ = of_runs(camera, detector, picture, 10.0, np.random.default_rng(1))
    share = sizes_by_truth(value, stated)
    print("disc: covariance of the angles, stated by true:", share.round(3))
    np.testing.assert_allclose(share, 1.0, atol=0.1)


def test_of_tags():
    centre, rotation = np.array([2.4, -0.7, 0.1]), facing(np.pi - 0.7, 0.1)
    camera = Optics(pitch_rad=0.05).around(1.5 * SQUARE @ rotation.T + centre, margin=3)
    picture = draw(camera, tag(centre, rotation, SIZE, cv2.aruco.DICT_4X4_50, 7))
    detector = TagDetector(camera, "4x4_50")
    value, stated, found = of_runs(camera, detector, picture, 10.0, np.random.default_rng(2))
    share = sizes_by_truth(value, stated)
    print("tag: covariance of the angles of the centre, stated by true:", share.round(3))
    np.testing.assert_allclose(share, 1.0, atol=0.1)
    for k in range(4):
        part = slice(2 * k, 2 * k + 2)
        corners = [Detection(one.outline[k], one.corner_covariance[part, part]) for one in found]
        value, covariance = angles(camera, corners, MountingNoise())
        share = sizes_by_truth(value, covariance.mean(axis=0))
        print(f"tag: of corner {k}:", share.round(3))
        np.testing.assert_allclose(share, 1.0, atol=0.1)
