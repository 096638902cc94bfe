import numpy as np
import pytest

from pilotage.evaluate import (
    ellipse_scale,
    mahalanobis_squared,
    mean_square_band,
    sigma_probability,
)


def test_mahalanobis_of_a_diagonal_covariance_by_hand() -> None:
    error = np.array([[2.0, 3.0, 0.1]])
    covariance = np.diag([4.0, 1.0, 0.01])[None]
    assert mahalanobis_squared(error, covariance) == pytest.approx([1.0 + 9.0 + 1.0], rel=1e-14)


def test_mahalanobis_agrees_with_a_dense_solve() -> None:
    rng = np.random.default_rng(1)
    factor = rng.normal(size=(50, 3, 3)) * [1.0, 10.0, 0.01]
    covariance = np.swapaxes(factor, 1, 2) @ factor + np.diag([1e-2, 1.0, 1e-6])
    error = rng.normal(size=(50, 3)) * [1.0, 10.0, 0.01]
    expected = np.einsum("ni,ni->n", error, np.linalg.solve(covariance, error[..., None])[..., 0])
    np.testing.assert_allclose(mahalanobis_squared(error, covariance), expected, rtol=1e-9)


def test_singular_indefinite_and_unknown_rows_have_no_value() -> None:
    covariance = np.array(
        [
            np.zeros((3, 3)),
            [[1.0, 1.0, 0.0], [1.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            [[1.0, 2.0, 0.0], [2.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
            np.diag([1.0, 1.0, -1.0]),
            np.full((3, 3), np.nan),
            np.eye(3),
        ]
    )
    value = mahalanobis_squared(np.ones((6, 3)), covariance)
    np.testing.assert_array_equal(np.isnan(value), [True, True, True, True, True, False])


def test_scale_of_units_does_not_make_a_covariance_singular() -> None:
    covariance = np.diag([1e8, 1e-8, 1e-20])[None]
    error = np.sqrt(np.diagonal(covariance, axis1=1, axis2=2))
    assert mahalanobis_squared(error, covariance) == pytest.approx([3.0], rel=1e-12)


def test_arguments_are_left_as_they_were() -> None:
    error, covariance = np.ones((1, 3)), np.eye(3)[None] + 0.5
    mahalanobis_squared(error, covariance)
    np.testing.assert_array_equal(error, np.ones((1, 3)))
    np.testing.assert_array_equal(covariance, np.eye(3)[None] + 0.5)


def test_mean_nees_of_sampled_gaussian_lies_in_its_band() -> None:
    covariance = np.array([[0.04, 0.01, 0.002], [0.01, 0.09, -0.003], [0.002, -0.003, 0.001]])
    error = np.random.default_rng(3).multivariate_normal(np.zeros(3), covariance, size=2000)
    nees = mahalanobis_squared(error, np.broadcast_to(covariance, (2000, 3, 3)))
    low, high = mean_square_band(3, 0.99, count=2000)
    assert low < nees.mean() < high
    within = mean_square_band(3, 0.95)
    assert np.mean((nees > within[0]) & (nees < within[1])) == pytest.approx(0.95, abs=0.015)


def test_chi_square_bands_of_the_tables() -> None:
    assert mean_square_band(1) == pytest.approx((0.000982, 5.0239), rel=1e-3)
    assert mean_square_band(2) == pytest.approx((0.05064, 7.3778), rel=1e-4)
    assert mean_square_band(3, 0.9) == pytest.approx((0.3518, 7.8147), rel=1e-3)
    # Bar-Shalom's example: 50 runs, 2 dof, 95 %: 100 dof, [74.2, 129.6] / 50.
    assert mean_square_band(2, 0.95, count=50) == pytest.approx((1.484, 2.591), abs=1e-3)


def test_probabilities_of_regions() -> None:
    assert ellipse_scale(0.95) == pytest.approx(2.4477, abs=5e-5)
    assert ellipse_scale(0.954) == pytest.approx(2.4816, abs=5e-5)
    assert ellipse_scale(1.0 - np.exp(-2.0)) == pytest.approx(2.0, abs=1e-12)
    assert sigma_probability(2.0) == pytest.approx(0.9545, abs=5e-5)
