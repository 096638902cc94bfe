"""Worlds of polygons: their walls, and where there is room."""

import sys

import numpy as np
import pytest

from pilotage.simulate.polygon_world import PolygonWorld, polygon_fault

ROOM = np.array([[0, 0], [4, 0], [4, 3], [0, 3.0]])
EAST = np.array([2.5, 0.0])
TABLE = np.array([[1, 1], [2, 1], [2, 2], [1, 2.0]])


def test_beams_meet_obstacles_and_the_boundary():
    walls = PolygonWorld(ROOM, (TABLE,)).walls()
    ranges = walls.cast([[0.5, 1.5, 0], [3, 0.5, np.pi]], [0, np.pi])
    np.testing.assert_allclose(ranges, [[0.5, 0.5], [3.0, 1.0]])


def test_there_is_room_between_walls_and_none_through_them():
    world = PolygonWorld(ROOM, (TABLE,))
    assert world.is_free((0.5, 0.5))
    assert not world.is_free((1.5, 1.5))
    assert not world.is_free((5, 1))
    assert world.is_free((0.5, 0.5), (3.5, 0.5))
    assert not world.is_free((0.5, 1.5), (3.5, 1.5))
    assert not world.is_free((0.5, 0.5), (0.5, 3.5))


def test_a_turn_on_the_spot_takes_no_room():
    assert PolygonWorld(ROOM).is_free((0.5, 0.5), (0.5, 0.5))


def test_obstacles_may_overlap():
    world = PolygonWorld(ROOM, (TABLE, TABLE + 0.5, TABLE + EAST))
    assert not world.is_free((2.25, 2.25))
    assert world.is_free((2.75, 1.5))


def test_the_box_holds_everything():
    world = PolygonWorld(ROOM, (TABLE + 1.2 * EAST,))
    np.testing.assert_array_equal(world.box, [[0, 0], [5, 3]])


def test_a_polygon_that_is_none_is_told():
    assert polygon_fault(ROOM) == ""
    assert "2 corners" in polygon_fault(ROOM[:2])
    assert "Self-intersection" in polygon_fault(ROOM[[0, 2, 1, 3]])


def test_without_shapely_it_is_said_how_to_get_it(monkeypatch):
    monkeypatch.setitem(sys.modules, "shapely", None)
    with pytest.raises(ImportError, match=r"pip install 'pilotage\[studies\]'"):
        polygon_fault(ROOM)
