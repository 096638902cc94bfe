import numpy as np
import pytest

from pilotage.evaluate.echo import Receiver, calibrate, cramer_rao, fit_echo, threshold
from pilotage.simulate.echo import Ultrasonic

PAIR = Ultrasonic()
TIMES = PAIR.times(14e-3)
STATE = PAIR.state(1.0, 5e-3)


def receiver(band_hz=10e3):
    return Receiver(PAIR.carrier_hz, PAIR.sample_hz, band_hz)


def clean():
    return PAIR.echo(TIMES, STATE, np.random.default_rng(0))


def test_noise_within_the_band_is_what_the_receiver_says():
    noise = np.random.default_rng(1).standard_normal(200_000)
    power = np.mean(np.square(receiver().envelope(noise)))
    assert power == pytest.approx(2 * receiver().noise(1.0) ** 2, rel=0.03)


def test_noise_is_independent_a_band_apart():
    noise = np.random.default_rng(2).standard_normal(400_000)
    squared = np.square(receiver().envelope(noise))[:: round(PAIR.sample_hz / 10e3)]
    assert abs(np.corrcoef(squared[1:], squared[:-1])[0, 1]) < 0.03


def test_a_wide_receiver_finds_the_pairs_own_parameters():
    found = calibrate(receiver(80e3), TIMES, clean(), STATE)
    assert found.time_s == pytest.approx(PAIR.time_s, rel=0.01)
    assert found.shape == pytest.approx(PAIR.shape, rel=0.01)
    assert abs(found.lead_s) < 1e-6


def test_a_clean_echo_is_found_to_a_tenth_of_a_sample():
    start = calibrate(receiver(), TIMES, clean(), STATE)
    late = PAIR.state(0.4, 7.1234e-3)
    samples = PAIR.echo(TIMES, late, np.random.default_rng(3))
    state, covariance = fit_echo(receiver(), TIMES, receiver().envelope(samples), 1e-3, start)
    assert state[1] - start.lead_s == pytest.approx(late[1], abs=0.1 / PAIR.sample_hz)
    assert covariance[2, 2] == covariance[3, 3] == 0.0


def test_the_threshold_is_crossed_last_before_the_peak():
    crossing, peak = threshold(np.arange(6.0), np.array([0.0, 0.9, 0.1, 0.6, 1.0, 0.0]))
    assert crossing == pytest.approx(2.8)
    assert peak == 1.0


def test_the_bound_falls_with_noise_and_rises_with_what_is_unknown():
    calibrated, free = np.array([np.inf, np.inf, 0.0, 0.0]), np.full(4, np.inf)
    one = cramer_rao(TIMES, STATE, 0.1, calibrated)
    assert cramer_rao(TIMES, STATE, 0.2, calibrated) == pytest.approx(2 * one, rel=1e-6)
    some = np.array([np.inf, np.inf, 0.2 * PAIR.time_s, 0.2 * PAIR.shape])
    assert one < cramer_rao(TIMES, STATE, 0.1, some) < cramer_rao(TIMES, STATE, 0.1, free)
