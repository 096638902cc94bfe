"""The simulator: seeded, and with the noise that it says."""

from dataclasses import replace

import numpy as np
import pytest

import pilotage
from pilotage.evaluate import compute_metrics
from pilotage.simulate import SCENARIOS, Encoders, Gyro, simulate
from pilotage.simulate.drives import circle


def _short(name: str, **changes):
    return replace(SCENARIOS[name], duration_s=20.0, **changes)


def test_a_seed_gives_the_same_recording_and_another_seed_another():
    def recorded(seed: int) -> list[bytes]:
        recording = simulate(_short("figure-eight"), np.random.default_rng(seed)).recording
        return [recording[i][2] for i in range(len(recording))]

    assert recorded(3) == recorded(3)
    assert recorded(3) != recorded(4)


def test_the_mower_stays_on_its_field_and_passes_stretches_without_a_marker():
    simulation = simulate(SCENARIOS["mower-spiral"], np.random.default_rng(1))
    assert np.abs(simulation.truth["x"]).max() < 25.0
    assert np.abs(simulation.truth["y"]).max() < 37.5
    assert len(simulation.config.map) == 28
    run = pilotage.replay(simulation.config, simulation.recording)
    without_s = np.diff(np.unique(run.reports["utime"])) * 1e-6
    assert without_s.max() > 15.0


def test_the_eight_stays_clear_of_the_reflectors():
    simulation = simulate(SCENARIOS["figure-eight"], np.random.default_rng(1))
    for x, y, _ in simulation.config.map.positions:
        assert np.hypot(simulation.truth["x"] - x, simulation.truth["y"] - y).min() > 0.5


def test_a_circle_closes():
    lap = circle(2 * np.pi * 1.5 / 0.5)
    assert np.hypot(*(lap.pose[-1, :2] - lap.pose[0, :2])) < 0.5 * 0.01  # within a step


def test_the_wheels_noise_grows_with_the_root_of_the_distance():
    drive = circle(400.0)
    ticks = Encoders(track_width_m=0.4, m_per_tick=1e-9, noise_m_per_sqrt_m=0.02).ticks(
        drive, np.random.default_rng(0)
    )
    exact = Encoders(track_width_m=0.4, m_per_tick=1e-9, noise_m_per_sqrt_m=0.0).ticks(
        drive, np.random.default_rng(0)
    )
    steps = np.diff((ticks - exact) * 1e-9, axis=0)
    travelled = np.diff(exact * 1e-9, axis=0)
    assert np.std(steps / np.sqrt(travelled)) == pytest.approx(0.02, rel=0.02)


def test_the_gyros_angle_is_a_random_walk_of_the_stated_size_about_its_bias():
    drive = circle(400.0)
    rates = Gyro(noise_rad_per_sqrt_s=1e-3, bias_rad_s=0.01).rates(drive, np.random.default_rng(0))
    error = (rates[1:] - drive.omega) * 0.01
    assert error.mean() / 0.01 == pytest.approx(0.01, abs=2e-4)
    assert np.std(error) / np.sqrt(0.01) == pytest.approx(1e-3, rel=0.02)


def test_the_gyros_bias_wanders_as_stated():
    drive = circle(400.0)
    gyro = Gyro(noise_rad_per_sqrt_s=0.0, walk_rad_s_per_sqrt_s=1e-4)
    steps = np.diff(gyro.rates(drive, np.random.default_rng(0))[1:] - drive.omega)
    assert np.std(steps) / np.sqrt(0.01) == pytest.approx(1e-4, rel=0.02)


def test_each_wheel_has_its_own_scale():
    drive = circle(100.0)
    rng = np.random.default_rng(0)
    exact = Encoders(m_per_tick=1e-9, noise_m_per_sqrt_m=0.0)
    ratio = replace(exact, scale=(1.02, 0.99)).ticks(drive, rng)[-1] / exact.ticks(drive, rng)[-1]
    np.testing.assert_allclose(ratio, (1.02, 0.99), rtol=1e-6)


def test_a_camera_misses_the_stated_part():
    full = _short("figure-eight").cameras[0]
    counts = []
    for camera in (full, replace(full, dropout=0.3)):
        scenario = _short("figure-eight", cameras=(camera,))
        simulation = simulate(scenario, np.random.default_rng(1))
        counts.append(pilotage.replay(simulation.config, simulation.recording).counts["samples"])
    assert counts[1] / counts[0] == pytest.approx(0.7, abs=0.05)


@pytest.mark.parametrize("name", SCENARIOS)
def test_the_suitable_configuration_is_consistent(name: str):
    nees = []
    for seed in range(8):
        simulation = simulate(SCENARIOS[name], np.random.default_rng(seed))
        run = pilotage.replay(simulation.config, simulation.recording)
        metrics = compute_metrics(run, simulation.truth)
        assert metrics.nees is not None
        nees.append(metrics.nees.mean)
    assert 0.6 < np.mean(nees) / 3 < 1.4


def test_slip_and_bias_are_found_by_the_calibration_states():
    scenario = replace(
        SCENARIOS["figure-eight"],
        encoders=replace(SCENARIOS["figure-eight"].encoders, slip=0.03),
        gyro=Gyro(bias_rad_s=0.004),
    )
    simulation = simulate(scenario, np.random.default_rng(2))
    run = pilotage.replay(simulation.config, simulation.recording)
    metrics = compute_metrics(run, simulation.truth)
    assert metrics.position is not None
    assert metrics.position.rmse_m < 0.02
    for name in ("gyro_bias", "distance_scale"):
        simulation.config[f"calibration.{name}.sigma"] = 0.0
    frozen = compute_metrics(
        pilotage.replay(simulation.config, simulation.recording), simulation.truth
    )
    assert frozen.position is not None
    assert frozen.position.rmse_m > 2 * metrics.position.rmse_m


def test_frames_that_arrive_late_are_fused_at_their_own_time():
    late = simulate(_short("figure-eight", latency_s=0.15), np.random.default_rng(2))
    punctual = simulate(_short("figure-eight"), np.random.default_rng(2))
    errors = []
    for simulation in (late, punctual):
        run = pilotage.replay(simulation.config, simulation.recording)
        assert run.counts["rejected"].get("late", 0) == 0
        position = compute_metrics(run, simulation.truth).position
        assert position is not None
        errors.append(position.rmse_m)
    assert errors[0] < 1.5 * errors[1]
