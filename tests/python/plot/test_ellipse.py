import numpy as np
import pytest

from pilotage.plot.ellipse import ellipse_label, ellipses, magnification


def test_outline_lies_where_the_mahalanobis_distance_is_k() -> None:
    covariance = np.array([[[4.0, 1.0], [1.0, 2.0]]])
    outline = ellipses(np.array([[10.0, -3.0]]), covariance)[0] - [10.0, -3.0]
    distance = np.einsum("ni,ij,nj->n", outline, np.linalg.inv(covariance[0]), outline)
    np.testing.assert_allclose(np.sqrt(distance), 2.4477, atol=5e-5)


def test_outline_holds_95_percent_of_a_sampled_gaussian() -> None:
    rng = np.random.default_rng(2)
    covariance = np.array([[4.0, 1.0], [1.0, 2.0]])
    sample = rng.multivariate_normal([0.0, 0.0], covariance, size=20_000)
    outline = ellipses(np.zeros((1, 2)), covariance[None])[0]
    matplotlib_path = pytest.importorskip("matplotlib.path").Path(outline)
    assert matplotlib_path.contains_points(sample).mean() == pytest.approx(0.95, abs=0.006)


def test_singular_covariance_gives_a_line_or_a_point() -> None:
    flat = np.array([np.zeros((2, 2)), np.diag([1.0, 0.0])])
    outlines = ellipses(np.zeros((2, 2)), flat)
    np.testing.assert_array_equal(outlines[0], 0.0)
    assert np.ptp(outlines[1][:, 0]) == pytest.approx(2 * 2.4477, rel=1e-3)
    np.testing.assert_allclose(outlines[1][:, 1], 0.0, atol=1e-12)


def test_label_says_probability_size_and_magnification() -> None:
    assert ellipse_label() == "95 % position ellipse (2.4477 σ)"
    assert ellipse_label(5) == "95 % position ellipse (2.4477 σ, drawn 5×)"
    assert ellipse_label(1, 0.99) == "99 % position ellipse (3.0349 σ)"


@pytest.mark.parametrize(
    ("radius", "times"), [(1.0, 1), (0.5, 2), (0.3, 5), (0.02, 50), (1e-9, 100), (0.0, 1)]
)
def test_small_ellipses_are_drawn_larger(radius: float, times: int) -> None:
    assert magnification(radius, 1.0) == times
