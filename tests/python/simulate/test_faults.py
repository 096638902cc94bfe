"""Each fault changes the messages as it says, and only those sent while it lasts."""

import numpy as np
import pytest

from pilotage import MarkerMap
from pilotage.simulate import Stream, faults
from pilotage.simulate.faults import Strike

STEP = 10_000


def _stream(count: int = 100) -> Stream:
    """Totals of two wheels that count up by 3 and 5 a message of 10 ms, 2 ms on their way."""
    utime = np.arange(count, dtype=np.int64) * STEP
    stream = Stream.sent(utime, np.arange(count)[:, None] * np.array([3.0, 5.0]))
    return stream.late(0.002, 0.0, np.random.default_rng(0))


def _frames() -> Stream:
    """Forty frames of two markers each."""
    utime = np.repeat(np.arange(40, dtype=np.int64) * STEP, 2)
    value = np.column_stack([np.arange(80.0), np.full(80, np.nan), 80.0 + np.arange(80.0)])
    return Stream.sent(utime, value, np.tile(np.array([7, 8], np.int32), 40))


def _strike(stream: Stream, start: int = 40, end: int = 70) -> Strike:
    hit = (stream.utime >= start * STEP) & (stream.utime < end * STEP)
    rng = np.random.default_rng(1)
    return Strike(
        hit, rng, MarkerMap([7, 8], np.zeros((2, 3))), lambda position, utime: np.empty(0)
    )


def _same_outside(before: Stream, after: Stream, strike: Strike) -> None:
    """Rows of messages that the fault does not touch are the same in every column."""
    kept = before.rows(~strike.hit)
    untouched = after.rows(np.isin(after.seq, kept.seq))
    for name in ("utime", "received", "seq", "value", "id"):
        np.testing.assert_array_equal(getattr(untouched, name), getattr(kept, name))


def test_off_sends_nothing():
    stream = _stream()
    strike = _strike(stream)
    struck = faults.off(stream, strike)
    assert len(struck) == 70
    _same_outside(stream, struck, strike)


def test_stuck_repeats_what_was_measured_last_under_new_stamps():
    stream = _stream()
    strike = _strike(stream)
    struck = faults.stuck(stream, strike)
    np.testing.assert_array_equal(struck.utime, stream.utime)
    np.testing.assert_array_equal(struck.seq, stream.seq)
    np.testing.assert_array_equal(struck.value[40:70], np.tile(stream.value[39], (30, 1)))
    _same_outside(stream, struck, strike)


def test_a_stuck_frame_is_repeated_whole():
    stream = _frames().rows(np.arange(80) != 21)  # the frame before has lost its second marker
    strike = _strike(stream, 11, 20)
    struck = faults.stuck(stream, strike)
    stuck = struck.rows((struck.seq >= 11) & (struck.seq < 20))
    np.testing.assert_array_equal(stuck.seq, np.arange(11, 20))
    np.testing.assert_array_equal(stuck.id, np.full(9, 7))
    np.testing.assert_array_equal(stuck.value[:, 0], np.full(9, 20.0))
    _same_outside(stream, struck, strike)


def test_garbage_is_anywhere_between_the_bounds():
    stream = _stream()
    strike = _strike(stream)
    struck = faults.garbage(stream, strike, low=[-10.0, 100.0], high=[10.0, 110.0])
    left, right = struck.value[strike.hit].T
    assert left.min() >= -10.0
    assert left.max() <= 10.0
    assert right.min() >= 100.0
    assert np.std(right) > 1.0
    _same_outside(stream, struck, strike)


def test_what_is_not_measured_stays_so():
    stream = _frames()
    struck = faults.garbage(stream, _strike(stream, 10, 20), low=-1.0, high=1.0)
    assert np.isnan(struck.value[:, 1]).all()
    assert np.isfinite(struck.value[:, [0, 2]]).all()


def test_nan_is_no_number():
    stream = _stream()
    strike = _strike(stream)
    struck = faults.nan(stream, strike)
    assert np.isnan(struck.value[strike.hit]).all()
    _same_outside(stream, struck, strike)


def test_linear_has_factor_and_offset():
    stream = _stream()
    strike = _strike(stream)
    struck = faults.linear(stream, strike, factor=[2.0, 1.0], offset=[0.0, 4.0])
    np.testing.assert_allclose(struck.value[strike.hit], stream.value[strike.hit] * [2, 1] + [0, 4])
    _same_outside(stream, struck, strike)


def test_travel_changes_the_growth_of_totals_and_leaves_no_jump():
    stream = _stream()
    struck = faults.travel(stream, _strike(stream), factor=[2.0, -1.0])
    growth = np.diff(struck.value, axis=0)
    np.testing.assert_array_equal(growth[39:69], np.tile([6.0, -5.0], (30, 1)))
    np.testing.assert_array_equal(np.delete(growth, np.s_[39:69], axis=0), np.tile([3, 5], (69, 1)))


def test_slow_keeps_one_of_so_many():
    stream = _stream()
    strike = _strike(stream)
    struck = faults.slow(stream, strike, one_of=10)
    np.testing.assert_array_equal(struck.seq, [*range(40), 40, 50, 60, *range(70, 100)])


def test_intermittent_is_silent_and_sending_by_turns():
    stream = _stream()
    strike = _strike(stream)
    struck = faults.intermittent(stream, strike, off_s=0.05, on_s=0.05)
    _same_outside(stream, struck, strike)
    kept = np.isin(np.arange(40, 70), struck.seq)
    assert kept.sum() == 15
    assert np.abs(np.diff(kept.astype(int))).sum() in (5, 6)


def test_delayed_comes_late_and_in_order():
    stream = _stream()
    struck = faults.delayed(stream, _strike(stream), delay_s=0.2)
    way = struck.received - struck.utime
    np.testing.assert_array_equal(way[:40], 2_000)
    np.testing.assert_array_equal(way[40:70], 202_000)
    assert (np.diff(struck.received) >= 0).all()
    np.testing.assert_array_equal(way[90:], 2_000)
    np.testing.assert_array_equal(struck.utime, stream.utime)


def test_out_of_order_overtakes_by_no_more_than_the_limit():
    stream = _stream()
    strike = _strike(stream)
    struck = faults.out_of_order(stream, strike, delay_s=0.1)
    assert (np.diff(struck.received) < 0).any()
    way = struck.received - stream.received
    assert way.min() >= 0
    assert 50_000 < way.max() <= 100_000
    _same_outside(stream, struck, strike)


def test_the_sightings_of_a_frame_arrive_together():
    stream = _frames()
    struck = faults.out_of_order(stream, _strike(stream, 10, 20), delay_s=0.1)
    np.testing.assert_array_equal(struck.received[::2], struck.received[1::2])


def test_a_burst_comes_at_once():
    stream = _stream()
    struck = faults.burst(stream, _strike(stream), hold_s=0.1)
    for first in (40, 50, 60):
        arrivals = struck.received[first : first + 10]
        np.testing.assert_array_equal(arrivals, (first + 10) * STEP + 2_000)
    np.testing.assert_array_equal(struck.utime, stream.utime)


def test_a_duplicate_is_the_same_but_for_its_arrival():
    stream = _frames()
    strike = _strike(stream, 10, 20)
    struck = faults.duplicate(stream, strike, copies=2, apart_s=0.003)
    assert len(struck) == 80 + 2 * 20
    copies = struck.rows(np.arange(80, 120))
    for i in range(2):
        copy = copies.rows(np.arange(20) + 20 * i)
        np.testing.assert_array_equal(copy.value, stream.value[strike.hit])
        np.testing.assert_array_equal(copy.seq, stream.seq[strike.hit])
        np.testing.assert_array_equal(copy.utime, stream.utime[strike.hit])
        np.testing.assert_array_equal(copy.received - copy.utime, (i + 1) * 3_000)


@pytest.mark.parametrize("ahead_s", [0.5, -0.5])
def test_restamped_is_ahead_or_behind(ahead_s: float):
    stream = _stream()
    strike = _strike(stream)
    struck = faults.restamped(stream, strike, ahead_s=ahead_s)
    np.testing.assert_array_equal((struck.utime - stream.utime)[strike.hit], ahead_s * 1e6)
    np.testing.assert_array_equal(struck.received, stream.received)
    _same_outside(stream, struck, strike)


def test_a_drifting_clock_gains_steadily():
    stream = _stream()
    strike = _strike(stream)
    struck = faults.drifting(stream, strike, ppm=1000)
    np.testing.assert_array_equal((struck.utime - stream.utime)[strike.hit], np.arange(30) * 10)
    _same_outside(stream, struck, strike)
