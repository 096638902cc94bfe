"""What a camera's sensor adds to the light is as much as was asked for."""

import numpy as np
import pytest

from pilotage.simulate.exposure import Exposure

LIGHT = np.full((200, 300, 3), (60.0, 120.0, 200.0), np.float32)


def develop(light: np.ndarray = LIGHT, seed: int = 1, **how: float) -> np.ndarray:
    return Exposure(**how).develop(light, np.random.default_rng(seed))


def test_without_anything_light_is_rounded_to_eight_bits():
    assert develop(np.full((2, 2, 3), 99.6, np.float32)).tolist() == [[[100] * 3] * 2] * 2
    assert develop().dtype == np.uint8


@pytest.mark.parametrize("noise", [1.0, 4.0, 10.0])
def test_noise_is_as_strong_as_asked_and_has_no_bias(noise):
    picture = develop(noise=noise).astype(float)
    rounding = 1 / 12
    np.testing.assert_allclose(picture.std(axis=(0, 1)), np.sqrt(noise**2 + rounding), rtol=0.02)
    np.testing.assert_allclose(picture.mean(axis=(0, 1)), LIGHT[0, 0], atol=5 * noise / 245)


def test_noise_of_neighbours_and_of_channels_is_independent():
    off = develop(noise=5.0).astype(float) - LIGHT
    assert abs(np.corrcoef(off[:, 1:, 0].ravel(), off[:, :-1, 0].ravel())[0, 1]) < 0.02
    assert abs(np.corrcoef(off[..., 0].ravel(), off[..., 1].ravel())[0, 1]) < 0.02


def test_the_same_seed_gives_the_same_picture():
    assert (develop(noise=4.0, seed=7) == develop(noise=4.0, seed=7)).all()
    assert (develop(noise=4.0, seed=7) != develop(noise=4.0, seed=8)).any()


def test_blur_spreads_a_point_by_its_sigma_and_leaves_its_place():
    point = np.zeros((41, 41, 3), np.float32)
    point[20, 25] = 255.0 * 20
    weight = Exposure(blur_px=1.5).develop(point, np.random.default_rng(1))[..., 0].astype(float)
    columns = np.arange(weight.shape[1])
    assert (columns * weight).sum() / weight.sum() == pytest.approx(25.0, abs=1e-9)
    spread = ((columns - 25.0) ** 2 * weight).sum() / weight.sum()
    assert spread == pytest.approx(1.5**2, rel=0.15)


def test_gain_makes_light_stronger_up_to_white():
    assert develop(gain=1.5)[0, 0].tolist() == [90, 180, 255]


def test_what_is_no_exposure_is_refused():
    with pytest.raises(ValueError, match="noise is -1, expected 0 to 100"):
        Exposure(noise=-1.0)
