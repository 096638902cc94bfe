"""The core's models from Python: shapes, many at once, and as models of a filter."""

import gc

import numpy as np
import pytest

import pilotage

POSE = np.array([1.0, 1.5, 0.3])
ROOM = [[0, 0, 4, 0], [4, 0, 4, 2], [4, 2, 0, 2], [0, 2, 0, 0]]
NO_NOISE = np.zeros(3)

MOTIONS = {
    "MoveAndTurn": (pilotage.MoveAndTurn(), [2.0, 0.5]),
    "EulerVelocity": (pilotage.EulerVelocity(0.1), [2.0, 0.5]),
    "MidpointVelocity": (pilotage.MidpointVelocity(0.1), [2.0, 0.5]),
    "ArcVelocity": (pilotage.ArcVelocity(0.1, slip_angle_rad=0.1), [2.0, 0.5]),
    "LinearizedVelocity": (pilotage.LinearizedVelocity(0.1), [2.0, 0.5]),
    "PlanarVelocity": (pilotage.PlanarVelocity(0.1), [2.0, -0.3, 0.5]),
    "SkidSteer": (pilotage.SkidSteer([[0.5, 0.5], [0.01, -0.01], [2, -2]], 0.1), [1.0, 0.9]),
}

MEASUREMENTS = {
    "RelativePosition": (pilotage.RelativePosition([5, 4], mounting=[0.2, 0, 0.1]), 2),
    "WorldBearing": (pilotage.WorldBearing([5, 4]), 1),
    "WallRange": (pilotage.WallRange(pilotage.WallMap(ROOM), -1.0), 1),
    "PositionFix": (pilotage.PositionFix(lever_arm=[0.5, 0.1]), 2),
    "HeadingFix": (pilotage.HeadingFix(offset_rad=0.2), 1),
    "PoseFix": (pilotage.PoseFix(), 3),
}


@pytest.fixture(params=MOTIONS)
def motion(request):
    return MOTIONS[request.param]


@pytest.fixture(params=MEASUREMENTS)
def measurement(request):
    return MEASUREMENTS[request.param]


def difference_quotients(function, at, step=1e-6):
    columns = [function(at + step * e) - function(at - step * e) for e in np.eye(len(at))]
    return np.column_stack(columns) / (2 * step)


def test_jacobians_of_motions_are_difference_quotients(motion):
    model, u = motion
    _, a, b = model.linearize(POSE, u)
    by_u = difference_quotients(lambda v: model.linearize(POSE, v)[0], np.array(u))
    np.testing.assert_allclose(b, by_u, atol=1e-9)
    if not isinstance(model, pilotage.LinearizedVelocity):
        by_x = difference_quotients(lambda x: model.linearize(x, u)[0], POSE)
        np.testing.assert_allclose(a, by_x, atol=1e-9)


def test_paths_are_steps_one_after_the_other(motion):
    model, u = motion
    path = model.path(POSE, [u, u])
    assert path.shape == (3, 3)
    np.testing.assert_array_equal(path[0], POSE)
    np.testing.assert_array_equal(path[1], model.linearize(POSE, u)[0])
    np.testing.assert_array_equal(path[1:], model.step_each(path[:-1], [u, u]))
    with pytest.raises(ValueError, match="u must have shape"):
        model.path(POSE, u)


def test_filters_predict_by_any_motion(motion):
    model, u = motion
    p, gamma = np.diag([0.1, 0.2, 0.3]), 0.01 * np.eye(len(u))
    ekf = pilotage.Ekf3(POSE, p)
    ekf.predict(model, u, gamma, NO_NOISE)
    following, a, b = model.linearize(POSE, u)
    np.testing.assert_array_equal(ekf.state, following)
    np.testing.assert_allclose(ekf.covariance, a @ p @ a.T + b @ gamma @ b.T, rtol=1e-12)


def test_an_input_of_another_size_is_named():
    ekf = pilotage.Ekf3(POSE, np.eye(3))
    with pytest.raises(ValueError, match=r"u must have shape \(m,\) and gamma \(m, m\), m = 2"):
        ekf.predict(pilotage.MoveAndTurn(), [1.0, 2.0, 3.0], np.eye(3), NO_NOISE)


def test_jacobians_of_measurements_are_difference_quotients(measurement):
    model, m = measurement
    value, jacobian, defined = model.linearize(POSE)
    assert defined
    assert value.shape == (m,)
    quotients = difference_quotients(lambda x: model.linearize(x)[0], POSE)
    np.testing.assert_allclose(jacobian, quotients, atol=1e-8)


def test_many_poses_at_once_give_what_each_gives(measurement):
    model, m = measurement
    poses = np.linspace([0.5, 0.5, -0.4], [3.0, 1.5, 0.4], 7)
    values = model.predict(poses)
    assert values.shape == (7, m)
    np.testing.assert_array_equal(values, [model.linearize(pose)[0] for pose in poses])
    with pytest.raises(ValueError, match="states must have shape"):
        model.predict(POSE)


def test_filters_update_by_any_measurement(measurement):
    model, m = measurement
    ekf = pilotage.Ekf3(POSE, 0.1 * np.eye(3))
    report = ekf.update(model, model.linearize(POSE)[0], np.eye(m))
    assert report.accepted
    np.testing.assert_allclose(ekf.state, POSE, atol=1e-12)
    assert np.trace(ekf.covariance) < 0.3
    with pytest.raises(ValueError, match=rf"z must have shape \({m},\)"):
        ekf.update(model, np.zeros(m + 1), np.eye(m + 1))


def test_angles_wrap_and_positions_do_not():
    assert pilotage.HeadingFix().minus([3.0], [-3.0]) == pytest.approx([6 - 2 * np.pi])
    assert pilotage.WorldBearing([0, 0]).minus([3.0], [-3.0]) == pytest.approx([6 - 2 * np.pi])
    np.testing.assert_allclose(
        pilotage.PoseFix().minus([4, 4, 3], [-4, -4, -3]), [8, 8, 6 - 2 * np.pi]
    )


def test_exp_a_dt_is_eulers_jacobian_with_the_arcs_end():
    u = [2.0, 0.5]
    following, a, _ = pilotage.LinearizedVelocity(0.1).linearize(POSE, u)
    np.testing.assert_array_equal(following, pilotage.ArcVelocity(0.1).linearize(POSE, u)[0])
    np.testing.assert_array_equal(a, pilotage.EulerVelocity(0.1).linearize(POSE, u)[1])


def test_velocities_in_the_state_move_the_pose():
    x = np.array([*POSE, 2.0, 0.5])
    following, a, b = pilotage.ConstantVelocity(0.1).linearize(x, [0, 0])
    np.testing.assert_array_equal(
        following[:3], pilotage.ArcVelocity(0.1).linearize(POSE, x[3:])[0]
    )
    np.testing.assert_array_equal(following[3:], x[3:])
    assert (a.shape, b.shape) == ((5, 5), (5, 2))


def test_encoders_and_gyro_see_the_velocities():
    x = np.array([*POSE, 2.0, 0.5])
    assert pilotage.Speed().linearize(x[:4])[0] == [2.0]
    assert pilotage.YawRate().linearize(x)[0] == [0.5]
    wheels, by_x, _ = pilotage.WheelTravel(track_width_m=0.4, dt_s=0.1).linearize(x)
    np.testing.assert_allclose(wheels, [0.19, 0.21])
    np.testing.assert_allclose(by_x @ x, wheels)


def test_noise_of_a_relative_position_lies_along_the_line_of_sight():
    noise = pilotage.relative_position_noise([3, 3], 0.1, 0.06)
    along = np.array([1, 1]) / np.sqrt(2)
    assert along @ noise @ along == pytest.approx(0.01 * 18)
    assert noise[0, 1] > 0


def test_a_scan_of_many_poses_is_a_row_of_ranges_each():
    room = pilotage.WallMap(ROOM)
    ranges = room.cast([[1, 1, 0], [3, 1, np.pi / 2]], [0, np.pi / 2, np.pi])
    np.testing.assert_allclose(ranges, [[3, 1, 1], [1, 3, 1]])
    assert room.cast([[9, 9, 0]], [0]) == np.inf


def test_walls_outlive_their_name():
    beam = pilotage.WallRange(pilotage.WallMap(ROOM), 0.0)
    gc.collect()
    assert beam.linearize([1, 1, 0])[0] == [3.0]


def test_a_beam_without_a_wall_does_not_correct():
    ekf = pilotage.Ekf3([9, 9, 0], np.eye(3))
    report = ekf.update(pilotage.WallRange(pilotage.WallMap(ROOM), 0.0), [1.0], [[1.0]])
    assert report.fault == "undefined"


def test_segments_need_four_columns():
    with pytest.raises(ValueError, match="segments must have shape"):
        pilotage.WallMap([[0, 0, 1]])


def test_an_echo_is_an_envelope_of_samples():
    echo = np.array([2.0, 3e-3, 1e-4, 3.0])  # A0, tau, T, alpha
    times = np.arange(0, 6e-3, 5e-6)
    envelope = pilotage.EchoEnvelope.at_times(echo, times)
    assert times[np.argmax(envelope)] == pytest.approx(3.3e-3, abs=5e-6)
    assert not envelope[times < 3e-3].any()
    sample = pilotage.EchoEnvelope(times[700])
    assert sample.predict([echo])[0] == envelope[700]
    assert not sample.linearize([2.0, 3e-3, -1e-4, 3.0])[2]
