"""Many runs: the same for any number of processes, consistent, and what is lost is said."""

import json
import os
import signal
from dataclasses import fields, replace

import numpy as np
import pytest

import pilotage
from pilotage.evaluate import pose_errors
from pilotage.montecarlo import find_scenario, run_montecarlo, simulate_run
from pilotage.montecarlo.summary import rows, to_dict
from pilotage.montecarlo.trial import chance, run_trial
from pilotage.simulate import Kidnap, Scenario, Start

SHORT = replace(find_scenario("nominal"), duration_s=12.0)


def _short(**changes) -> Scenario:
    return replace(SHORT, **changes)


def test_numbers_do_not_depend_on_the_number_of_processes():
    seen: list[float] = []
    one = run_montecarlo(SHORT, 25, seed=4, jobs=1, progress=seen.append)
    two = run_montecarlo(SHORT, 25, seed=4, jobs=2)
    for field in fields(one.trials):
        np.testing.assert_array_equal(
            getattr(one.trials, field.name), getattr(two.trials, field.name)
        )
    assert to_dict(one) == to_dict(two)
    assert seen == [0.5, 1.0]
    assert (run_montecarlo(SHORT, 25, seed=5).position_m != one.position_m).any()


def test_more_runs_begin_with_the_same_ones():
    few, more = (run_montecarlo(SHORT, runs, seed=4) for runs in (2, 3))
    np.testing.assert_array_equal(few.trials.distance, more.trials.distance[:2])


def test_nominal_runs_are_consistent_and_near_the_bound():
    result = run_montecarlo(find_scenario("nominal"), 40, jobs=2)
    assert result.bound is not None
    assert result.nees.mean == pytest.approx(1.0, abs=0.15)
    assert result.nis["scanner"].mean == pytest.approx(1.0, abs=0.05)
    late = result.time_s > 10.0
    ratio = result.position_m[late] / result.bound.position_m[late]
    assert ratio.mean() == pytest.approx(1.05, abs=0.12)
    assert len(result.lost) == 0
    assert not result.wrong_ok.any()


def test_a_run_can_be_looked_at_by_itself():
    result = run_montecarlo(SHORT, 3, seed=8)
    simulation = simulate_run(SHORT, 8, 2)
    run = pilotage.replay(simulation.config, simulation.recording)
    errors = pose_errors(run.poses, simulation.truth)
    np.testing.assert_allclose(errors.distance[::10], result.trials.distance[2], atol=1e-12)


def test_the_bound_is_of_any_order_of_components_and_before_the_runs(monkeypatch):
    (scanner,) = SHORT.cameras
    turned = replace(scanner, components=("range", "bearing"), sigma=(0.02, 0.0, 0.05))
    assert turned.components == ("bearing", "range")
    monkeypatch.setattr("pilotage.montecarlo.running.Bound.of", _no_bound)
    with pytest.raises(ValueError, match="no bound, and nothing run"):
        run_montecarlo(_short(cameras=(turned,)), 10**9)


def _no_bound(*_: object) -> None:
    raise ValueError("no bound, and nothing run")


def test_frames_count_when_they_arrive_but_those_before_a_kidnap_as_captured():
    late = replace(
        SHORT, start=Start(), latency_s=0.5, kidnap=Kidnap(at_s=(6.0, 6.0), turn_rad=(1.0, 1.0))
    )
    trial = run_trial(late, chance(1, 0))
    prompt = run_trial(replace(late, latency_s=0.0), chance(1, 0))
    k = trial.kidnap_index
    np.testing.assert_array_equal(trial.pairs[: k + 1], prompt.pairs[: k + 1])
    assert (trial.pairs[k : k + 5] == trial.pairs[k]).all()  # none tells of the kidnap yet
    np.testing.assert_array_equal(trial.pairs[k + 6 :], prompt.pairs[k + 1 : -5])
    unmoved = run_trial(replace(late, kidnap=None), chance(1, 0))
    np.testing.assert_array_equal(unmoved.triples[5:20], prompt.triples[:15])


def test_each_component_has_its_nis_and_so_has_the_whole():
    (scanner,) = SHORT.cameras
    both = replace(scanner, components=("bearing", "range"), sigma=(0.02, 0.0, 0.05))
    result = run_montecarlo(_short(cameras=(both,)), 20)
    assert list(result.nis) == ["scanner", "scanner bearing", "scanner range"]
    for nis in result.nis.values():
        assert nis.mean == pytest.approx(1.0, abs=0.1)
        assert nis.band[0] < 1.0 < nis.band[1]
        assert len(nis.over_time) == 13


def test_without_a_pose_nothing_is_claimed():
    start = Start(known=False, x_m=(-2.0, 2.0), y_m=(-2.0, 2.0))
    result = run_montecarlo(_short(start=start), 2)
    assert result.bound is None
    content = to_dict(result)
    assert content["over_bound"] is None
    assert content["right_or_undecided"] == 1.0
    json.dumps(content, allow_nan=False)
    assert "position RMSE" in [row.label for row in rows(result)]


def test_what_sees_nothing_and_slips_away_is_lost():
    (scanner,) = SHORT.cameras
    blind = replace(scanner, reach_m=0.1)
    start = Start(sigma_position_m=5.0)
    result = run_montecarlo(_short(cameras=(blind,), start=start), 3)
    assert result.lost.tolist() == [0, 1, 2]
    assert result.nis == {}


def test_a_kidnap_is_noticed_and_recovered_from():
    (scanner,) = SHORT.cameras
    kidnap = Kidnap(at_s=(6.0, 7.0), distance_m=(3.0, 4.0))
    scenario = _short(
        duration_s=30.0, cameras=(replace(scanner, half_view_rad=3.1),), kidnap=kidnap
    )
    result = run_montecarlo(scenario, 4)
    assert result.bound is None
    assert (result.trials.distance[:, 59] < 0.5).all()
    assert (result.trials.distance[:, 60:72].max(axis=1) > 2.0).all()
    assert result.kidnapped
    assert (result.recovery_s > 0.0).all()


def _die(*_: object) -> None:
    os.kill(os.getpid(), signal.SIGKILL)


def test_a_process_that_dies_is_told_with_the_run(monkeypatch: pytest.MonkeyPatch):
    monkeypatch.setattr("pilotage.montecarlo.running._run_chunk", _die)
    with pytest.raises(RuntimeError, match="a process died, at or soon after run 0 of 'nominal'"):
        run_montecarlo(SHORT, 30, jobs=2)
