"""Misses and false detections are as frequent as asked, and look like true ones."""

from dataclasses import dataclass, field

import numpy as np
import pytest

from pilotage.simulate.detection_faults import Unreliable

IMAGE = np.zeros((480, 640, 3), np.uint8)


@dataclass(frozen=True, eq=False)
class Found:
    """What `pilotage.camera.Detection` has."""

    pixel: np.ndarray
    id: int = -1
    label: int = 2
    range_m: float = 4.0
    outline: np.ndarray = field(default_factory=lambda: np.zeros((4, 2)))
    poses: tuple = ("a", "b")


class Sees:
    def __init__(self, *found: Found) -> None:
        self.found = found

    def detect(self, image: np.ndarray) -> tuple[Found, ...]:
        return self.found


A, B = Found(np.array([100.0, 200.0]), id=3), Found(np.array([300.0, 210.0]), id=5)


def unreliable(*found: Found, seed: int = 1, **how) -> Unreliable:
    return Unreliable(Sees(*found), np.random.default_rng(seed), **how)


def test_misses_and_false_ones_are_as_frequent_as_asked():
    spoiled = unreliable(A, B)
    missed = sum(3 not in [one.id for one in spoiled.detect(IMAGE)] for _ in range(100))
    assert 0 < missed < 50
    for _ in range(4900):
        spoiled.detect(IMAGE)
    assert spoiled.asked == 10_000
    assert spoiled.missed == pytest.approx(2000, abs=120)
    assert spoiled.made_up == pytest.approx(2000, abs=120)


def test_without_faults_all_is_as_it_was():
    assert {*unreliable(A, B, miss=0.0, false=0.0).detect(IMAGE)} == {A, B}


def test_a_false_one_looks_true_and_is_elsewhere():
    spoiled = unreliable(A, miss=1.0, false=1.0, top=0.25, ids=[7, 8])
    false = [one for _ in range(300) for one in spoiled.detect(IMAGE)]
    assert len(false) == 300
    pixels = np.array([one.pixel for one in false])
    np.testing.assert_allclose(pixels.min(axis=0), (-0.5, 119.5), atol=8.0)
    np.testing.assert_allclose(pixels.max(axis=0), (639.5, 479.5), atol=8.0)
    assert {one.id for one in false} == {7, 8}
    assert {(one.label, one.poses) for one in false} == {(2, ())}
    np.testing.assert_allclose(false[0].outline - false[0].pixel, A.outline - A.pixel)
    assert spoiled.false_ones == [false[-1]]


def test_a_false_one_may_be_alone_where_nothing_is():
    spoiled = unreliable(A, false=1.0, miss=0.0)
    spoiled.detect(IMAGE)
    spoiled._detector = Sees()
    assert len(spoiled.detect(IMAGE)) == 1


def test_the_same_seed_spoils_alike():
    one, other = (
        [[tuple(found.pixel) for found in spoiled.detect(IMAGE)] for _ in range(20)]
        for spoiled in (unreliable(A, B, seed=4), unreliable(A, B, seed=4))
    )
    assert one == other
