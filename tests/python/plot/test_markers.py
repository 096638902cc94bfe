import numpy as np

from pilotage.plot import markers_figure
from pilotage.plot.markers import count_frames
from support import runs
from support.artists import artist, texts


def test_frames_are_counted_by_sensor_and_number() -> None:
    reports = runs.reports(
        [20, 10, 10, 10, 10],
        sensor=[0, 0, 0, 1, 0],
        frame_seq=[2, 1, 1, 1, 1],
        accepted=[True, True, False, True, True],
    )
    utime, seen, fused = count_frames(reports)
    np.testing.assert_array_equal(utime, [10, 10, 20])
    np.testing.assert_array_equal(seen, [3, 1, 1])
    np.testing.assert_array_equal(fused, [2, 1, 1])


def test_bars_are_sightings_per_frame() -> None:
    run, _, _ = runs.drive()  # two sightings a frame, every eighth sighting rejected
    axes = markers_figure(run).axes[0]
    seen = artist(axes, "seen, not fused").get_data().values
    fused = artist(axes, "fused").get_data().values
    np.testing.assert_array_equal(np.unique(seen), [0.0, 2.0])
    np.testing.assert_array_equal(np.unique(fused), [0.0, 1.0, 2.0])
    assert np.count_nonzero(seen) == 40
    assert np.count_nonzero(fused == 1.0) == 10


def test_trace_and_variances_stand_apart_with_their_units() -> None:
    run, _, _ = runs.drive()
    figure = markers_figure(run)
    _, trace, position, heading = figure.axes
    for axes, value in ((trace, 0.0525), (position, 0.05), (heading, 0.0025)):
        np.testing.assert_allclose(artist(axes, "variance").get_ydata(), value)
        assert axes.get_yscale() == "log"
    assert {"m² + rad²", "m²", "rad²", "trace of P"} <= set(texts(figure))


def test_zero_variance_and_no_sightings_are_said() -> None:
    run = runs.Run(poses=runs.poses([0, 1], covariance=np.zeros((3, 3))))
    figure = markers_figure(run)
    assert {"zero throughout", "no sightings"} <= set(texts(figure))
    figure.draw_without_rendering()
