from dataclasses import replace

import numpy as np
import pytest

from pilotage.simulate.skid_steer import SkidSteered, look_at_walls, square_lap

CALM = replace(SkidSteered(), slip=(0.0,) * 3, slip_turning=(0.0,) * 3, sonar_sigma_m=(0.0, 0.0))


def test_walls_are_seen_at_their_angle():
    distance, incidence = look_at_walls(np.array([[1.0, 1.0, 0.0], [1.0, 1.0, 0.2]]))
    np.testing.assert_allclose(distance[0], 1.5)
    np.testing.assert_allclose(distance[1], 1.5 / np.cos(0.2))
    np.testing.assert_allclose(incidence[1], 0.2)


def test_a_beam_along_a_side_wall_meets_it_askew():
    _, incidence = look_at_walls(np.array([[0.5, 0.0, np.radians(-20.0)]]))
    assert np.degrees(incidence[0, 0]) == pytest.approx(70.0)


def test_without_slip_it_comes_back_but_for_its_sideways_drift():
    lap = square_lap(CALM, np.random.default_rng(0))
    assert np.hypot(*lap.pose[-1, :2]) < 0.15
    assert lap.pose[-1, 2] == pytest.approx(4 * np.pi, abs=0.05)


def test_sonar_without_noise_is_the_distance_where_it_is_heard():
    lap = square_lap(CALM, np.random.default_rng(0))
    distance, incidence = look_at_walls(lap.pose[1:])
    heard = np.isfinite(lap.sonar)
    np.testing.assert_array_equal(lap.sonar[heard], distance[heard])
    assert heard.any(axis=0).tolist() == [True, False, False, True]
    assert incidence[heard].max() <= CALM.sonar_aligned_rad
