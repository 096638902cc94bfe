"""The picture's geometry against OpenCV's own projection, to hundredths of a pixel."""

import cv2
import numpy as np
import pytest
from numpy.typing import NDArray

from pilotage import CameraModel
from pilotage.simulate import appearance
from pilotage.simulate.appearance import Body, Disc, Pole, Tag
from pilotage.simulate.render import Renderer, World
from pilotage.simulate.surroundings import PLACES, Surroundings
from pilotage.simulate.tilt import tilted
from support.cv_camera import CvCamera
from support.outlines import centroid, polygon_centroid

BLACK = (0.0, 0.0, 0.0)
DARK = Surroundings(BLACK, 0.0, 0.0, BLACK, BLACK, BLACK, 0.0, 0.0)
GREY = (100.0, 100.0, 100.0)
PAPER = Surroundings(GREY, 0.0, 0.0, GREY, GREY, GREY, 0.0, 0.0)
RED, BLUE = (0.0, 0.0, 200.0), (200.0, 0.0, 0.0)
BARREL = (-0.28, 0.09, 1e-3, -7e-4, 0.0)
RATIONAL = (0.6, -0.2, 1e-3, -7e-4, 0.01, 0.9, -0.1, 0.0)
LENSES = {"none": (), "five": BARREL, "eight": RATIONAL}
BODY = {"roll_rad": 0.05, "pitch_rad": 0.35}
MOUNTING = (0.4, -0.1, 1.2, 0.3)
POSE = np.array([3.0, -2.0, 0.7])
LEVEL = (0.0, 0.0)
IDEAL_PX = 0.02


def optics(distortion: tuple[float, ...]) -> tuple:
    return (640, 480), (520.0, 515.0, 322.3, 236.8), distortion


def renderer(
    *bodies: Body, lens: tuple[float, ...] = BARREL, around: Surroundings = DARK
) -> Renderer:
    return Renderer(CameraModel(*optics(lens), **BODY), MOUNTING, World(bodies, around))


EYE, TURN = renderer().sight(POSE)


def seen_at(points: NDArray[np.float64], lens: tuple[float, ...] = BARREL) -> NDArray[np.float64]:
    """(n, 2) pixels of points in frame map, by OpenCV."""
    return CvCamera(*optics(lens), **BODY).project((points - EYE) @ TURN)


def before(ahead: float, left: float, z: float = 0.0) -> tuple[float, float, float]:
    """A place before the camera, at a height above the ground."""
    x, y, _ = EYE + TURN @ (ahead, left, 0.0)
    return float(x), float(y), z


def ring(place: tuple[float, float, float], radius: float) -> NDArray[np.float64]:
    angle = np.linspace(0, 2 * np.pi, 2000, endpoint=False)
    return place + radius * np.column_stack([np.cos(angle), np.sin(angle), 0 * angle])


def facing(left: float = 0.0, ahead: float = 1.5, **of: float) -> Tag:
    """A tag that looks to the camera, more or less."""
    x, y, z = before(ahead, left, 0.7)
    towards = np.arctan2(EYE[1] - y, EYE[0] - x)
    return Tag((x, y, z), float(towards) + 0.3, 3, size_m=0.25, pitch_rad=-0.2, roll_rad=0.1, **of)


@pytest.mark.parametrize("lens", LENSES.values(), ids=LENSES)
@pytest.mark.parametrize("place", [(1.6, 0.3), (2.7, -1.1), (4.0, 1.5), (6.9, -2.7), (8.0, 3.0)])
def test_the_centre_of_a_disc_is_where_opencv_projects_it(place, lens):
    disc = Disc(before(*place), 0.18, RED)
    picture = renderer(disc, lens=lens).draw(POSE)
    expected = polygon_centroid(seen_at(ring(disc.position, disc.radius_m), lens))
    np.testing.assert_allclose(centroid(picture[..., 2]), expected, atol=IDEAL_PX)


def test_the_area_of_a_disc_is_right():
    disc = Disc(before(3.0, 0.2), 0.15, RED)
    edge = seen_at(ring(disc.position, disc.radius_m)).astype(np.float32)
    assert renderer(disc).draw(POSE)[..., 2].sum() / 200.0 == pytest.approx(
        cv2.contourArea(edge), rel=2e-3
    )


@pytest.mark.parametrize("height", [0.5, 1.35], ids=["below the eye", "above"])
def test_a_pole_is_between_its_tangents_from_foot_to_top(height, monkeypatch):
    monkeypatch.setattr(appearance, "LIT", 1.0)
    pole = Pole(before(3.4, -0.4), height, 0.08, RED)
    ends = [ring((*pole.foot[:2], z), pole.radius_m) for z in (0.0, height)]
    hull = cv2.convexHull(seen_at(np.concatenate(ends), ()).astype(np.float32))[:, 0]
    picture = renderer(pole, lens=()).draw(POSE)[..., 2]
    assert picture.sum() / 200.0 == pytest.approx(cv2.contourArea(hull), rel=2e-3)
    expected = polygon_centroid(hull.astype(float))
    np.testing.assert_allclose(centroid(picture), expected, atol=IDEAL_PX)


def test_a_poles_shade_does_not_move_its_centre_line(monkeypatch):
    pole = Pole(before(3.4, -0.4), 1.0, 0.3, RED)
    shaded = renderer(pole).draw(POSE)[200:260, :, 2]
    monkeypatch.setattr(appearance, "LIT", 1.0)
    plain = renderer(pole).draw(POSE)[200:260, :, 2]
    assert shaded[plain == 200.0].min() < 0.85 * 200.0
    np.testing.assert_allclose(centroid(shaded), centroid(plain), atol=0.1)


def test_the_plate_of_a_tag_is_where_opencv_projects_it():
    tag = facing(dark=1.0, light=1.0)
    plate = 8 / 6 * (tag.corners() - tag.centre) + tag.centre
    edge = np.linspace(plate, np.roll(plate, -1, axis=0), 200, endpoint=False, axis=1)
    picture = renderer(tag).draw(POSE)[..., 0]
    expected = polygon_centroid(seen_at(edge.reshape(-1, 3)))
    np.testing.assert_allclose(centroid(picture), expected, atol=IDEAL_PX)


@pytest.mark.parametrize(
    ("dictionary", "number"),
    [
        ("4x4_50", cv2.aruco.DICT_4X4_50),
        ("6X6_250", cv2.aruco.DICT_6X6_250),
        ("apriltag_36h11", cv2.aruco.DICT_APRILTAG_36h11),
        ("apriltag_16h5", cv2.aruco.DICT_APRILTAG_16h5),
    ],
)
def test_opencv_reads_a_tag_and_its_corners(dictionary, number):
    tag = facing(dictionary=dictionary)
    picture = renderer(tag, around=PAPER).draw(POSE).astype(np.uint8)
    parameters = cv2.aruco.DetectorParameters()
    parameters.cornerRefinementMethod = cv2.aruco.CORNER_REFINE_SUBPIX
    finder = cv2.aruco.ArucoDetector(cv2.aruco.getPredefinedDictionary(number), parameters)
    corners, ids, _ = finder.detectMarkers(picture)
    assert np.ravel(ids).tolist() == [3]
    np.testing.assert_allclose(corners[0][0], seen_at(tag.corners()), atol=0.5)


def test_the_back_of_a_tag_is_blank():
    tag = facing()
    turned = Tag(tag.position, tag.yaw_rad + np.pi, 3, size_m=0.25)
    grey = renderer(turned).draw(POSE)[..., 0]
    inside = grey[tuple(seen_at(tag.centre[None])[0].astype(int)[::-1])]
    assert inside == pytest.approx(grey.max())


def test_an_unknown_dictionary_is_named_with_those_there_are():
    with pytest.raises(ValueError, match=r"dictionary is 4x4_51; the nearest .*4x4_50"):
        _ = facing(dictionary="4x4_51").cells
    with pytest.raises(ValueError, match="id is 90, expected 0 to 49 in 4x4_50"):
        _ = Tag((0.0, 0.0, 0.0), 0.0, 90).cells


@pytest.mark.parametrize("order", [1, -1])
def test_what_is_near_hides_what_is_far(order):
    near, far = Pole(before(2.0, 0.0), 2.0, 0.2, RED), Pole(before(4.0, 0.0), 1.0, 0.2, BLUE)
    beside = Pole(before(4.0, 1.2), 1.0, 0.2, BLUE)
    picture = renderer(*(near, far, beside)[::order]).draw(POSE)
    assert picture[tuple(seen_at(near.centre[None])[0].astype(int)[::-1])][2] > 150
    only_beside = centroid(picture[..., 0])
    assert abs(only_beside - seen_at(beside.centre[None])[0]).max() < 15


def test_a_body_stands_on_a_disc_on_the_ground():
    disc, pole = Disc(before(3.0, 0.0), 0.5, BLUE), Pole(before(3.1, 0.0), 0.3, 0.1, RED)
    picture = renderer(disc, pole).draw(POSE)
    assert picture[tuple(seen_at(pole.centre[None])[0].astype(int)[::-1])][2] > 150


def test_a_disc_that_is_partly_behind_the_camera_is_drawn_where_it_is_not():
    carpet = Disc(before(0.0, 0.0), 3.0, RED)
    picture = renderer(carpet).draw(POSE)[..., 2]
    ahead = seen_at(np.array([before(2.9, 0.0), before(3.1, 0.0)])).astype(int)
    assert [picture[v, u] for u, v in ahead] == [200.0, 0.0]


def test_a_tilted_body_sees_as_the_simulator_of_angles_says():
    angles = np.array([[0.03, -0.02]])
    disc = Disc(before(3.0, 0.5), 0.1, RED)
    picture = renderer(disc).draw(POSE, tuple(angles[0]))
    edge = (ring(disc.position, disc.radius_m) - EYE) @ TURN
    level = np.column_stack(
        [np.arctan2(edge[:, 1], edge[:, 0]), np.arctan2(edge[:, 2], np.hypot(*edge[:, :2].T))]
    )
    seen = tilted(np.column_stack([level, np.ones(len(level))])[None], angles, MOUNTING[3])[0]
    flat = np.cos(seen[:, 1])
    ways = np.column_stack(
        [flat * np.cos(seen[:, 0]), flat * np.sin(seen[:, 0]), np.sin(seen[:, 1])]
    )
    expected = polygon_centroid(CvCamera(*optics(BARREL), **BODY).project(ways))
    np.testing.assert_allclose(centroid(picture[..., 2]), expected, atol=IDEAL_PX)


def test_where_a_lens_ends_the_picture_is_black():
    narrow = CameraModel((640, 480), (300.0, 300.0, 319.5, 239.5), (-0.4, 0.0, 0.0, 0.0))
    picture = Renderer(narrow, MOUNTING, World((), PAPER)).draw(POSE)
    assert np.isnan(narrow.rays(np.array([[0.0, 0.0]]))).all()
    assert picture[0, 0].max() == 0
    assert picture[240, 320].max() > 50


@pytest.mark.parametrize("place", PLACES)
def test_the_ground_is_where_it_is_and_stays_there(place):
    one = renderer(around=PLACES[place])
    picture = one.draw(POSE)
    assert np.isfinite(picture).all()
    ahead = POSE + np.array([*(TURN @ (0.02, 0.0, 0.0))[:2], 0.0])
    moved = one.draw(ahead)
    # Two centimetres ahead, what was seen at a pixel has come down to another.
    points = np.array([before(2.0 + 0.05 * i, 0.1 * j) for i in range(8) for j in range(-4, 5)])
    here, there = (seen_at(points - shift) for shift in ((0, 0, 0), (*(ahead - POSE)[:2], 0)))
    same = [
        cv2.remap(p, at[:, None].astype(np.float32), None, cv2.INTER_LINEAR)[:, 0, 1]
        for p, at in ((picture, here), (moved, there))
    ]
    assert np.corrcoef(*same)[0, 1] > 0.9
