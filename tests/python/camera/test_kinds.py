import numpy as np
import pytest

pytest.importorskip("cv2")

from pilotage.camera.colour import COLOURS, Colour, hue_saturation_value
from pilotage.camera.discs import DiscDetector
from pilotage.camera.kinds import KINDS, keys, make_detector, mounting_noise, shutter
from pilotage.camera.mounting import MountingNoise
from pilotage.camera.poles import PoleDetector
from pilotage.camera.shutter import Shutter
from pilotage.camera.tags import TagDetector
from support.optics import Optics

CAMERA = Optics().whole
WHERE = "detectors.front"


def make(**content):
    return make_detector(content, CAMERA, 0.4, WHERE)


def test_each_kind_is_made_of_its_keys():
    assert make(kind="discs", radius_m=0.1, colour="yellow", size_ratio=3) == DiscDetector(
        CAMERA, 0.4, 0.1, COLOURS["yellow"], size_ratio=3.0
    )
    red = {"hue_deg": [350, 10], "value": [0.1, 1]}
    assert make(kind="discs", radius_m=0.1, colour=red) == DiscDetector(
        CAMERA, 0.4, 0.1, Colour((350.0, 10.0), value=(0.1, 1.0))
    )
    assert make(kind="poles", height_m=1, colours={1: "blue", 2: red}) == PoleDetector(
        CAMERA, 1.0, {1: COLOURS["blue"], 2: Colour((350.0, 10.0), value=(0.1, 1.0))}
    )
    tags = make(kind="tags", dictionary="4x4_50", size_m=0.15, yaw_rad={7: 1.5, 8: -3})
    assert isinstance(tags, TagDetector)
    assert (tags.size_m, tags.yaw_rad) == (0.15, {7: 1.5, 8: -3.0})


def test_the_height_of_a_camera_is_the_sensors_and_of_poles_their_own():
    assert make(kind="discs", radius_m=0.1).height_m == 0.4
    assert make(kind="poles", height_m=1.2, colours={0: "red"}).height_m == 1.2


def test_mounting_noise_stands_beside_the_detectors_keys():
    content = {"kind": "discs", "radius_m": 0.1, "sigma_pitch_rad": 0.01}
    assert mounting_noise(content, WHERE) == MountingNoise(sigma_pitch_rad=0.01)
    assert make(**content) == make(kind="discs", radius_m=0.1)
    for kind in KINDS:
        assert {"kind", "sigma_roll_rad", "sigma_pitch_rad", "sigma_yaw_rad"} <= set(keys(kind))


def test_the_time_of_capture_stands_there_too():
    content = {"kind": "discs", "radius_m": 0.1, "exposure_offset_s": 0.01, "readout_s": 0.03}
    assert shutter(content, WHERE) == Shutter(0.01, 0.03)
    assert make(**content) == make(kind="discs", radius_m=0.1)
    with pytest.raises(ValueError, match=r"detectors.front: readout_s is -1, expected 0 to 1"):
        shutter({**content, "readout_s": -1}, WHERE)


@pytest.mark.parametrize(
    ("content", "message"),
    [
        ({"radius_m": 0.1}, "detectors.front: 'kind' is missing, one of discs, poles, tags"),
        ({"kind": "discz"}, "detectors.front.kind is 'discz', expected one of discs, poles, tags"),
        ({"kind": ["discs"]}, r"kind is \['discs'\], expected one of"),
        ({"kind": "discs"}, "detectors.front: 'radius_m' is missing"),
        ({"kind": "discs", "raduis_m": 1}, "unknown key 'raduis_m'; the nearest .* 'radius_m'"),
        ({"kind": "discs", "height_m": 1}, "unknown key 'height_m'"),
        ({"kind": "discs", "camera": 1}, "unknown key 'camera'"),
        ({"kind": "discs", "radius_m": -1}, "detectors.front: radius_m is -1, expected 0.0001 to"),
        ({"kind": "discs", "radius_m": 1, "colour": "rot"}, "front.colour is 'rot', expected one"),
        ({"kind": "discs", "radius_m": 1, "colour": {"hue": 1}}, "colour: unknown key 'hue'"),
        (
            {"kind": "discs", "radius_m": 1, "colour": {"hue_deg": [0, 400]}},
            "colour: hue_deg is 400, expected 0 to 360",
        ),
        ({"kind": "poles", "height_m": 1}, "'colours' is missing"),
        ({"kind": "poles", "height_m": 1, "colours": ["red"]}, "colours is .*, expected numbers"),
        ({"kind": "poles", "height_m": 1, "colours": {"a": "red"}}, "colours has the key 'a'"),
        ({"kind": "tags"}, "'dictionary' is missing"),
        ({"kind": "tags", "dictionary": "4x4_49"}, "dictionary is 4x4_49; the nearest .*4x4_"),
        ({"kind": "tags", "dictionary": "4x4_50", "yaw_rad": {1: 90}}, "yaw_rad.1 is 90, expected"),
        ({"kind": "tags", "dictionary": "4x4_50", "sigma_yaw": 1}, "nearest .*is 'sigma_yaw_rad'"),
        ("tags", "detectors.front is 'tags', expected keys with values"),
    ],
)
def test_what_is_wrong_is_named(content, message):
    with pytest.raises(ValueError, match=message):
        make_detector(content, CAMERA, 0.4, WHERE)


def test_mounting_noise_that_is_wrong_is_named():
    with pytest.raises(
        ValueError, match=r"detectors\.front: sigma_roll_rad is -1, expected 0 to 1"
    ):
        mounting_noise({"kind": "tags", "dictionary": "4x4_50", "sigma_roll_rad": -1}, WHERE)


@pytest.mark.parametrize(
    ("name", "colour"),
    [
        ("red", (40, 30, 200)),
        ("red", (60, 30, 200)),
        ("red", (30, 60, 200)),
        ("yellow", (30, 190, 210)),
        ("green", (50, 170, 60)),
        ("blue", (200, 70, 40)),
    ],
)
def test_a_colour_is_found_and_others_are_not(name, colour):
    hsv = hue_saturation_value(np.full((1, 1, 3), colour, np.uint8))
    assert [other for other, range_ in COLOURS.items() if range_.mask(hsv).any()] == [name]


def test_grey_and_dark_are_no_colour():
    for colour in ((120, 120, 130), (5, 5, 25), (0, 0, 0), (255, 255, 255)):
        hsv = hue_saturation_value(np.full((1, 1, 3), colour, np.uint8))
        assert not any(range_.mask(hsv).any() for range_ in COLOURS.values())
