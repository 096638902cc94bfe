"""The ready configurations on real recordings: how accurate, and how honest."""

from pathlib import Path
from typing import Any

import numpy as np
import pytest
from numpy.typing import NDArray

from pilotage import Run, replay
from pilotage.evaluate import Metrics, compute_metrics, wrap_angle
from pilotage.lcmtypes import encoders_t, gyro_t, odometry_t, pose_t
from pilotage.logs import Log, read, write_lcmlog
from pilotage.replaying import Replay, prepared_config, replay_log
from support.datasets import dataset


def _metrics(path: Path, robot: int | None = None) -> Metrics:
    log = read(path, robot=robot)
    return compute_metrics(replay_log(log).run, log.truth)


@pytest.mark.parametrize(
    ("path", "position_m", "heading_deg"),
    [
        ("mower-listing", 0.36, 1.0),
        ("lost-in-the-woods/dataset2.mat", 0.030, 1.0),
        ("plaza/Plaza1_.mat", 0.34, 1.5),
    ],
)
def test_the_ready_configuration_is_accurate(path: str, position_m: float, heading_deg: float):
    folder, _, file = path.partition("/")
    metrics = _metrics(dataset(folder) / file)
    assert metrics.position is not None
    assert metrics.position.rmse_m <= position_m
    assert metrics.heading is not None
    assert metrics.heading.rmse_deg <= heading_deg
    assert metrics.nees is not None
    assert metrics.nees.mean <= 3.0
    assert metrics.counts.samples == metrics.counts.accepted + sum(metrics.counts.rejected.values())


def test_one_configuration_serves_all_mrclam_robots():
    folder = dataset("mrclam") / "MRCLAM_Dataset6"
    errors = []
    for robot in (1, 2, 3):
        metrics = _metrics(folder, robot)
        assert metrics.position is not None
        errors.append(metrics.position.rmse_m)
    assert np.mean(errors) <= 0.160


def _bytes_of(replayed: Replay, folder: Path) -> bytes:
    replayed.run.write_poses_csv(str(folder / "pose.csv"))
    replayed.run.write_reports_csv(str(folder / "reports.csv"))
    return (folder / "pose.csv").read_bytes() + (folder / "reports.csv").read_bytes()


def test_a_converted_log_replays_to_the_same_bytes(tmp_path: Path):
    log = read(dataset("plaza") / "Plaza1_.mat")
    original = replay_log(log)
    write_lcmlog(log, tmp_path / "plaza.lcmlog")
    (tmp_path / "config.yaml").write_text(original.config.to_yaml())
    converted = replay_log(read(tmp_path / "plaza.lcmlog"), tmp_path / "config.yaml")
    assert _bytes_of(converted, tmp_path) == _bytes_of(original, tmp_path)


def test_the_error_does_not_depend_on_where_the_recording_starts():
    log = read(dataset("lost-in-the-woods") / "dataset2.mat")
    assert log.truth is not None
    start = log.truth["utime"][len(log.truth) // 2]
    late = Log(log.kind, log.recording, log.truth[log.truth["utime"] >= start], log.map)
    run = replay_log(late).run
    settled = run.poses["utime"] > start + 20_000_000
    truth = log.truth[np.isin(log.truth["utime"], run.poses["utime"][settled])]
    poses = run.poses[np.isin(run.poses["utime"], truth["utime"])]
    assert np.hypot(poses["x"] - truth["x"], poses["y"] - truth["y"]).mean() < 0.05


def test_a_foreign_robots_encoders_are_understood_and_its_other_messages_named(tmp_path: Path):
    log = read(dataset("lcm-logs") / "maebot_convex.lcmlog")
    (tmp_path / "maebot.yaml").write_text(
        "motion: {heading: wheels}\n"
        "encoders: {channel: MAEBOT_ENCODERS, time: receive, left_m_per_tick: 2.1e-4,\n"
        "           right_m_per_tick: 2.1e-4, track_width_m: 0.08}\n"
        "gyro: {channel: MAEBOT_IMU}\n"
        "initial: {x_m: 0, y_m: 0, heading_rad: 0}\n"
        "sensors: {laser: {z_m: 0.1}}\n"
        "map: [{id: 1, x: 0, y: 0}]\n"
    )
    run = replay_log(log, tmp_path / "maebot.yaml").run
    assert len(run.poses) > 3400  # one an encoder message, but for those that arrived out of order
    assert np.all(np.isfinite(run.poses["x"]))
    by_name = {row["name"]: row for row in run.inputs}
    assert by_name["gyro"]["counts"] == {"wrong_type": 1376}
    assert any("MAEBOT_IMU: expected gyro_t" in notice for notice in run.notices)
    # Its clock is 349 days off; the pose is dated by arrival, as configured.
    assert run.poses["utime"][0] == 1477530571543258


def _decoded(run: Run, channel: str, kind: Any) -> NDArray[np.float64]:
    """(n, 3) x, y [m] and heading [rad] of published messages."""
    messages = map(kind.decode, run.published.messages(channel))
    return np.array([(m.x, m.y, m.heading) for m in messages])


def test_the_smooth_output_has_no_jumps_where_the_pose_has():
    log = read(dataset("mower-listing"))
    config = prepared_config(log)
    run = replay(config, log.recording, keep_messages=True)
    encoders = map(encoders_t.decode, log.recording.messages("ENCODERS"))
    gyro = [gyro_t.decode(data).rate for data in log.recording.messages("GYRO")]
    ticks = np.array([(m.left + m.right) / 2 for m in encoders])
    driven = np.abs(np.diff(ticks)) * config["encoders.left_m_per_tick"]
    smooth, pose = (
        np.diff(_decoded(run, channel, kind), axis=0)
        for channel, kind in (("ODOMETRY", odometry_t), ("POSE", pose_t))
    )
    step, turn = np.hypot(smooth[:, 0], smooth[:, 1]), np.abs(wrap_angle(smooth[:, 2]))
    assert np.all(step <= 1.05 * driven + 1e-6)
    assert turn.max() <= 0.025 * 1.05 * np.abs(gyro).max()  # of the longest interval
    jumps = run.published.messages("POSE_JUMP")
    assert 0 < len(jumps) == run.poses["resets"][-1] <= 20
    assert np.hypot(pose[:, 0], pose[:, 1]).max() > 10 * step.max()
