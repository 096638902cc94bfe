import math

import numpy as np
import pytest

cv2 = pytest.importorskip("cv2")

from pilotage.camera.tag_pose import tag_poses  # noqa: E402
from pilotage.camera.tags import TagDetector  # noqa: E402
from support.optics import BARREL, Optics  # noqa: E402
from support.pictures import draw, facing, seen, tag  # noqa: E402

SIZE = 0.2
SQUARE = SIZE / 2 * np.array([[-1, 1, 0], [1, 1, 0], [1, -1, 0], [-1, -1, 0.0]])
OPTICS = Optics(pitch_rad=0.05)
PLACES = [
    ((1.5, 0.6, 0.2), facing(np.pi + 0.35, 0.1)),
    ((2.5, -0.6, 0.1), facing(np.pi - 0.5)),
    ((2.0, -1.0, -0.4), facing(np.pi - 0.9, 0.1)),
    ((1.2, 0.0, 0.0), facing(np.pi + 0.1)),
]


def look(centre, rotation, name="4x4_50", number=7, optics=OPTICS, samples=10):
    corners = SQUARE @ rotation.T + np.asarray(centre, dtype=float)
    wide = 1.8 * SQUARE @ rotation.T + np.asarray(centre, dtype=float)
    camera = optics.around(wide)
    detector = TagDetector(camera, name, SIZE)
    dictionary = getattr(cv2.aruco, "DICT_" + name.upper())
    return (
        camera,
        detector,
        corners,
        draw(camera, tag(centre, rotation, SIZE, dictionary, number), samples=samples),
    )


@pytest.mark.parametrize("optics", [OPTICS, Optics(distortion=())], ids=["barrel", "straight"])
def test_without_noise_centre_and_corners_are_within_a_tenth_of_a_pixel(optics):
    worst_centre = worst_corner = 0.0
    for centre, rotation in PLACES:
        camera, detector, corners, image = look(centre, rotation, optics=optics)
        for blur in (0.0, 0.7):
            (found,) = detector.detect(seen(image, blur))
            truth = camera.project(np.array([centre]))[0]
            worst_centre = max(worst_centre, np.abs(found.pixel - truth).max())
            worst_corner = max(worst_corner, np.abs(found.outline - camera.project(corners)).max())
    print(f"worst error of a centre {worst_centre:.3f} px, of a corner {worst_corner:.3f} px")
    assert worst_centre < 0.05
    assert worst_corner < 0.1


@pytest.mark.parametrize(
    "name", ["4x4_50", "6x6_250", "aruco_original", "apriltag_36h11", "apriltag_25h9"]
)
def test_each_family_tells_its_numbers(name):
    _, detector, _, image = look((1.0, 0.1, 0.1), facing(np.pi + 0.2), name, number=11, samples=4)
    (found,) = detector.detect(seen(image))
    assert (found.id, found.label, found.has_elevation) == (11, -1, True)
    assert found.range_m == pytest.approx(math.sqrt(1.02), rel=2e-3)


def test_a_dictionary_may_be_called_as_opencv_does_and_an_unknown_one_names_the_nearest():
    camera = OPTICS.whole
    assert TagDetector(camera, "DICT_5X5_100").detect(np.zeros((480, 640, 3), np.uint8)) == []
    with pytest.raises(
        ValueError, match="is april_36h11; the nearest known one is 'apriltag_36h11'"
    ):
        TagDetector(camera, "april_36h11")


def test_without_a_size_there_is_neither_range_nor_pose():
    camera, _, _, image = look(*PLACES[0], samples=4)
    (found,) = TagDetector(camera, "4x4_50").detect(seen(image))
    assert math.isnan(found.range_m)
    assert found.pose is None
    assert found.poses == ()


def test_the_pose_of_a_tag_that_is_turned_away():
    for centre, rotation in PLACES[:3]:
        _, detector, _, image = look(centre, rotation)
        (found,) = detector.detect(seen(image))
        assert found.pose is found.poses[0]
        np.testing.assert_allclose(found.pose.translation, centre, atol=4e-3)
        turn = math.acos((np.trace(found.pose.rotation.T @ rotation) - 1) / 2)
        assert turn < 0.015
        other = found.poses[1]
        assert other.error_px > 5 * found.pose.error_px


def test_one_seen_from_the_front_has_no_pose_but_bearing_elevation_and_range():
    centre = (3.5, 0.0, 0.1)
    camera, detector, _, image = look(centre, facing(np.pi + 0.02))
    (found,) = detector.detect(seen(image, 0.7, 4.0, np.random.default_rng(1)))
    assert found.pose is None
    assert len(found.poses) == 2
    assert found.range_m == pytest.approx(math.hypot(*centre), abs=4 * found.sigma_range_m)
    np.testing.assert_allclose(found.pixel, camera.project(np.array([centre]))[0], atol=0.1)


def test_a_tag_too_small_to_refine_has_a_coarse_covariance():
    camera, detector, corners, image = look((7.0, 0.1, 0.1), facing(np.pi + 0.2), samples=6)
    (found,) = detector.detect(seen(image, 0.4))
    assert np.sqrt(found.corner_covariance.diagonal()).min() > 0.3
    assert np.abs(found.outline - camera.project(corners)).max() < 1.0


def test_wrong_poses_are_hardly_ever_told_where_two_are_alike():
    rng = np.random.default_rng(5)
    camera = Optics(distortion=BARREL, pitch_rad=0.05).whole
    told = wrong = 0
    for _ in range(400):
        rotation = facing(np.pi + rng.uniform(-0.6, 0.6))
        centre = np.array([rng.uniform(1.0, 3.5), rng.uniform(-0.5, 0.5), rng.uniform(-0.1, 0.2)])
        corners = camera.project(SQUARE @ rotation.T + centre) + 0.05 * rng.standard_normal((4, 2))
        best, other = tag_poses(camera, corners, 0.05**2 * np.eye(8), SIZE)
        if best.error_px <= 0.2 * other.error_px:
            told += 1
            near, far = (np.trace(pose.rotation.T @ rotation) for pose in (best, other))
            wrong += int(near < far)
    print(f"{told} of 400 told, {wrong} of them flipped")
    assert told > 100
    assert wrong <= told // 100
