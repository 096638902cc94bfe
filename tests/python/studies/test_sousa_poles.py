"""Odometry and coloured poles: the paper's filter, what misprints do to it, and the bump."""

import json
from dataclasses import replace

import numpy as np
import pytest

from pilotage import Config, Localizer, RelativePosition
from pilotage.evaluate import pose_errors
from pilotage.evaluate.courses import Courses
from pilotage.lcmtypes import marker_frame_t, status_t
from pilotage.simulate.pole_runs import CAMERA, RUNS, static_errors
from pilotage.simulate.poles import ahead, corner_poles
from pilotage.studies import sousa_filters as filters
from pilotage.studies.sousa_poles import courses
from pilotage.studies.study import Request, find_study


def world(run, k=0):
    return RUNS[run].world(np.random.default_rng((1, k)))


def end_errors(run, name, runs):
    return courses(run, [name], 1, range(runs))[0].distance[:, -1]


def test_the_study_writes_its_results_tables_and_figures(tmp_path):
    told = []
    found = find_study("sousa-poles").run(Request(effort=0.01, jobs=1, progress=told.append))
    assert told[-1] == 1.0
    names = {path.name for path in found.save(tmp_path)}
    numbers = {f"figure-{n}.png" for n in ("2", "3", "4", "5", "5-both", "9")}
    assert names == {"results.json", "bump.png"} | numbers
    stored = json.loads((tmp_path / "results.json").read_text(), parse_constant=pytest.fail)
    assert set(stored["results"]["runs"]) == set(RUNS)
    assert len(found.tables) == 6
    for table in found.tables:
        assert all(len(row) == len(table.head) for row in table.rows)


def test_one_run_is_the_same_whoever_computes_it():
    alone = courses("bump, both", ["ours"], 1, range(3, 4))[0]
    among = courses("bump, both", ["ours"], 1, range(2, 5))[0]
    assert np.array_equal(alone.distance[0], among.distance[1])


def test_both_poles_after_a_bump_bring_ours_back_and_rarely_the_papers():
    """The bar asks for 95 % of 200; the study prints that."""
    papers, ours = courses("bump, both", ["the paper's", "ours"], 1, range(60))
    assert ours.settled_within(0.2, 4.0) >= 0.95
    assert 0.05 <= papers.settled_within(0.2, 4.0) <= 0.35
    # It is not that the bump is small.
    assert ours.distance[:, 0].min() > 0.7
    assert np.median(ours.settling_s(0.2)) < 1.0


def test_our_defaults_come_back_by_the_localizer_itself_as_well():
    """`Localizer.run` takes no frames, so there its search may begin a sighting earlier."""
    struck = world("bump, both")
    config = Config()
    config.map = struck.poles
    config["motion.source"] = "velocity"
    config["sensors.camera.sigma_bearing_rad"] = 0.06
    config["sensors.camera.sigma_range_per_m"] = 0.1
    config["sensors.camera.sigma_range_m"] = 0.01
    for name, value in zip(("x_m", "y_m", "heading_rad"), struck.told, strict=True):
        config[f"initial.{name}"] = float(value)
    for name in ("sigma_position_m", "sigma_heading_rad"):
        config[f"initial.{name}"] = filters.START_VARIANCE**0.5
    drive, seen = struck.drive, struck.seen
    rates = np.insert(np.column_stack([drive.v, drive.omega]), 0, 0.0, axis=0)
    elevation = np.full(len(seen.step), np.nan)
    poses = Localizer(config).run(
        drive.utime,
        rates,
        sighting_utime=drive.utime[seen.step],
        sighting_id=struck.poles.ids[seen.pole],
        sighting=np.column_stack([seen.bearing, elevation, seen.distance]),
    )
    replayed = filters.ours(struck)
    assert poses["resets"][-1] == replayed["resets"][-1] == 1
    off = np.hypot(poses["x"] - replayed["x"], poses["y"] - replayed["y"])
    assert off[: struck.struck].max() <= 1e-9
    assert off.max() < 0.05


def test_the_papers_filter_converges_on_the_stopped_robot_from_4_m_off():
    assert end_errors("stopped, in turn", "the paper's", 5).max() < 0.1


def test_a_gate_locks_out_the_start_that_its_covariance_calls_impossible():
    """4 m are 126 sigma of P(0) = 1e-3 I: the paper's own runs must do without a gate."""
    assert np.isclose(4.0 / filters.START_VARIANCE**0.5, 126.5, atol=0.1)
    assert end_errors("stopped, in turn", "gate at 0.999", 2).min() > 3.9
    slowly, papers = (
        courses("stopped, in turn", [name], 1, range(2))[0].settling_s(0.2)
        for name in ("Student-t of 4", "the paper's")
    )
    assert (slowly > 1.5 * papers).all()


def test_equation_15_as_printed_mirrors_the_ellipse():
    rng = np.random.default_rng(1)
    bearing = np.pi / 4 + CAMERA.sigma_bearing_rad * rng.standard_normal(200_000)
    distance = 4.0 * (1.0 + CAMERA.sigma_per_m * rng.standard_normal(200_000))
    measured = np.cov(distance * np.cos(bearing), distance * np.sin(bearing))
    pole = 4.0 * np.array([np.cos(np.pi / 4), np.sin(np.pi / 4)])
    right, printed = filters.noise(pole), filters.printed_noise(pole)
    assert right[0, 1] == pytest.approx(0.0512, abs=1e-4)
    assert measured[0, 1] == pytest.approx(right[0, 1], rel=0.03)
    assert printed == pytest.approx(right * [[1, -1], [-1, 1]])
    # In the paper's words: R' turned by Rot as eq. 15 prints it, and by its transpose.
    c, s = np.cos(np.pi / 4), np.sin(np.pi / 4)
    rot, axes = np.array([[c, s], [-s, c]]), np.diag([0.4**2, 0.24**2])
    assert printed == pytest.approx(rot @ axes @ rot.T)
    assert right == pytest.approx(rot.T @ axes @ rot)


def test_equation_14_needs_no_atan2_for_the_noise():
    """Half a turn more brings the ellipse onto itself."""
    behind = np.array([-3.0, 1.0])
    assert filters.noise(behind) == pytest.approx(filters.noise(-behind))


def test_the_misprint_costs_accuracy_where_the_start_is_right():
    right, printed = courses(
        "moving, told right", ["the paper's", "eq. 15 as printed"], 1, range(20)
    )
    assert printed.end_m > 1.1 * right.end_m


def test_a_thousand_static_measurements_give_the_papers_sigmas():
    sigmas = [
        np.sqrt(np.mean(static_errors(np.random.default_rng((1, k))) ** 2, axis=0))
        for k in range(20)
    ]
    assert np.mean(sigmas, axis=0) == pytest.approx([0.1, 0.06], rel=0.02)
    assert np.std(sigmas, axis=0) == pytest.approx([0.1 / 2000**0.5, 0.06 / 2000**0.5], rel=0.5)


def test_the_robot_on_the_circle_is_told_colours_only_and_sees_one_pole_at_a_time():
    circle = world("circle, by colour")
    assert len(np.unique(circle.seen.step)) == len(circle.seen.step)
    assert set(circle.seen.pole) == {0, 1, 2, 3}
    assert len(set(corner_poles().labels)) == 3
    recorded = circle.seen.record(circle.drive, circle.poles, colours_only=True)
    frames = [marker_frame_t.decode(data) for data in recorded.messages("MARKERS")]
    assert {sighting.id for frame in frames for sighting in frame.sightings} == {-1}
    assert {sighting.label for frame in frames for sighting in frame.sightings} == {0, 1, 2}
    assert ahead(circle.drive, circle.poles).sum(axis=1).max() == 1
    for name in ("the paper's", "ours"):
        assert end_errors("circle, by colour", name, 3).max() < 0.2, name


def test_with_two_of_four_poles_in_view_it_is_back_or_says_that_it_is_not():
    """Today's judge asks for three poles, so it is not; the page says so."""
    (ours,) = courses("bump, both of four", ["ours"], 1, range(10))
    late = slice(len(ours.time_s) // 2, None)
    astray = ours.distance[:, late] > 0.5
    assert np.mean(astray & (ours.status[:, late] == status_t.OK)) < 0.1


def test_settling_is_for_good():
    error = np.array([[0.1, 0.3, 0.1, 0.1], [0.1, 0.1, 0.1, 0.3], [0.1, 0.1, 0.1, 0.1]])
    none = np.zeros_like(error)
    course = Courses(np.arange(4.0), error, none, none > 0, none.astype(int))
    assert course.settling_s(0.2).tolist() == [2.0, np.inf, 0.0]
    assert course.settled_within(0.2, 2.0) == pytest.approx(2 / 3)
    unknown = replace(course, distance=np.where(error == 0.3, np.nan, error))
    assert unknown.settling_s(0.2).tolist() == [2.0, np.inf, 0.0]


def test_the_papers_measurement_is_what_the_camera_sees():
    still = world("stopped, both")
    exact = RelativePosition(still.poles.positions[0, :2]).predict(np.array([[4.0, 0.0, 0.0]]))[0]
    seen = still.seen.relative[still.seen.pole == 0]
    assert seen.mean(axis=0) == pytest.approx(exact, abs=0.1)
    assert pose_errors(filters.papers(still), still.drive.truth()).distance[0] == 4.0
