"""Wrong starts, outliers, kidnaps, tilt, and drives by waypoints."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial.transform import Rotation

from pilotage import MarkerMap
from pilotage.lcmtypes import marker_frame_t
from pilotage.simulate import (
    SCENARIOS,
    Kidnap,
    Outliers,
    Start,
    Tilt,
    measure,
    suitable_config,
    worlds,
)
from pilotage.simulate.drives import circle
from pilotage.simulate.tilt import tilted
from pilotage.simulate.waypoints import waypoints

YARD = replace(SCENARIOS["yard"], duration_s=40.0)


def _seen(**changes):
    measured = measure(replace(YARD, **changes), np.random.default_rng(3))
    return measured.sightings["scanner"]


def test_a_robot_drawn_from_its_priors_differs_by_as_much_as_they_say():
    start = Start(sigma_position_m=0.2, sigma_heading_rad=0.1, error_factor=2.0)
    scenario = replace(YARD, start=start)
    rng = np.random.default_rng(0)
    robots = [scenario.drawn(rng) for _ in range(2000)]
    sigma = np.std([r.start.error for r in robots], axis=0)
    np.testing.assert_allclose(sigma, [0.4, 0.4, 0.2], rtol=0.06)
    assert np.std([r.gyro.bias_rad_s for r in robots]) == pytest.approx(1e-3, rel=0.06)
    scale = np.array([r.encoders.scale for r in robots])
    assert np.std(scale[:, 0]) == pytest.approx(0.01, rel=0.06)
    np.testing.assert_array_equal(scale[:, 0], scale[:, 1])


def test_the_localizer_is_told_the_wrong_start_and_the_stated_sigma():
    start = Start(sigma_position_m=0.2, error=(1.0, -2.0, 0.3))
    scenario = replace(YARD, start=start)
    measured = measure(scenario, np.random.default_rng(0))
    config = suitable_config(scenario, measured.markers, measured.drive)
    told = [config[f"initial.{key}"] for key in ("x_m", "y_m", "heading_rad")]
    np.testing.assert_allclose(told - measured.drive.pose[0], start.error)
    assert config["initial.sigma_position_m"] == 0.2
    unknown = suitable_config(
        replace(YARD, start=Start(known=False)), measured.markers, measured.drive
    )
    assert np.isnan(unknown["initial.x_m"])


def test_a_drive_begins_anywhere_in_the_box():
    start = Start(x_m=(-1.0, 1.0), y_m=(5.0, 6.0))
    rng = np.random.default_rng(0)
    first = np.array([start.placed(circle(1.0), rng).pose[0] for _ in range(300)])
    assert first.min(axis=0) == pytest.approx([-1.0, 5.0, -np.pi], abs=0.1)
    assert first.max(axis=0) == pytest.approx([1.0, 6.0, np.pi], abs=0.1)


@pytest.mark.parametrize("kind", ["bearing", "id", "both"])
def test_outliers_are_as_many_as_asked_and_of_their_kind(kind: str):
    clean, spoilt = _seen(), _seen(outliers=Outliers(0.3, kind))
    of_bearing = spoilt.value[:, 0] != clean.value[:, 0]
    of_id = spoilt.id != clean.id
    assert np.mean(of_bearing | of_id) == pytest.approx(0.3, abs=0.04)
    assert of_bearing.any() == (kind != "id")
    assert of_id.any() == (kind != "bearing")
    assert not (of_bearing & of_id).any()
    assert np.abs(spoilt.value[:, 0]).max() <= 1.6
    np.testing.assert_array_equal(spoilt.value[:, 2], clean.value[:, 2])


def test_sightings_may_have_no_ids():
    measured = measure(replace(YARD, ids=False), np.random.default_rng(3))
    assert set(measured.sightings["scanner"].id) > {0}  # what it is of is known to who simulates
    frames = [marker_frame_t.decode(data) for data in measured.record().messages("MARKERS")]
    assert {s.id for frame in frames for s in frame.sightings} == {-1}


def test_markers_stand_where_the_survey_is_wrong_by_its_sigma():
    plain = worlds.yard()
    sigmas = np.array([0.0, 0.3] * 5)
    surveyed = MarkerMap(plain.ids, plain.positions, sigmas)
    scenario = replace(YARD, site=worlds.Surveyed.of(surveyed), duration_s=5.0).with_noise(0.0)
    off = []
    for seed in range(200):
        measured = measure(scenario, np.random.default_rng(seed))
        np.testing.assert_array_equal(measured.markers.positions, plain.positions)
        off.append(measured.true_markers.positions - plain.positions)
    spread = np.std(off, axis=0)
    np.testing.assert_allclose(spread, np.outer(sigmas, (1.0, 1.0, 0.0)), rtol=0.2)
    (scanner,), seen = scenario.cameras, measured.sightings["scanner"]
    marker = seen.id[sigmas[seen.id] > 0.0][0]
    rows = seen.rows(seen.id == marker)
    exact = scanner.look(measured.drive, measured.true_markers.positions[marker], rows.utime)
    np.testing.assert_allclose(rows.value[:, [0, 2]], exact[:, [0, 2]], atol=1e-9)
    told = suitable_config(scenario, measured.markers, measured.drive).map
    np.testing.assert_array_equal(told.positions, plain.positions)
    np.testing.assert_array_equal(told.sigmas, sigmas)


def test_an_exact_survey_takes_no_chance():
    rng = np.random.default_rng(3)
    assert worlds.as_they_stand(worlds.yard(), rng).positions.tolist() == (
        worlds.yard().positions.tolist()
    )
    assert rng.random() == np.random.default_rng(3).random()


@pytest.mark.parametrize("ids", [True, False])
def test_sightings_say_the_labels_of_their_markers(ids: bool):
    plain = worlds.yard()
    labels = np.arange(10) % 3 - 1
    site = worlds.Surveyed.of(MarkerMap(plain.ids, plain.positions, 0.0, labels))
    measured = measure(replace(YARD, site=site, ids=ids), np.random.default_rng(3))
    seen = measured.sightings["scanner"]
    assert measured.markers.labels.tolist() == labels.tolist()
    recording = measured.record()
    frames = [marker_frame_t.decode(data) for data in recording.messages("MARKERS")]
    sightings = [s for frame in frames for s in frame.sightings]
    assert [s.label for s in sightings] == labels[seen.id].tolist()
    assert [s.id for s in sightings] == (seen.id.tolist() if ids else [-1] * len(seen))
    # All else is as `add_sightings` has it.
    unlabelled = measure(replace(YARD, ids=ids), np.random.default_rng(3)).record()
    for sighting in sightings:
        sighting.label = -1
    expected = unlabelled.messages("MARKERS")
    assert [frame.encode() for frame in frames] == expected
    np.testing.assert_array_equal(recording.arrivals("MARKERS"), unlabelled.arrivals("MARKERS"))


@pytest.mark.parametrize(
    "kidnap",
    [Kidnap((10.0, 20.0), distance_m=(3.0, 5.0)), Kidnap((10.0, 20.0), turn_rad=(0.5, 1.0))],
)
def test_a_kidnap_moves_the_robot_and_nothing_that_it_measures_of_its_motion(kidnap: Kidnap):
    plain = measure(YARD, np.random.default_rng(3))
    for seed in range(20):
        drive, at = kidnap.strike(plain.drive, plain.markers, np.random.default_rng(seed))
        k = int(np.flatnonzero(drive.utime == at)[0])
        assert 10.0 <= (at - drive.utime[0]) * 1e-6 <= 20.01
        np.testing.assert_array_equal(drive.pose[:k], plain.drive.pose[:k])
        jump = np.abs(drive.pose[k] - plain.drive.pose[k])
        assert kidnap.distance_m[0] - 1e-9 <= np.hypot(*jump[:2]) <= kidnap.distance_m[1] + 1e-9
        assert kidnap.turn_rad[0] - 1e-9 <= jump[2] <= kidnap.turn_rad[1] + 1e-9
        np.testing.assert_array_equal(drive.increments, plain.drive.increments)


def test_a_kidnap_to_where_nothing_is_is_an_error():
    plain = measure(YARD, np.random.default_rng(3))
    with pytest.raises(ValueError, match=r"nothing within the markers is .*99.* m away"):
        Kidnap((1.0, 2.0), distance_m=(99.0, 100.0)).strike(
            plain.drive, plain.markers, np.random.default_rng(0)
        )


def test_a_tilted_body_sees_along_turned_axes():
    rng = np.random.default_rng(5)
    level = rng.uniform((-3.0, -1.0, 1.0), (3.0, 1.0, 9.0), (4, 6, 3))
    angles = rng.uniform(-0.3, 0.3, (4, 2))
    yaw = 0.7
    seen = tilted(level, angles, yaw)
    for frame in range(4):
        pitch, roll = angles[frame]
        body = Rotation.from_euler("YX", [pitch, roll])  # its own axes, in this order
        for marker in range(6):
            ray = _ray(*level[frame, marker, :2], yaw)
            np.testing.assert_allclose(
                _ray(*seen[frame, marker, :2], yaw), body.inv().apply(ray), atol=1e-12
            )
    np.testing.assert_array_equal(seen[..., 2], level[..., 2])


def _ray(bearing: float, elevation: float, yaw: float) -> np.ndarray:
    flat = np.cos(elevation)
    return np.array([flat * np.cos(bearing + yaw), flat * np.sin(bearing + yaw), np.sin(elevation)])


def test_nose_down_raises_what_is_ahead():
    (seen,) = tilted(np.array([[[0.0, 0.0, 5.0]]]), np.array([[0.1, 0.0]]), 0.0)
    assert seen[0, 1] == pytest.approx(0.1)


@pytest.mark.parametrize("tau_s", [0.0, 3.0])
def test_tilt_is_as_large_and_as_lasting_as_it_says(tau_s: float):
    angles = Tilt(0.02, tau_s).angles(circle(3000.0), np.random.default_rng(2))
    assert np.std(angles, axis=0) == pytest.approx([0.02, 0.02], rel=0.1)
    after_1_s = np.mean(angles[100:] * angles[:-100], axis=0) / 0.02**2
    expected = np.exp(-1.0 / tau_s) if tau_s else 0.0
    assert after_1_s == pytest.approx([expected, expected], abs=0.1)


def test_waypoints_are_passed_in_turn_at_the_speed():
    points = [(0.0, 0.0), (4.0, 0.0), (4.0, 3.0)]
    drive = waypoints(40.0, points, speed_m_s=0.5)
    far = [np.hypot(*(drive.pose[:, :2] - p).T) for p in points]
    assert max(f.min() for f in far) < 0.01
    passed = [int(np.argmax(f < 0.01)) for f in far]
    assert passed == sorted(passed)
    assert drive.v.max() == pytest.approx(0.5)
    assert drive.pose[0] == pytest.approx([0.0, 0.0, 0.0])
    assert np.hypot(*(drive.pose[2000:, :2] - points[0]).T).min() < 0.02  # round again
