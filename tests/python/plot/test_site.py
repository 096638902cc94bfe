import math

import numpy as np

from pilotage.plot.site import site_figure
from pilotage.site import Survey
from support.artists import artist, has, texts
from support.sites import BEARINGS, RANGES, SQUARE, site


def test_the_radius_is_drawn_over_the_area_with_markers_and_partners() -> None:
    survey = Survey.of(site(SQUARE))
    figure = site_figure(survey)
    axes = figure.axes[0]
    np.testing.assert_allclose(artist(axes, "radius").get_array(), survey.coverage.average_m)
    assert artist(axes, "radius").get_extent() == [-2.0, 6.0, -2.0, 6.0]
    ends = np.column_stack([artist(axes, "partners").get_xdata(), [0.0] * 12])
    assert np.isnan(ends[2::3, 0]).all()
    said = texts(figure)
    assert {"0", "1", "2", "3", "marker"} <= set(said)
    assert "alike without ids: turned by 90° about (2.0, 2.0) m" in said
    assert any("heading known to 3°" in text for text in said)
    assert not any("no marker in view" in text for text in said)
    figure.draw_without_rendering()


def test_blind_and_unsure_zones_are_hatched() -> None:
    survey = Survey.of(site(SQUARE, RANGES), reach_m=1.9, area=(-4, -4, 8, 8), view_rad=math.pi)
    figure = site_figure(survey)
    axes = figure.axes[0]
    assert artist(axes, "no marker in view").hatches == ["xxxxxx"]
    assert has(axes, "above 1 m, or not fixed")
    figure.draw_without_rendering()


def test_the_danger_circle_is_drawn_only_for_bearings() -> None:
    xy = [(0, 0), (5, 0), (2, 4)]
    circle = artist(site_figure(Survey.of(site(xy, BEARINGS))).axes[0], "circle")
    around = circle.get_xdata() + 1j * circle.get_ydata()
    np.testing.assert_allclose(np.abs(around - (2.5 + 1.25j)), math.hypot(2.5, 1.25))
    assert not has(site_figure(Survey.of(site(xy))).axes[0], "circle")


def test_a_map_of_which_nothing_is_seen_can_be_drawn() -> None:
    figure = site_figure(Survey.of(site(SQUARE), reach_m=0.1))
    figure.draw_without_rendering()
