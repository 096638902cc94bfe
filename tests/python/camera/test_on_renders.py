"""The detectors on whole images of the renderer, over all of the image and its distortion."""

import math

import numpy as np
import pytest

cv2 = pytest.importorskip("cv2")

from pilotage.camera.colour import COLOURS  # noqa: E402
from pilotage.camera.discs import DiscDetector  # noqa: E402
from pilotage.camera.poles import PoleDetector  # noqa: E402
from pilotage.camera.tags import TagDetector  # noqa: E402
from pilotage.simulate.appearance import Disc, Pole, Tag  # noqa: E402
from pilotage.simulate.exposure import Exposure  # noqa: E402
from pilotage.simulate.paints import PAINTS  # noqa: E402
from pilotage.simulate.render import Renderer, World  # noqa: E402
from pilotage.simulate.surroundings import PLACES  # noqa: E402
from support.optics import Optics  # noqa: E402

POSE = np.array([0.3, -0.2, 0.1])


def look(camera, height, bodies, noise=0.0):
    """An image, and where points (n, 3) in frame map show in it."""
    renderer = Renderer(camera, (0.1, 0.0, height, 0.05), World(bodies, PLACES["lawn"]))
    image = Exposure(noise=noise).develop(renderer.draw(POSE), np.random.default_rng(1))
    eye, rotation = renderer.sight(POSE)

    def shown(points):
        return camera.project((np.asarray(points, dtype=float) - eye) @ rotation)

    return image, shown


def test_discs_all_over_the_image():
    rng = np.random.default_rng(3)
    places = [
        (x, y + rng.uniform(-0.1, 0.1), 0.0)
        for x in (1.4, 1.9, 2.5, 3.2, 4.2, 5.2)
        for y in np.arange(-4, 4.1, 0.8)
    ]
    camera = Optics(pitch_rad=0.2).whole
    image, shown = look(camera, 0.5, [Disc(place, 0.1) for place in places])
    truth = shown(places)
    found = DiscDetector(camera, 0.5, 0.1).detect(image)
    far = [np.hypot(*(truth - one.pixel).T) for one in found]
    which = [int(np.nanargmin(one)) for one in far]
    errors = np.array([one.pixel for one in found]) - truth[which]
    print(f"{len(found)} discs, worst error {np.abs(errors).max():.3f} px")
    assert len(set(which)) == len(found)
    inside = ((truth > 60) & (truth < np.array(camera.size) - 60)).all(axis=1)
    assert set(np.flatnonzero(inside)) <= set(which)
    assert np.abs(errors).max() < 0.1


def test_poles_that_are_lit_from_a_side_and_stand_before_lawn_trees_and_sky():
    poles = {(3.0, 0.6): "yellow", (4.0, -1.2): "blue", (6.0, 2.4): "yellow", (2.4, -0.2): "blue"}
    camera = Optics(pitch_rad=0.0).whole
    bodies = [Pole((*at, 0.0), 1.0, 0.1, PAINTS[name]) for at, name in poles.items()]
    image, shown = look(camera, 0.5, bodies, noise=3.0)
    found = PoleDetector(camera, 1.0, {1: COLOURS["yellow"], 2: COLOURS["blue"]}, 0.1).detect(image)
    assert len(found) == len(poles)
    for (at, name), foot in zip(poles.items(), shown([(*at, 0.0) for at in poles]), strict=True):
        one = min(found, key=lambda seen: float(np.hypot(*(seen.pixel - foot))))
        assert one.label == {"yellow": 1, "blue": 2}[name]
        truth = camera.angles(foot[None])[0, 0]
        assert camera.angles(one.pixel[None])[0, 0] == pytest.approx(truth, abs=0.1 / 500)
        eye = POSE[:2] + 0.1 * np.array([math.cos(POSE[2]), math.sin(POSE[2])])
        slant = math.hypot(*(np.array(at) - eye), 0.5)
        assert one.range_m == pytest.approx(slant, rel=0.004)


def test_tags_and_the_sensors_pose_from_each():
    tags = [
        Tag((2.6, 0.9, 0.5), math.pi - 0.3, 1, dictionary="4X4_50", size_m=0.2),
        Tag((2.2, -0.6, 0.4), math.pi + 0.5, 2, dictionary="4X4_50", size_m=0.2),
        Tag((1.6, 0.2, 0.7), math.pi - 0.6, 3, dictionary="4X4_50", size_m=0.2),
    ]
    camera = Optics(pitch_rad=0.0).whole
    image, shown = look(camera, 0.5, tags)
    detector = TagDetector(camera, "4x4_50", 0.2, {tag.id: tag.yaw_rad for tag in tags})
    found = {one.id: one for one in detector.detect(image)}
    assert sorted(found) == [1, 2, 3]
    eye = POSE[:2] + 0.1 * np.array([math.cos(POSE[2]), math.sin(POSE[2])])
    for tag in tags:
        one = found[tag.id]
        assert np.abs(one.pixel - shown([tag.centre])[0]).max() < 0.1
        # The renderer divides a large tag's pixels by four, so a side may be off by an eighth.
        assert np.abs(one.outline - shown(tag.corners())).max() < 0.2
        fix = detector.sensor_pose(one, tag.centre)
        assert fix is not None
        pose, covariance = fix
        error = pose - [*eye, POSE[2] + 0.05]
        assert np.abs(error[:2]).max() < 0.03
        assert abs(error[2]) < 0.02
        assert TagDetector(camera, "4x4_50", 0.2).sensor_pose(one, tag.centre) is None
        assert (np.abs(error) < 6 * np.sqrt(covariance.diagonal())).all()
