"""A node that begins with a checkpoint: a hypothesis, until the robot's sensors confirm it."""

import math
import time
from collections.abc import Callable
from pathlib import Path

import pytest

import pilotage
from pilotage.health import radius_95_m
from pilotage.lcmtypes import pose_t, status_t
from pilotage.logs import Log
from pilotage.replaying import recorded_config
from support.bench import Bench
from support.bus import Node, node
from support.driving import CONFIG, Robot

INITIALIZING, OK = status_t.INITIALIZING, status_t.OK
EVERY_SECOND = CONFIG + "checkpoint: {interval_s: 1}\n"


def _drive(running: Node, robot: Robot, steps: int, sightings: bool = True) -> list[pose_t]:
    """Go on for some steps; the poses that answer them."""
    poses = running.messages["POSE"]
    before = len(poses)
    for _ in range(steps):
        for channel, message in robot.messages(sightings):
            running.send(channel, message)
        if robot.step % 20 == 0:
            running.bus.handle_timeout(1)
    running.wait(lambda: len(poses) >= before + steps, "poses")
    return poses[before:]


def _sight(running: Node, robot: Robot) -> pose_t:
    """One sighting and the motion after it; the pose then."""
    running.send(*list(robot.messages())[-1])
    return _drive(running, robot, 1, sightings=False)[-1]


def _end(running: Node) -> None:
    """End it as an init system does; it writes a last checkpoint."""
    running.process.terminate()
    assert running.process.wait(timeout=10) == 0


def _kept(folder: Path, config: str = EVERY_SECOND) -> tuple[Robot, str]:
    """A robot that has driven for two seconds, and its checkpoint's path."""
    robot, bench, path = Robot(), Bench(config), folder / "pose"
    while robot.step < 200:
        bench.send_all(robot.messages())
    bench.pass_time(robot.utime + 2_000_000)
    assert bench.engine.checkpoint is not None
    path.write_bytes(bench.engine.checkpoint)
    return robot, str(path)


def test_sigterm_writes_where_the_robot_was_last(tmp_path: Path):
    robot, path = Robot(), str(tmp_path / "pose")
    with node(tmp_path, EVERY_SECOND, "--checkpoint", path) as running:
        assert _drive(running, robot, 120)[-1].status == OK
        _end(running)
    kept = pilotage.read_checkpoint(path)
    assert kept["utime"] == robot.utime - 10_000
    robot.step -= 1
    assert kept["ticks"] == robot.ticks
    x, y, heading = robot.pose(robot.utime)
    assert math.dist(kept["state"][:2], (x, y)) < 0.05
    assert abs(math.remainder(kept["state"][2] - heading, 2 * math.pi)) < 0.02
    assert kept["covariance"].shape == (3, 3)


def test_it_is_ok_only_after_sightings_that_agree(tmp_path: Path):
    robot, path = _kept(tmp_path)
    with node(tmp_path, EVERY_SECOND, "--checkpoint", path) as running:
        assert f"begins with the pose of {path}; sightings are to confirm it" in running.said
        poses = _drive(running, robot, 100, sightings=False)
        assert {pose.status for pose in poses} == {INITIALIZING}
        assert all(robot.distance(pose) < radius_95_m(pose) for pose in poses)
        said = running.status_after(time.time())
        assert said.state == INITIALIZING
        assert "0 of the 3 sightings in a row that confirm the pose" in said.reason
        for expected in (INITIALIZING, INITIALIZING, OK):
            pose = _sight(running, robot)
            assert pose.status == expected
        assert robot.distance(pose) < radius_95_m(pose)


def test_ticks_that_have_not_changed_confirm_it_at_once(tmp_path: Path):
    robot, path = _kept(tmp_path)
    robot.step -= 1  # the counts that it ended with
    with node(tmp_path, EVERY_SECOND, "--checkpoint", path) as running:
        assert _drive(running, robot, 1, sightings=False)[0].status == OK


def test_a_robot_carried_away_is_never_ok_where_it_was(tmp_path: Path):
    robot, path = _kept(tmp_path)
    robot.aside = (0.0, 3.0)
    robot.step += 50  # pushed: the wheels have turned
    with node(tmp_path, EVERY_SECOND, "--checkpoint", path) as running:
        poses = _drive(running, robot, 1500)
        assert poses[0].status == INITIALIZING
        assert all(pose.status != OK or robot.distance(pose) < 0.5 for pose in poses)
        assert poses[-1].status == OK, running.status_after(time.time()).reason


def _flipped(path: Path) -> None:
    content = bytearray(path.read_bytes())
    content[40] ^= 0x10
    path.write_bytes(content)


SPOILT: dict[str, tuple[Callable[[Path], object], str]] = {
    "a flipped bit": (_flipped, "is damaged: its CRC is wrong"),
    "a torn end": (lambda p: p.write_bytes(p.read_bytes()[:-30]), "is damaged: its CRC is wrong"),
    "a stump": (lambda p: p.write_bytes(b"\0" * 7), "is too short"),
    "another file": (lambda p: p.write_text("x_m: 1\n" * 30), "is damaged: its CRC is wrong"),
    "a folder": (lambda p: (p.unlink(), p.mkdir()), "cannot be read: Is a directory"),
}


@pytest.mark.parametrize("how", SPOILT)
def test_a_checkpoint_that_cannot_be_read_is_named_and_the_node_goes_on(tmp_path: Path, how: str):
    robot, path = _kept(tmp_path)
    spoil, words = SPOILT[how]
    spoil(Path(path))
    with node(tmp_path, EVERY_SECOND, "--checkpoint", path) as running:
        said = [line for line in running.said.splitlines() if path in line]
        assert said == [f"pilotage-node: begins without a checkpoint, since {path} {words}"]
        robot = Robot()
        assert _drive(running, robot, 50)[-1].status == OK
        _end(running)
    if how == "a folder":
        assert f"{path}: cannot replace: Is a directory; the checkpoint is not kept" in running.said
    else:
        assert pilotage.read_checkpoint(path)["utime"] == robot.utime - 10_000


def test_a_checkpoint_of_another_map_is_named_and_not_used(tmp_path: Path):
    _, path = _kept(tmp_path)
    other = EVERY_SECOND.replace("x: 5.0", "x: 5.5")
    with node(tmp_path, other, "--checkpoint", path) as running:
        assert f"begins without a checkpoint, since {path} belongs to another map" in running.said
        assert _drive(running, Robot(), 2)[0].x == 0.0


def test_another_configuration_leaves_the_pose_and_forgets_the_calibration(tmp_path: Path):
    robot, path = _kept(tmp_path, EVERY_SECOND + "calibration: {gyro_bias: {sigma: 0.01}}\n")
    assert pilotage.read_checkpoint(path)["state"].shape == (6,)
    with node(tmp_path, EVERY_SECOND, "--checkpoint", path) as running:
        assert "begins with the pose" in running.said
        poses = _drive(running, robot, 20)
        assert poses[-1].status == OK
        assert robot.distance(poses[-1]) < 0.1


def test_a_run_that_began_with_a_checkpoint_replays_to_the_same_bytes(tmp_path: Path):
    robot, path = _kept(tmp_path)
    log = str(tmp_path / "run.lcmlog")
    fast = EVERY_SECOND.replace("interval_s: 1", "interval_s: 0.1")
    with node(tmp_path, fast, "--checkpoint", path, "--record", log) as running:
        _drive(running, robot, 100, sightings=False)
        _drive(running, robot, 300)
        running.status_after(time.time())
        _end(running)
    recorded = pilotage.Recording.load(log)
    config = recorded_config(Log("lcm", recorded, truth=None, map=None))
    assert config is not None
    run = pilotage.replay(config, recorded, keep_messages=True)
    assert run.damage == []
    for channel in ("POSE", "ODOMETRY", "STATUS", "POSE_JUMP", "MARKER_REPORT"):
        again = run.published.messages(channel)
        messages = recorded.messages(channel)
        assert again[: len(messages)] == messages
        # Only a replay knows that no more motion will come, and judges what waits for it.
        assert len(again) == len(messages) or channel == "MARKER_REPORT"
    first = pose_t.decode(run.published.messages("POSE")[0])
    assert first.status == INITIALIZING
    assert robot.distance(first) < 0.1


def test_the_status_tells_how_old_the_checkpoint_is(tmp_path: Path):
    robot, path = Robot(), str(tmp_path / "pose")
    with node(tmp_path, EVERY_SECOND, "--checkpoint", path) as running:
        running.wait(lambda: running.messages["STATUS"], "a status")
        assert math.isnan(running.messages["STATUS"][0].checkpoint_age_s)
        _drive(running, robot, 50)
        start = time.time()
        for second in (1.1, 2.1):
            said = running.status_after(start + second)
        assert 0.0 <= said.checkpoint_age_s < 2.0
        made = pilotage.read_checkpoint(path)["made"]
        assert made <= said.utime + 2_000_000


def test_a_place_that_cannot_be_written_is_named_and_the_node_goes_on(tmp_path: Path):
    path = str(tmp_path / "no-such-folder" / "pose")
    with node(tmp_path, EVERY_SECOND, "--checkpoint", path) as running:
        _drive(running, Robot(), 50)
        running.wait(lambda: "the checkpoint is not kept" in running.said, "a word about it")
        assert f"{path}.new: cannot create: No such file or directory" in running.said
        _end(running)
