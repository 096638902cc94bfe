"""The core's camera against OpenCV's, and against itself."""

import numpy as np
import pytest

import pilotage

SIZE, MATRIX = (640, 480), (610.0, 605.0, 322.5, 238.0)
DISTORTIONS = {
    "none": (),
    "four": (-0.28, 0.09, 0.0012, -0.0007),
    "five": (0.12, -0.25, -0.001, 0.0015, 0.11),
    "eight": (0.8, -0.3, 0.0005, 0.001, 0.02, 1.1, 0.05, -0.01),
}


@pytest.fixture(params=DISTORTIONS)
def distortion(request):
    return DISTORTIONS[request.param]


def pixels(count=500):
    return np.random.default_rng(1).uniform((0, 0), SIZE, (count, 2))


def opencv_matrix():
    fx, fy, cx, cy = MATRIX
    return np.array([[fx, 0, cx], [0, fy, cy], [0, 0, 1]])


def test_projects_as_opencv(distortion):
    cv2 = pytest.importorskip("cv2")
    camera = pilotage.CameraModel(SIZE, MATRIX, distortion, roll_rad=0.07, pitch_rad=0.3)
    points = camera.rays(pixels()) * np.linspace(0.3, 20, 500)[:, None]
    from_level = camera.rotation.T
    expected, _ = cv2.projectPoints(
        points, cv2.Rodrigues(from_level)[0], np.zeros(3), opencv_matrix(), np.array(distortion)
    )
    np.testing.assert_allclose(camera.project(points), expected[:, 0], atol=1e-9)


def test_undistorts_what_opencv_distorts(distortion):
    cv2 = pytest.importorskip("cv2")
    x, y, z = pilotage.CameraModel(SIZE, MATRIX, distortion).rays(pixels()).T
    to_the_right_down_and_ahead = np.column_stack([-y, -z, x])
    expected, _ = cv2.projectPoints(
        to_the_right_down_and_ahead, np.zeros(3), np.zeros(3), opencv_matrix(), np.array(distortion)
    )
    np.testing.assert_allclose(expected[:, 0], pixels(), atol=1e-7)


def test_a_ray_is_seen_where_it_came_from(distortion):
    camera = pilotage.CameraModel(SIZE, MATRIX, distortion, roll_rad=-0.2, pitch_rad=0.5)
    rays = camera.rays(pixels())
    np.testing.assert_allclose(np.linalg.norm(rays, axis=1), 1, atol=1e-12)
    np.testing.assert_allclose(camera.project(7 * rays), pixels(), atol=1e-8)


def test_angles_are_those_of_the_ray():
    camera = pilotage.CameraModel(SIZE, MATRIX, roll_rad=-0.2, pitch_rad=0.5)
    x, y, z = camera.rays(pixels()).T
    expected = np.column_stack([np.arctan2(y, x), np.arctan2(z, np.hypot(x, y))])
    np.testing.assert_allclose(camera.angles(pixels()), expected, atol=1e-14)


def test_positive_pitch_looks_down_and_positive_roll_lowers_the_right_side():
    centre = np.array([MATRIX[2:]])
    assert pilotage.CameraModel(SIZE, MATRIX, pitch_rad=0.2).angles(centre)[0, 1] == pytest.approx(
        -0.2
    )
    rolled = pilotage.CameraModel(SIZE, MATRIX, roll_rad=0.2)
    azimuth, elevation = rolled.angles(centre + np.array([100, 0]))[0]
    assert azimuth < 0
    assert elevation < 0


def test_covariance_of_angles_is_that_of_noisy_pixels(distortion):
    camera = pilotage.CameraModel(SIZE, MATRIX, distortion, roll_rad=0.1, pitch_rad=0.4)
    covariance = np.array([[0.8, 0.3], [0.3, 0.5]])
    rng = np.random.default_rng(2)
    for pixel in pixels(5):
        noisy = rng.multivariate_normal(pixel, covariance, 40_000)
        stated = camera.angle_covariance(pixel[None], covariance[None])[0]
        measured = np.cov(camera.angles(noisy).T)
        np.testing.assert_allclose(measured, stated, atol=0.03 * np.abs(stated).max())


def test_nothing_is_seen_behind_the_camera_or_where_the_lens_folds_the_image():
    barrel = pilotage.CameraModel(SIZE, MATRIX, (-0.3, 0, 0, 0))
    assert np.tan(barrel.widest_rad) == pytest.approx(np.sqrt(1 / 0.9))  # d/dr (r - 0.3 r^3) = 0
    turned = np.tan(barrel.widest_rad)
    points = [[1, 0, 0], [-1, 0, 0], [1, 0.999 * turned, 0], [1, 1.001 * turned, 0], [1, np.nan, 0]]
    seen = np.isfinite(barrel.project(points)).all(axis=1)
    np.testing.assert_array_equal(seen, [True, False, True, False, False])
    # r - 0.3 r^3 is 0.703 at its highest.
    u = MATRIX[2] + MATRIX[0] * np.array([0.70, 0.71, np.inf, np.nan])
    rays = barrel.rays(np.column_stack([u, np.full(4, MATRIX[3])]))
    np.testing.assert_array_equal(np.isfinite(rays).all(axis=1), [True, False, False, False])


def test_nothing_at_all_is_no_error():
    camera = pilotage.CameraModel(SIZE, MATRIX)
    assert camera.project(np.empty((0, 3))).shape == (0, 2)
    assert camera.angles(np.empty((0, 2))).shape == (0, 2)
    assert camera.angle_covariance(np.empty((0, 2)), np.empty((0, 2, 2))).shape == (0, 2, 2)


@pytest.mark.parametrize(
    ("arguments", "word"),
    [
        ({"size": (0, 480)}, "0 x 480"),
        ({"matrix": (0.0, 600, 320, 240)}, "fx is 0"),
        ({"matrix": (600, np.inf, 320, 240)}, "fy is inf"),
        ({"matrix": (600, 600, np.nan, 240)}, "cx is nan"),
        ({"distortion": (0.1, 0.2)}, "2 distortion coefficients"),
        ({"distortion": (0, 0, np.nan, 0)}, "coefficient 3 is nan"),
        ({"pitch_rad": np.inf}, "pitch_rad is inf"),
    ],
)
def test_what_is_no_camera_is_refused_by_name_and_value(arguments, word):
    with pytest.raises(ValueError, match=word):
        pilotage.CameraModel(**{"size": SIZE, "matrix": MATRIX, **arguments})


def test_shapes_are_checked_by_name():
    camera = pilotage.CameraModel(SIZE, MATRIX)
    with pytest.raises(ValueError, match=r"points must have shape \(4, 3\)"):
        camera.project(np.zeros((4, 2)))
    with pytest.raises(ValueError, match=r"covariance must have shape \(4, 2, 2\)"):
        camera.angle_covariance(np.zeros((4, 2)), np.zeros((2, 2)))
