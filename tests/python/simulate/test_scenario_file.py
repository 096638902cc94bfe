"""Scenario files: all that can be said in one, and errors that name what is wrong."""

import re
from pathlib import Path
from typing import Any

import numpy as np
import pytest
import yaml

from pilotage import Config
from pilotage.simulate import SCENARIOS, find_scenario, measure, suitable_config

LEAST: dict[str, Any] = {
    "site": "yard",
    "drive": "rounds",
    "duration_s": 5,
    "sensors": {"eye": {"sigma_bearing_rad": 0.02}},
}


def _write(folder: Path, **changes: Any) -> Path:
    file = folder / "site.yaml"
    file.write_text(yaml.safe_dump(LEAST | changes))
    return file


def test_the_example_in_the_documentation_is_read_with_every_key(tmp_path: Path):
    page = (Path(__file__).parents[3] / "docs" / "montecarlo.md").read_text()
    example = re.findall(r"^```yaml\n(.*?)^```", page, re.M | re.S)[0]
    file = tmp_path / "site.yaml"
    file.write_text(example)
    scenario = find_scenario(str(file))
    assert scenario.name == "site"
    measured = measure(scenario, np.random.default_rng(1))
    assert sum(map(len, measured.sightings.values())) > 0
    config = suitable_config(scenario, measured.markers, measured.drive)
    assert config["sensors.scanner.fusion"] == "student_t"


def test_a_name_is_one_of_the_simulators():
    assert find_scenario("yard") is SCENARIOS["yard"]


def test_a_map_file_is_found_beside_the_scenario(tmp_path: Path):
    (tmp_path / "markers.yaml").write_text("- {id: 7, x: 1, y: 2, z: 0.5}\n")
    scenario = find_scenario(str(_write(tmp_path, site="markers.yaml")))
    assert scenario.site(np.random.default_rng(0)).ids.tolist() == [7]


def test_a_map_files_survey_and_labels_are_kept(tmp_path: Path):
    (tmp_path / "markers.yaml").write_text("- {id: 7, x: 1, y: 2, z: 0.5, sigma: 0.3, label: 4}\n")
    markers = find_scenario(str(_write(tmp_path, site="markers.yaml"))).site(None)
    assert (markers.sigmas.tolist(), markers.labels.tolist()) == ([0.3], [4])


def test_only_the_noise_of_what_is_measured_is_configured(tmp_path: Path):
    eye = {"components": ["range", "bearing"], "sigma_elevation_rad": 0.03}
    scenario = find_scenario(str(_write(tmp_path, sensors={"eye": eye})))
    measured = measure(scenario, np.random.default_rng(1))
    config = suitable_config(scenario, measured.markers, measured.drive)
    key = "sensors.eye.sigma_elevation_rad"
    assert config[key] == Config()[key]
    assert config["sensors.eye.sigma_range_m"] == 0.1


def test_a_sensor_is_described_as_in_the_configuration(tmp_path: Path):
    eye = {"x_m": 0.3, "yaw_rad": 1.5, "sigma_range_m": 0.07, "rate_hz": 4}
    (camera,) = find_scenario(str(_write(tmp_path, sensors={"eye": eye}))).cameras
    assert camera.name == "eye"
    assert camera.mounting[0] == 0.3
    assert camera.mounting[3] == 1.5
    assert camera.sigma[2] == 0.07
    assert camera.rate_hz == 4.0


def test_on_and_off_are_words_of_the_configuration(tmp_path: Path):
    for word in ("on", "off"):
        file = _write(tmp_path)
        file.write_text(file.read_text() + f"config: {{noise: {{adaptation: {word}}}}}\n")
        assert find_scenario(str(file)).config == {"noise.adaptation": word}


def test_keys_of_the_configuration_stand_in_sections_or_with_dots(tmp_path: Path):
    config = {"sensors.eye.fusion": "gate", "status": {"alert_limit_m": 0.5}}
    scenario = find_scenario(str(_write(tmp_path, config=config)))
    measured = measure(scenario, np.random.default_rng(1))
    suitable = suitable_config(scenario, measured.markers, measured.drive)
    assert suitable["sensors.eye.fusion"] == "gate"
    assert suitable["status.alert_limit_m"] == 0.5


def test_numbers_without_a_point_are_numbers(tmp_path: Path):
    file = _write(tmp_path)
    file.write_text(file.read_text() + "gyro: {bias_sigma_rad_s: 1e-4}\n")
    assert find_scenario(str(file)).gyro.bias_sigma_rad_s == 1e-4


@pytest.mark.parametrize(
    ("changes", "words"),
    [
        ({"sensor": {}}, "unknown key 'sensor'; the nearest known key is 'sensors'"),
        ({"gyro": {"bias_rad": 1}}, "gyro: unknown key 'bias_rad'; .* 'bias_rad_s'"),
        ({"gyro": {"bias_rad_s": "much"}}, "gyro.bias_rad_s is 'much', expected a number"),
        ({"gyro": {"bias_rad_s": float("nan")}}, "gyro.bias_rad_s is nan, expected a number"),
        ({"gyro": 3}, "gyro is 3, expected keys with values"),
        ({"ids": "no"}, "ids is 'no', expected true or false"),
        ({"site": "field"}, "no site 'field', and no file .*field; there are mower, "),
        ({"site": [{"id": 1, "x": 0}]}, "site: .*y"),
        ({"site": []}, "site: .*marker"),
        ({"drive": "slalom"}, "drive .* spiral, circle"),
        ({"drive": {"name": "circle", "radius": 1}}, "drive: unknown key 'radius'; .*'radius_m'"),
        ({"drive": {"waypoints": [[0, 0]]}}, "drive: waypoints are 1, expected two points or more"),
        ({"drive": {"waypoints": [[0, 0], [1]]}}, r"waypoints\[1\] is \[1\], expected 2 values"),
        ({"drive": {"waypoints": [[0, 0], [0, 0]]}}, "are the same"),
        ({"duration_s": 0.2}, "duration_s is 0.2, expected 1 to 100000"),
        ({"sensors": {}}, "sensors has none"),
        ({"sensors": {"eye": {"rate": 2}}}, "sensors.eye: unknown key 'rate'; .*'rate_hz'"),
        ({"sensors": {"eye": {"components": ["colour"]}}}, "components are colour, expected some"),
        ({"sensors": {"eye": {"rate_hz": 0}}}, "sensors.eye: rate_hz is 0, expected 0.001 to 1"),
        ({"sensors": {"eye": {"rate_hz": 2e6}}}, "sensors.eye: rate_hz is 2e.06, expected 0.001"),
        ({"sensors": {"eye": {"sigma_range_m": -1}}}, "sigma_range_m is -1, expected 0 or more"),
        ({"sensors": {"eye": {"reach_m": -1}}}, "sensors.eye: reach_m is -1, expected 0 or more"),
        ({"sensors": {"eye": {"half_view_rad": 90}}}, "eye: half_view_rad is 90, expected 0 to 6"),
        ({"sensors": {"eye": {"dropout": 1.5}}}, "sensors.eye: dropout is 1.5, expected 0 to 1"),
        ({"encoders": {"slip": 1}}, "encoders: slip is 1, expected -0.9 to 0.9"),
        ({"encoders": {"m_per_tick": 0}}, "encoders: m_per_tick is 0, expected 1e-12 to 1"),
        ({"encoders": {"track_width_m": 0}}, "encoders: track_width_m is 0, expected 0.001 to"),
        ({"encoders": {"noise_m_per_sqrt_m": -1}}, "encoders: noise_m_per_sqrt_m is -1, expected"),
        ({"encoders": {"scale_sigma": -1}}, "encoders: scale_sigma is -1, expected 0 to 1"),
        ({"gyro": {"noise_rad_per_sqrt_s": -1}}, "gyro: noise_rad_per_sqrt_s is -1, expected 0 or"),
        ({"gyro": {"walk_rad_s_per_sqrt_s": -1}}, "gyro: walk_rad_s_per_sqrt_s is -1, expected 0"),
        ({"gyro": {"bias_sigma_rad_s": -1}}, "gyro: bias_sigma_rad_s is -1, expected 0 to 1"),
        ({"latency_s": -1}, "latency_s is -1, expected 0 to 60"),
        ({"jitter_s": -1}, "jitter_s is -1, expected 0 to 60"),
        ({"tilt": {"rms_rad": -1}}, "tilt: rms_rad is -1, expected 0 to 1"),
        ({"tilt": {"rms_rad": 0.1, "tau_s": -1}}, "tilt: tau_s is -1, expected 0 or more"),
        ({"start": {"sigma_position_m": -1}}, "start: sigma_position_m is -1, expected 0 or more"),
        ({"start": {"error_factor": -1}}, "start: error_factor is -1, expected 0 or more"),
        ({"start": {"x_m": [1, 0], "y_m": [0, 1]}}, r"start: x_m is \[1, 0\], expected from <= to"),
        ({"kidnap": {"at_s": [3, 2]}}, r"kidnap: at_s is \[3, 2\], expected 0 <= from <= to"),
        ({"kidnap": {"at_s": [-1, 2]}}, r"kidnap: at_s is \[-1, 2\], expected 0 <= from"),
        ({"kidnap": {"at_s": [1, 2], "distance_m": [4, 3]}}, r"distance_m is \[4, 3\], expected"),
        ({"kidnap": {"at_s": [4, 5]}}, "kidnap.at_s ends at 5, .* before .*: duration_s is 5"),
        ({"drive": {"name": "circle", "radius_m": 0}}, "drive: radius_m is 0, expected 0.001"),
        ({"drive": {"name": "figure-eight", "radius_m": 0}}, "drive: radius_m is 0, expected"),
        ({"drive": {"name": "figure-eight", "speed_m_s": 0}}, "drive: speed_m_s is 0, expected"),
        ({"drive": {"waypoints": [[0, 0], [1, 0]], "speed_m_s": 0}}, "drive: speed_m_s is 0, exp"),
        ({"outliers": {"share": 0.1}, "ids": False}, "outliers.kind is both, and ids is false"),
        (
            {"outliers": {"share": 0.1}, "sensors": {"eye": {"components": ["range"]}}},
            "outliers.kind is both, and sensors.eye.components has no bearing .*; say kind: id",
        ),
        (
            {"outliers": {"share": 0.1}, "site": [{"id": 1, "x": 0, "y": 0}]},
            "outliers.kind is both, and site has one marker",
        ),
        ({"config": {"gate": 1}}, "config: unknown key 'gate'"),
        ({"config": {"sensors.eye.fusion": "kalman"}}, "config: .*fusion"),
        ({"config": {"sensors.eyes.fusion": "gate"}}, "config: sensors.eyes is none of .*: eye"),
        ({"config": {"gyro.channel": "ENCODERS"}}, "config: .*ENCODERS"),
        ({"outliers": {}}, "outliers: 'share' is missing"),
        ({"outliers": {"share": 2}}, "share is 2, expected 0 to 1"),
        ({"outliers": {"share": 0.1, "kind": "odd"}}, "kind is 'odd', expected bearing, id or"),
        ({"start": {"x_m": [0, 1]}}, "start: x_m and y_m"),
        ({"kidnap": {"at_s": 3}}, "kidnap.at_s is 3, expected a list"),
    ],
)
def test_what_is_wrong_is_named_with_its_place(tmp_path: Path, changes, words: str):
    file = _write(tmp_path, **changes)
    with pytest.raises(ValueError, match=words) as error:
        find_scenario(str(file))
    assert str(error.value).startswith(str(file))


@pytest.mark.parametrize("key", ["site", "drive", "duration_s", "sensors"])
def test_what_is_missing_is_named(tmp_path: Path, key: str):
    file = tmp_path / "site.yaml"
    file.write_text(yaml.safe_dump({k: v for k, v in LEAST.items() if k != key}))
    with pytest.raises(ValueError, match=f"'{key}' is missing"):
        find_scenario(str(file))


def test_a_key_that_stands_twice_and_what_is_no_yaml_are_named_with_the_line(tmp_path: Path):
    file = tmp_path / "site.yaml"
    file.write_text("site: yard\ngyro:\n  bias_rad_s: 1\n  bias_rad_s: 2\n")
    with pytest.raises(ValueError, match="line 3: the key 'bias_rad_s' stands there twice"):
        find_scenario(str(file))
    file.write_text("site: [\n")
    with pytest.raises(ValueError, match="line 2"):
        find_scenario(str(file))


def test_neither_a_name_nor_a_file_is_named_with_what_there_is():
    with pytest.raises(ValueError, match="no scenario 'square', and no such file; there are mower"):
        find_scenario("square")
