"""What is sent of what was found."""

from dataclasses import replace

import numpy as np
import pytest

from pilotage import CameraModel, MarkerMap
from pilotage.camera.detection import Detection
from pilotage.camera.eye import Eye
from pilotage.camera.messages import _mean, message
from pilotage.camera.mounting import MountingNoise
from pilotage.camera.shutter import Shutter
from pilotage.camera.tag_pose import tag_poses
from pilotage.camera.tags import TagDetection, TagDetector
from pilotage.lcmtypes import marker_frame_t, pixel_frame_t, pose_fix_t

CAMERA = CameraModel((640, 480), (500, 500, 319.5, 239.5), [-0.1, 0.02, 0, 0], pitch_rad=0.2)
MARKERS = MarkerMap([3, 4], [[2.0, 0.5, 0.5], [2.5, -0.5, 0.6]])
TAGS = TagDetector(CAMERA, "4x4_50", size_m=0.2, yaw_rad={3: np.pi, 4: 2.8})
SENSOR = np.array([0.2, -0.1, 0.4])
HEADING = 0.05

FOUND = [
    Detection(np.array([100.0, 300.0]), np.diag([0.04, 0.09]), 7, 2, 3.5, 0.2),
    Detection(np.array([400.0, 200.0]), np.diag([0.01, 0.01]), has_elevation=False),
]


def eye(measures: str, noise: MountingNoise = MountingNoise()) -> Eye:  # noqa: B008 - frozen
    mounting = (0.0, 0.0, 0.4, 0.0)
    return Eye("front", CAMERA, TAGS, noise, Shutter(), measures, "CHANNEL", mounting)


def test_markers_are_angles_with_their_sigmas():
    frame = marker_frame_t.decode(message(eye("markers"), 5, 9, FOUND, MARKERS).encode())
    assert (frame.utime, frame.seq, frame.sensor, frame.n) == (5, 9, "front", 2)
    pixels = np.array([one.pixel for one in FOUND])
    bearing, elevation = CAMERA.angles(pixels)[0]
    covariance = CAMERA.angle_covariance(pixels, np.array([one.covariance for one in FOUND]))
    first, second = frame.sightings
    assert (first.id, first.label, first.range, first.sigma_range) == (7, 2, 3.5, 0.2)
    assert (first.bearing, first.elevation) == (bearing, elevation)
    assert (first.sigma_bearing**2, first.sigma_elevation**2) == pytest.approx(
        tuple(np.diag(covariance[0]))
    )
    assert (second.id, second.label) == (-1, -1)
    assert np.isnan([second.elevation, second.sigma_elevation, second.range]).all()


def test_pixels_are_as_they_were_found():
    frame = pixel_frame_t.decode(message(eye("pixels"), 5, 9, FOUND, MARKERS).encode())
    assert (frame.utime, frame.seq, frame.sensor, frame.n) == (5, 9, "front", 2)
    [first, _] = frame.observations
    assert (first.id, first.label, first.u, first.v) == (7, 2, 100.0, 300.0)
    assert (first.sigma_u, first.sigma_v) == pytest.approx((0.2, 0.3))


def test_mounting_noise_is_in_pixels_and_in_angles():
    noise = MountingNoise(sigma_pitch_rad=0.01)
    [pixel, _] = message(eye("pixels", noise), 0, 0, FOUND, MARKERS).observations
    assert pixel.sigma_v == pytest.approx(500 * 0.01, rel=0.3)
    [sighting, _] = message(eye("markers", noise), 0, 0, FOUND, MARKERS).sightings
    assert sighting.sigma_elevation == pytest.approx(0.01, rel=0.2)


@pytest.mark.parametrize("measures", ["markers", "pixels"])
def test_an_image_without_markers_is_an_empty_frame(measures: str):
    assert message(eye(measures), 5, 9, [], MARKERS).n == 0


def tag(number: int, noise_px: float = 0.1, offset: float = 0.0) -> TagDetection:
    """As seen from the sensor; `offset` spoils its corners, px."""
    yaw, row = TAGS.yaw_rad[number], number - 3
    c, s = np.cos(yaw), np.sin(yaw)
    hung = np.array([[-s, 0.0, c], [c, 0.0, s], [0.0, 1.0, 0.0]])
    square = 0.1 * np.array([[-1, 1, 0], [1, 1, 0], [1, -1, 0], [-1, -1, 0.0]])
    c, s = np.cos(HEADING), np.sin(HEADING)
    level = np.array([[c, -s, 0], [s, c, 0], [0, 0, 1.0]])
    corners = CAMERA.project((square @ hung.T + MARKERS.positions[row] - SENSOR) @ level)
    covariance = noise_px**2 * np.eye(8)
    best, *_ = tag_poses(CAMERA, corners + offset, covariance, 0.2)
    return TagDetection(corners.mean(axis=0), np.eye(2), id=number, pose=best)


def fix_of(*tags: TagDetection, noise: MountingNoise = MountingNoise()):  # noqa: B008
    return message(eye("pose", noise), 5, 9, tags, MARKERS)


def test_a_tag_tells_the_pose_of_the_sensor():
    fix = pose_fix_t.decode(fix_of(tag(3)).encode())
    assert (fix.utime, fix.seq, fix.sensor) == (5, 9, "front")
    np.testing.assert_allclose([fix.x, fix.y, fix.heading], [*SENSOR[:2], HEADING], atol=1e-5)


def test_two_tags_tell_it_better_and_the_better_one_weighs_more():
    one, other = tag(3), tag(4, noise_px=5.0, offset=1.0)
    alone, worse, both = fix_of(one), fix_of(other), fix_of(one, other)
    assert np.trace(np.reshape(both.covariance, (3, 3))) < np.trace(
        np.reshape(alone.covariance, (3, 3))
    )
    off, little = ([fix.x - SENSOR[0], fix.y - SENSOR[1]] for fix in (worse, both))
    assert np.hypot(*little) < 0.3 * np.hypot(*off)


def test_two_alike_tags_are_believed_alike():
    pose, covariance = _mean([(np.zeros(3), np.eye(3)), (np.array([2.0, 4.0, 1.0]), np.eye(3))])
    np.testing.assert_allclose(pose, [1, 2, 0.5])
    np.testing.assert_allclose(covariance, np.eye(3) / 2)


def test_fixes_across_the_turn_of_the_heading_are_not_averaged_through_zero():
    pose, _ = _mean(
        [(np.array([1.0, 2.0, 3.1]), np.eye(3)), (np.array([1.0, 2.0, -3.1]), np.eye(3))]
    )
    assert abs(pose[2]) == pytest.approx(np.pi)


def test_a_yaw_of_the_mounting_that_is_not_known_is_in_the_heading():
    plain, loose = fix_of(tag(3)), fix_of(tag(3), noise=MountingNoise(0.0, 0.01, 0.02))
    assert loose.covariance[8] - plain.covariance[8] == pytest.approx(0.02**2)
    assert loose.covariance[:8] == plain.covariance[:8]


@pytest.mark.parametrize(
    "one", [replace(tag(3), pose=None), replace(tag(3), id=9), FOUND[0]], ids=["doubt", "map", "no"]
)
def test_what_tells_no_pose_gives_none(one: Detection):
    assert fix_of(one) is None
    assert fix_of() is None
