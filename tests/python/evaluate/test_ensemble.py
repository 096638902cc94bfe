import numpy as np
import pytest

from pilotage.evaluate import Ensemble

COVARIANCE = np.array([[0.04, 0.01, 0.0], [0.01, 0.09, 0.02], [0.0, 0.02, 0.01]])


@pytest.fixture(scope="module")
def honest() -> Ensemble:
    error = np.random.default_rng(3).multivariate_normal(np.zeros(3), COVARIANCE, 20_000)
    return Ensemble(error, np.tile(COVARIANCE, (len(error), 1, 1)))


def test_an_honest_ensemble_is_what_it_states(honest: Ensemble):
    assert honest.position_m == pytest.approx(honest.stated_m, rel=0.02)
    assert honest.heading_deg == pytest.approx(honest.stated_deg, rel=0.02)
    assert honest.in_ellipse(0.954) == pytest.approx(0.954, abs=0.005)
    assert honest.in_ellipse(1 - np.exp(-2)) == pytest.approx(0.865, abs=0.008)
    assert honest.in_cone() == pytest.approx(0.954, abs=0.005)
    assert honest.lost <= 1e-4


@pytest.mark.parametrize("column", [0, 2])
def test_an_error_beyond_its_covariance_is_lost(honest: Ensemble, column: int):
    error = honest.error.copy()
    error[: len(error) // 4, column] += 10.0
    assert Ensemble(error, honest.covariance).lost == pytest.approx(0.25, abs=1e-3)


def test_where_nothing_is_uncertain_there_is_no_share():
    sure = Ensemble(np.zeros((3, 3)), np.zeros((3, 3, 3)))
    assert np.isnan([sure.in_ellipse(0.95), sure.in_cone(), sure.lost]).all()
