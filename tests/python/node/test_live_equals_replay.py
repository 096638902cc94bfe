"""A live run and the replay of what was recorded of it give the same bytes."""

from pathlib import Path

import numpy as np
import pytest

import pilotage
from pilotage.evaluate import wrap_angle
from support.drives import write_drive
from support.node_session import node_session
from support.private_network import run_privately

SPEED = 10.0


def _replayed(folder: Path, log: str) -> pilotage.Recording:
    config = pilotage.load_config(str(folder / "robot.yaml"))
    run = pilotage.replay(config, str(folder / log), keep_messages=True)
    assert run.damage == []
    return run.published


def test_what_lcm_logger_recorded_beside_the_node_gives_its_poses(tmp_path: Path):
    write_drive(tmp_path)
    live = run_privately(
        tmp_path, node_session, tmp_path, tmp_path / "drive.lcmlog", logger=True
    )
    assert live.exit_code == 0
    assert len(live.messages["POSE"]) == 2001
    assert _replayed(tmp_path, "logger.lcmlog").messages("POSE") == live.messages["POSE"]


@pytest.mark.parametrize("policy", ["utime", "receive", "mapped"])
def test_the_nodes_own_record_gives_all_that_it_published(tmp_path: Path, policy: str):
    by_policy = {f"{name}__time": policy for name in ("encoders", "gyro", "sensors__scanner")}
    write_drive(tmp_path, encoders__max_speed_m_s=10 * SPEED, **by_policy)
    live = run_privately(
        tmp_path,
        node_session,
        tmp_path,
        tmp_path / "drive.lcmlog",
        options=["--record", str(tmp_path / "node.lcmlog")],
        speed=SPEED,
    )
    assert live.exit_code == 0
    assert len(live.messages["POSE"]) > 1900
    assert len(live.messages["MARKER_REPORT"]) > 1000
    replayed = _replayed(tmp_path, "node.lcmlog")
    for channel in ("POSE", "MARKER_REPORT", "STATUS"):
        assert replayed.messages(channel) == live.messages[channel]


def test_over_lcm_an_exact_drive_is_followed_to_two_ticks(tmp_path: Path):
    truth = write_drive(tmp_path, exact=True)
    live = run_privately(tmp_path, node_session, tmp_path, tmp_path / "drive.lcmlog")
    poses = [pilotage.lcmtypes.pose_t.decode(data) for data in live.messages["POSE"]]
    assert [p.utime for p in poses] == truth["utime"].tolist()
    config = pilotage.load_config(str(tmp_path / "robot.yaml"))
    two_ticks = 2 * config["encoders.left_m_per_tick"]
    distance = np.hypot([p.x for p in poses] - truth["x"], [p.y for p in poses] - truth["y"])
    turn = np.abs(wrap_angle([p.heading for p in poses] - truth["heading"]))
    assert distance.max() <= two_ticks
    assert turn.max() <= two_ticks / config["encoders.track_width_m"]
