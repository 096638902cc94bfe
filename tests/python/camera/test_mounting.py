from dataclasses import replace

import numpy as np
import pytest

from support.optics import BARREL, Optics, sizes_by_truth

pytest.importorskip("cv2")

from pilotage import CameraModel
from pilotage.camera.detection import Detection
from pilotage.camera.mounting import MountingNoise, angles

ROLL, PITCH = 0.3, 0.4
SIGMAS = (0.004, 0.006, 0.002)


def camera(roll=ROLL, pitch=PITCH):
    return CameraModel((640, 480), (500.0, 505.0, 318.0, 242.0), BARREL, roll, pitch)


@pytest.mark.parametrize("pixel", [(320, 240), (40, 60), (600, 400)])
@pytest.mark.parametrize("only", [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 1)])
def test_mounting_noise_against_cameras_mounted_a_little_otherwise(pixel, only):
    rng = np.random.default_rng(3)
    sigma = np.multiply(SIGMAS, only)
    pixels = np.array([pixel], dtype=float)
    values = []
    for roll, pitch, yaw in sigma * rng.standard_normal((4000, 3)):
        values.append(camera(ROLL + roll, PITCH + pitch).angles(pixels)[0] + [yaw, 0])
    noise = MountingNoise(*sigma).pixel_covariance(camera(), pixels)
    stated = camera().angle_covariance(pixels, noise)[0]
    true = np.cov(np.transpose(values))
    np.testing.assert_allclose(stated, true, atol=0.08 * np.trace(true))
    if all(only):
        np.testing.assert_allclose(sizes_by_truth(values, stated), 1.0, atol=0.1)


def test_pixel_noise_and_mounting_noise_add_up():
    optics = Optics().whole
    seen = [Detection(np.array([100.0, 300.0]), np.array([[0.04, 0.01], [0.01, 0.02]]))]
    _, alone = angles(optics, seen, MountingNoise())
    _, both = angles(optics, seen, MountingNoise(*SIGMAS))
    _, mounting = angles(
        optics, [replace(seen[0], covariance=np.zeros((2, 2)))], MountingNoise(*SIGMAS)
    )
    assert mounting.max() > 0
    np.testing.assert_allclose(both, alone + mounting)
    np.testing.assert_allclose(
        alone, optics.angle_covariance(seen[0].pixel[None], seen[0].covariance[None])
    )


def test_what_has_no_elevation_has_none():
    seen = [
        Detection(np.array([100.0, 300.0]), np.eye(2)),
        Detection(np.array([100.0, 300.0]), np.eye(2), has_elevation=False),
    ]
    value, covariance = angles(Optics().whole, seen, MountingNoise())
    np.testing.assert_array_equal(np.isnan(value), [[False, False], [False, True]])
    assert value[0, 0] == value[1, 0]
    assert covariance[1, 0, 0] == covariance[0, 0, 0]
    assert np.isnan(covariance[1, 1]).all()


def test_no_detections_are_no_angles():
    value, covariance = angles(Optics().whole, [], MountingNoise())
    assert (value.shape, covariance.shape) == ((0, 2), (0, 2, 2))


def test_a_negative_sigma_is_an_error():
    with pytest.raises(ValueError, match="sigma_pitch_rad is -1, expected 0 to 1"):
        MountingNoise(sigma_pitch_rad=-1.0)


@pytest.mark.parametrize("pixel", [(320, 240), (40, 60), (600, 400)])
def test_mounting_noise_in_pixels_against_cameras_mounted_a_little_otherwise(pixel):
    rng = np.random.default_rng(4)
    point = camera().rays(np.array([pixel], dtype=float))
    seen = []
    for roll, pitch, yaw in np.array(SIGMAS) * rng.standard_normal((4000, 3)):
        c, s = np.cos(yaw), np.sin(yaw)
        turned = point @ np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])
        seen.append(camera(ROLL + roll, PITCH + pitch).project(turned)[0])
    stated = MountingNoise(*SIGMAS).pixel_covariance(camera(), np.array([pixel], dtype=float))[0]
    np.testing.assert_allclose(sizes_by_truth(seen, stated), 1.0, atol=0.1)


def test_without_mounting_noise_pixels_stay_as_they_are():
    pixels = np.array([[1.0, 2.0], [3.0, 4.0]])
    assert not MountingNoise().pixel_covariance(camera(), pixels).any()
