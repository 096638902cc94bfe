"""A survey sees lines, circles and views, and is quick also on large maps."""

import numpy as np
import pytest

from pilotage.simulate import worlds
from pilotage.site import Layout, Survey
from pilotage.site.shapes import circle_through, in_line
from support.sites import BEARINGS, GRID, LINE, RANGES, SQUARE, markers, site


def test_places_in_a_line_are_told_from_others():
    direction = np.exp(0.7j)
    line = (3 + 1j) + direction * np.array([0.0, 1.0, 4.0, 9.0])
    assert in_line(line, 1e-6)
    assert in_line(line[:2], 1e-6)
    assert in_line(line + 0.05j * direction * np.array([1, -1, 1, -1]), 0.08)
    assert not in_line(line + np.array([0, 0, 0.3j * direction, 0]), 0.05)
    assert not in_line(np.array([0, 4, 4 + 4j, 4j]), 0.05)


def test_a_circle_goes_through_places_on_it():
    angles = np.array([0.1, 1.0, 2.5, 4.0])
    circle = circle_through(7 - 2j + 3.0 * np.exp(1j * angles), 1e-6)
    assert circle is not None
    assert circle.centre == pytest.approx(7 - 2j)
    assert circle.radius == pytest.approx(3.0)
    assert circle.passes(10.2 - 2j, 0.1)
    assert not circle.passes(7 - 2j, 0.1)
    assert circle_through(np.array([0, 4, 4 + 4j, 3j]), 0.05) is None
    assert circle_through(np.array([0, 4, 9]), 0.05) is None


def test_every_view_of_a_square_fits_elsewhere_and_none_of_the_yard():
    square = Survey.of(site(SQUARE)).views
    assert square.part(square.alike) == 1.0
    yard = Survey.of(site(worlds.yard().positions[:, :2]), reach_m=8.0, view_rad=3.0).views
    assert yard.views
    assert yard.alike == []


def test_views_of_a_grid_fit_elsewhere_though_a_marker_far_off_breaks_the_whole():
    survey = Survey.of(site([*GRID, (2.0, 60.0)]), reach_m=10.0)
    seen = [view for view in survey.views.views if 28 not in view.seen]
    assert all(view.alike for view in seen)
    assert len(seen) > 10


def test_a_ring_seen_from_the_ring_is_on_the_danger_circle():
    z = 5.0 * np.exp(2j * np.pi * np.array([0.0, 0.3, 0.7]))
    survey = Survey.of(site(np.column_stack([z.real, z.imag]), BEARINGS), area=(-6, -6, 6, 6))
    ring = np.pi * (5.5**2 - 4.5**2) / 144.0
    views = survey.views
    assert survey.bearings_only
    assert views.part(views.on_circle, on_circle=True) == pytest.approx(ring, abs=0.03)


def test_a_line_is_seen_as_such_and_mirrors_what_has_no_bearing():
    survey = Survey.of(site(LINE, RANGES))
    assert survey.in_line
    assert survey.mirror
    assert survey.views.part(survey.views.in_line) == 1.0
    assert not any(match.ids_help for match in survey.symmetries)


def test_tolerance_is_of_noise_and_survey_and_never_that_of_a_crowd():
    config = site(SQUARE)
    (sight,) = Survey.of(config).sights
    assert Layout.of(config.map).tolerance_m([sight]) == pytest.approx(3 * 0.05)
    rough = Layout.of(markers(SQUARE, sigma=0.12))
    assert rough.tolerance_m([sight]) == pytest.approx(3 * 0.13)
    assert Layout.of(markers(SQUARE, sigma=9.0)).tolerance_m([sight]) == pytest.approx(4 / 3)


def test_a_map_of_one_marker_can_be_looked_at():
    survey = Survey.of(site([(3, 4)]))
    assert survey.symmetries == []
    assert survey.coverage.ground.area == (2.0, 3.0, 4.0, 5.0)


@pytest.mark.parametrize("xy", [[(1, 1)] * 3, [(0, 0), (0, 0), (5, 0), (5, 5), (2, 1)]])
def test_markers_in_one_place_can_be_looked_at(xy):
    survey = Survey.of(site(xy))
    assert survey.symmetries == []
    assert np.isfinite(np.median(survey.coverage.average_m))


def test_a_site_far_from_the_frames_origin_is_the_same_site():
    near, far = (
        Survey.of(site(np.array(SQUARE) + offset), reach_m=3.0) for offset in (0.0, [5e5, 5e6])
    )
    assert len(far.symmetries) == 3
    assert far.coverage.fewer(2) == pytest.approx(near.coverage.fewer(2), abs=1e-3)
    np.testing.assert_allclose(far.coverage.average_m, near.coverage.average_m, rtol=1e-2)


def test_five_hundred_markers_are_looked_at():
    xy = np.random.default_rng(1).uniform(0, 120, (500, 2))
    done: list[float] = []
    survey = Survey.of(site(xy), reach_m=8.0, view_rad=3.0, progress=done.append)
    assert survey.symmetries == []
    assert 0.0 < survey.views.part(survey.views.alike) < 0.2
    assert done == sorted(done)
    assert done[-1] > 0.95
