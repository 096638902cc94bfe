"""Without noise the estimate is the truth, whatever the robot, the drive and the sensors."""

from dataclasses import replace
from itertools import combinations

import numpy as np
import pytest

import pilotage
from pilotage.evaluate import wrap_angle
from pilotage.simulate import SCENARIOS, simulate
from pilotage.simulate.sensors import COMPONENTS

MIXES = [mix for size in (1, 2, 3) for mix in combinations(COMPONENTS, size)]
CALIBRATION = ("gyro_bias", "distance_scale", "rotation_scale")


def _largest_error(scenario: str, mix: tuple[str, ...], settings: dict[str, object]) -> float:
    exact = SCENARIOS[scenario].with_noise(0.0)
    cameras = tuple(replace(camera, components=mix) for camera in exact.cameras)
    exact = replace(exact, cameras=cameras, duration_s=40.0)
    simulation = simulate(exact, np.random.default_rng(5))
    for key, value in settings.items():
        simulation.config[key] = value
    run = pilotage.replay(simulation.config, simulation.recording)
    assert run.counts["accepted"] > 0
    assert (
        run.counts["accepted"] + run.counts["rejected"].get("no_motion", 0)
        == (run.counts["samples"])
    )
    poses, truth = run.poses, simulation.truth
    np.testing.assert_array_equal(poses["utime"], truth["utime"])
    heading = np.abs(wrap_angle(poses["heading"] - truth["heading"])).max()
    position = np.hypot(poses["x"] - truth["x"], poses["y"] - truth["y"]).max()
    return float(max(heading, position))


@pytest.mark.parametrize("mix", MIXES, ids="-".join)
@pytest.mark.parametrize("scenario", SCENARIOS)
def test_the_estimate_is_the_truth(scenario: str, mix: tuple[str, ...]):
    certain = {"initial.sigma_position_m": 0.0, "initial.sigma_heading_rad": 0.0}
    certain |= {f"calibration.{name}.sigma": 0.0 for name in CALIBRATION}
    unsure = {"initial.sigma_position_m": 0.1, "initial.sigma_heading_rad": 0.05}
    unsure |= {f"calibration.{name}.sigma": 0.01 for name in CALIBRATION}
    for settings in (certain, unsure):
        for heading in ("gyro", "wheels", "both"):
            assert _largest_error(scenario, mix, settings | {"motion.heading": heading}) <= 1e-9
