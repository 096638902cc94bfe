import time
from pathlib import Path

import numpy as np
import pytest

from pilotage.logs import read
from support import made_logs
from support.datasets import dataset
from support.made_logs import pose_row
from support.messages import channels, messages

BAD_TABLE = (ValueError, RuntimeError)


def test_travels_become_absolute_ticks_of_a_micrometre(tmp_path: Path) -> None:
    travels = [(0.0, 0.0), (1.4e-6, 0.0005), (1.4e-6, -0.0002), (1.4e-6, 0.0)]
    rows = "\n".join(pose_row(10 + 0.01 * i, *wheels) for i, wheels in enumerate(travels))
    log = read(made_logs.mower(tmp_path, poselog=rows))
    encoders = messages(log.recording)["ENCODERS"]
    # What a tick cannot hold is carried over to the next row, so nothing of the travel is lost.
    assert [m.left for m in encoders] == [0, 1, 3, 4]
    assert [m.right for m in encoders] == [0, 500, 300, 300]


def test_columns_come_out_under_their_names(tmp_path: Path) -> None:
    log = read(made_logs.mower(tmp_path))
    assert log.kind == "mower"
    assert log.notes == ()
    sent = messages(log.recording)
    assert [(m.utime, m.rate) for m in sent["GYRO"]] == [(10_000_000, 0.0), (10_010_000, 0.3)]
    (frame,) = sent["MARKERS"]
    assert (frame.utime, frame.sensor, frame.n) == (10_005_000, "camera", 1)
    (sighting,) = frame.sightings
    assert (sighting.id, sighting.bearing, sighting.elevation) == (1, 0.5, -0.1)
    assert np.isnan(sighting.range)
    assert np.isnan(sighting.sigma_bearing)
    assert log.truth is not None
    assert log.truth[1].tolist() == pytest.approx((10_010_000, 1.0, 2.0, 7.0 - 2 * np.pi))
    assert log.map is not None
    assert log.map.ids.tolist() == [0, 1]
    assert log.map.positions.tolist() == [[1.0, 2.0, 0.0], [3.0, 4.0, 0.0]]


def test_at_one_stamp_the_turn_comes_before_the_motion_and_both_before_sightings(
    tmp_path: Path,
) -> None:
    rows = f"{pose_row(10.0)}\n{pose_row(10.0)}\n"
    log = read(made_logs.mower(tmp_path, poselog=rows, angles="10.0 1 0 0 0 0\n"))
    assert [c for _, c in channels(log.recording)] == 2 * ["GYRO"] + 2 * ["ENCODERS"] + ["MARKERS"]


def test_sightings_of_one_stamp_are_one_frame(tmp_path: Path) -> None:
    angles = "10.001 0 0.1 0 0 0\n10.001 1 0.2 0 0 0\n10.002 1 0.3 0 0 0\n"
    log = read(made_logs.mower(tmp_path, angles=angles))
    assert [m.n for m in messages(log.recording)["MARKERS"]] == [2, 1]


def test_log_without_a_sighting_is_dead_reckoning_only(tmp_path: Path) -> None:
    assert "MARKERS" not in messages(read(made_logs.mower(tmp_path, angles="")).recording)


def test_truth_that_is_not_a_number_is_left_out(tmp_path: Path) -> None:
    rows = f"{pose_row(10.0, truth=(np.nan, 0, 0))}\n{pose_row(10.01)}\n"
    log = read(made_logs.mower(tmp_path, poselog=rows))
    assert log.truth is not None
    assert log.truth["utime"].tolist() == [10_010_000]


def test_rows_out_of_order_are_put_in_order_and_the_user_is_told(tmp_path: Path) -> None:
    rows = "\n".join(pose_row(t) for t in (10.0, 10.02, 10.01, 10.03))
    log = read(made_logs.mower(tmp_path, poselog=rows))
    stamps = [m.utime for m in messages(log.recording)["ENCODERS"]]
    assert stamps == sorted(stamps)
    (note,) = log.notes
    assert "poselog.txt: time goes back at 1 data rows, first at row 3 by 0.01 s" in note


@pytest.mark.parametrize(
    ("name", "pattern"),
    [
        ("marker-001-003-angles.txt", r"\*angles\*\.txt"),
        ("marker-001-map.txt", r"\*map\*\.txt"),
    ],
)
def test_missing_file_is_named_with_its_folder(tmp_path: Path, name: str, pattern: str) -> None:
    folder = made_logs.mower(tmp_path / "run")
    (folder / name).unlink()
    with pytest.raises(FileNotFoundError, match=rf"run: no {pattern}"):
        read(folder)


def test_two_logs_in_one_folder_are_named(tmp_path: Path) -> None:
    (made_logs.mower(tmp_path) / "marker-002-poselog.txt").write_text(pose_row(1.0))
    with pytest.raises(ValueError, match=r"marker-001-poselog\.txt, marker-002-poselog\.txt"):
        read(tmp_path)


def test_ragged_row_is_named_with_its_line(tmp_path: Path) -> None:
    rows = f"{pose_row(10.0)}\n{pose_row(10.01)}\n1 2 3\n"
    with pytest.raises(BAD_TABLE, match=r"poselog\.txt:3: has 3 columns.* 21"):
        read(made_logs.mower(tmp_path, poselog=rows))


def test_file_with_too_few_columns_says_which_one_is_needed(tmp_path: Path) -> None:
    with pytest.raises(BAD_TABLE, match=r"angles\.txt:1: has 2 columns, column 3 is needed"):
        read(made_logs.mower(tmp_path, angles="10.0 1\n"))


def test_word_that_is_no_number_is_named_with_its_line(tmp_path: Path) -> None:
    with pytest.raises(BAD_TABLE, match=r"angles\.txt:2: 'left' is not a number"):
        read(made_logs.mower(tmp_path, angles="10.0 1 0 0 0 0\n10.1 1 left 0 0 0\n"))


@pytest.mark.parametrize(
    ("rows", "message"),
    [
        ("", r"poselog\.txt: holds no rows"),
        (pose_row(np.nan), r"poselog\.txt: data row 1: time is nan, expected a finite number"),
        (
            f"{pose_row(10.0)}\n{pose_row(10.1, right=np.nan)}",
            r"poselog\.txt: data row 2: right wheel travel is nan",
        ),
    ],
)
def test_pose_log_that_cannot_be_used_is_refused(tmp_path: Path, rows: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        read(made_logs.mower(tmp_path, poselog=rows))


@pytest.mark.parametrize(
    ("markers", "message"),
    [
        ("", r"map\.txt: .*empty|map\.txt: .*no marker"),
        ("3 0 0\n4 0 0\n3 1 1\n", r"map\.txt: .*3.*twice"),
        ("3.5 0 0\n", r"map\.txt: data row 1: marker id is 3\.5, expected a whole number"),
        ("3 nan 0\n", r"map\.txt: .*finite"),
    ],
)
def test_map_that_cannot_be_used_is_refused(tmp_path: Path, markers: str, message: str) -> None:
    with pytest.raises(ValueError, match=message):
        read(made_logs.mower(tmp_path, markers=markers))


def test_real_log_comes_whole() -> None:
    log = read(dataset("mower-listing"))
    sent = messages(log.recording)
    assert len(sent["GYRO"]) == len(sent["ENCODERS"]) == 54_900
    assert sum(m.n for m in sent["MARKERS"]) == 184
    assert len(sent["MARKERS"]) == 184 - 17
    first, last = sent["ENCODERS"][0], sent["ENCODERS"][-1]
    assert (first.utime, first.left, first.right) == (1_000_000_000, 0, 0)
    assert (last.utime, last.left, last.right) == (1_548_990_000, 492_351_000, 562_462_500)
    assert all(m.left % 500 == 0 and m.right % 500 == 0 for m in sent["ENCODERS"])
    assert sent["GYRO"][0].rate == 0.00141290131
    assert (sent["MARKERS"][0].utime, sent["MARKERS"][0].sightings[0].id) == (1_008_743_000, 27)
    assert log.truth is not None
    assert len(log.truth) == 54_900
    assert log.truth[0].tolist() == (1_000_000_000, 15.4556614, 13.8350529, 1.9651472)
    assert np.all(np.abs(log.truth["heading"]) <= np.pi)
    assert log.map is not None
    assert log.map.ids.tolist() == list(range(28))


def test_real_log_is_read_quickly() -> None:
    folder = dataset("mower-listing")
    walls = []
    for _ in range(5):
        start = time.perf_counter()
        read(folder)
        walls.append(time.perf_counter() - start)
    # It takes 30 ms; the bound only catches a reader that has lost its fast path.
    assert min(walls) < 0.25
