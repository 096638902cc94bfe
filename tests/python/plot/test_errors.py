import numpy as np
import pytest

from pilotage.plot import errors_figure
from support import runs
from support.artists import artist, has, texts


def test_panels_show_errors_in_metres_and_degrees() -> None:
    run, truth, _ = runs.drive()
    figure = errors_figure(run, truth)
    x, _, heading = figure.axes
    np.testing.assert_allclose(
        artist(x, "error").get_ydata(), run.poses["x"] - truth["x"], atol=1e-12
    )
    turn = np.degrees(run.poses["heading"] - truth["heading"])
    np.testing.assert_allclose(artist(heading, "error").get_ydata(), turn, atol=1e-9)
    assert {"x error (m)", "y error (m)", "heading error (deg)"} <= set(texts(figure))
    assert artist(x, "error").get_xdata()[-1] == pytest.approx(40.0)


def test_band_is_two_sigma_and_says_its_probability() -> None:
    run, truth, _ = runs.drive()
    figure = errors_figure(run, truth)
    for axes, sigma in zip(figure.axes, (0.1, 0.2, np.degrees(0.05)), strict=True):
        height = artist(axes, "band").get_paths()[0].vertices[:, 1]
        assert height.max() == pytest.approx(2.0 * sigma)
        assert height.min() == pytest.approx(-2.0 * sigma)
    assert "±2σ of the filter, 95.4 % of a Gaussian" in texts(figure)


def test_headline_counts_the_rows_within() -> None:
    run, truth, _ = runs.drive(100)
    run.poses["x"] = truth["x"]
    run.poses["x"][:10] += 0.21
    assert "90.0 % within ±2σ, 95.4 % expected" in texts(errors_figure(run, truth))


def test_gap_in_truth_leaves_a_gap() -> None:
    run, truth, _ = runs.drive()
    truth["x"][100:200] = np.nan
    x, y, _ = errors_figure(run, truth).axes
    np.testing.assert_array_equal(
        np.flatnonzero(np.isnan(artist(x, "error").get_ydata())), np.arange(100, 200)
    )
    assert not np.isnan(artist(y, "error").get_ydata()).any()
    assert not np.isnan(artist(x, "band").get_paths()[0].vertices).any()


def test_no_error_leaves_the_panel() -> None:
    run, truth, _ = runs.drive()
    run.poses["x"][7] += 50.0
    low, high = errors_figure(run, truth).axes[0].get_ylim()
    assert low == -high
    assert high > 50.0


def test_without_truth_the_bands_stand_alone() -> None:
    run, _, _ = runs.drive()
    figure = errors_figure(run)
    assert "no truth to compare with" in texts(figure)
    assert "estimate less truth" not in texts(figure)
    assert has(figure.axes[0], "band")
