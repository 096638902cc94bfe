"""The study of the echoes, the transform and the square, shortened."""

import json

import numpy as np
import pytest

from pilotage import EchoEnvelope
from pilotage.simulate.skid_steer import square_lap
from pilotage.studies import tamas_echo, tamas_robot, tamas_square
from pilotage.studies.study import Request, find_study


@pytest.fixture(scope="module")
def findings():
    return find_study("tamas").run(Request(effort=0.05, jobs=2))


def test_results_tables_and_figures_are_there(findings, tmp_path):
    names = {path.name for path in findings.save(tmp_path)}
    figures = {"figure-2", "figure-4", "figure-5", "figure-6", "figure-7", "time-of-flight"}
    assert names == {"results.json"} | {f"{name}.png" for name in figures}
    stored = json.loads((tmp_path / "results.json").read_text())
    assert stored["tables"][0]["title"] == "What it must show"
    assert all(table["rows"] for table in stored["tables"])
    assert set(stored["results"]) >= {"transform", "time_of_flight_s", "square", "ratio_at_10_db"}


def test_the_unscented_transform_meets_its_bars(findings):
    transform = findings.results["transform"]
    assert transform["ut_1"]["mean"] <= 0.001
    assert max(transform["ut_1"]["var"]) <= 0.06
    assert transform["linear"]["var"][1] > 0.8
    # The paper's figure 2 has the true mean at (0, 1), which is where the linear one puts it.
    assert transform["linear"]["mean"] == pytest.approx(0.035, abs=0.001)


def test_the_filter_beats_the_threshold_at_10_db_and_keeps_to_the_bound():
    case = tamas_echo.Case(10.0)
    errors = []
    for k in range(300):
        rng = np.random.default_rng((7, k))
        flight, samples = tamas_echo.record(case, rng)
        crossing, state = tamas_echo.estimate(case, samples, rng)
        begin = state[1] - tamas_echo.receiver(case.band_hz)[1].lead_s
        errors.append((crossing - flight, begin - flight))
    crossing, begin = np.transpose(errors)
    rmse = np.sqrt(np.mean(begin**2))
    assert rmse <= 0.8 * crossing.std()
    assert 0.9 * case.bound(0.0) < rmse < 1.2 * case.bound(0.0)


def test_all_four_parameters_stand_between_their_bounds_at_10_db(findings):
    cases = tamas_echo.SNR_DB.index(10)
    ukf = findings.results["time_of_flight_s"]["all four"][cases]["ukf"]
    bounds = findings.results["bound_s"]
    assert 0.5 * bounds["0.2"][cases] < ukf < 1.2 * bounds["inf"][cases]


def test_the_rise_alone_stands_a_second_echo_close_behind(findings):
    found = findings.results["time_of_flight_s"]
    close = tamas_echo.DELAYS_S.index(0.2e-3)
    assert found["rise"][close]["ukf"] < 0.7 * found["rise"][close]["threshold"]
    assert found["rise"][close]["ukf"] < 0.5 * found["whole"][close]["ukf"]


def test_the_error_of_the_range_grows_with_the_distance(findings):
    errors = [e["ukf"] for e in findings.results["time_of_flight_s"]["distances"]]
    assert errors[::4] == sorted(errors[::4])
    assert errors[-1] > 10 * errors[0]


def test_the_envelope_falls_after_its_peak_as_its_printed_exponent_does_not():
    state = tamas_echo.PAIR.state(2.0, 1e-3)
    peak = state[1] + state[3] * state[2]
    around = EchoEnvelope.at_times(state, peak + np.array([-1e-4, 0.0, 1e-4, 5e-3]))
    assert around[1] == pytest.approx(2.0)
    assert around[0] < 2.0
    assert around[2] < 2.0
    assert around[3] < 1e-6


def test_the_printed_arctan_loses_a_third_of_a_corner_read_at_once():
    start, none, corner = np.zeros(3), np.zeros(1), np.array([np.pi / 2])
    printed = tamas_square.turn_then_move(start, none, np.arctan(corner))[-1, 2]
    assert np.degrees(printed) == pytest.approx(57.5, abs=0.05)
    assert np.degrees(tamas_square.turn_then_move(start, none, corner)[-1, 2]) == pytest.approx(90)


def test_printed_odometry_fails_on_a_robot_that_the_mended_one_follows(findings):
    lost, printed, no_arctan, midpoint = findings.results["printed_odometry"]["0.5 s"]
    assert lost > 3.0
    assert printed > 10 * no_arctan
    assert max(no_arctan, midpoint) < 5.0
    exact = findings.results["printed_odometry"]["0.1 s"]
    assert exact[2] < 0.1
    assert exact[3] < 0.1


def test_coefficients_come_back_from_a_drive(findings):
    pair = findings.results["coefficients"]
    assert np.abs(pair["fitted"] - pair["true"]).max() < 0.02


def test_a_black_wall_is_misread_by_the_white_curve(findings):
    assert max(by_own for _, by_own in findings.results["infrared"].values()) < 0.04
    assert findings.results["infrared"]["white"][0] < 0.05
    assert findings.results["infrared"]["black"][0] > 1.0


def test_each_step_on_the_square_brings_something():
    known = tamas_robot.measure_robot(np.random.default_rng(3))
    each = np.array([tamas_robot.one_run(3, k, known) for k in range(6)])
    lap = square_lap(tamas_robot.ROBOT, np.random.default_rng(0))
    names = list(tamas_robot.paths(lap, known))
    rms = dict(zip(names, np.sqrt(np.mean(each[:, :, 0] ** 2, axis=0)), strict=True))
    nees = dict(zip(names, each[:, :, 3].mean(axis=0), strict=True))
    assert rms["skid steering, 29–30"] < 0.5 * rms["odometry, 31–35"]
    linear = next(name for name in names if "LKF" in name)
    assert rms[linear] < 0.5 * rms["gyro and compass, 36–37"]
    for kind in ("EKF", "UKF"):
        assert rms[f"{kind}: + Q at corners"] < 0.5 * rms[linear]
        assert rms[f"{kind}: + Q at corners"] < 0.015
        assert nees[f"{kind}: R by distance"] > 1.5
        assert 0.6 < nees[f"{kind}: + Q at corners"] < 1.5
        assert rms[f"{kind}: + infrared"] < 1.05 * rms[f"{kind}: + Q at corners"]


def test_the_number_of_processes_changes_nothing():
    known = tamas_robot.measure_robot(np.random.default_rng(1))
    one, two = (
        tamas_robot.laps(Request(seed=4, effort=0.03, jobs=jobs), known).results for jobs in (1, 2)
    )
    np.testing.assert_equal(one, two)
