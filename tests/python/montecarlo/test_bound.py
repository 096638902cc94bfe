"""The bound, held against what is known otherwise."""

from dataclasses import replace

import numpy as np
import pytest

from pilotage import CalibratedArc, Ekf6, MarkerModel
from pilotage.montecarlo import Bound
from pilotage.montecarlo.bound import motion, recursion
from pilotage.simulate import SCENARIOS, Camera, Encoders, Gyro, Scenario, Start
from pilotage.simulate.drives import Drive, circle
from pilotage.simulate.worlds import four_poles

RATE_HZ = 100.0  # a frame in every step, so that nothing is left to chance


def _scenario(**changes) -> Scenario:
    scenario = Scenario(
        "circle",
        lambda _: four_poles(),
        circle,
        duration_s=5.0,
        encoders=Encoders(track_width_m=0.5, noise_m_per_sqrt_m=0.05, scale_sigma=0.02),
        gyro=Gyro(noise_rad_per_sqrt_s=1e-4, bias_sigma_rad_s=3e-3, walk_rad_s_per_sqrt_s=1e-4),
        cameras=(
            Camera("eye", ("bearing", "range"), (0.1, 0.0, 0.3, 0.2), (0.02, 0.0, 0.1), RATE_HZ),
        ),
        start=Start(sigma_position_m=0.2, sigma_heading_rad=0.1),
    )
    return replace(scenario, **changes)


def test_of_a_linear_gaussian_system_it_is_the_kalman_filters_covariance():
    rng = np.random.default_rng(3)
    a, h = rng.normal(size=(20, 3, 3)), rng.normal(size=(21, 2, 3))
    q = np.diag([0.1, 0.2, 0.0])
    r = np.diag([0.5, 2.0])
    bound = recursion(np.eye(3), a, np.tile(q, (20, 1, 1)), h.swapaxes(1, 2) @ np.linalg.inv(r) @ h)
    p = np.eye(3)
    for i in range(21):
        if i:
            p = a[i - 1] @ p @ a[i - 1].T + q
        gain = p @ h[i].T @ np.linalg.inv(h[i] @ p @ h[i].T + r)
        p = p - gain @ h[i] @ p
        np.testing.assert_allclose(bound[i], p, rtol=1e-6, atol=1e-9)


def test_it_is_the_covariance_of_the_cores_filter_at_the_true_pose():
    scenario, markers = _scenario(), four_poles()
    drive = circle(scenario.duration_s)
    bound = Bound.of(scenario, markers, drive)
    (eye,) = scenario.cameras
    models = [MarkerModel(p, list(eye.components), eye.mounting) for p in markers.positions]
    ekf = Ekf6(
        [*drive.pose[0], 0.0, 1.0, 1.0], np.diag(np.square([0.2, 0.2, 0.1, 3e-3, 0.02, 0.0]))
    )
    arc = CalibratedArc(0.01)
    for k, (distance, turn) in enumerate(drive.increments, start=1):
        # Once the gyro tells the turn, each wheel tells the distance: the better one counts more.
        left, right = distance - 0.25 * turn, distance + 0.25 * turn
        gamma = np.diag([0.05**2 * left * right / (left + right), 1e-4**2 * 0.01])
        ekf.predict(arc, [distance, turn], gamma, [0.0, 0.0, 0.0, 1e-4**2 * 0.01, 0.0, 0.0])
        for model in models:
            exact, _, _ = model.linearize(ekf.state[:3])
            assert ekf.update(model, exact, np.diag([0.02**2, 0.1**2])).accepted
        p = ekf.covariance  # but for the little that the wheels tell of the turn
        assert bound.position_m[k] == pytest.approx(np.sqrt(p[0, 0] + p[1, 1]), rel=1e-3)
        assert bound.heading_rad[k] == pytest.approx(np.sqrt(p[2, 2]), rel=1e-3)


def test_good_wheels_beside_a_bad_gyro_tell_the_turn_and_the_gyros_bias():
    encoders = Encoders(track_width_m=0.5, noise_m_per_sqrt_m=1e-5, scale_sigma=0.0)
    scenario = _scenario(encoders=encoders, gyro=Gyro(noise_rad_per_sqrt_s=0.1))
    drive = circle(5.0)
    transition, noise, calibration = motion(scenario, drive)
    assert np.abs(transition[:, 2, 3]).max() < 1e-6  # the bias turns nobody
    assert noise[:, 2, 2].max() < 1e-8
    # Each step of 10 ms measures the bias with the gyro's noise.
    np.testing.assert_allclose(calibration[:, 0, 0], 0.01**2 / (0.1**2 * 0.01), rtol=1e-3)


def test_standing_adds_no_noise():
    still = np.zeros(50)
    utime = np.arange(51) * 10_000
    drive = Drive(utime, still, still, np.zeros((51, 3)))
    _, noise, _ = motion(_scenario(), drive)
    assert np.abs(noise[:, :3, :3]).max() < 1e-12


def test_fewer_frames_tell_less():
    scenario, markers = _scenario(), four_poles()
    (eye,) = scenario.cameras
    drive = circle(scenario.duration_s)
    ends = [
        Bound.of(replace(scenario, cameras=(camera,)), markers, drive).position_m[-1]
        for camera in (eye, replace(eye, rate_hz=10.0), replace(eye, rate_hz=10.0, dropout=0.5))
    ]
    assert ends == sorted(ends)
    assert ends[0] < ends[1] < ends[2]


def test_the_start_is_as_wrong_as_it_is_drawn():
    yard = SCENARIOS["yard"]
    start = Start(sigma_position_m=0.1, sigma_heading_rad=0.05, error_factor=10.0)
    bound = Bound.of(replace(yard, start=start), yard.site(np.random.default_rng(0)), circle(1.0))
    assert bound.position_m[0] == pytest.approx(np.sqrt(2.0))
    assert bound.heading_rad[0] == pytest.approx(0.5)
