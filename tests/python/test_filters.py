"""The filters as Python sees them: same models, same answers where they must be, clear refusals."""

import numpy as np
import pytest

from pilotage import (
    ArcUnicycle,
    CalibratedArc,
    DifferentialDrive,
    Ekf3,
    Ekf5,
    Ekf6,
    GyroDrive,
    LinearKalman,
    MarkerModel,
    MidpointUnicycle,
    Policy,
    Ukf3,
    Ukf4,
    Ukf5,
    Ukf6,
    Unscented,
    unscented_transform,
)

START = np.array([1.0, 2.0, 3.1])
NARROW = np.diag([1e-8, 1e-8, 1e-8])
SIGHTING = MarkerModel([4.0, 6.0, 0.5], ["bearing", "range"])


@pytest.mark.parametrize(
    ("model", "inputs"),
    [
        (MidpointUnicycle(), 2),
        (ArcUnicycle(), 2),
        (DifferentialDrive(0.5), 2),
        (GyroDrive(), 3),
    ],
)
def test_ukf3_takes_the_models_of_ekf3(model, inputs):
    filters = [Ekf3(START, NARROW), Ukf3(START, NARROW)]
    for f in filters:
        f.predict(model, np.full(inputs, 0.1), 1e-8 * np.eye(inputs), np.full(3, 1e-9))
        z = SIGHTING.predict(f.state[None])[0] + [1e-5, 1e-4]
        assert f.update(SIGHTING, z, 1e-8 * np.eye(2)).accepted
    ekf, ukf = filters
    np.testing.assert_allclose(ukf.state, ekf.state, atol=1e-7)
    np.testing.assert_allclose(ukf.covariance, ekf.covariance, atol=1e-12)


def test_ukf6_takes_the_model_of_ekf6_and_leaves_frozen_states():
    x = np.array([*START, 0.01, 1.02, 0.98])
    p = np.diag([1e-8, 1e-8, 1e-8, 0, 1e-8, 0])
    filters = [Ekf6(x, p), Ukf6(x, p)]
    for f in filters:
        f.predict(CalibratedArc(0.02), [0.1, 0.05], 1e-8 * np.eye(2), np.zeros(6))
        f.update(SIGHTING, SIGHTING.predict(f.state[None, :3])[0] + 1e-4, 1e-8 * np.eye(2))
    np.testing.assert_allclose(filters[1].state, filters[0].state, atol=1e-7)
    assert filters[1].state[3] == 0.01
    assert filters[1].state[5] == 0.98
    assert not filters[1].covariance[[3, 5]].any()


@pytest.mark.parametrize("kind", [Ekf5, Ukf5])
def test_five_states_are_corrected_by_markers(kind):
    f = kind([*START, 0.5, 0.1], np.eye(5))
    z = SIGHTING.predict(START[None])[0]
    assert f.update(SIGHTING, z, 0.01 * np.eye(2)).accepted
    assert (np.diag(f.covariance)[:2] < 0.9).all()
    assert f.covariance[3, 3] == pytest.approx(1)


def test_the_jacobian_given_to_ekf5_is_by_five_states():
    f = Ekf5(np.zeros(5), np.eye(5))
    assert f.correct([1.0], [[0, 0, 0, 1, 0]], [[1.0]]).accepted
    np.testing.assert_allclose(f.state, [0, 0, 0, 0.5, 0])
    with pytest.raises(ValueError, match=r"h \(m, 5\)"):
        f.correct([1.0], [[0, 0, 1]], [[1.0]])


def test_the_state_of_ukf4_is_no_pose():
    assert Ukf4([0, 0, 100, 0], np.eye(4)).state[2] == 100


def test_an_outlier_is_gated_or_weighted():
    z = SIGHTING.predict(START[None])[0] + [0, 5]
    r = 1e-4 * np.eye(2)
    gated = Ukf3(START, 0.01 * np.eye(3))
    report = gated.update(SIGHTING, z, r, Policy.gate(0.001))
    assert report.fault == "gated"
    assert not report.accepted
    np.testing.assert_array_equal(gated.state, START)
    weighted = Ukf3(START, 0.01 * np.eye(3))
    assert weighted.update(SIGHTING, z, r, Policy.student_t(4)).weight < 0.1


def test_a_marker_at_the_sensor_is_undefined():
    here = MarkerModel([*START[:2], 0], ["range"])
    assert Ukf3(START, np.zeros((3, 3))).update(here, [1], [[1]]).fault == "undefined"


def test_without_input_noise_six_points_give_the_prediction():
    u = np.array([1.0, 0.3])
    root = np.linalg.cholesky(p := np.array([[0.1, 0.02, 0], [0.02, 0.2, 0.01], [0, 0.01, 0.3]]))
    points = np.vstack([root.T, -root.T]) * np.sqrt(3)
    images = ArcUnicycle().step_each(points, np.tile(u, (6, 1)))
    f = Ukf3(np.zeros(3), p)
    f.predict(ArcUnicycle(), u, np.zeros((2, 2)), np.zeros(3))
    np.testing.assert_allclose(f.state, images.mean(axis=0), atol=1e-14)
    np.testing.assert_allclose(f.covariance, np.cov(images.T, bias=True), atol=1e-14)


@pytest.mark.parametrize("n", [1, 2, 3, 4])
def test_linear_kalman_is_the_textbooks(n):
    random = np.random.default_rng(n)
    x, b, u = random.normal(size=n), random.normal(size=(n, 2)), random.normal(size=2)
    a = random.normal(size=(n, n))
    p, q = (np.diag(random.uniform(0.1, 1, n)) for _ in range(2))
    m = min(n, 3)
    h, z, r = random.normal(size=(m, n)), random.normal(size=m), np.eye(m)
    f = LinearKalman(x, p)
    f.predict(a, b @ u, q)
    x, p = a @ x + b @ u, a @ p @ a.T + q
    np.testing.assert_allclose(f.state, x)
    np.testing.assert_allclose(f.covariance, p)
    report = f.update(z, h, r)
    k = p @ h.T @ np.linalg.inv(h @ p @ h.T + r)
    np.testing.assert_allclose(report.innovation, z - h @ x)
    np.testing.assert_allclose(f.state, x + k @ (z - h @ x))
    np.testing.assert_allclose(f.covariance, (np.eye(n) - k @ h) @ p, atol=1e-12)


def test_linear_kalman_says_which_shapes_it_wants():
    with pytest.raises(ValueError, match="1 to 4 states"):
        LinearKalman(np.zeros(5), np.eye(5))
    with pytest.raises(ValueError, match="fit each other"):
        LinearKalman(np.zeros(2), np.eye(3))
    f = LinearKalman(np.zeros(2), np.eye(2))
    with pytest.raises(ValueError, match="do not fit n states"):
        f.predict(np.eye(3), np.zeros(2), np.eye(2))
    with pytest.raises(ValueError, match="do not fit n states"):
        f.update([1.0], [[1.0]], [[1.0]])
    with pytest.raises(ValueError, match=r"z must have shape \(2,\)"):
        Ukf3(START, NARROW).update(SIGHTING, [1.0], [[1.0]])


def polar(x):
    return x[0] * np.array([np.cos(x[1]), np.sin(x[1])])


def test_polar_to_cartesian_is_the_papers():
    angle = np.deg2rad(15) ** 2
    mean, covariance = unscented_transform(
        [1, np.pi / 2], np.diag([0.02**2, angle]), polar, Unscented(kappa=1)
    )
    true_mean = np.exp(-angle / 2)
    true = (1 + 0.02**2) / 2 * (1 + np.array([-1, 1]) * np.exp(-2 * angle)) - [0, true_mean**2]
    np.testing.assert_allclose(mean, [0, true_mean], atol=1e-3 * true_mean)
    np.testing.assert_allclose(np.diag(covariance), true, rtol=0.06)


@pytest.mark.parametrize(("n", "m"), [(1, 1), (2, 5), (6, 2), (6, 6)])
def test_a_linear_function_is_exact(n, m):
    random = np.random.default_rng(n)
    a, x, p = random.normal(size=(m, n)), random.normal(size=n), np.diag(random.uniform(1, 2, n))
    mean, covariance = unscented_transform(x, p, lambda at: a @ at)
    np.testing.assert_allclose(mean, a @ x)
    np.testing.assert_allclose(covariance, a @ p @ a.T, atol=1e-12)


def test_what_cannot_be_transformed_is_refused():
    with pytest.raises(ValueError, match="up to 6 entries"):
        unscented_transform(np.zeros(7), np.eye(7), polar)
    with pytest.raises(ValueError, match="f must return"):
        unscented_transform(np.zeros(2), np.eye(2), lambda x: np.zeros(7))
    with pytest.raises(ValueError, match="fit each other"):
        unscented_transform(np.zeros(2), np.eye(3), polar)
    with pytest.raises(ZeroDivisionError):  # what f raises comes through
        unscented_transform(np.zeros(2), np.eye(2), lambda x: 1 / 0)
    for bad in ({"alpha": 0}, {"beta": -1}, {"kappa": -1}, {"alpha": float("nan")}):
        with pytest.raises(ValueError, match="alpha must be above 0"):
            Unscented(**bad)
