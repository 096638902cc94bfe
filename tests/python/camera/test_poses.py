"""Logs of poses, and which one an image has."""

from pathlib import Path

import numpy as np
import pytest

import pilotage
from pilotage.camera.poses import KEPT, Poses, read_poses
from pilotage.lcmtypes import pose_t


def some() -> Poses:
    poses = Poses()
    for i in range(5):
        poses.add(100_000 * i, (float(i), -1.0, 0.5))
    return poses


def test_it_is_the_first_one_at_the_time_or_after():
    poses = some()
    assert poses.at(200_000).tolist() == [2, -1, 0.5]
    assert poses.at(200_001).tolist() == [3, -1, 0.5]
    assert poses.at(-300_000).tolist() == [0, -1, 0.5]
    assert poses.at(400_001) is None
    assert poses.at(-600_000) is None


def test_the_newest_stands_in_where_all_are_older_but_not_for_long():
    assert some().at(600_000, or_before=True).tolist() == [4, -1, 0.5]
    assert some().at(1_000_000, or_before=True) is None
    assert Poses().at(0, or_before=True) is None


def test_after_a_clock_that_was_set_back_the_old_ones_are_forgotten():
    poses = some()
    poses.add(50_000, (9.0, 9.0, 0.0))
    assert poses.at(50_000).tolist() == [9, 9, 0]
    assert poses.at(200_000) is None
    assert poses.newest == 50_000


def test_only_the_newest_are_kept():
    poses = Poses()
    for i in range(KEPT + 10):
        poses.add(i, (float(i), 0.0, 0.0))
    assert poses.at(0)[0] == 10


def test_a_log_of_the_node_gives_its_poses_and_another_the_truth(tmp_path: Path):
    recording = pilotage.Recording()
    recording.add_reference("REFERENCE", [1, 2], [5.0, 6.0], [0.0, 0.0], [0.1, 0.2])
    recording.save(str(tmp_path / "truth.lcmlog"))
    poses, words = read_poses(tmp_path / "truth.lcmlog")
    assert poses.at(2).tolist() == [6, 0, 0.2]
    assert words.endswith("2 true poses")
    for utime, x in ((30, 3.0), (20, 2.0)):
        message = pose_t()
        message.utime, message.x = utime, x
        recording.add(utime, "POSE", message.encode())
    recording.save(str(tmp_path / "node.lcmlog"))
    poses, words = read_poses(tmp_path / "node.lcmlog")
    assert poses.at(20).tolist() == [2, 0, 0]
    assert poses.at(21).tolist() == [3, 0, 0]
    assert words.endswith("2 poses of a node")


def test_a_log_without_poses_is_refused(tmp_path: Path):
    recording = pilotage.Recording()
    recording.add_gyro("GYRO", [1], [0.0])
    recording.save(str(tmp_path / "gyro.lcmlog"))
    with pytest.raises(ValueError, match="holds neither pose_t nor reference_t"):
        read_poses(tmp_path / "gyro.lcmlog")


def test_the_papers_pose_log_and_a_trajectory_are_read(tmp_path: Path):
    rows = np.zeros((3, 21))
    rows[:, 2] = 10 + 0.1 * np.arange(3)
    rows[:, 18:] = [[1, 2, 0.3], [4, 5, 0.6], [7, 8, 7.0]]
    np.savetxt(tmp_path / "poselog.txt", rows)
    poses, _ = read_poses(tmp_path / "poselog.txt")
    assert poses.at(10_050_000).tolist() == [4, 5, 0.6]
    assert poses.at(10_150_000)[2] == pytest.approx(7.0 - 2 * np.pi)
    (tmp_path / "pose.csv").write_text("utime,x,y,heading,v\n5,1,2,3,0\n")
    poses, _ = read_poses(tmp_path / "pose.csv")
    assert poses.at(5).tolist() == [1, 2, 3]
