"""Wheels that report speeds, and a camera that finds square markers."""

from dataclasses import replace

import numpy as np
import pytest

from pilotage import ArcVelocity
from pilotage.evaluate import wrap_angle
from pilotage.evaluate.mse import mean_squared_errors, spread
from pilotage.simulate import drives, worlds
from pilotage.simulate.fiducials import FiducialCamera
from pilotage.simulate.wheel_speeds import WheelSpeeds
from pilotage.simulate.wheels_and_camera import WheelsAndCamera

EXACT = FiducialCamera(
    sigma_bearing_rad=0.0, sigma_range_per_m=0.0, sigma_direction_rad_per_m=0.0, wild_share=0.0
)


@pytest.fixture(scope="module")
def drive():
    return drives.weaving(30.0)


def test_exact_wheels_lead_to_the_truth(drive):
    wheels = WheelSpeeds(0.3, 0.0, rate_hz=100.0)
    driven = WheelsAndCamera.on(drive, worlds.ring(), wheels, np.random.default_rng(0))
    path = ArcVelocity(wheels.step_s).path(driven.truth[0], driven.rates)
    np.testing.assert_allclose(path, driven.truth, atol=1e-8)
    left, right = driven.ticks(1e-6)[-1] * 1e-6
    assert (right - left) / 0.3 == pytest.approx(driven.truth[-1, 2] - driven.truth[0, 2], abs=1e-4)


def test_noise_of_wheels_is_that_of_speed_and_yaw_rate(drive):
    wheels = WheelSpeeds(0.3, 0.1)
    noise = wheels.report(drive, np.random.default_rng(0)) - replace(wheels, sigma_m_s=0.0).report(
        drive, np.random.default_rng(0)
    )
    covariance = np.cov((noise @ wheels.mixing.T).T)
    stated = wheels.rate_covariance()
    np.testing.assert_allclose(np.diag(covariance), np.diag(stated), rtol=0.15)
    np.testing.assert_allclose(stated, np.diag([0.005, 2 * 0.01 / 0.09]), atol=1e-15)


def test_an_exact_camera_sees_bearing_range_and_direction(drive):
    markers, utime = worlds.ring(), drive.utime[::50]
    seen = EXACT.detect(drive, markers, utime, np.random.default_rng(0))
    pose = drive.at(utime)[seen.frame]
    marker = markers.positions[seen.marker, :2]
    across = pose[:, :2] - marker
    np.testing.assert_allclose(
        wrap_angle(seen.direction - np.arctan2(across[:, 1], across[:, 0])), 0, atol=1e-12
    )
    heading = pose[:, 2]
    lens = pose[:, :2] + 0.07 * np.column_stack([np.cos(heading), np.sin(heading)])
    np.testing.assert_allclose(seen.range, np.hypot(*(marker - lens).T), rtol=1e-12)
    assert (np.abs(seen.bearing) <= EXACT.camera.half_view_rad).all()


def test_only_far_markers_are_wild(drive):
    markers, utime = worlds.ring(), drive.utime[::10]
    exact, wild = (
        replace(EXACT, wild_share=share).detect(drive, markers, utime, np.random.default_rng(0))
        for share in (0.0, 0.2)
    )
    astray = np.abs(wrap_angle(wild.direction - exact.direction)) > 1e-9
    assert not astray[exact.range <= 3.0].any()
    assert astray[exact.range > 3.0].mean() == pytest.approx(0.2, abs=0.03)


def test_nearest_and_limit():
    drive = drives.weaving(20.0)
    seen = EXACT.detect(drive, worlds.ring(), drive.utime[::10], np.random.default_rng(0))
    nearest = seen.nearest()
    assert len(np.unique(nearest.frame)) == len(nearest.frame) == len(np.unique(seen.frame))
    for frame, distance in zip(nearest.frame, nearest.range, strict=True):
        assert distance == seen.range[seen.frame == frame].min()
    assert seen.within(2.0).range.max() <= 2.0 < seen.range.max()


def test_mean_squared_errors_wrap_headings():
    truth = np.zeros((5, 3))
    estimate = truth + np.array([1.0, -2.0, 2 * np.pi - 0.5])
    np.testing.assert_allclose(mean_squared_errors(estimate, truth, 2), [[1, 4, 0.25]] * 2)


def test_spread_is_of_means():
    values = np.repeat([0.0, 1.0], 10)
    assert spread(values) == (0.0, 1.0)
    assert spread(np.tile([0.0, 1.0], 10), of=2) == (0.5, 0.5)
    assert spread(np.array([1.0, 3.0]), of=5) == (2.0, 2.0)
