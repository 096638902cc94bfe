"""Runs of the campaign: the same for any number of processes."""

import os
import signal
from dataclasses import replace

import numpy as np
import pytest

from pilotage.campaign import FaultReport, Task, run_once, run_tasks
from pilotage.evaluate import Outcome
from pilotage.simulate import SCENARIOS, Campaign
from pilotage.simulate.cells import NO_FAULT

CAMPAIGN = Campaign.load()
CELLS = {cell.name: cell for cell in CAMPAIGN.cells}


def test_figures_do_not_depend_on_the_number_of_processes():
    tasks = [Task(NO_FAULT, 3), Task(CELLS["gyro out of order"], 12)]
    seen: list[float] = []
    one = run_tasks("yard", tasks, CAMPAIGN.window, seed=4, jobs=1, progress=seen.append)
    assert seen == [pytest.approx(1 / 3), pytest.approx(2 / 3), 1.0]
    assert run_tasks("yard", tasks, CAMPAIGN.window, seed=4, jobs=2) == one
    assert run_tasks("yard", tasks, CAMPAIGN.window, seed=5) != one
    assert [figures.runs for figures in one] == [3, 12]


def test_without_a_fault_it_is_right_and_says_so():
    outcome = run_once(SCENARIOS["yard"], NO_FAULT, CAMPAIGN.window, (1, 2, 3))
    assert isinstance(outcome, Outcome)
    assert outcome.ok > 0.99
    assert outcome.error_m < 0.1
    assert outcome.said_s == np.inf  # no false alarm
    assert not outcome.silent


def test_without_markers_it_is_not_ok():
    outcome = run_once(SCENARIOS["yard"], CELLS["markers off"], CAMPAIGN.window, (1, 2, 3))
    assert isinstance(outcome, Outcome)
    assert outcome.finite
    assert not outcome.ok_at_end
    assert outcome.again_s < 10.0


def test_another_time_policy_dates_the_failing_input():
    chance = (1, 2, 3)
    cell = CELLS["markers stamp forward"]
    stamped, received = (
        run_once(SCENARIOS["yard"], cell, CAMPAIGN.window, chance, time)
        for time in (None, "receive")
    )
    assert isinstance(stamped, Outcome)
    assert isinstance(received, Outcome)
    assert received.error_m != stamped.error_m


def test_a_crash_is_an_outcome(monkeypatch: pytest.MonkeyPatch):
    def crash(*_: object, **__: object) -> None:
        raise RuntimeError("boom")

    monkeypatch.setattr("pilotage.campaign.running.replay", crash)
    (figures,) = run_tasks("yard", [Task(NO_FAULT, 2)], CAMPAIGN.window)
    assert figures.crashes == 2
    assert "RuntimeError: boom" in figures.crash


def _die(*_: object, **__: object) -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def test_a_process_that_dies_is_told_with_the_cell(monkeypatch: pytest.MonkeyPatch):
    # Workers import the module anew, so what kills them is what they are given to do.
    monkeypatch.setattr("pilotage.campaign.running._run_chunk", _die)
    with pytest.raises(RuntimeError, match="a process died, at or soon after 'gyro off'"):
        run_tasks("yard", [Task(CELLS["gyro off"], 20)], CAMPAIGN.window, jobs=2)


@pytest.mark.parametrize(
    ("arguments", "words"),
    [
        (("square", ""), "no scenario 'square'; there are mower-spiral"),
        (("yard", "xyz"), "no cell has 'xyz' in its name"),
    ],
)
def test_what_cannot_be_run_is_named(arguments: tuple[str, str], words: str):
    scenario, only = arguments
    with pytest.raises(ValueError, match=words):
        FaultReport.make(scenario, runs=1, seed=1, jobs=1, only=only)


def test_a_scenario_that_is_too_short_is_named(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setitem(SCENARIOS, "yard", replace(SCENARIOS["yard"], duration_s=50.0))
    with pytest.raises(ValueError, match=r"'yard' lasts 50 s, but .* need 55 s"):
        FaultReport.make("yard", runs=1, seed=1, jobs=1)
