"""Cameras and world of a scenario file: every key is read, and every error names what is wrong."""

import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

from pilotage.simulate import find_scenario, measure
from pilotage.simulate.scenario_file import RENDERED
from pilotage.simulate.scene_file import EXPOSURE

PAGE = Path(__file__).parents[3] / "docs" / "camera-rendered.md"
EXAMPLE = re.findall(r"^```yaml\n(.*?)^```", PAGE.read_text(), re.M | re.S)[0]


def changed(folder: Path, *path: str, value: Any) -> str:
    """A scenario file that is the documentation's but for one value; None takes the key away."""
    content = yaml.safe_load(EXAMPLE)
    inner = content
    for key in path[:-1]:
        inner = inner[key]
    inner[path[-1]] = value
    if value is None:
        del inner[path[-1]]
    file = folder / "site.yaml"
    file.write_text(yaml.safe_dump(content))
    return str(file)


def test_the_example_in_the_documentation_has_every_key_of_a_camera(tmp_path):
    file = tmp_path / "site.yaml"
    file.write_text(EXAMPLE)
    (camera,) = find_scenario(str(file)).scene.cameras
    given = set(yaml.safe_load(EXAMPLE)["cameras"]["front"])
    named = set(vars(camera)) - {"name", "mounting", "exposure", "model"}
    assert given == named | set(EXPOSURE) | {"x_m", "y_m", "z_m", "yaw_rad"}
    assert camera.mounting == (0.1, 0.0, 0.5, 0.0)
    assert camera.model.matrix == (554.0, 554.0, 322.4, 236.1)
    assert camera.model.pitch_rad == 0.1
    assert camera.exposure.exposure_s == 0.02


@pytest.mark.parametrize("name", yaml.safe_load(RENDERED.read_text()))
def test_a_built_in_scenario_also_measures_without_pictures(name):
    scenario = find_scenario(name)
    measured = measure(scenario, np.random.default_rng(1))
    assert sum(map(len, measured.sightings.values())) > 100
    world = scenario.scene.world(measured.true_markers)
    assert len(world.bodies) == len(measured.markers)


def test_the_papers_scenario_is_the_papers():
    scenario = find_scenario("mower-cameras")
    cameras = {camera.name: camera for camera in scenario.scene.cameras}
    assert list(cameras) == ["front", "rear"]
    assert {camera.rate_hz for camera in cameras.values()} == {0.5}
    assert scenario.duration_s == 549
    assert len(scenario.site(np.random.default_rng(1))) == 28


def test_noise_is_scaled_with_all_other():
    scenario = find_scenario("mower-cameras").with_noise(0.0)
    assert {camera.exposure.noise for camera in scenario.scene.cameras} == {0.0}


@pytest.mark.parametrize(
    ("path", "value", "words"),
    [
        (("cameras", "front", "focal"), 3, r"cameras\.front: unknown key 'focal'.*'focal_px'"),
        (("cameras", "front", "nois"), 3, r"cameras\.front: unknown key 'nois'.*'noise'"),
        (("cameras", "front", "size"), [640], r"cameras\.front\.size is \[640\], expected 2"),
        (("cameras", "front", "size"), [640, 1.5], r"cameras\.front: size is 1\.5, expected 16"),
        (("cameras", "front", "distortion"), [1, 2], r"cameras\.front: .*distortion"),
        (("cameras", "front", "focal_px"), [0, 5], r"cameras\.front: .*fx"),
        (("cameras", "front", "noise"), -1, r"cameras\.front: noise is -1, expected 0 to 100"),
        (
            ("cameras", "front", "pictures"),
            "gif",
            r"cameras\.front: pictures is 'gif', .*png or jpg",
        ),
        (("cameras", "front", "components"), ["height"], r"cameras\.front: .*height"),
        (("cameras",), {}, "cameras has none, expected one or more"),
        (("cameras",), None, "'sensors' is missing|there is a world, and 'cameras' is missing"),
        (("sensors",), {"front": {}}, "front is in cameras and in sensors"),
        (("world", "sky"), "blue", "world: unknown key 'sky'"),
        (("world", "surroundings"), "moon", "surroundings is 'moon', expected one of lawn, hall"),
        (("world", "markers"), None, "world: 'markers' is missing"),
        (("world", "markers", "kind"), "flags", r"markers\.kind is 'flags', expected one of discs"),
        (("world", "markers", "hight_m"), 1, r"markers: unknown key 'hight_m'.*'height_m'"),
        (("world", "markers", "colours"), {1: "pink", 2: "red"}, "colour is 'pink', expected one"),
        (("world", "markers", "colours"), {1: "red"}, "colours has none for the label 2"),
        (("world", "markers", "colours"), ["red"], r"colours is \['red'\], expected numbers with"),
    ],
)
def test_what_is_wrong_is_named(tmp_path, path, value, words):
    with pytest.raises(ValueError, match=words) as caught:
        find_scenario(changed(tmp_path, *path, value=value))
    assert str(caught.value).startswith(str(tmp_path / "site.yaml"))


def test_no_picture_no_opencv():
    code = (
        "import sys, pilotage.simulate as simulate; simulate.find_scenario('poles'); "
        "sys.exit('cv2' in sys.modules)"
    )
    assert subprocess.run([sys.executable, "-c", code]).returncode == 0
