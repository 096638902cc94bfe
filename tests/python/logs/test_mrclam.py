from pathlib import Path

import numpy as np
import pytest

from pilotage.logs import read
from support import made_logs
from support.datasets import dataset
from support.messages import messages


def test_commanded_velocity_holds_until_the_next_row(tmp_path: Path) -> None:
    sent = messages(read(made_logs.mrclam(tmp_path)).recording)["VELOCITY"]
    # velocity_t states the mean since the row before; the first only opens the interval.
    assert [(m.utime, m.v, m.omega) for m in sent] == [
        (100_000_000, 0.1, 0.2),
        (100_500_000, 0.1, 0.2),
        (101_000_000, 0.3, 0.4),
    ]


def test_barcodes_become_subjects(tmp_path: Path) -> None:
    log = read(made_logs.mrclam(tmp_path))
    frames = messages(log.recording)["MARKERS"]
    assert [[s.id for s in f.sightings] for f in frames] == [[6, 1], [1099]]
    first = frames[0].sightings[0]
    assert (frames[0].sensor, first.range, first.bearing) == ("camera", 2.0, 0.1)
    assert np.isnan(first.elevation)
    assert log.map is not None
    assert log.map.ids.tolist() == [6, 7]
    assert log.map.positions[0].tolist() == [1.0, 2.0, 0.0]
    assert log.map.sigmas.tolist() == pytest.approx([np.sqrt(12.5e-6), 0.0])


def test_barcode_that_is_not_listed_is_told_to_the_user(tmp_path: Path) -> None:
    (note,) = read(made_logs.mrclam(tmp_path)).notes
    assert "Robot1_Measurement.dat: 1 sightings" in note
    assert "(99)" in note


def test_truth_heading_is_wrapped(tmp_path: Path) -> None:
    truth = read(made_logs.mrclam(tmp_path)).truth
    assert truth is not None
    assert truth[0].tolist() == pytest.approx((99_500_000, 1.0, 2.0, 7.0 - 2 * np.pi))


def test_robot_must_be_chosen_among_several(tmp_path: Path) -> None:
    folder = made_logs.mrclam(tmp_path, robots=(2, 11))
    assert len(read(folder, robot=11).recording) == 5
    with pytest.raises(ValueError, match=r"has robot 2, 11: say which one"):
        read(folder)
    with pytest.raises(ValueError, match=r"has robot 2, 11, not 3"):
        read(folder, robot=3)


def test_velocity_that_is_not_a_number_is_left_to_the_localizer_to_count(tmp_path: Path) -> None:
    log = read(made_logs.mrclam(tmp_path, odometry="100.0 nan 0.2\n100.5 0.3 0.4\n"))
    sent = messages(log.recording)["VELOCITY"]
    assert [np.isnan(m.v) for m in sent] == [True, True]


@pytest.mark.parametrize(
    "name",
    [
        "Barcodes.dat",
        "Landmark_Groundtruth.dat",
        "Robot1_Measurement.dat",
        "Robot1_Groundtruth.dat",
    ],
)
def test_missing_file_is_named_with_its_folder(tmp_path: Path, name: str) -> None:
    folder = made_logs.mrclam(tmp_path / "data")
    (folder / name).unlink()
    with pytest.raises(FileNotFoundError, match=rf"data: no {name}"):
        read(folder)


def test_folder_without_any_robot_says_what_is_missing(tmp_path: Path) -> None:
    folder = made_logs.mrclam(tmp_path, robots=())
    with pytest.raises(FileNotFoundError, match=r"no Robot<N>_Odometry\.dat"):
        read(folder)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"odometry": "# nothing\n"}, r"Robot1_Odometry\.dat: holds no rows"),
        ({"odometry": "nan 0 0\n"}, r"Odometry\.dat: data row 1: time is nan"),
        ({"measurement": "1 2.5 1 1\n"}, r"Measurement\.dat: data row 1: barcode is 2\.5"),
        ({"measurement": "1 -5 1 1\n"}, r"Measurement\.dat: data row 1: no barcode is -5"),
        ({"barcodes": "6 63\n7 63\n"}, r"Barcodes\.dat: barcode 63 stands for subjects 6 and 7"),
        ({"landmarks": "6 0 0 0 0\n6 1 1 0 0\n"}, r"Landmark_Groundtruth\.dat: .*6.*twice"),
    ],
)
def test_file_that_cannot_be_used_is_refused(
    tmp_path: Path, change: dict[str, str], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        read(made_logs.mrclam(tmp_path, **change))


@pytest.mark.parametrize(
    ("robot", "motions", "sightings", "truths", "unlisted"),
    [(1, 61_785, 1_942, 49_241, 1), (2, 65_005, 4_031, 59_705, 0), (3, 61_158, 5_627, 56_977, 2)],
)
def test_real_robot_comes_whole(
    robot: int, motions: int, sightings: int, truths: int, unlisted: int
) -> None:
    log = read(dataset("mrclam"), robot=robot)
    sent = messages(log.recording)
    assert len(sent["VELOCITY"]) == motions
    ids = [s.id for f in sent["MARKERS"] for s in f.sightings]
    assert len(ids) == sightings
    assert sum(i > 20 for i in ids) == unlisted
    assert set(range(6, 21)) <= set(ids)
    assert log.truth is not None
    assert len(log.truth) == truths
    assert log.truth["utime"][0] == 1_248_444_175_103_000
    assert log.map is not None
    assert log.map.ids.tolist() == list(range(6, 21))
    assert log.map.positions[0].tolist() == [0.58831396, -4.28264845, 0.0]


def test_real_sighting_is_the_one_in_the_file() -> None:
    frame = messages(read(dataset("mrclam"), robot=3).recording)["MARKERS"][0]
    # Barcodes 63, 81 and 7 are subjects 6, 7 and 8.
    assert frame.utime == 1_248_444_188_862_000
    assert [(s.id, s.range, s.bearing) for s in frame.sightings][:3] == [
        (6, 7.051, -0.036),
        (7, 7.234, -0.017),
        (8, 7.427, 0.010),
    ]
