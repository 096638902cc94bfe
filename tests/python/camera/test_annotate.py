"""Annotated pictures: colours are where they belong."""

import numpy as np
import pytest

from pilotage import CameraModel, MarkerMap
from pilotage.camera.annotate import EXPECTED, FOUND, REFUSED, Answer, annotate, projections
from pilotage.camera.detection import Detection
from pilotage.camera.eye import Eye
from pilotage.camera.mounting import MountingNoise
from pilotage.camera.shutter import Shutter

GREY = np.full((240, 320, 3), 128, np.uint8)


def found(u: float, v: float, **more) -> Detection:
    return Detection(np.array([u, v]), np.eye(2), **more)


def near(picture, colour, at, within: int = 1) -> bool:
    """Whether a colour is about a pixel, up to the smoothing of a line."""
    u, v = (round(value) for value in at)
    window = picture[v - within : v + within + 1, u - within : u + within + 1].astype(int)
    return bool((np.abs(window - np.array(colour)).sum(axis=2) < 120).any())


def coloured(picture, colour) -> int:
    return int((np.abs(picture.astype(int) - np.array(colour)).sum(axis=2) < 120).sum())


def test_the_image_itself_stays_as_it_is():
    image = GREY.copy()
    annotate(image, [found(50, 50)], {1: np.array([60.0, 60.0])}, words="front")
    assert (image == GREY).all()


def test_nothing_to_draw_draws_nothing():
    assert (annotate(GREY, [], {}) == GREY).all()


def test_a_detection_has_a_cross_and_its_outline():
    corners = np.array([[130.0, 90.0], [170.0, 90.0], [170.0, 130.0], [130.0, 130.0]])
    picture = annotate(GREY, [found(150, 110, id=4, outline=corners)], {})
    for at in ([150, 110], [153, 110], [150, 107], *corners, [150, 90], [130, 110]):
        assert near(picture, FOUND, at), at
    assert not near(picture, FOUND, [140, 100])


def test_an_expected_marker_has_a_circle_and_its_number():
    picture = annotate(GREY, [], {12: np.array([100.0, 80.0])})
    for at in ([113, 80], [87, 80], [100, 93], [100, 67]):
        assert near(picture, EXPECTED, at), at
    assert not near(picture, EXPECTED, [100, 80], 5)
    digits = picture[55:72, 113:135]
    assert coloured(digits, EXPECTED) > 10


def test_a_line_goes_from_a_detection_to_the_marker_that_it_is_of():
    expected = {4: np.array([200.0, 160.0]), 5: np.array([60.0, 60.0])}
    picture = annotate(GREY, [found(100, 120, id=4)], expected)
    for share in (0.3, 0.5, 0.7):
        assert near(picture, FOUND, [100 + 100 * share, 120 + 40 * share])
    assert not near(picture, FOUND, [80, 90], 3)


def test_without_an_id_there_is_no_line():
    picture = annotate(GREY, [found(100, 120)], {4: np.array([200.0, 160.0])})
    assert not near(picture, FOUND, [160, 144], 2)


def test_what_the_localizer_answers_goes_before_the_detections_own_id():
    expected = {4: np.array([200.0, 160.0]), 5: np.array([100.0, 30.0])}
    answers = {0: Answer(5, "gate")}
    picture = annotate(GREY, [found(100, 120, id=4)], expected, answers)
    assert near(picture, REFUSED, [100, 75])
    assert not near(picture, FOUND, [150, 140], 2)
    assert coloured(picture, FOUND) == 0


def test_what_is_outside_or_nowhere_is_no_error():
    outline = np.array([[-500.0, 4.0], [1e9, 5.0], [3.0, 3.0]])
    nowhere = found(np.nan, np.nan, id=1)
    picture = annotate(GREY, [found(-40, 900, id=1, outline=outline), nowhere], {})
    assert picture.shape == GREY.shape


def test_words_stand_at_the_lower_border():
    picture = annotate(GREY, [], {}, words="front 3 found")
    assert (picture[:210] == GREY[:210]).all()
    assert (picture[215:] > 200).any()


@pytest.mark.parametrize("heading", [0.0, 2.0])
def test_the_map_is_projected_through_the_pose(heading: float):
    camera = CameraModel((320, 240), (250, 250, 159.5, 119.5), pitch_rad=0.2)
    eye = Eye(
        "front", camera, None, MountingNoise(), Shutter(), "markers", "M", (0.5, 0.0, 1.0, 0.0)
    )
    pose = np.array([3.0, -2.0, heading])
    ahead = np.array([np.cos(heading), np.sin(heading), 0.0])
    markers = MarkerMap([1, 2, 3], [[3, -2, 0] + d * ahead for d in (4.5, -4.5, 0.6)])
    seen = projections(eye, markers, pose)
    assert list(seen) == [1]  # behind, and below the image
    np.testing.assert_allclose(seen[1], camera.project(np.array([[4.0, 0, -1.0]]))[0])
