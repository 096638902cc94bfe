import numpy as np
import pytest

from pilotage.evaluate.polar import polar_moments


@pytest.mark.parametrize("bearing", [0.0, 0.7, np.pi / 2])
def test_moments_are_those_of_many_points(bearing):
    mean, sigma = np.array([2.0, bearing]), np.array([0.1, 0.4])
    r, b = np.random.default_rng(0).normal(mean, sigma, (400_000, 2)).T
    points = np.stack([r * np.cos(b), r * np.sin(b)])
    centre, covariance = polar_moments(mean, sigma)
    np.testing.assert_allclose(points.mean(axis=1), centre, atol=5e-3)
    np.testing.assert_allclose(np.cov(points), covariance, atol=5e-3)


def test_the_mean_of_figure_2():
    centre, covariance = polar_moments(np.array([1.0, np.pi / 2]), np.radians([0.0, 15.0]))
    assert centre == pytest.approx([0.0, 0.966], abs=5e-4)
    assert np.diag(covariance) == pytest.approx([0.064, 0.0022], abs=5e-4)
