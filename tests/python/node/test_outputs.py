"""What a controller and an operator use besides poses: resets, a rate, odometry, jumps."""

import math
import time
from pathlib import Path

import numpy as np
import pytest

import pilotage
from pilotage.lcmtypes import odometry_t, pose_jump_t, pose_reset_t, pose_t, status_t
from pilotage.logs import Log
from pilotage.replaying import recorded_config
from support.bus import Node, node
from support.driving import CONFIG, PERIOD_US, Robot


def _reset(running: Node, robot: Robot, seq: int, aside: tuple[float, float] = (0, 0)) -> None:
    """Tell it a pose shortly before its next motion."""
    reset = pose_reset_t()
    reset.utime, reset.seq = robot.utime - PERIOD_US // 2, seq
    x, y, reset.heading = robot.pose(reset.utime)
    reset.x, reset.y = x + aside[0], y + aside[1]
    reset.covariance = [0.01, 0, 0, 0, 0.01, 0, 0, 0, 0.001]
    running.send("POSE_RESET", reset)


def _go(running: Node, robot: Robot, seconds: float, sightings: bool = True) -> None:
    """Drive on, in real time."""
    start, first = time.monotonic(), robot.step
    while (passed := time.monotonic() - start) < seconds:
        while (robot.step - first) * PERIOD_US * 1e-6 < passed:
            for channel, message in robot.messages(sightings):
                running.send(channel, message)
        running.bus.handle_timeout(2)


def _status(running: Node, robot: Robot, sightings: bool = False) -> status_t:
    """Drive on until there is a status of what was sent so far."""
    _go(running, robot, 0.1, sightings)
    now = time.time() * 1e6
    while running.messages["STATUS"][-1].utime < now:
        _go(running, robot, 0.05, sightings)
    return running.messages["STATUS"][-1]


def _replayed(log: str) -> tuple[pilotage.Recording, pilotage.Recording]:
    """What a node recorded, and what its replay publishes."""
    recorded = pilotage.Recording.load(log)
    config = recorded_config(Log("lcm", recorded, truth=None, map=None))
    assert config is not None
    return recorded, pilotage.replay(config, recorded, keep_messages=True).published


@pytest.mark.parametrize(
    ("accept", "while_ok", "while_not_ok"),
    [
        ("always", "accepted", "accepted"),
        ("not_ok", "not_allowed", "accepted"),
        ("never", "not_allowed", "not_allowed"),
    ],
)
def test_the_status_answers_a_pose_reset(
    tmp_path: Path, accept: str, while_ok: str, while_not_ok: str
):
    robot = Robot()
    config = CONFIG + f"pose_reset: {{accept: {accept}}}\n"
    with node(tmp_path, config) as running:
        running.wait(lambda: running.messages["STATUS"], "a status")
        said = running.messages["STATUS"][-1]
        assert (said.reset_seq, said.reset_answer) == (-1, "")
        _go(running, robot, 0.05, sightings=False)
        _reset(running, robot, 7)
        said = _status(running, robot)
        assert (said.reset_seq, said.reset_answer) == (7, while_not_ok)
        assert said.state == status_t.INITIALIZING
        said = _status(running, robot, sightings=True)
        assert said.state == status_t.OK
        before = said.resets
        _reset(running, robot, 8, (5.0, 0.0))
        said = _status(running, robot)
        assert (said.reset_seq, said.reset_answer) == (8, while_ok)
        moved = while_ok == "accepted"
        assert said.resets == before + moved
        assert said.state == (status_t.INITIALIZING if moved else status_t.OK)
        assert (robot.distance(running.messages["POSE"][-1]) > 4.0) == moved


def test_poses_at_a_rate_of_their_own_go_forward_and_replay_to_the_same_bytes(tmp_path: Path):
    log = str(tmp_path / "run.lcmlog")
    robot = Robot(first_us=int(time.time() * 1e6))
    with node(tmp_path, CONFIG + "output: {rate_hz: 50}\n", "--record", log) as running:
        _go(running, robot, 3.0)
        running.process.terminate()
        assert running.process.wait(timeout=10) == 0
    recorded, replayed = _replayed(log)
    poses = [pose_t.decode(data) for data in recorded.messages("POSE")]
    utime = np.array([pose.utime for pose in poses])
    assert 100 <= len(poses) <= 152
    assert np.diff(utime).min() == np.median(np.diff(utime)) == 20_000  # a pause leaves a gap
    assert all(robot.distance(pose) < 0.1 for pose in poses)
    assert all(np.all(np.isfinite(pose.covariance)) for pose in poses)
    for channel in ("POSE", "ODOMETRY", "STATUS"):
        assert replayed.messages(channel) == recorded.messages(channel)
    assert len(recorded.messages("ODOMETRY")) > 250


def test_odometry_goes_on_where_the_pose_jumps_and_the_jump_is_announced(tmp_path: Path):
    log, robot = str(tmp_path / "run.lcmlog"), Robot()
    with node(tmp_path, CONFIG, "--record", log) as running:
        _go(running, robot, 0.5)
        _reset(running, robot, 0, (2.0, -1.0))
        _go(running, robot, 0.5, sightings=False)
        running.process.terminate()
        assert running.process.wait(timeout=10) == 0
    recorded, replayed = _replayed(log)
    poses = [pose_t.decode(data) for data in recorded.messages("POSE")]
    odometry = [odometry_t.decode(data) for data in recorded.messages("ODOMETRY")]
    jumps = [pose_jump_t.decode(data) for data in recorded.messages("POSE_JUMP")]
    assert [o.utime for o in odometry] == [p.utime for p in poses]
    assert (odometry[0].x, odometry[0].y, odometry[0].heading) == (0.0, 0.0, 0.0)
    steps = np.hypot(np.diff([o.x for o in odometry]), np.diff([o.y for o in odometry]))
    np.testing.assert_allclose(steps, 0.01, atol=0.0015)  # ticks of 1 mm
    (jump,) = jumps
    first = next(p for p in poses if p.utime == jump.utime)
    assert (jump.cause, jump.resets, first.resets) == ("reset", 1, 1)
    assert list(jump.after) == [first.x, first.y, first.heading]
    assert math.dist(jump.after[:2], jump.before[:2]) == pytest.approx(math.sqrt(5.0), abs=0.02)
    assert poses[-1].resets == 1
    for channel in ("POSE", "ODOMETRY", "POSE_JUMP"):
        assert replayed.messages(channel) == recorded.messages(channel)
