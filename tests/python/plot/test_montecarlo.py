from dataclasses import replace

import numpy as np
import pytest

from pilotage.montecarlo import MonteCarlo, find_scenario, run_montecarlo
from pilotage.plot.montecarlo import montecarlo_figure
from support.artists import artist, has, texts

SHORT = replace(find_scenario("nominal"), duration_s=8.0)


@pytest.fixture(scope="module")
def result() -> MonteCarlo:
    return run_montecarlo(SHORT, 5)


def test_errors_stand_beside_the_bound(result: MonteCarlo):
    figure = montecarlo_figure(result)
    position, heading, *_ = figure.axes
    np.testing.assert_array_equal(artist(position, "rmse").get_ydata(), result.position_m)
    assert result.bound is not None
    np.testing.assert_array_equal(
        artist(heading, "bound").get_ydata(), np.degrees(result.bound.heading_rad)
    )
    assert {"5 runs", "posterior Cramér-Rao bound", "95 % band"} <= set(texts(figure))


def test_nees_and_nis_have_their_bands(result: MonteCarlo):
    figure = montecarlo_figure(result)
    _, _, nees, nis = figure.axes
    band = artist(nees, "band").get_paths()[0].vertices[:, 1]
    assert (band.min(), band.max()) == pytest.approx((result.nees.low[0], result.nees.high[0]))
    assert len(artist(nis, "ratio").get_ydata()) == 8
    assert has(nis, "band")
    assert artist(nis, "ratio").get_xdata()[0] == 0.5  # the middle of the first second
    inside = f"{100 * result.nees.inside:.1f} % of the time in the band"
    assert any(inside in text for text in texts(figure))
    assert any(text == "scanner" for text in texts(figure))


def test_without_a_bound_there_is_none(result: MonteCarlo):
    figure = montecarlo_figure(replace(result, bound=None))
    assert not has(figure.axes[0], "bound")
    assert "posterior Cramér-Rao bound" not in texts(figure)


def test_lost_runs_are_named(result: MonteCarlo):
    distance = result.trials.distance.copy()
    distance[[1, 3]] = 7.0
    lost = replace(result, trials=replace(result.trials, distance=distance))
    assert "2 lost: 1, 3" in texts(montecarlo_figure(lost))


def test_without_any_pose_it_says_so(result: MonteCarlo):
    unknown = np.full_like(result.trials.distance, np.nan)
    trials = replace(result.trials, distance=unknown, heading=unknown, nees=unknown)
    figure = montecarlo_figure(replace(result, trials=trials, bound=None))
    assert texts(figure).count("no pose") == 3
