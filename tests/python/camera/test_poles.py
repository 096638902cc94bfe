import math

import numpy as np
import pytest

cv2 = pytest.importorskip("cv2")

from pilotage.camera import poles  # noqa: E402
from pilotage.camera.colour import COLOURS  # noqa: E402
from pilotage.camera.poles import PoleDetector  # noqa: E402
from support.optics import Optics  # noqa: E402
from support.pictures import draw, pole, seen  # noqa: E402

LEVEL = Optics(pitch_rad=0.0)
BLUE, YELLOW = (190.0, 60.0, 40.0), (40.0, 200.0, 210.0)
COLOURS_BY_LABEL = {3: COLOURS["blue"], 5: COLOURS["yellow"]}


def look(foot, height=1.0, radius=0.1, colour=BLUE, optics=LEVEL, samples=8):
    foot = np.asarray(foot, dtype=float)
    around = [[0, 0, 0], [0, 0, height]] + radius * np.array(
        [[[1, 0, 0], [-1, 0, 0]], [[0, 1, 0], [0, -1, 0]]]
    ).reshape(4, 1, 3)
    camera = optics.around((foot + around).reshape(-1, 3))
    detector = PoleDetector(camera, height, COLOURS_BY_LABEL, radius)
    return camera, detector, draw(camera, pole(foot, height, radius, colour), samples=samples)


@pytest.mark.parametrize(
    "foot",
    [
        (3, 0.2, -0.5),
        (3, 1.4, -0.5),
        (4, -2, -0.3),
        (6, -1, -0.5),
        (2.5, 0, -1.1),
        (1.5, 0.5, -0.5),
    ],
)
def test_bearing_and_distance_without_noise(foot):
    camera, detector, image = look(foot)
    (found,) = detector.detect(seen(image))
    azimuth = camera.angles(found.pixel[None])[0, 0]
    assert azimuth == pytest.approx(math.atan2(foot[1], foot[0]), abs=0.1 / 500)
    # A tenth of a pixel at each end.
    assert found.range_m == pytest.approx(math.dist(foot, (0, 0, 0)), abs=0.14 / 500 * foot[0] ** 2)
    assert np.abs(found.pixel - camera.project(np.array([foot]))[0]).max() < 0.15
    assert not found.has_elevation
    assert found.id == -1


def test_its_label_is_its_colours():
    for label, colour in ((3, BLUE), (5, YELLOW)):
        _, detector, image = look((3, 0.2, -0.5), colour=colour, samples=4)
        assert [one.label for one in detector.detect(seen(image))] == [label]


@pytest.mark.parametrize("end", ["top", "foot"])
def test_with_an_end_out_of_view_there_is_a_bearing_and_no_range(end):
    foot = (2.0, 0.3, -0.5)
    camera, _, image = look(foot)
    half = image.shape[0] // 2
    fx, fy, cx, cy = camera.matrix
    image = image[half:] if end == "top" else image[:half]
    shift = half if end == "top" else 0
    cut = type(camera)(image.shape[1::-1], (fx, fy, cx, cy - shift), camera.distortion, 0.02, 0.0)
    (found,) = PoleDetector(cut, 1.0, COLOURS_BY_LABEL, 0.1).detect(seen(image))
    assert math.isnan(found.range_m)
    assert math.isnan(found.sigma_range_m)
    assert cut.angles(found.pixel[None])[0, 0] == pytest.approx(math.atan2(0.3, 2.0), abs=0.2 / 500)
    sigma = np.sqrt(cut.angle_covariance(found.pixel[None], found.covariance[None])[0].diagonal())
    assert sigma[0] < 1e-3
    assert (sigma[1] < 1e-2) == (end == "top")  # the foot's place in the image


def test_a_pole_at_the_side_and_a_thing_that_lies_are_none():
    camera, _, image = look((3, 0.2, -0.5), samples=4)
    half = image.shape[1] // 2
    fx, fy, cx, cy = camera.matrix
    cut = type(camera)((half, image.shape[0]), (fx, fy, cx, cy), camera.distortion, 0.02, 0.0)
    assert PoleDetector(cut, 1.0, COLOURS_BY_LABEL, 0.1).detect(seen(image[:, :half])) == []
    _, detector, image = look((3, 0.2, -0.5), height=0.25, samples=4)
    assert detector.detect(seen(image)) == []


def test_stated_covariance_of_bearing_and_range(monkeypatch):
    for floor in ("LINE_SAMPLING_PX", "END_SAMPLING_PX"):
        monkeypatch.setattr(poles, floor, 0.0)  # what noise makes is to be seen
    camera, detector, image = look((5, 0.8, -0.5), radius=0.05)
    rng = np.random.default_rng(4)
    values, stated = [], []
    for _ in range(1500):
        (found,) = detector.detect(seen(image, 0.7, 12.0, rng))
        values.append([camera.angles(found.pixel[None])[0, 0], found.range_m])
        noise = camera.angle_covariance(found.pixel[None], found.covariance[None])
        stated.append([noise[0, 0, 0], found.sigma_range_m**2])
    share = np.mean(stated, axis=0) / np.var(values, axis=0)
    print("variance stated by true, bearing and range:", share.round(3))
    np.testing.assert_allclose(share, 1.0, atol=0.15)
