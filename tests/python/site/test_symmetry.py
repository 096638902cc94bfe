"""Motions that bring a map onto itself are found, all of them, and no others."""

import numpy as np
import pytest

from pilotage import MarkerMap
from pilotage.simulate import worlds
from pilotage.site import Layout, Motion, Sight, elsewhere, symmetries
from support.sites import GRID, LINE, RECTANGLE, SQUARE, markers, site

NEAR = 0.1
YARD = worlds.yard().positions[:, :2]


def _turns(layout: Layout, mirror: bool = False) -> list[int]:
    found = symmetries(layout, NEAR, mirror)
    return [round(np.degrees(m.motion.angle_rad)) for m in found if m.motion.mirror == mirror]


def _words(layout: Layout, mirror: bool = False) -> list[str]:
    middle = complex(layout.z.mean())
    return [match.motion.words(middle) for match in symmetries(layout, NEAR, mirror)]


def test_a_square_is_itself_in_four_ways():
    assert _turns(Layout.of(markers(SQUARE))) == [90, -90, 180]
    assert _words(Layout.of(markers(SQUARE)))[0] == "turned by 90° about (2.0, 2.0) m"
    assert len(_turns(Layout.of(markers(SQUARE)), mirror=True)) == 4


def test_a_rectangle_is_itself_upside_down():
    assert _words(Layout.of(markers(RECTANGLE))) == ["turned by 180° about (3.0, 1.5) m"]
    assert _words(Layout.of(markers(RECTANGLE)), mirror=True)[1:] == [
        "mirrored at the line through (3.0, 1.5) m towards 0°",
        "mirrored at the line through (3.0, 1.5) m towards 90°",
    ]


@pytest.mark.parametrize("xy", [YARD, LINE, [(0, 0), (5, 0), (1, 3)], [(2, 1)]])
def test_a_layout_that_does_not_repeat_has_none(xy):
    assert symmetries(Layout.of(markers(xy)), NEAR, mirror=False) == []


def test_two_markers_are_always_themselves_the_other_way_round():
    assert _words(Layout.of(markers([(0, 0), (5, 0)]))) == ["turned by 180° about (2.5, 0.0) m"]


def test_a_line_is_its_own_mirror_image_marker_by_marker():
    (match,) = symmetries(Layout.of(markers(LINE)), NEAR, mirror=True)
    assert not match.ids_help
    assert match.motion(np.array([2 + 3j])) == pytest.approx(2 - 3j)


@pytest.mark.parametrize("lost", range(12))
def test_a_ring_with_any_marker_set_aside_repeats_but_for_that_one(lost: int):
    z = 5.0 * np.exp(2j * np.pi * np.arange(12) / 12)
    z[lost] *= 1.3
    found = symmetries(Layout.of(markers(np.column_stack([z.real, z.imag]))), NEAR, mirror=False)
    assert len(found) == 11
    assert all(len(match.origin) == 10 for match in found)  # neither it nor what falls where it was
    assert all(lost not in match.origin and lost not in match.target for match in found)


def test_markers_set_off_by_less_than_the_tolerance_do_not_break_it():
    rng = np.random.default_rng(1)
    xy = np.array(GRID) + rng.uniform(-0.03, 0.03, (28, 2))
    (first, *_) = symmetries(Layout.of(markers(xy)), NEAR, mirror=False)
    assert len(first.origin) == 28
    assert first.error_m < NEAR
    assert np.degrees(abs(first.motion.angle_rad)) == pytest.approx(180, abs=0.5)


def test_a_grid_is_moved_onto_itself_but_for_a_row():
    layout = Layout.of(markers(GRID))
    found = symmetries(layout, NEAR, mirror=False)
    counts = {m.motion.words(complex(layout.z.mean())): len(m.origin) for m in found}
    assert counts["turned by 180° about (9.6, 21.0) m"] == 28
    assert counts["moved by (0.0, 7.0) m"] == counts["moved by (0.0, -7.0) m"] == 24
    assert counts["moved by (6.4, 0.0) m"] == 21
    assert min(counts.values()) >= 0.7 * 28


def test_a_turn_of_any_map_about_any_point_is_found():
    rng = np.random.default_rng(2)
    for _ in range(20):
        z = rng.uniform(-20, 20, 8) + 1j * rng.uniform(-20, 20, 8)
        centre, angle = complex(*rng.uniform(-30, 30, 2)), np.pi
        twice = np.concatenate([z, centre + np.exp(1j * angle) * (z - centre)])
        layout = Layout.of(markers(np.column_stack([twice.real, twice.imag])))
        (first, *_) = symmetries(layout, NEAR, mirror=False)
        assert first.motion(np.array([centre])) == pytest.approx(centre, abs=1e-6)
        assert sorted(first.target) == list(range(16))


def test_labels_and_heights_tell_markers_apart():
    plain, eye = markers(SQUARE), Sight.of(site(SQUARE), "eye", components=["elevation"])

    def labelled(labels: list[int]) -> MarkerMap:
        return MarkerMap(plain.ids, plain.positions, plain.sigmas, labels)

    coloured = labelled([7, 3, 7, 3])
    assert _turns(Layout.of(coloured)) == [180]
    assert Layout.of(coloured).names == ["0 (7)", "1 (3)", "2 (7)", "3 (3)"]
    assert _turns(Layout.of(labelled([1, 2, 3, 90000]))) == []
    stepped = MarkerMap(plain.ids, plain.positions + [[0, 0, 0], [0, 0, 1]] * 2)
    assert _turns(Layout.of(stepped, [eye])) == [180]
    assert _turns(Layout.of(stepped)) == [90, -90, 180]


def test_a_view_is_found_elsewhere():
    corner = [(0, 0), (2, 0), (0, 3)]
    far = [(20 - y, 10 + x) for x, y in corner]  # turned by 90° and moved
    layout = Layout.of(markers([*corner, *far, (9, 40)]))
    match = elsewhere(layout, np.array([0, 1, 2]), NEAR, mirror=False)
    assert match is not None
    assert list(match.target) == [3, 4, 5]
    assert match.motion == pytest.approx((1j, 20 + 10j, False))
    assert elsewhere(layout, np.array([0, 1, 2, 6]), NEAR, mirror=False) is None


def test_a_mirrored_view_is_another_only_without_bearings():
    layout = Layout.of(markers([(0, 0), (2, 0), (0, 3), (20, 0), (18, 0), (20, 3)]))
    seen = np.array([0, 1, 2])
    assert elsewhere(layout, seen, NEAR, mirror=False) is None
    match = elsewhere(layout, seen, NEAR, mirror=True)
    assert match is not None
    assert list(match.target) == [3, 4, 5]


@pytest.mark.parametrize(
    ("motion", "words"),
    [
        (Motion(1 + 0j, 3 - 2j), "moved by (3.0, -2.0) m"),
        (Motion(1j, 2 + 0j), "turned by 90° about (1.0, 1.0) m"),
        (Motion(-1 + 0j, 0j), "turned by 180° about (0.0, 0.0) m"),
        (Motion(1 + 0j, 4j, True), "mirrored at the line through (0.0, 2.0) m towards 0°"),
        (
            Motion(1 + 0j, 5 + 4j, True),
            "mirrored at the line through (0.0, 2.0) m towards 0°, and moved along it by 5.0 m",
        ),
    ],
)
def test_motions_are_said_in_words(motion: Motion, words: str):
    assert motion.words(0j) == words
