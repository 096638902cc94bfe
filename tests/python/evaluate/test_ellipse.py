import numpy as np
import pytest

from pilotage.evaluate import ellipse_axes


def test_radii_lie_along_their_axes():
    radii, axes = ellipse_axes(np.diag([4.0, 1.0]), 0.954)
    np.testing.assert_allclose(radii, 2.4816 * np.array([1.0, 2.0]), rtol=1e-4)
    np.testing.assert_allclose(np.abs(axes), [[0, 1], [1, 0]])


def test_a_segment_is_an_ellipse_without_width():
    radii, _ = ellipse_axes(np.array([[[1.0, 1.0], [1.0, 1.0]]]), 0.5)
    assert radii.shape == (1, 2)
    assert radii[0, 0] == pytest.approx(0.0, abs=1e-7)
