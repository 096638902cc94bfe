"""What goes wrong with markers is as stated, in the frames in which it is stated."""

from dataclasses import replace

import numpy as np
import pytest

from pilotage.evaluate import wrap_angle
from pilotage.simulate import SCENARIOS, Campaign, Cell, Measured, Stream, measure
from pilotage.simulate.cells import Window

WINDOW = Window(30.0, 45.0)
YARD = SCENARIOS["yard"]


@pytest.fixture(scope="module")
def measured() -> Measured:
    return measure(YARD, np.random.default_rng(3))


def _struck(measured: Measured, fault: str, **size: object) -> tuple[Stream, Stream, np.ndarray]:
    """Sightings before and after, and which of the former the fault may touch."""
    cell = Cell("markers", fault, size)
    after = cell.strike(measured, YARD.cameras, WINDOW, np.random.default_rng(5))
    assert after.encoders is measured.encoders
    assert after.gyro is measured.gyro
    before = measured.sightings["scanner"]
    start, end = WINDOW.at(int(measured.drive.utime[0]))
    return before, after.sightings["scanner"], (before.utime >= start) & (before.utime < end)


def test_a_wrong_id_is_another_markers(measured: Measured):
    before, after, hit = _struck(measured, "wrong id", share=0.5)
    wrong = before.id != after.id
    assert not wrong[~hit].any()
    assert wrong[hit].mean() == pytest.approx(0.5, abs=0.1)
    assert set(after.id) <= set(measured.markers.ids)
    np.testing.assert_array_equal(before.value, after.value)


def test_a_swapped_pair_carries_each_others_number(measured: Measured):
    before, after, hit = _struck(measured, "swapped pair")
    wrong = before.id != after.id
    assert wrong.any()
    assert not wrong[~hit].any()
    one, other = np.unique(before.id[wrong])
    both = hit & np.isin(before.id, (one, other))
    np.testing.assert_array_equal(after.id[both], one + other - before.id[both])


def test_a_moved_marker_is_seen_where_it_stands(measured: Measured):
    before, after, hit = _struck(measured, "moved", distance_m=1.0)
    rows = np.flatnonzero(np.nan_to_num(before.value[:, 2]) != np.nan_to_num(after.value[:, 2]))
    assert hit[rows].all()
    assert len(set(before.id[rows])) == 1
    # By how far the sighting's point has moved, from law of cosines in the sensor's own plane.
    flat = np.sqrt(np.array([s.value[rows, 2] for s in (before, after)]) ** 2 - 0.1**2)
    turn = wrap_angle(after.value[rows, 0] - before.value[rows, 0])
    moved = np.sqrt(flat[0] ** 2 + flat[1] ** 2 - 2 * flat[0] * flat[1] * np.cos(turn))
    assert np.median(moved) == pytest.approx(1.0, abs=0.05)


def test_a_removed_marker_is_not_seen(measured: Measured):
    before, after, hit = _struck(measured, "removed")
    gone = np.setdiff1d(before.id[hit], after.id[(after.seq >= before.seq[hit][0])])
    lost = len(before) - len(after)
    assert lost > 0
    counts = [int((before.id[hit] == marker).sum()) for marker in np.unique(before.id[hit])]
    assert lost in counts
    assert len(gone) <= 1


def test_a_phantom_stands_in_a_frame_as_if_it_were_seen(measured: Measured):
    before, after, hit = _struck(measured, "phantom", share=0.3, reach_m=8.0)
    frames = len(np.unique(before.seq[hit]))
    ghosts = len(after) - len(before)
    assert ghosts == pytest.approx(0.3 * frames, rel=0.35)
    frame, first = np.unique(after.seq, return_index=True)
    assert (np.diff(after.seq) >= 0).all()  # each in its frame
    for name in ("utime", "received"):
        column = getattr(after, name)
        np.testing.assert_array_equal(column, column[first][np.searchsorted(frame, after.seq)])
    assert np.nanmax(after.value[:, 2]) < 9.0


def test_a_site_without_markers_in_view_is_named(measured: Measured):
    cell = Cell("markers", "moved", {"distance_m": 1.0})
    nothing = {"scanner": measured.sightings["scanner"].rows(np.zeros(0, dtype=np.intp))}
    blind = replace(measured, sightings=nothing)
    with pytest.raises(ValueError, match="choose another scenario"):
        cell.strike(blind, YARD.cameras, WINDOW, np.random.default_rng(5))


@pytest.mark.parametrize("cell", Campaign.load().cells, ids=lambda cell: cell.name)
def test_every_committed_cell_can_be_injected_and_encoded(measured: Measured, cell: Cell):
    struck = cell.strike(measured, YARD.cameras, WINDOW, np.random.default_rng(5))
    recording, intact = struck.record(), measured.record()
    assert len(recording) > 0.7 * len(intact)
    assert cell.meaning.endswith(".")
    if cell.fault != "removed":
        a, b = ([r[i] for i in range(len(r))] for r in (recording, intact))
        assert a != b
