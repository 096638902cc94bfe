import numpy as np

from pilotage.evaluate import pose_errors
from support import runs


def test_error_is_estimate_less_truth() -> None:
    poses = runs.poses([0, 100], x=[3.0, 1.0], y=[4.0, 2.0], heading=[0.3, 0.0])
    errors = pose_errors(poses, runs.truth([0, 100], x=[0.0, 1.0], y=[0.0, 1.0], heading=0.1))
    np.testing.assert_array_equal(errors.position, [[3.0, 4.0], [0.0, 1.0]])
    np.testing.assert_array_equal(errors.distance, [5.0, 1.0])
    np.testing.assert_allclose(errors.heading, [0.2, -0.1], atol=1e-16)
    assert errors.pose.shape == (2, 3)


def test_heading_error_across_pi_is_small() -> None:
    poses = runs.poses([0], heading=np.radians(-179.0))
    errors = pose_errors(poses, runs.truth([0], heading=np.radians(179.0)))
    np.testing.assert_allclose(np.degrees(errors.heading), [2.0], atol=1e-12)


def test_constant_offset_is_not_aligned_away() -> None:
    utime = np.arange(0, 1000, 100)
    x = np.linspace(0.0, 1.0, 10)
    errors = pose_errors(runs.poses(utime, x=x + 0.5), runs.truth(utime, x=x))
    np.testing.assert_allclose(errors.distance, 0.5, atol=1e-15)


def test_without_truth_no_error_is_known() -> None:
    for truth in (None, runs.truth([])):
        errors = pose_errors(runs.poses([0, 1]), truth)
        assert np.isnan(errors.pose).all()
        assert np.isnan(errors.distance).all()
