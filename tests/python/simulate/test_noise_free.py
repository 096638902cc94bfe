"""Without noise the estimate is the truth, whatever the robot, the drive and the sensors."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

import pilotage
from pilotage.evaluate import wrap_angle
from pilotage.simulate import SCENARIOS, Scenario, Simulation, simulate
from pilotage.simulate.sensors import COMPONENTS

MIXES = [mix for size in (1, 2, 3) for mix in combinations(COMPONENTS, size)]
CALIBRATION = ("gyro_bias", "distance_scale", "rotation_scale")
POSITION, HEADING = "initial.sigma_position_m", "initial.sigma_heading_rad"
CERTAIN = {POSITION: 0.0, HEADING: 0.0} | {f"calibration.{c}.sigma": 0.0 for c in CALIBRATION}
UNSURE = {POSITION: 0.1, HEADING: 0.05} | {f"calibration.{c}.sigma": 0.01 for c in CALIBRATION}


def _exact(name: str, mix: tuple[str, ...]) -> Scenario:
    scenario = SCENARIOS[name].with_noise(0.0)
    cameras = tuple(replace(camera, components=mix) for camera in scenario.cameras)
    return replace(scenario, cameras=cameras)


def _largest_errors(simulation: Simulation, settings: dict[str, object]) -> tuple[float, float]:
    """Of position [m] and heading [rad], over the whole drive."""
    config = pilotage.Config(simulation.config)
    for key, value in settings.items():
        config[key] = value
    run = pilotage.replay(config, simulation.recording)
    assert run.counts["accepted"] > 0
    assert run.counts["rejected"].keys() <= {"no_motion"}  # after the last motion sample
    poses, truth = run.poses, simulation.truth
    np.testing.assert_array_equal(poses["utime"], truth["utime"])
    position = np.hypot(poses["x"] - truth["x"], poses["y"] - truth["y"]).max()
    heading = np.abs(wrap_angle(poses["heading"] - truth["heading"])).max()
    return float(position), float(heading)


@pytest.mark.parametrize("mix", MIXES, ids="-".join)
@pytest.mark.parametrize("scenario", SCENARIOS)
def test_the_estimate_is_the_truth(scenario: str, mix: tuple[str, ...]):
    simulation = simulate(_exact(scenario, mix), np.random.default_rng(5))
    for prior in (CERTAIN, UNSURE):
        for heading in ("gyro", "wheels", "both"):
            errors = _largest_errors(simulation, prior | {"motion.heading": heading})
            assert max(errors) <= 1e-9


@pytest.mark.parametrize("scenario", SCENARIOS)
def test_ticks_cost_no_more_than_two_of_them(scenario: str):
    exact = _exact(scenario, SCENARIOS[scenario].cameras[0].components)
    encoders = SCENARIOS[scenario].encoders
    coarse = replace(encoders, noise_m_per_sqrt_m=0.0)
    simulation = simulate(replace(exact, encoders=coarse), np.random.default_rng(5))
    for prior in (CERTAIN, UNSURE):
        position, heading = _largest_errors(simulation, prior)
        assert position <= 2 * encoders.m_per_tick
        assert heading <= 2 * encoders.m_per_tick / encoders.track_width_m


def test_frames_that_arrive_late_change_nothing():
    late = replace(_exact("figure-eight", COMPONENTS), latency_s=0.3)
    assert max(_largest_errors(simulate(late, np.random.default_rng(5)), UNSURE)) <= 1e-9
