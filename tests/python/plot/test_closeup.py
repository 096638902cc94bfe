import numpy as np
import pytest

from pilotage.plot import closeup_figure
from pilotage.plot.closeup import tick_poses, window_around, worst_pose
from support import runs
from support.artists import artist, has, texts


def test_window_lies_around_the_largest_error() -> None:
    run, truth, markers = runs.drive()
    run.poses["x"][300] = truth["x"][300] + 3.0
    run.poses["y"][300] = truth["y"][300]
    figure = closeup_figure(run, truth, markers)
    assert "around the largest position error, 3.00 m at 30 s" in texts(figure)
    x = artist(figure.axes[0], "estimate").get_xdata()
    assert 90 < x.size < 110  # 10 s of 40 s
    assert run.poses["x"][300] in x


def test_times_and_probability_stand_along_the_path() -> None:
    run, truth, markers = runs.drive()
    figure = closeup_figure(run, truth, markers, window_s=(8.0, 19.0))
    said = texts(figure)
    assert {"10", "12", "14", "16", "18"} <= set(said)
    assert {"95 %", "8 s to 19 s", "numbers: time since start (s)"} <= set(said)
    assert "95 % position ellipse (2.4477 σ)" in said


def test_estimate_is_joined_to_truth_of_the_same_moment() -> None:
    run, truth, _ = runs.drive()
    axes = closeup_figure(run, truth, window_s=(8.0, 18.0)).axes[0]
    x = artist(axes, "same moment").get_xdata()
    pose = np.flatnonzero(run.poses["x"] == x[0])[0]
    assert x[1] == pytest.approx(truth["x"][pose], abs=1e-12)
    assert np.isnan(x[2])


def test_without_truth_the_largest_variance_is_shown() -> None:
    run, _, _ = runs.drive()
    run.poses["covariance"][100, 0, 0] = 9.0
    assert worst_pose(run.poses, None) == (100, "around the largest position variance at 10 s")
    axes = closeup_figure(run).axes[0]
    assert not has(axes, "same moment")


def test_window_without_a_pose_is_refused() -> None:
    run, truth, _ = runs.drive()
    with pytest.raises(ValueError, match="no pose between 50 s and 60 s: the run lasts 40 s"):
        closeup_figure(run, truth, window_s=(50.0, 60.0))


def test_window_stays_inside_the_run() -> None:
    assert window_around(1.0, 400.0) == (0.0, 20.0)
    assert window_around(399.0, 400.0) == (380.0, 400.0)
    assert window_around(2.0, 5.0) == (0.0, 10.0)
    assert window_around(5000.0, 10_000.0) == (4970.0, 5030.0)


def test_ticks_are_round_times() -> None:
    time = np.arange(100.0, 130.0, 0.01)
    np.testing.assert_allclose(time[tick_poses(time)], [100, 105, 110, 115, 120, 125], atol=1e-9)
    np.testing.assert_array_equal(tick_poses(np.array([0.03])), [0])


def test_times_do_not_pile_up_where_the_robot_stands() -> None:
    x = np.concatenate([np.zeros(300), np.linspace(0.0, 5.0, 101)])
    run = runs.Run(poses=runs.poses(np.arange(401) * 50_000, x=x))
    tags = closeup_figure(run, window_s=(0.0, 20.0)).axes[0].texts
    assert [tag.get_text() for tag in tags if "%" not in tag.get_text()] == ["0", "20"]


def test_one_pose_can_be_drawn() -> None:
    closeup_figure(runs.Run(poses=runs.poses([0]))).draw_without_rendering()
