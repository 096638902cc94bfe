"""Blind zones against their areas, and the radius against the core's filter."""

import math

import numpy as np
import pytest

from pilotage import Config, Ekf3, MarkerModel
from pilotage.evaluate import ellipse_scale
from pilotage.site import Survey
from pilotage.site.ground import CELLS, Ground
from support.sites import BEARINGS, BOTH, LINE, RANGES, SQUARE, site

K95 = ellipse_scale(0.95)
AREA = (-5.0, -4.0, 5.0, 4.0)
HEADING = Config()["initial.sigma_heading_rad"]


def test_the_blind_zone_of_one_marker_is_all_but_its_disc():
    survey = Survey.of(site([(1.0, 0.5)]), reach_m=3.0, area=AREA)
    disc = np.pi * (3.0**2 - 0.5**2) / 80.0  # it sees it at sensor height, 0.5 m below
    few = survey.coverage.fewer(1)
    assert few.poses == pytest.approx(1.0 - disc, abs=0.005)
    assert few.best_heading == pytest.approx(few.worst_heading)
    assert survey.coverage.fewer(2).poses == 1.0


@pytest.mark.parametrize("degrees", [30, 57, 172, 300])
def test_a_field_of_view_sees_as_many_headings(degrees: float):
    survey = Survey.of(site([(0, 0)]), view_rad=math.radians(degrees), area=AREA)
    few = survey.coverage.fewer(1)
    assert few.poses == pytest.approx(1.0 - degrees / 360.0, abs=0.01)
    assert few.worst_heading > 0.99  # but for what is nearer than the sensor sees
    assert few.best_heading < 0.01


def test_overlapping_discs_see_two():
    survey = Survey.of(site([(-1, 0), (1, 0)]), reach_m=2.0, area=AREA)
    r = math.sqrt(2.0**2 - 0.5**2)
    lens = 2 * r * r * math.acos(1 / r) - 2 * math.sqrt(r * r - 1)
    assert survey.coverage.fewer(2).poses == pytest.approx(1.0 - lens / 80.0, abs=0.005)


def test_one_marker_by_bearing_and_range_has_the_textbook_radius():
    survey = Survey.of(site([(0, 0)], sensor={**BOTH, "z_m": 0.5}), area=AREA)
    ground = survey.coverage.ground
    distance = np.hypot(*np.meshgrid(ground.x, ground.y))
    across = distance * math.hypot(0.01, HEADING)
    expected = K95 * np.maximum(across, 0.05)
    np.testing.assert_allclose(survey.coverage.average_m, expected, rtol=1e-5)


@pytest.mark.parametrize("sensor", [BOTH, BEARINGS, RANGES])
def test_the_radius_is_that_of_the_cores_filter(sensor: dict[str, float]):
    mounted = {**sensor, "x_m": 0.3, "y_m": 0.1, "z_m": 0.2, "yaw_rad": 0.4}
    config = site(SQUARE, mounted)
    survey = Survey.of(config, reach_m=4.5, view_rad=3.0)
    coverage, (sight,) = survey.coverage, survey.sights
    poses = coverage.ground.poses()
    radius = coverage.radius_m.ravel()
    visible = coverage.visible.reshape(len(poses), -1)
    for row in np.flatnonzero(visible.sum(axis=1) >= 2)[::997]:
        # A filter at the true pose that knows but the heading; nothing is left to iterate.
        ekf = Ekf3(poses[row], np.diag([1e4, 1e4, HEADING**2]))
        for marker in config.map.positions[visible[row]]:
            model = MarkerModel(marker, list(sight.components), list(sight.mounting))
            z, _, _ = model.linearize(poses[row])
            ekf.update(model, z, np.diag([sight.sigmas[c] ** 2 for c in sight.components]))
        largest = np.linalg.eigvalsh(ekf.covariance[:2, :2])[-1]
        assert radius[row] == pytest.approx(K95 * math.sqrt(largest), rel=1e-2)


def test_the_radius_is_the_spread_of_least_squares_estimates():
    config = site([(4, 0), (0, 3), (-3, -2)], BEARINGS)
    survey = Survey.of(config, area=(-0.1, -0.1, 0.1, 0.1))
    models = [MarkerModel(marker, ["bearing"]) for marker in config.map.positions]
    rng = np.random.default_rng(5)
    lines = [model.linearize([0, 0, 0]) for model in models]
    h = np.vstack([*(line[1] for line in lines), [0, 0, 1]])
    weight = np.array([0.01, 0.01, 0.01, HEADING]) ** -1
    noise = rng.standard_normal((20_000, 4))
    pose = np.linalg.lstsq(weight[:, None] * h, noise.T, rcond=None)[0]
    largest = np.linalg.eigvalsh(np.cov(pose[:2]))[-1]
    middle = np.median(survey.coverage.average_m)
    assert middle == pytest.approx(K95 * math.sqrt(largest), rel=0.03)


def test_one_frame_of_ranges_to_one_marker_fixes_no_position():
    survey = Survey.of(site([(0, 0)], RANGES), area=AREA)
    assert np.all(np.isinf(survey.coverage.radius_m))


def test_a_heading_that_is_known_exactly_is_the_limit_of_one_known_well():
    exact, well = (
        Survey.of(site(SQUARE, BEARINGS, initial__sigma_heading_rad=s)).coverage.average_m
        for s in (0.0, 1e-6)
    )
    np.testing.assert_allclose(exact, well, rtol=1e-6)


def test_a_part_of_the_area_has_its_radius():
    coverage = Survey.of(site(SQUARE), reach_m=3.0, area=AREA).coverage
    for part in (0.2, 0.5):
        radius = coverage.radius_of_part(part)
        assert np.mean(coverage.average_m <= radius) == pytest.approx(part, abs=0.01)
    assert coverage.radius_of_part(1.0) == math.inf


@pytest.mark.parametrize("area", [(0, 0, 1e6, 1e-3), (0, 0, 1e-3, 1e6), (0, 0, 900, 1)])
def test_a_long_and_thin_area_has_no_more_cells_than_another(area):
    ny, nx, _ = Ground.of(area, markers=4, sensors=1, all_round=True).shape
    assert min(ny, nx) >= 2
    assert ny * nx <= 1.2 * CELLS[1]


def test_bearings_see_no_distance_along_their_line():
    survey = Survey.of(site(LINE, BEARINGS), area=(14.0, -0.5, 20.0, 0.5))
    on_line = np.argmin(np.abs(survey.coverage.ground.y))
    middle = survey.coverage.average_m
    assert np.min(middle[on_line]) > 3.0 * np.max(middle[0])
