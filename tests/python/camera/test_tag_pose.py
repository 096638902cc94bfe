import math

import numpy as np
import pytest

cv2 = pytest.importorskip("cv2")

from pilotage.camera.tag_pose import tag_poses  # noqa: E402
from support.optics import Optics, sizes_by_truth  # noqa: E402
from support.pictures import facing  # noqa: E402

SIZE = 0.3
SQUARE = SIZE / 2 * np.array([[-1, 1, 0], [1, 1, 0], [1, -1, 0], [-1, -1, 0.0]])
CAMERA = Optics(pitch_rad=0.1).whole
SENSOR, HEADING = np.array([2.0, -1.0, 0.4]), 0.7
TAG, YAW = np.array([3.6, 0.9, 0.6]), HEADING + np.pi + 0.9


def corners_seen(upright: float = 0.0):
    """Of the tag on the wall, turned on it by `upright`, from the sensor."""
    c, s = math.cos(upright), math.sin(upright)
    turned = SQUARE @ np.array([[c, s, 0], [-s, c, 0], [0, 0, 1.0]])
    c, s = math.cos(HEADING), math.sin(HEADING)
    in_map = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
    return CAMERA.project((turned @ facing(YAW).T + TAG - SENSOR) @ in_map)


@pytest.mark.parametrize("quarter", range(4))
def test_the_chain_gives_the_sensors_pose_whichever_edge_of_the_tag_is_up(quarter):
    corners = corners_seen(quarter * np.pi / 2)
    best, _ = tag_poses(CAMERA, corners, 0.01 * np.eye(8), SIZE)
    pose, _ = best.sensor_in_map(TAG, YAW)
    np.testing.assert_allclose(pose, [*SENSOR[:2], HEADING], atol=1e-6)
    assert best.error_px < 1e-6


def test_stated_covariance_of_the_chain_against_noisy_corners():
    rng = np.random.default_rng(2)
    spread = rng.standard_normal((8, 8))
    noise = 0.1**2 * (
        0.5 * np.eye(8) + 0.5 * spread @ spread.T / 8
    )  # corners not alike, and coupled
    root = np.linalg.cholesky(noise)
    exact = corners_seen()
    poses, ranges, stated = [], [], []
    for _ in range(2000):
        noisy = exact + (root @ rng.standard_normal(8)).reshape(4, 2)
        best, _ = tag_poses(CAMERA, noisy, noise, SIZE)
        pose, covariance = best.sensor_in_map(TAG, YAW)
        poses.append(pose)
        ranges.append(best.range_m)
        stated.append([*covariance.ravel(), best.sigma_range_m**2])
    mean = np.mean(stated, axis=0)
    share = sizes_by_truth(poses, mean[:9].reshape(3, 3))
    print("stated by true: pose", share.round(3), "range", round(mean[9] / np.var(ranges), 3))
    np.testing.assert_allclose(share, 1.0, atol=0.1)
    assert mean[9] / np.var(ranges) == pytest.approx(1.0, abs=0.1)
    bias = np.abs(np.mean(poses, axis=0) - [*SENSOR[:2], HEADING])
    assert (bias < 0.1 * np.std(poses, axis=0)).all()
