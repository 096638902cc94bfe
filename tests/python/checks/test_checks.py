"""Every check has one thing to find, and nothing else finds it."""

from collections.abc import Callable
from pathlib import Path

import numpy as np
import pytest

from pilotage import Config, MarkerMap, load_config
from pilotage.checks import check_config, markers, motion, no_multicast, sensors, timing
from pilotage.simulate import SCENARIOS, simulate
from support.configs import sound

CONFIGS = Path(__file__).parents[3] / "configs"


def _markers(*positions: tuple[float, float, float]) -> MarkerMap:
    return MarkerMap(range(len(positions)), positions)


FINDINGS: dict[str, tuple[Callable, Config, str, list[str]]] = {
    "ticks": (
        motion.wheels_by_default,
        sound(encoders__left_m_per_tick=0.001, encoders__right_m_per_tick=0.001),
        "encoders",
        ["left_m_per_tick", "0.001"],
    ),
    "track width": (
        motion.wheels_by_default,
        sound(encoders__track_width_m=0.5, motion__heading="both"),
        "encoders.track_width_m",
        ["0.5 m"],
    ),
    "gyro bias": (
        motion.frozen_gyro_bias,
        sound(calibration__gyro_bias__sigma=0),
        "calibration.gyro_bias",
        ["frozen"],
    ),
    "exact motion": (
        motion.motion_without_noise,
        sound(
            noise__wheel_m_per_sqrt_m=0, noise__gyro_rad_per_sqrt_s=0,
            noise__position_m_per_sqrt_m=0,
        ),
        "noise",
        ["exact"],
    ),
    "degrees": (
        motion.degrees_for_radians,
        sound(sensors__camera__yaw_rad=90),
        "sensors.camera.yaw_rad",
        ["90 rad"],
    ),
    "no map": (sensors.nothing_to_see, sound(markers=None), "map", ["missing"]),
    "no calibration": (
        sensors.nothing_to_see,
        sound(sensors__film__measures="pixels", sensors__film__z_m=1.0),
        "sensors.film.intrinsics",
        ["missing"],
    ),
    "no sensor": (sensors.nothing_to_see, sound(without="sensors."), "sensors", ["missing"]),
    "mounting": (
        sensors.never_mounted,
        sound(sensors__camera__x_m=0, sensors__camera__z_m=0),
        "sensors.camera",
        ["origin"],
    ),
    "noise of a sensor": (
        sensors.noise_by_default,
        sound(sensors__camera__sigma_bearing_rad=0.02),
        "sensors.camera",
        ["default noise"],
    ),
    "too exact a sensor": (
        sensors.noise_too_small,
        sound(sensors__camera__sigma_range_m=1e-4),
        "sensors.camera.sigma_range_m",
        ["0.0001"],
    ),
    "elevation": (
        sensors.elevation_says_nothing,
        sound(sensors__camera__sigma_elevation_rad=0.01, sensors__camera__z_m=0.5),
        "sensors.camera.z_m",
        ["0.5", "as high"],
    ),
    "close markers": (
        markers.markers_too_close,
        sound(_markers((0, 0, 0), (0.1, 0, 0), (5, 0, 0), (5, 5, 0), (0, 5, 0))),
        "map",
        ["markers 0 and 1", "0.1 m", "camera"],
    ),
    "two markers in one place": (
        markers.markers_too_close,
        sound(_markers((0, 0, 0), (5, 0, 0), (5, 5, 0), (5, 0, 0))),
        "map",
        ["markers 1 and 3", "0 m"],
    ),
    "latency": (
        timing.window_shorter_than_a_latency,
        sound(sensors__camera__latency_s=1.9, encoders__latency_s=-0.2),
        "sensors.camera.latency_s",
        ["2.1 s", "window_s is 2"],
    ),
    "latency of the gyro": (
        timing.window_shorter_than_a_latency,
        sound(gyro__latency_s=5),
        "gyro.latency_s",
        ["5 s", "window_s is 2"],
    ),
    "capacity": (
        timing.history_too_small,
        sound(history__window_s=6),
        "history.capacity",
        ["2048", "5.1 s", "200 Hz"],
    ),
    "outputs": (
        timing.outputs_on_one_channel,
        sound(output__status="POSE"),
        "output.status",
        ["POSE", "output.pose"],
    ),
}  # fmt: skip


@pytest.mark.parametrize("case", FINDINGS)
def test_a_check_finds_its_one_thing(case: str):
    check, config, key, words = FINDINGS[case]
    (finding,) = check(config)
    assert finding.key == key
    for word in words:
        assert word in finding.problem
    assert finding.remedy
    assert check_config(config) == [finding]


def test_every_check_is_tried_here():
    listed = {*motion.CHECKS, *sensors.CHECKS, *markers.CHECKS, *timing.CHECKS}
    assert {check for check, *_ in FINDINGS.values()} == listed


def test_a_sound_configuration_has_no_finding():
    assert check_config(sound()) == []


@pytest.mark.parametrize("name", SCENARIOS)
def test_what_the_simulator_configures_has_no_finding(name: str):
    assert check_config(simulate(SCENARIOS[name], np.random.default_rng(1)).config) == []


@pytest.mark.parametrize("file", sorted(CONFIGS.glob("*.yaml")), ids=lambda file: file.stem)
def test_the_ready_configurations_lack_only_map_and_mounting(file: Path):
    found = check_config(load_config(str(file)))
    assert found[0].key == "map"
    assert all("origin" in finding.problem for finding in found[1:])


def test_a_machine_without_multicast_gets_the_commands(monkeypatch):
    monkeypatch.setattr("pilotage.multicast.available", lambda: True)
    assert list(no_multicast()) == []
    monkeypatch.setattr("pilotage.multicast.available", lambda: False)
    (finding,) = no_multicast()
    assert "ip route add" in finding.remedy
