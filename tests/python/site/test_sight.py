"""What a sensor sees is what the core's model says."""

import math

import numpy as np
import pytest

from pilotage import Config, MarkerModel
from pilotage.site import Sight, guessed
from support.sites import BEARINGS, BOTH, RANGES, site

MOUNTED = {"x_m": 0.3, "y_m": -0.1, "z_m": 0.4, "yaw_rad": 2.0}


def _sight(sensor: dict[str, float], reach_m: float = math.inf, view_rad: float = 7.0) -> Sight:
    return Sight.of(site([(0, 0)], sensor), "eye", reach_m, view_rad)


@pytest.mark.parametrize(
    ("sensor", "components"),
    [
        (BOTH, ("bearing", "range")),
        (BEARINGS, ("bearing",)),
        (RANGES, ("range",)),
        ({"sigma_elevation_rad": 0.006, "sigma_bearing_rad": 0.05}, ("bearing", "elevation")),
        ({"z_m": 1.0}, ()),
    ],
)
def test_what_is_measured_is_guessed_by_the_noise_that_is_stated(sensor, components):
    assert guessed(site([(0, 0)], sensor), "eye") == components
    assert _sight(sensor).components == (components or ("bearing", "range"))
    assert _sight(sensor).known_by == ("guessed by its noise" if components else "assumed")


def test_what_is_told_is_measured_though_its_noise_is_the_default():
    default = {"sigma_bearing_rad": Config()["sensors.eye.sigma_bearing_rad"], **RANGES}
    config = site([(0, 0)], default)
    assert Sight.of(config, "eye").components == ("range",)  # what nobody can know better
    sight = Sight.of(config, "eye", components=["range", "bearing"])
    assert sight.components == ("bearing", "range")
    assert sight.known_by == "told"
    with pytest.raises(ValueError, match="components are colour, expected some of bearing, elev"):
        Sight.of(config, "eye", components=["colour"])


@pytest.mark.parametrize(
    "noise", [BOTH, BEARINGS, RANGES, {**BOTH, "sigma_elevation_rad": 0.01}, {**RANGES, "g": 1}]
)
@pytest.mark.parametrize("sigma_m", [0.0, 0.05])
def test_information_is_that_of_the_cores_jacobians(noise: dict[str, float], sigma_m: float):
    noise = dict(noise)
    if noise.pop("g", 0):
        noise["sigma_range_per_m"] = 0.1
    sight = _sight({**MOUNTED, **noise})
    marker = [1.0, 2.0, 0.9]
    rng = np.random.default_rng(3)
    poses = np.column_stack([rng.uniform(-9, 9, (50, 2)), rng.uniform(-9, 9, 50)])
    model = MarkerModel(marker, list(sight.components), list(sight.mounting))
    for pose, information in zip(poses, sight.information(marker, sigma_m, poses), strict=True):
        value, h, _ = model.linearize(pose)
        r = sigma_m**2 * h[:, :2] @ h[:, :2].T
        for i, component in enumerate(sight.components):
            growth = noise.get("sigma_range_per_m", 0.0) * value[i] * (component == "range")
            r[i, i] += sight.sigmas[component] ** 2 + growth**2
        expected = h.T @ np.linalg.inv(r) @ h
        np.testing.assert_allclose(information, expected, rtol=1e-6, atol=1e-6 * expected.max())


@pytest.mark.parametrize("heading", [-9.0, -3.0, 0.0, 3.0, 9.0])
def test_a_marker_is_in_view_by_bearing_and_distance(heading: float):
    sight = _sight({**BOTH, "min_distance_m": 0.5}, reach_m=5.0, view_rad=math.radians(90))
    angle, distance = np.meshgrid(np.radians([-50, -40, 0, 40, 50]), [0.4, 0.6, 4.9, 5.1])
    direction = heading + angle.ravel()
    x, y = -distance.ravel() * [np.cos(direction), np.sin(direction)]
    poses = np.column_stack([x, y, np.full(x.size, heading)])
    seen = sight.sees([0.0, 0.0, 0.0], poses).reshape(distance.shape)
    expected = np.zeros_like(seen)
    expected[1:3, 1:4] = True
    np.testing.assert_array_equal(seen, expected)


def test_blur_is_that_of_what_is_measured():
    assert _sight(BEARINGS).blur(10.0) == pytest.approx(0.1)
    assert _sight(RANGES).blur(10.0) == pytest.approx(0.05)
    assert _sight({**RANGES, "sigma_range_per_m": 0.1}).blur(10.0) == pytest.approx(1.0, abs=2e-3)
