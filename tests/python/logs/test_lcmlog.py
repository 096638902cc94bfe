from pathlib import Path

import numpy as np
import pytest

from pilotage.logs import read, write_lcmlog
from support import made_logs
from support.datasets import dataset
from support.messages import channels, messages


def test_log_comes_back_with_its_truth(tmp_path: Path) -> None:
    log = read(made_logs.mower(tmp_path / "run"))
    path = tmp_path / "run.lcmlog"
    write_lcmlog(log, path)
    again = read(path)
    assert (again.kind, again.map, again.notes) == ("lcm", None, ())
    assert channels(again.recording) == channels(log.recording)
    assert log.truth is not None
    assert again.truth is not None
    np.testing.assert_array_equal(again.truth, log.truth)


def test_truth_is_written_once_however_often_the_log_is(tmp_path: Path) -> None:
    log = read(made_logs.woods(tmp_path / "a.mat"))
    for name in ("one", "two"):
        write_lcmlog(log, tmp_path / name)
    one = read(tmp_path / "one")  # recognised without an ending
    assert (tmp_path / "one").read_bytes() == (tmp_path / "two").read_bytes()
    write_lcmlog(one, tmp_path / "three")
    assert (tmp_path / "three").read_bytes() == (tmp_path / "one").read_bytes()
    assert [m.utime for m in messages(one.recording)["REFERENCE"]] == [0, 200_000]


def test_reference_comes_after_what_was_measured_at_its_time(tmp_path: Path) -> None:
    log = read(made_logs.woods(tmp_path / "a.mat"))
    write_lcmlog(log, tmp_path / "a.lcmlog")
    order = channels(log.recording)
    assert order[:3] == [(0, "VELOCITY"), (0, "MARKERS"), (0, "REFERENCE")]
    assert [t for t, _ in order] == sorted(t for t, _ in order)


def test_damage_is_told_to_the_user(tmp_path: Path) -> None:
    path = tmp_path / "a.lcmlog"
    write_lcmlog(read(made_logs.plaza(tmp_path / "a.mat")), path)
    whole = path.read_bytes()
    path.write_bytes(whole[:-5])
    log = read(path)
    assert log.notes
    assert all(note.startswith(str(path)) for note in log.notes)


def test_log_whose_beginning_is_lost_is_still_known_by_its_ending(tmp_path: Path) -> None:
    write_lcmlog(read(made_logs.plaza(tmp_path / "a.mat")), tmp_path / "whole.lcmlog")
    path = tmp_path / "cut.lcmlog"
    path.write_bytes((tmp_path / "whole.lcmlog").read_bytes()[3:])
    log = read(path)
    assert log.kind == "lcm"
    assert len(log.recording) == len(read(tmp_path / "whole.lcmlog").recording) - 1
    assert log.notes


def test_log_without_truth_has_none(tmp_path: Path) -> None:
    log = read(made_logs.plaza(tmp_path / "a.mat"))
    log.recording.save(str(tmp_path / "a.lcmlog"))
    assert read(tmp_path / "a.lcmlog").truth is None


def test_real_log_of_another_robot_is_read() -> None:
    log = read(dataset("lcm-logs") / "maebot_convex.lcmlog")
    assert log.truth is None
    assert log.notes == ()
    order = channels(log.recording)
    assert {c for _, c in order} == {"MAEBOT_ENCODERS", "MAEBOT_IMU", "RPLIDAR_LASER", "SLAM_POSE"}
    assert (order[-1][0] - order[0][0]) * 1e-6 == pytest.approx(69, abs=1)
