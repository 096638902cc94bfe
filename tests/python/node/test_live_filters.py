"""An extended and an unscented filter at once beside a simulator, as in Kohler's report."""

from pathlib import Path

import numpy as np
import pytest

from pilotage import Config, lcmtypes
from pilotage.evaluate import TRAJECTORY, pose_errors
from pilotage.live import URL, play
from pilotage.simulate import find_scenario, simulate
from support.bus import node

RING = Path(__file__).parents[3] / "docs" / "studies" / "kohler-ring.yaml"


def test_both_filters_run_beside_the_simulator(tmp_path: Path):
    scenario = find_scenario(str(RING))
    ring = simulate(scenario, np.random.default_rng(1))
    steps = 2500  # past the first markers
    end = int(ring.truth["utime"][steps])
    recording = type(ring.recording)()
    for i in range(len(ring.recording)):
        received, channel, data = ring.recording[i]
        if received <= end:
            recording.add(received, channel, data)

    unscented = Config(ring.config)
    unscented["filter"] = "ukf"
    for output in ("pose", "report", "status", "odometry", "jump"):
        unscented[f"output.{output}"] = "UKF_" + ring.config[f"output.{output}"]

    (tmp_path / "ukf").mkdir()
    with (
        node(tmp_path, ring.config.to_yaml()) as ekf,
        node(tmp_path / "ukf", unscented.to_yaml()),
    ):
        poses = {"POSE": [], "UKF_POSE": []}
        for channel, taken in poses.items():
            ekf.bus.subscribe(
                channel, lambda _, data, taken=taken: taken.append(lcmtypes.pose_t.decode(data))
            ).set_queue_capacity(0)
        play(recording, 20.0, url=URL)
        ekf.wait(lambda: all(len(p) > steps for p in poses.values()), "poses of both")

    last = {channel: np.zeros(1, TRAJECTORY) for channel in poses}
    for channel, taken in poses.items():
        final = taken[-1]
        last[channel][0] = (final.utime, final.x, final.y, final.heading)
        assert pose_errors(last[channel], ring.truth).distance[0] < 0.15, channel
    difference = abs(last["POSE"]["x"] - last["UKF_POSE"]["x"])[0]
    assert 1e-9 < difference < 0.1


@pytest.mark.outside
def test_the_scenario_names_its_filter():
    assert find_scenario(str(RING)).config["filter"] == "ekf"
