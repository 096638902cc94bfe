from pathlib import Path

import numpy as np
import pytest
from numpy.typing import ArrayLike

from pilotage.logs import read
from support import made_logs
from support.datasets import dataset
from support.messages import messages


def test_velocity_holds_until_the_next_row(tmp_path: Path) -> None:
    sent = messages(read(made_logs.woods(tmp_path / "a.mat")).recording)["VELOCITY"]
    assert [(m.utime, m.v, m.omega) for m in sent] == [
        (0, 1.0, 0.1),
        (100_000, 1.0, 0.1),
        (200_000, 2.0, 0.2),
    ]


def test_zero_range_is_a_landmark_not_seen(tmp_path: Path) -> None:
    frames = messages(read(made_logs.woods(tmp_path / "a.mat")).recording)["MARKERS"]
    assert [
        (f.utime, f.sensor, [(s.id, s.range, s.bearing) for s in f.sightings]) for f in frames
    ] == [
        (0, "laser", [(2, 5.0, 0.5)]),
        (200_000, "laser", [(1, 2.0, -0.5), (2, 4.0, 0.0)]),
    ]


def test_range_that_is_not_a_number_leaves_the_bearing(tmp_path: Path) -> None:
    path = made_logs.woods(tmp_path / "a.mat", r=[[0, np.nan], [0, 0], [0, 0]])
    (frame,) = messages(read(path).recording)["MARKERS"]
    assert frame.sightings[0].bearing == 0.5
    assert np.isnan(frame.sightings[0].range)


def test_truth_is_left_out_where_it_is_not_valid(tmp_path: Path) -> None:
    truth = read(made_logs.woods(tmp_path / "a.mat")).truth
    assert truth is not None
    assert truth["utime"].tolist() == [0, 200_000]
    assert truth["heading"].tolist() == pytest.approx([0.0, 7.0 - 2 * np.pi])


def test_landmarks_are_counted_from_one(tmp_path: Path) -> None:
    markers = read(made_logs.woods(tmp_path / "a.mat")).map
    assert markers is not None
    assert markers.ids.tolist() == [1, 2]
    assert markers.positions.tolist() == [[1.0, 2.0, 0.0], [3.0, 4.0, 0.0]]


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"om": None, "v": None}, r"a\.mat: lacks the variables v, om; it has .*true_valid"),
        ({"v": [[1.0], [2.0]]}, r"a\.mat: variable v has shape \(2,\), expected \(3,\)"),
        ({"r": np.ones((3, 3))}, r"variable r has shape \(3, 3\), expected \(3, 2\)"),
        ({"l": np.ones((2, 3))}, r"variable l has shape \(2, 3\), expected \(2, 2\)"),
        ({"t": [[0.0], [np.nan], [0.2]]}, r"a\.mat: t: data row 2: time is nan"),
        ({"l": [[1.0, np.nan], [0.0, 0.0]]}, r"a\.mat: l: .*finite"),
    ],
)
def test_variable_that_cannot_be_used_is_named(
    tmp_path: Path, change: dict[str, ArrayLike | None], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        read(made_logs.woods(tmp_path / "a.mat", **change))


def test_file_without_landmarks_is_refused(tmp_path: Path) -> None:
    nothing = np.zeros((3, 0))
    path = made_logs.woods(tmp_path / "a.mat", l=np.zeros((0, 2)), r=nothing, b=nothing)
    with pytest.raises(ValueError, match=r"a\.mat: l: "):
        read(path)


def test_real_log_comes_whole() -> None:
    log = read(dataset("lost-in-the-woods"))
    assert (log.kind, log.notes) == ("woods", ())
    sent = messages(log.recording)
    assert len(sent["VELOCITY"]) == 12_609
    assert (sent["VELOCITY"][-1].utime, sent["VELOCITY"][0].v) == (
        1_260_800_000,
        pytest.approx(-0.02213944, abs=1e-8),
    )
    assert sum(f.n for f in sent["MARKERS"]) == 61_086
    assert {s.id for f in sent["MARKERS"] for s in f.sightings} == set(range(1, 18))
    first = sent["MARKERS"][0]
    assert [s.id for s in first.sightings] == [10, 11, 12, 13, 14, 15, 16]
    assert first.sightings[0].range == pytest.approx(1.37430716, abs=1e-8)
    assert log.truth is not None
    assert len(log.truth) == 12_278
    assert log.map is not None
    assert len(log.map) == 17


def test_real_velocity_belongs_to_the_interval_before_its_stamp() -> None:
    """The truth turns as the messages say: it would do so less one period earlier or later."""
    log = read(dataset("lost-in-the-woods"))
    assert log.truth is not None
    turn = np.diff(np.unwrap(log.truth["heading"]))
    whole = np.diff(log.truth["utime"]) == 100_000
    rate = {m.utime: m.omega for m in messages(log.recording)["VELOCITY"]}
    match = [
        np.corrcoef(
            turn[whole],
            [rate.get(int(t) + shift, 0.0) for t in log.truth["utime"][1:][whole]],
        )[0, 1]
        for shift in (-100_000, 0, 100_000)
    ]
    assert match[1] == max(match)
