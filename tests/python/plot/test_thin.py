import numpy as np

from pilotage.plot.thin import envelope, stride


def test_short_series_comes_back_as_it_is() -> None:
    x, y = np.arange(20.0), np.arange(20.0)
    assert envelope(x, y, buckets=10)[1] is y


def test_lowest_and_highest_points_survive_in_order() -> None:
    y = np.zeros(10_000)
    y[[1234, 1237, 9_999]] = -5.0, 7.0, 2.0
    x, thin = envelope(np.arange(10_000.0), y, buckets=100)
    assert thin.size == 200
    assert np.all(np.diff(x) >= 0.0)
    for at in (1234, 1237, 9_999):
        assert thin[np.flatnonzero(x == at)] == [y[at]]


def test_gap_stays_a_gap() -> None:
    y = np.ones(10_000)
    y[3000:5000] = np.nan
    x, thin = envelope(np.arange(10_000.0), y, buckets=100)
    np.testing.assert_array_equal(np.isnan(thin), (x >= 3000) & (x < 5000))


def test_stride_keeps_within_the_limit() -> None:
    for count, limit in ((0, 10), (10, 10), (11, 10), (1001, 10)):
        kept = np.arange(count)[stride(count, limit)]
        assert kept.size <= limit
        assert kept.size == count or kept.size > limit // 2
