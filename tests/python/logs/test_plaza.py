from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from numpy.typing import ArrayLike

from pilotage.logs import read
from support import made_logs
from support.datasets import dataset
from support.messages import messages


def test_increments_become_means_over_the_interval_before_their_stamp(tmp_path: Path) -> None:
    sent = messages(read(made_logs.plaza(tmp_path / "a.mat")).recording)["VELOCITY"]
    assert [m.utime for m in sent] == [10_000_000, 10_200_000, 10_700_000]
    # The first row only opens an interval; it stands over the usual period.
    assert [m.v for m in sent] == pytest.approx([0.1 / 0.35, 1.0, 1.0])
    assert [m.omega for m in sent] == pytest.approx([0.0, 0.1, -0.02])


def test_ranges_come_alone_and_with_the_beacons_own_numbers(tmp_path: Path) -> None:
    log = read(made_logs.plaza(tmp_path / "a.mat"))
    frames = messages(log.recording)["MARKERS"]
    assert [(f.utime, f.sensor, f.sightings[0].id, f.sightings[0].range) for f in frames] == [
        (10_100_000, "radio", 5, 7.5),
        (10_300_000, "radio", 0, 8.5),
    ]
    assert np.isnan(frames[0].sightings[0].bearing)
    assert log.map is not None
    assert log.map.ids.tolist() == [0, 5]
    assert log.notes == ()


def test_ranges_between_beacons_are_left_out_and_the_user_is_told(tmp_path: Path) -> None:
    path = made_logs.plaza(tmp_path / "a.mat", TD=[[10.1, 2, 5, 7.5], [10.2, 0, 5, 3.0]])
    log = read(path)
    assert len(messages(log.recording)["MARKERS"]) == 1
    assert any("1 ranges between beacons were left out" in note for note in log.notes)


def test_ranges_out_of_order_are_put_in_order_and_the_user_is_told(tmp_path: Path) -> None:
    path = made_logs.plaza(tmp_path / "a.mat", TD=[[10.5, 2, 5, 7.5], [10.1, 2, 0, 8.5]])
    log = read(path)
    assert [f.utime for f in messages(log.recording)["MARKERS"]] == [10_100_000, 10_500_000]
    assert any("TD: time goes back at 1 data rows" in note for note in log.notes)


def test_truth_that_drives_backwards_is_turned_and_the_user_is_told(tmp_path: Path) -> None:
    """Of the published runs one states its heading so."""
    backwards = [[9.8, 0, 0, 3.0], [10.0, -0.1, 0, -0.1], [10.2, -0.3, 0, 0.1]]
    log = read(made_logs.plaza(tmp_path / "a.mat", GT=backwards))
    assert log.truth is not None
    assert log.truth["heading"].tolist() == pytest.approx([3.0 - np.pi, np.pi - 0.1, 0.1 - np.pi])
    assert any("it was turned" in note for note in log.notes)


def test_names_with_the_run_before_them_are_understood(tmp_path: Path) -> None:
    log = read(made_logs.plaza(tmp_path / "a.mat", prefix="Gesling1_"))
    assert (log.kind, len(log.recording)) == ("plaza", 5)


@pytest.mark.parametrize(
    ("change", "message"),
    [
        ({"DR": None, "GT": None}, r"a\.mat: lacks the variables GT, DR; it has TD, TL"),
        ({"TD": [[1.0, 2.0, 3.0]]}, r"variable TD has shape \(1, 3\), expected \(n, 4\)"),
        ({"DR": [[10.0, 0, 0]]}, r"a\.mat: DR has 1 rows, expected 2 or more"),
        (
            {"DR": [[10.0, 0, 0], [10.2, 0, 0], [10.2, 0, 0]]},
            r"a\.mat: DR: data row 3: time does not increase",
        ),
        ({"TD": [[np.nan, 2, 5, 7.5]]}, r"a\.mat: TD: data row 1: time is nan"),
        ({"TL": [[5.0, 0, 0], [5.0, 1, 1]]}, r"a\.mat: TL: .*5.*twice"),
        ({"TL": [[0.5, 0, 0]]}, r"a\.mat: TL: data row 1: beacon is 0\.5"),
    ],
)
def test_variable_that_cannot_be_used_is_named(
    tmp_path: Path, change: dict[str, ArrayLike | None], message: str
) -> None:
    with pytest.raises(ValueError, match=message):
        read(made_logs.plaza(tmp_path / "a.mat", **change))


def test_real_log_comes_whole() -> None:
    log = read(dataset("plaza"))
    sent = messages(log.recording)
    assert len(sent["VELOCITY"]) == 9_657
    assert len(sent["MARKERS"]) == 3_529
    assert {s.id for f in sent["MARKERS"] for s in f.sightings} == {0, 1, 5, 6}
    first = sent["MARKERS"][0]
    assert (first.utime, first.sightings[0].id) == (3_858_062_000, 5)
    assert first.sightings[0].range == pytest.approx(65.4660078, abs=1e-7)
    assert log.truth is not None
    assert len(log.truth) == 9_658
    assert (log.truth["utime"][-1] - log.truth["utime"][0]) * 1e-6 == pytest.approx(1933.441909)
    assert log.map is not None
    assert log.map.positions[0].tolist() == pytest.approx([-46.623234, 11.025549, 0.0])
    (note,) = log.notes  # about the ranges; the truth's heading points ahead in this run
    assert "TD: time goes back at 2 data rows, first at row 1989 by 64.375 s" in note


def test_real_turns_add_up_to_the_truths_heading() -> None:
    log = read(dataset("plaza"))
    sent = messages(log.recording)["VELOCITY"]
    assert log.truth is not None
    turned = np.cumsum([m.omega * (m.utime - k.utime) * 1e-6 for k, m in pairwise(sent)])
    heading = np.unwrap(log.truth["heading"])
    np.testing.assert_allclose(turned, heading[2:] - heading[1], atol=1e-5)
