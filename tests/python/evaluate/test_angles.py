import numpy as np
import pytest

from pilotage.evaluate import wrap_angle


@pytest.mark.parametrize(
    ("angle", "wrapped"),
    [
        (0.0, 0.0),
        (np.pi, np.pi),
        (-np.pi, np.pi),
        (np.radians(190.0), np.radians(-170.0)),
        (np.radians(-350.0), np.radians(10.0)),
        (np.radians(725.0), np.radians(5.0)),
    ],
)
def test_angle_comes_into_the_half_open_turn(angle: float, wrapped: float) -> None:
    assert wrap_angle(angle) == pytest.approx(wrapped, abs=1e-14)


def test_angle_inside_comes_back_bit_for_bit() -> None:
    inside = np.array([1e-300, -1e-17, 3.0, -3.0, np.nextafter(-np.pi, 0.0), np.pi])
    np.testing.assert_array_equal(wrap_angle(inside), inside)


def test_one_step_beyond_the_ends_comes_in_at_the_other_end() -> None:
    assert -np.pi < wrap_angle(np.nextafter(np.pi, 4.0)) < -3.14
    assert 3.14 < wrap_angle(np.nextafter(-np.pi, -4.0)) < np.pi


def test_no_angle_leaves_the_half_open_turn() -> None:
    near = np.pi * np.arange(-99, 100)
    angles = np.concatenate([np.nextafter(near, -1e9), near, np.nextafter(near, 1e9)])
    wrapped = wrap_angle(angles)
    assert np.all((wrapped > -np.pi) & (wrapped <= np.pi))
    np.testing.assert_allclose(np.cos(wrapped), np.cos(angles), atol=1e-12)
    assert -np.pi < wrap_angle(1e300) <= np.pi


def test_unknown_angle_stays_unknown() -> None:
    assert np.isnan(wrap_angle(np.nan))
