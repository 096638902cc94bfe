"""What is said of runs that were made by hand."""

from typing import Any

import numpy as np
import pytest

from pilotage.lcmtypes import status_t
from pilotage.montecarlo import MonteCarlo
from pilotage.montecarlo.measures import OF_RUNS
from pilotage.montecarlo.summary import rows, runs_to_look_at, to_dict
from pilotage.montecarlo.trial import NO_POSE, PARTS, Trial

G = 100  # times, 0.1 s apart
OK, LOST = status_t.OK, status_t.LOST


def _result(**changes: Any) -> MonteCarlo:
    """One run that is right, OK and sees two markers in ten frames a second."""
    every = np.arange(G)
    trial: dict[str, Any] = {
        "distance": np.full((1, G), 0.01),
        "heading": np.zeros((1, G)),
        "nees": np.full((1, G), 3.0),
        "status": np.full((1, G), OK, dtype=np.int8),
        "wrong": np.zeros((1, G), dtype=bool),
        "in_view": np.full((1, G), 2),
        "pairs": every[None],
        "triples": every[None],
        "kidnap_index": np.array([G]),
        "nis": np.ones((1, 1, PARTS, 10)),
        "dof": np.ones((1, 1, PARTS, 10)),
    }
    time_s = every * 0.1
    return MonteCarlo("hand", 1, time_s, Trial(**trial | changes), [("eye", ("bearing",))], None)


def _when(first: int, last: int, inside: Any, outside: Any) -> np.ndarray:
    at = np.arange(G)
    return np.where((first <= at) & (at < last), inside, outside)[None]


def _measured(name: str, **changes: Any) -> Any:
    return OF_RUNS[name].of(_result(**changes))


def test_all_is_well():
    assert _measured("rmse_m") == pytest.approx(0.01)
    assert _measured("anees") == pytest.approx(1.0)
    assert _measured("nis") == [1.0]
    assert _measured("lost") == _measured("wrong_ok") == 0.0
    assert _measured("ok") == 1.0
    assert np.isnan(_measured("recovered"))
    assert np.isnan(_measured("over_bound"))


@pytest.mark.parametrize(("first", "lost"), [(40, 0.0), (52, 1.0), (99, 1.0)])
def test_lost_is_far_off_in_the_last_five_seconds(first: int, lost: float):
    assert _measured("lost", distance=_when(first, first + 1, 1.1, 0.01)) == lost


def test_lost_runs_are_named_with_what_shows_one():
    result = _result(distance=np.full((1, G), np.nan))
    (words,) = runs_to_look_at(result, "site.yaml")
    assert words.startswith("lost: 0; ")
    assert "pilotage simulate site.yaml --seed 1 --run 0 -o run-0.lcmlog" in words
    assert "or without a pose in the last 5 s" in str([row.unit for row in rows(result)])


def test_runs_that_were_ok_while_wrong_are_named_as_well():
    (words,) = runs_to_look_at(_result(wrong=_when(30, 32, True, False)), "yard")
    assert words.startswith("OK while wrong: 0; ")
    assert list(runs_to_look_at(_result(), "yard")) == []


def test_the_rmse_is_over_time_of_that_over_the_runs_with_a_pose():
    distance = np.full((2, G), 0.3)
    distance[1, 50:] = np.nan
    distance[0, 50:] = 0.1
    result = _result(distance=distance)
    assert OF_RUNS["rmse_m"].of(result) == pytest.approx(np.sqrt((0.3**2 + 0.1**2) / 2))


def test_nees_is_held_against_the_band_of_the_runs_that_are_known_then():
    nees = np.full((40, G), 3.0 * 1.3)  # within the band of ten runs, not of forty
    nees[10:, 50:] = np.nan
    result = _result(nees=nees)
    assert result.nees.inside == pytest.approx(0.5)
    assert result.nees.low[0] > result.nees.low[-1]
    assert to_dict(result)["anees_in_band"] == pytest.approx(0.5)
    assert ("  in its band", "50.0") in [row[:2] for row in rows(result)]


def test_all_of_it_is_in_the_file():
    content = to_dict(
        _result(
            kidnap_index=np.array([30]),
            status=_when(32, 60, LOST, OK).astype(np.int8),
            wrong=_when(30, 35, True, False),
        )
    )
    assert content["first_ok_s"] == [0.0]
    assert content["recovery_s"] == [pytest.approx(3.0)]
    assert content["wrong_ok_runs"] == [0]
    assert content["wrong_ok_time"] == pytest.approx(0.02)
    eye = content["nis"]["eye"]
    assert eye["mean"] == 1.0
    assert eye["over_time"]["time_s"][:2] == [0.5, 1.5]
    assert eye["over_time"]["nis"] == [1.0] * 10
    assert eye["over_time"]["low"][0] < 1.0 < eye["over_time"]["high"][0]


@pytest.mark.parametrize(
    ("ok_again", "pairs_seen", "recovered"),
    [(60, 2, 1.0), (80, 2, 1.0), (95, 2, 0.0), (85, 1, 1.0), (100, 2, 0.0)],
)
def test_recovery_counts_the_time_with_two_markers_in_view(ok_again, pairs_seen, recovered):
    status = _when(32, ok_again, LOST, OK).astype(np.int8)
    wrong = _when(30, min(ok_again, 60), True, False)
    changes = {
        "status": status,
        "wrong": wrong,
        "kidnap_index": np.array([30]),
        "in_view": np.full((1, G), pairs_seen),
    }
    assert _measured("recovered", **changes) == recovered


@pytest.mark.parametrize(("not_ok_from", "honest"), [(32, 1.0), (33, 1.0), (36, 0.0)])
def test_from_the_third_pair_on_it_may_not_be_ok(not_ok_from: int, honest: float):
    changes = {
        "status": _when(not_ok_from, 60, LOST, OK).astype(np.int8),
        "wrong": _when(30, 60, True, False),
        "kidnap_index": np.array([30]),
    }
    assert _measured("honest", **changes) == honest


@pytest.mark.parametrize(
    ("first_ok", "wrong", "right_or_undecided", "decided"),
    [(8, False, 1.0, 1.0), (20, False, 1.0, 0.0), (8, True, 0.0, 0.0), (G, False, 1.0, 0.0)],
)
def test_a_start_is_decided_by_its_first_ok(first_ok, wrong, right_or_undecided, decided):
    changes = {
        "status": _when(first_ok, G, OK, NO_POSE).astype(np.int8),
        "wrong": np.full((1, G), wrong),
    }
    assert _measured("right_or_undecided", **changes) == right_or_undecided
    assert _measured("decided", **changes) == decided


def test_ambiguous_is_so_to_the_end_and_never_ok():
    ambiguous = np.full((1, G), status_t.AMBIGUOUS, dtype=np.int8)
    assert _measured("ambiguous", status=ambiguous) == 1.0
    assert _measured("ambiguous", status=_when(5, 6, OK, ambiguous[0]).astype(np.int8)) == 0.0
