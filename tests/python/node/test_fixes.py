"""A robot without any marker, live: satellite navigation, a compass, a dock, walls."""

import math
import time
from pathlib import Path

import pytest

import pilotage
from pilotage.lcmtypes import heading_t, pose_fix_t, pose_t, position_fix_t, status_t, wall_range_t
from pilotage.logs import Log
from pilotage.replaying import recorded_config
from support.bus import Node, node
from support.driving import TRACK_M, Robot

NAN = math.nan
ROOM = ((-4.0, -2.0), (4.0, -2.0), (4.0, 6.0), (-4.0, 6.0))
ANTENNA = (0.3, -0.1)

BASE = f"""
encoders: {{left_m_per_tick: 0.001, right_m_per_tick: 0.001, track_width_m: {TRACK_M}}}
filter: %s
"""
OUTDOORS = """
initial: {x_m: 0.2, y_m: -0.1, heading_rad: 0.05, sigma_position_m: 0.3}
sensors:
  gps: {measures: pose, x_m: 0.3, y_m: -0.1, sigma_position_m: 0.02}
  compass: {measures: pose, yaw_rad: 0.5, sigma_heading_rad: 0.02}
"""
INDOORS = """
sensors:
  dock: {measures: pose, sigma_position_m: 0.05}
  laser: {measures: walls, yaw_rad: 0.1, sigma_range_m: 0.02}
walls: [[[-4, -2], [4, -2], [4, 6], [-4, 6], [-4, -2]]]
"""


def _position(robot: Robot) -> position_fix_t:
    x, y, heading = robot.pose(robot.utime)
    fix = position_fix_t()
    fix.utime, fix.seq, fix.sensor, fix.covariance = robot.utime, robot.step, "gps", [NAN] * 4
    c, s = math.cos(heading), math.sin(heading)
    fix.x = x + c * ANTENNA[0] - s * ANTENNA[1]
    fix.y = y + s * ANTENNA[0] + c * ANTENNA[1]
    return fix


def _heading(robot: Robot) -> heading_t:
    fix = heading_t()
    fix.utime, fix.seq, fix.sensor, fix.sigma = robot.utime, robot.step, "compass", NAN
    fix.heading = robot.pose(robot.utime)[2] + 0.5
    return fix


def _pose(robot: Robot) -> pose_fix_t:
    fix = pose_fix_t()
    fix.utime, fix.seq, fix.sensor, fix.covariance = robot.utime, robot.step, "dock", [NAN] * 9
    fix.x, fix.y, fix.heading = robot.pose(robot.utime)
    return fix


def _ranges(robot: Robot) -> wall_range_t:
    """Of three beams, the last of which says that it hit nothing."""
    x, y, heading = robot.pose(robot.utime)
    message = wall_range_t()
    message.utime, message.seq, message.sensor, message.n = robot.utime, robot.step, "laser", 3
    message.angle, message.sigma = [0.0, 1.8, -1.8], [NAN] * 3
    for angle in message.angle:
        c, s = math.cos(heading + 0.1 + angle), math.sin(heading + 0.1 + angle)
        across = ((ROOM[1][0] if c > 0 else ROOM[0][0]) - x) / c
        along = ((ROOM[2][1] if s > 0 else ROOM[0][1]) - y) / s
        message.range.append(min(across, along))
    message.range[-1] = NAN
    return message


def _drive(running: Node, robot: Robot, steps: int, *sensors) -> None:
    """Send motion at every step, and each sensor's message at every tenth."""
    first = robot.step
    for step in range(first, first + steps):
        for channel, make in sensors if step % 10 == 5 else ():
            running.send(channel, make(robot))
        for channel, message in robot.messages(sightings=False):
            running.send(channel, message)
        last = robot.step - first
        if last % 100 == 0 or last == steps:  # no faster than it can be read
            poses = running.messages["POSE"]
            running.wait(
                lambda poses=poses: poses and poses[-1].utime == robot.utime - robot.period_us,
                "the newest pose",
            )


def _check(running: Node, robot: Robot, log: str, fused: dict[str, int]) -> None:
    newest = running.messages["POSE"][-1]
    assert robot.distance(newest) < 0.05
    turn = newest.heading - robot.pose(newest.utime)[2]
    assert abs(math.remainder(turn, 2 * math.pi)) < 0.03
    assert newest.status == status_t.OK
    running.process.terminate()
    assert running.process.wait(timeout=10) == 0
    recorded = pilotage.Recording.load(log)
    config = recorded_config(Log("lcm", recorded, truth=None, map=None))
    assert config is not None
    run = pilotage.replay(config, recorded, keep_messages=True)
    for channel in ("POSE", "MARKER_REPORT"):
        assert run.published.messages(channel) == recorded.messages(channel)
    accepted = run.reports[run.reports["accepted"]]
    for name, count in fused.items():
        assert (accepted["sensor"] == run.sensors.index(name)).sum() == count
    assert pose_t.decode(recorded.messages("POSE")[-1]).utime == newest.utime


@pytest.mark.parametrize("kind", ["ekf", "ukf"])
def test_positions_and_headings_localize_a_robot_that_sees_no_marker(tmp_path: Path, kind: str):
    log, robot = str(tmp_path / "run.lcmlog"), Robot()
    with node(tmp_path, BASE % kind + OUTDOORS, "--record", log) as running:
        _drive(running, robot, 600, ("FIX", _position), ("FIX", _heading))
        _check(running, robot, log, {"gps": 60, "compass": 60})


@pytest.mark.parametrize("kind", ["ekf", "ukf"])
def test_a_dock_starts_it_and_walls_keep_it(tmp_path: Path, kind: str):
    log, robot = str(tmp_path / "run.lcmlog"), Robot()
    with node(tmp_path, BASE % kind + INDOORS, "--record", log) as running:
        _drive(running, robot, 20, ("FIX", _pose))
        _drive(running, robot, 580, ("WALLS", _ranges))
        _check(running, robot, log, {"dock": 2, "laser": 116})


def test_a_message_of_another_kind_of_sensor_is_counted_and_named(tmp_path: Path):
    robot = Robot()
    with node(tmp_path, BASE % "ekf" + INDOORS) as running:
        _drive(running, robot, 10, ("FIX", _pose))
        wrong = _heading(robot)
        wrong.sensor = "laser"
        running.send("WALLS", wrong)
        unknown = _pose(robot)
        unknown.sensor = "beacon"
        running.send("FIX", unknown)
        half = _pose(robot)
        half.seq, half.x = 11, NAN
        running.send("FIX", half)
        _drive(running, robot, 100)
        running.wait(lambda: "beacon" in running.said and "heading_t" in running.said, "words")
        inputs = {entry.name: entry for entry in running.status_after(time.time()).inputs}
        assert {r.reason: r.count for r in inputs["laser"].rejected} == {"wrong_type": 1}
        rejected = {r.reason: r.count for r in inputs["dock"].rejected}
        assert rejected == {"unknown_sensor": 1, "bad_value": 1}
