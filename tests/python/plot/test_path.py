import numpy as np

from pilotage.plot import path_figure
from pilotage.plot.path import spread_along
from support import runs
from support.artists import artist, has, texts


def test_path_shows_truth_estimate_markers_and_ellipses() -> None:
    run, truth, markers = runs.drive()
    figure = path_figure(run, truth, markers)
    axes = figure.axes[0]
    np.testing.assert_array_equal(artist(axes, "truth").get_xdata(), truth["x"])
    np.testing.assert_array_equal(artist(axes, "estimate").get_ydata(), run.poses["y"])
    np.testing.assert_array_equal(artist(axes, "markers").get_xdata(), [6.0, -6.0])
    assert artist(axes, "markers").get_marker() == "*"
    assert len(artist(axes, "ellipses").get_paths()) == 30
    said = texts(figure)
    assert "95 % position ellipse (2.4477 σ)" in said
    assert {"3", "7", "95 %", "x in frame map (m)", "truth", "estimate"} <= set(said)
    assert axes.get_aspect() == 1.0


def test_ellipses_have_their_true_size() -> None:
    run, _, _ = runs.drive()
    outline = artist(path_figure(run).axes[0], "ellipses").get_paths()[0].vertices
    assert abs(np.ptp(outline[:, 0]) - 2 * 2.4477 * 0.1) < 1e-3
    assert abs(np.ptp(outline[:, 1]) - 2 * 2.4477 * 0.2) < 1e-3


def test_tiny_ellipses_are_drawn_larger_and_say_so() -> None:
    run, _, _ = runs.drive()
    run.poses["covariance"] *= 1e-4
    figure = path_figure(run)
    assert "95 % position ellipse (2.4477 σ, drawn 50×)" in texts(figure)
    outline = artist(figure.axes[0], "ellipses").get_paths()[0].vertices
    assert abs(np.ptp(outline[:, 0]) - 2 * 2.4477 * 0.1 * 0.01 * 50) < 1e-3


def test_truth_is_darker_than_the_estimate() -> None:
    run, truth, _ = runs.drive()
    axes = path_figure(run, truth).axes[0]

    def grey(gid: str) -> float:
        colour = artist(axes, gid).get_color().lstrip("#")
        red, green, blue = (int(colour[i : i + 2], 16) for i in (0, 2, 4))
        return 0.299 * red + 0.587 * green + 0.114 * blue

    assert grey("truth") + 60 < grey("estimate")


def test_truth_line_breaks_at_a_gap() -> None:
    run, truth, _ = runs.drive(4000)
    truth = np.delete(truth, np.s_[1000:1100])
    line = artist(path_figure(run, truth).axes[0], "truth")
    assert np.isnan(line.get_xdata()[1000])
    assert np.count_nonzero(np.isnan(line.get_xdata())) == 1


def test_all_of_path_and_map_is_in_view() -> None:
    run, truth, markers = runs.drive()
    axes = path_figure(run, truth, markers).axes[0]
    (left, right), (low, high) = axes.get_xlim(), axes.get_ylim()
    assert left < -6.0 < 6.0 < right
    assert low < -5.0 < 5.0 < high


def test_without_truth_and_map_the_estimate_stands_alone() -> None:
    run, _, _ = runs.drive()
    figure = path_figure(run)
    axes = figure.axes[0]
    assert not has(axes, "truth")
    assert not has(axes, "markers")
    assert "truth" not in texts(figure)
    path_figure(run, runs.truth([]), runs.Map(np.zeros(0, np.int32), np.zeros((0, 3))))


def test_poses_are_spread_by_distance_not_by_time() -> None:
    poses = runs.poses(np.arange(104), x=np.concatenate([np.zeros(100), [1.0, 2.0, 3.0, 4.0]]))
    np.testing.assert_array_equal(spread_along(poses, 4), [100, 101, 102, 103])


def test_robot_that_stands_still_can_be_drawn() -> None:
    path_figure(runs.Run(poses=runs.poses([0, 1, 2]))).draw_without_rendering()


def test_the_last_ellipse_is_at_the_end_whatever_the_length() -> None:
    run, _, _ = runs.drive()
    for count in range(1, 60):
        chosen = spread_along(run.poses, count)
        assert chosen.max() == len(run.poses) - 1
