"""The first paper's drive as simulated: length, clock, gaps, and the shared drive's noise."""

import numpy as np
import pytest

from pilotage import MarkerModel
from pilotage.evaluate import wrap_angle
from pilotage.logs.mower import Triple, read_triple
from pilotage.simulate import Encoders
from pilotage.simulate.drives import circle
from pilotage.simulate.mower import BEHIND_S, BLIND_S, DURATION_S, mower_log
from pilotage.simulate.poselog import at_rows, in_step
from support.datasets import dataset

ROWS = 1000  # 10 s


@pytest.fixture(scope="module")
def log() -> Triple:
    return mower_log(np.random.default_rng((1, 0)))


def test_it_is_as_long_and_sees_as_much_as_the_papers(log: Triple):
    assert log.time[-1] - log.time[0] == pytest.approx(DURATION_S, abs=0.05)
    assert len(log.marker_id) == 28
    assert 160 <= len(log.sighting_time) <= 200
    turned = np.degrees(log.truth[-1, 2] - log.truth[0, 2])
    assert turned == pytest.approx(6 * 360, abs=30)  # inwards, six times round


def test_its_stamps_repeat_and_a_uniform_clock_would_fall_5_s_behind(log: Triple):
    steps = np.diff(log.time)
    assert steps.min() == 0.0
    assert 100 <= np.sum(steps == 0.0) <= 1000
    assert log.time[-1] - in_step(log).time[-1] == pytest.approx(BEHIND_S, abs=0.1)


def test_one_marker_or_none_is_seen_in_the_paper_s_stretch(log: Triple):
    since = log.sighting_time - log.time[0]
    assert np.sum((since >= BLIND_S[0]) & (since < BLIND_S[1])) <= 1
    assert np.sum(since >= BLIND_S[1]) > 50


def test_ideal_angles_are_of_the_same_markers_at_the_same_times(log: Triple):
    ideal = mower_log(np.random.default_rng((1, 0)), marker_noise=0.0)
    assert (ideal.sighting_time == log.sighting_time).all()
    assert (ideal.sighting_id == log.sighting_id).all()
    assert (ideal.motion == log.motion).all()
    assert np.std(wrap_angle(log.sighting - ideal.sighting), axis=0) == pytest.approx(
        [0.048, 0.006], rel=0.15
    )
    assert np.abs(_angle_errors(ideal)).max() < 0.02  # 1 cm between rows, half a metre off


def test_a_sighting_is_dated_by_the_first_row_at_or_after_it(log: Triple):
    late = at_rows(log).sighting_time - log.sighting_time
    assert late.min() >= 0.0
    assert late.max() < 0.03


def test_its_noise_is_that_of_the_shared_drive():
    real = _noise(read_triple(dataset("mower-listing")))
    drawn = [_noise(mower_log(np.random.default_rng((1, k)))) for k in range(10)]
    for name in real:
        spread = [noise[name] for noise in drawn]
        assert min(spread) * 0.9 <= real[name] <= max(spread) * 1.1, (name, real[name], spread)


def test_slip_that_lasts_is_as_large_and_as_lasting_as_it_says():
    drive = circle(4000.0)
    slips = Encoders(m_per_tick=1e-9, noise_m_per_sqrt_m=0.0, wander=0.02, wander_s=20.0)
    exact = Encoders(m_per_tick=1e-9, noise_m_per_sqrt_m=0.0).travel(drive)
    wander = np.diff(slips.ticks(drive, np.random.default_rng(1)) * 1e-9, axis=0) / exact - 1.0
    assert np.std(wander, axis=0) == pytest.approx([0.02, 0.02], rel=0.2)
    after_20_s = np.mean(wander[2000:] * wander[:-2000], axis=0) / 0.02**2
    assert after_20_s == pytest.approx(np.exp([-1.0, -1.0]), abs=0.2)


def _noise(log: Triple) -> dict[str, float]:
    """How large the errors of a log are, by its truth."""
    step = log.time[-1] - log.time[0]
    step /= len(log.time) - 1
    turn = np.diff(log.truth[:, 2])
    rate = log.motion[1:, 2] - turn / step
    ahead = log.truth[ROWS::ROWS, :2] - log.truth[:-ROWS:ROWS, :2]
    # A chord is short of its arc by sin(half the turn) over half the turn.
    half = (log.truth[ROWS::ROWS, 2] - log.truth[:-ROWS:ROWS, 2]) / 2
    way = np.hypot(*ahead.T) / np.sinc(half / np.pi)
    wheels = np.add.reduceat(log.motion[1:, :2].mean(axis=1), np.arange(0, len(turn), ROWS))
    scale = wheels[: len(way)] / way - 1.0
    second = np.diff(log.truth[:, 0], 2)
    azimuth, elevation = _angle_errors(log).std(axis=0)
    return {
        "distance over 10 s": float(np.std(scale)),
        "gyro": float(np.std(rate)),
        "reference": float(np.std(second)),
        "azimuth": float(azimuth),
        "elevation": float(elevation),
    }


def _angle_errors(log: Triple) -> np.ndarray:
    row = np.minimum(np.searchsorted(log.time, log.sighting_time), len(log.time) - 1)
    place = dict(zip(log.marker_id.tolist(), log.marker_position, strict=True))
    errors = []
    for k, i in enumerate(row):
        marker = [*place[log.sighting_id[k]], 0.0]
        model = MarkerModel(marker, ["bearing", "elevation"], [0.0, 0.0, 0.226, 0.0])
        errors.append(model.minus(log.sighting[k], model.predict(log.truth[[i]])[0]))
    return np.array(errors)
