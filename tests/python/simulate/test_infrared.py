import numpy as np
import pytest

from pilotage.simulate.infrared import InfraredPair, LogCurve


def test_nothing_returns_out_of_reach_or_askew():
    pair, rng = InfraredPair(), np.random.default_rng(0)
    distance = np.array([0.05, 0.3, 0.3, 0.9])
    reading = pair.reading(distance, np.radians([0.0, 0.0, 11.0, 0.0]), 0.9, rng)
    assert np.isfinite(reading).tolist() == [False, True, False, False]


def test_a_curve_gives_back_the_distance_of_a_logarithm():
    distance = np.linspace(0.1, 0.8, 20)
    curve = LogCurve.fit(distance, 0.2 - 1.5 * np.log(distance))
    assert (curve.at_1_m, curve.slope) == pytest.approx((0.2, -1.5))
    np.testing.assert_allclose(curve.distance(0.2 - 1.5 * np.log(distance)), distance)
