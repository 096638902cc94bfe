"""The committed bars, and how they are judged."""

import json
from pathlib import Path

import numpy as np
import pytest

from pilotage.montecarlo.bars import Bar, bar_rows, bar_scenario, changed, find_scenario
from pilotage.montecarlo.gate import false_rejects
from pilotage.montecarlo.judging import judge
from pilotage.montecarlo.measures import OF_RUNS

DRIVEN = [name for name, row in bar_rows().items() if row.change is not None]


@pytest.mark.parametrize("name", DRIVEN)
def test_every_row_has_a_scenario_and_a_bar(name: str):
    row = bar_rows()[name]
    assert find_scenario(name).name == name
    assert row.what
    assert row.bars
    if any("reference" in measure for measure in row.bars):
        assert row.reference is not None
        bar_scenario(row.reference, name)


def test_priors_are_those_that_are_agreed_upon():
    position, heading = find_scenario("nominal").prior()
    assert position == 0.1
    assert np.degrees(heading) == pytest.approx(3.0, abs=1e-3)


def test_ten_markers_stand_in_no_symmetric_way_and_one_to_four_are_in_view():
    scenario = find_scenario("nominal")
    markers = scenario.site(np.random.default_rng(0))
    assert len(markers) == 10
    drive = scenario.drive(scenario.duration_s)
    (scanner,) = scenario.cameras
    in_view = scanner.in_view(scanner.look_at_all(drive, markers, drive.utime)).sum(axis=1)
    assert in_view.min() == 1
    assert in_view.max() == 4


def test_a_change_reaches_into_parts_and_takes_out_what_is_null():
    base = {"a": {"b": 1, "c": 2}, "d": 3, "e": [1]}
    assert changed(base, {"a": {"b": 5}, "d": None, "e": [2, 3]}) == {
        "a": {"b": 5, "c": 2},
        "e": [2, 3],
    }
    assert base["d"] == 3


@pytest.mark.parametrize(
    ("bar", "values", "met", "words"),
    [
        (Bar(max=1.1), [1.1], True, "≤ 1.100"),
        (Bar(max=1.1), [1.0, 1.2], False, "≤ 1.100"),
        (Bar(min=2.0), [2.5], True, "≥ 2.000"),
        (Bar(0.95, 1.06), [0.94], False, "0.950 to 1.060"),
        (Bar(max=1.1), [float("nan")], False, "≤ 1.100"),
    ],
)
def test_a_bar(bar: Bar, values: list[float], met: bool, words: str):
    assert bar.met(values) == met
    assert bar.text(OF_RUNS["anees"]) == words


def test_rows_are_judged_and_saved(tmp_path: Path):
    verdict = judge("outliers-5-bearing", runs=2, seed=1, jobs=1, folder=tmp_path)
    assert [line[0] for line in verdict.table()] == ["row", "outliers-5-bearing", ""]
    content = json.loads((tmp_path / "bars.json").read_text())
    assert content["runs"] == 2
    assert content["judgements"][0]["measure"] == "position RMSE / reference"
    assert (tmp_path / "outliers-5-bearing" / "montecarlo.json").is_file()
    assert verdict.met == all(line[-1] == "met" for line in verdict.table()[1:])


def test_a_key_that_the_configuration_does_not_have_is_an_error(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setitem(bar_rows()["outliers-5-id"].change, "config", {"no.such_key": 1})
    with pytest.raises(ValueError, match=r"outliers-5-id: config: .*no\.such_key"):
        judge("outliers-5-id", runs=1, seed=1, jobs=1)


def test_an_error_of_a_run_is_not_taken_for_one_of_its_row(monkeypatch: pytest.MonkeyPatch):
    def fail(*_: object) -> None:
        raise KeyError("of a programmer")

    monkeypatch.setattr("pilotage.montecarlo.judging.run_montecarlo", fail)
    with pytest.raises(KeyError, match="of a programmer"):
        judge("nominal", runs=1, seed=1, jobs=1)


def test_the_gate_rejects_as_many_as_it_says():
    for dof in (1, 2, 3):
        share = false_rejects(dof, 300_000, np.random.default_rng(0))
        assert share == pytest.approx(1.0, abs=0.25)


def test_a_row_that_is_not_there_is_named_with_those_that_are():
    with pytest.raises(ValueError, match="no row has 'square' in its name; there are nominal, "):
        judge("square", runs=1, seed=1, jobs=1)
