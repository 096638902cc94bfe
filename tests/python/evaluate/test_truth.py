import numpy as np

from pilotage.evaluate import interpolate
from support import runs


def test_position_lies_on_the_line_between_two_rows() -> None:
    truth = runs.truth([0, 400_000], x=[0.0, 4.0], y=[10.0, 6.0], heading=[0.1, 0.5])
    np.testing.assert_allclose(interpolate(truth, [100_000]), [[1.0, 9.0, 0.2]], atol=1e-15)


def test_heading_takes_the_shorter_arc_across_pi() -> None:
    truth = runs.truth([0, 100_000], heading=np.radians([170.0, -170.0]))
    heading = np.degrees(interpolate(truth, [25_000, 50_000, 75_000])[:, 2])
    np.testing.assert_allclose(heading, [175.0, 180.0, -175.0], atol=1e-12)


def test_nothing_is_known_outside_or_across_a_gap() -> None:
    truth = runs.truth([0, 500_000, 1_000_001], x=[0.0, 1.0, 2.0])
    x = interpolate(truth, [-1, 250_000, 500_000, 750_000, 1_000_001, 1_000_002])[:, 0]
    np.testing.assert_array_equal(x, [np.nan, 0.5, 1.0, np.nan, 2.0, np.nan])


def test_gap_bound_can_be_stated() -> None:
    truth = runs.truth([0, 1_000_000], x=[0.0, 1.0])
    assert interpolate(truth, [500_000], max_gap_s=1.0)[0, 0] == 0.5


def test_invalid_row_hides_its_intervals_but_not_its_neighbours() -> None:
    truth = runs.truth([0, 100, 200, 300], x=[0.0, 1.0, np.nan, np.inf])
    x = interpolate(truth, [50, 100, 150, 200, 250, 300])[:, 0]
    np.testing.assert_array_equal(x, [0.5, 1.0, np.nan, np.nan, np.nan, np.nan])


def test_position_without_heading_is_still_a_position() -> None:
    truth = runs.truth([0, 100], x=[0.0, 1.0], y=[0.0, 2.0], heading=np.nan)
    np.testing.assert_array_equal(interpolate(truth, [50]), [[0.5, 1.0, np.nan]])


def test_last_row_of_a_repeated_stamp_stands_at_it() -> None:
    truth = runs.truth([0, 100, 100, 200], x=[0.0, 1.0, 5.0, 6.0])
    x = interpolate(truth, [50, 100, 150])[:, 0]
    np.testing.assert_array_equal(x, [0.5, 5.0, 5.5])


def test_times_may_repeat_and_truth_may_be_out_of_order() -> None:
    truth = runs.truth([200, 0, 100], x=[2.0, 0.0, 1.0])
    np.testing.assert_array_equal(interpolate(truth, [150, 150])[:, 0], [1.5, 1.5])


def test_stamps_of_today_lose_no_microsecond() -> None:
    now = 1_760_000_000_000_000
    truth = runs.truth([now, now + 10], x=[0.0, 10.0])
    assert interpolate(truth, [now + 3])[0, 0] == 3.0


def test_empty_truth_knows_nothing() -> None:
    assert np.isnan(interpolate(runs.truth([]), [0, 1])).all()
