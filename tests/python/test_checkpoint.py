"""Where a checkpoint is a hypothesis only, and what confirms it."""

import math
from pathlib import Path

import numpy as np
import pytest

from pilotage import Config, ConfigError, read_checkpoint
from pilotage.health import radius_95_m
from pilotage.lcmtypes import status_t
from support.bench import Bench
from support.driving import CONFIG, Robot

WITHOUT_START = CONFIG.replace("initial: {x_m: 0, y_m: 0, heading_rad: 0}", "")


def _driven(robot: Robot, steps: int = 300, config: str = CONFIG) -> bytes:
    """The checkpoint after a drive."""
    bench = Bench(config)
    for _ in range(steps):
        bench.send_all(robot.messages())
    assert bench.pose.status == status_t.OK
    bench.pass_time(robot.utime + 6_000_000)
    assert bench.engine.checkpoint is not None
    return bench.engine.checkpoint


@pytest.mark.parametrize("power_cycle", [False, True])
@pytest.mark.parametrize("far_m", [0.7, 1.5, 3.0, 6.0, 15.0])
@pytest.mark.parametrize("towards", range(4))
def test_a_robot_carried_away_is_never_ok_where_it_was(
    far_m: float, towards: int, power_cycle: bool
):
    robot = Robot()
    kept = _driven(robot)
    angle = 0.3 + towards * math.pi / 2
    robot.aside = (far_m * math.cos(angle), far_m * math.sin(angle))
    robot.step += 300  # the wheels have turned meanwhile
    if power_cycle:
        robot.ticks_from = robot.step
    bench = Bench(WITHOUT_START, kept)
    for _ in range(2000):
        bench.send_all(robot.messages())
        if bench.pose.status == status_t.OK:
            off_m = robot.distance(bench.pose)
            assert off_m < far_m / 2
            assert off_m < max(0.1, 2.5 * radius_95_m(bench.pose))
    # From farther it may stay honestly unsure: no search for a start looks there.
    assert bench.pose.status == status_t.OK or far_m > 10.0, bench.status.reason


def test_unseen_it_is_never_ok_however_far_it_drives():
    robot = Robot()
    bench = Bench(WITHOUT_START, _driven(robot))
    for _ in range(2000):
        bench.send_all(robot.messages(sightings=False))
        assert bench.pose.status == status_t.INITIALIZING
    assert "0 of the 3 sightings" in bench.status.reason


def test_ticks_of_zero_confirm_nothing():
    """Both counters stand at zero after every power cycle, wherever the robot was put meanwhile."""
    robot, bench = Robot(ticks_from=0), Bench(CONFIG + "checkpoint: {interval_s: 0.01}\n")
    for _ in range(5):
        bench.send_all(robot.messages())
        robot.ticks_from = robot.step
    assert bench.pose.status == status_t.OK
    kept = bench.engine.checkpoint
    again = Bench(WITHOUT_START, kept)
    again.send_all(robot.messages(sightings=False))
    assert again.pose.status == status_t.INITIALIZING


def test_ticks_that_have_not_changed_confirm_it():
    robot = Robot()
    kept = _driven(robot)
    robot.step -= 1  # the counts that it ended with
    bench = Bench(WITHOUT_START, kept)
    bench.send_all(robot.messages(sightings=False))
    assert bench.pose.status == status_t.OK


def test_python_reads_what_the_engine_made(tmp_path: Path):
    robot = Robot()
    path = tmp_path / "pose"
    path.write_bytes(_driven(robot, config=CONFIG + "calibration: {gyro_bias: {sigma: 0.01}}\n"))
    kept = read_checkpoint(str(path))
    robot.step -= 1
    assert kept["utime"] == robot.utime
    assert kept["ticks"] == robot.ticks
    assert kept["state"].shape == (6,)
    assert math.dist(kept["state"][:2], robot.pose(robot.utime)[:2]) < 0.1
    np.testing.assert_array_equal(kept["covariance"], kept["covariance"].T)
    content = bytearray(path.read_bytes())
    for place in range(0, len(content), 7):
        content[place] ^= 1
        path.write_bytes(content)
        with pytest.raises(RuntimeError, match="is damaged: its CRC is wrong"):
            read_checkpoint(str(path))
        content[place] ^= 1
    with pytest.raises(RuntimeError, match="no such file"):
        read_checkpoint(str(tmp_path / "other"))


@pytest.mark.parametrize(
    ("settings", "period_us"),
    [
        ("", 1_000_000),
        ("checkpoint: {interval_s: 0.25}", 250_000),
        ("checkpoint: {interval_s: 1.0e-9}", 1_000),
        ("output: {rate_hz: 20}\ncheckpoint: {interval_s: 0.25}", 50_000),
        ("output: {rate_hz: 0.1}", 1_000_000),
    ],
)
def test_ticks_come_as_often_as_anything_is_due(settings: str, period_us: int):
    assert Bench(CONFIG + settings).engine.tick_period == period_us


def test_the_interval_is_kept_and_the_status_stays_at_one_a_second():
    robot, bench = Robot(), Bench(CONFIG + "checkpoint: {interval_s: 0.1}\n")
    made = set()
    for _ in range(1000):
        bench.send_all(robot.messages())
        made.add(bench.engine.checkpoint)
    assert 90 <= len(made) <= 102
    assert 10 <= len(bench.messages["STATUS"]) <= 11


def test_a_rate_that_no_clock_resolves_is_refused():
    with pytest.raises(ConfigError, match=r"output.rate_hz is .*, expected 0 or"):
        Config.parse("output: {rate_hz: 1.0e+7}")
