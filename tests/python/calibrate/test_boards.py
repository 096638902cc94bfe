"""Boards in drawn pictures."""

import cv2
import numpy as np
import pytest

from pilotage.calibrate.boards import Charuco, Chessboard, parse_board
from pilotage.calibrate.intrinsics import calibrate
from pilotage.calibrate.looking import find_views
from support.boards import BoardCamera, charuco, chessboard, stances

CAMERA = BoardCamera()
SQUARE_M = 0.025


def of_chessboard(count=12, seed=1):
    """Pictures of a board of 7 by 5 corners."""
    rng = np.random.default_rng(seed)
    texture = chessboard(7, 5)
    for k, (turn, place) in enumerate(stances(count, (3, 2), rng, far=(9.0, 12.0))):
        yield f"{k}.png", CAMERA.look(texture, SQUARE_M, turn, SQUARE_M * place, rng=rng)


def of_charuco(count=12, seed=1):
    """Pictures of a board of 7 by 5 squares."""
    rng = np.random.default_rng(seed)
    texture = charuco(7, 5, 0.75, cv2.aruco.DICT_4X4_50)
    for k, (turn, place) in enumerate(stances(count, (2.5, 1.5), rng, far=(4.0, 7.0))):
        yield f"{k}.png", CAMERA.look(texture, SQUARE_M, turn, SQUARE_M * place, rng=rng)


@pytest.mark.parametrize(
    ("pictures", "board", "fewest"),
    [
        (of_chessboard, Chessboard(7, 5, SQUARE_M), 8),
        (of_charuco, Charuco(7, 5, SQUARE_M, 0.75 * SQUARE_M, "4x4_50"), 10),
    ],
    ids=["chessboard", "charuco"],
)
def test_a_lens_from_drawn_boards_is_the_true_one(pictures, board, fewest):
    views, size = find_views(pictures(), board)
    assert len(views) >= fewest
    found = calibrate(views, size, 4)
    truth = np.array([*CAMERA.model.matrix, *CAMERA.model.distortion[:4]])
    print(found.rms_px, (found.values - truth).round(4), found.sigmas.round(4))
    assert found.rms_px < 0.15
    assert (np.abs(found.values - truth) < 3 * found.sigmas).all()
    assert np.abs(found.values - truth)[:4].max() < 1.0


def test_a_part_of_a_charuco_board_is_enough():
    texture = charuco(7, 5, 0.75, cv2.aruco.DICT_4X4_50)
    near = np.array([-0.5, -1.5, 5.0])
    picture = CAMERA.look(texture, 1.0, (0.2, 0.1, 0.0), near)
    found = Charuco(7, 5, 1.0, 0.75, "4x4_50").find(picture)
    assert found is not None
    points, pixels = found
    assert 6 <= len(points) < 24
    assert points.shape == (len(points), 3)
    assert pixels.shape == (len(points), 2)


def test_squares_counted_for_corners_are_told():
    with pytest.raises(ValueError, match=r"in none of the pictures: there is one of 7x5: inner"):
        find_views(of_chessboard(2), Chessboard(8, 6, SQUARE_M))


def test_another_dictionary_is_told():
    board = Charuco(7, 5, SQUARE_M, 0.75 * SQUARE_M, "6x6_50")
    with pytest.raises(ValueError, match="no tag of 6x6_50"):
        find_views(of_charuco(1), board)


def test_no_board_at_all_says_so():
    blank = np.full((48, 64), 120, np.uint8)
    with pytest.raises(ValueError, match="in none of the pictures: is all of it in view"):
        find_views([("a.png", blank)], Chessboard(7, 5, SQUARE_M))


def test_pictures_of_two_sizes_are_refused():
    small, large = (np.zeros((k, 2 * k), np.uint8) for k in (40, 60))
    with pytest.raises(ValueError, match=r"b\.png is 120 by 60 pixels, but a\.png 80 by 40"):
        find_views([("a.png", small), ("b.png", large)], Chessboard(7, 5, SQUARE_M))


def test_a_board_is_read_from_words():
    assert parse_board(["chessboard", "9x6", "0.025"]) == Chessboard(9, 6, 0.025)
    assert parse_board(["charuco 7x5 0.04 0.03 4x4_50"]) == Charuco(7, 5, 0.04, 0.03, "4x4_50")


@pytest.mark.parametrize(
    ("words", "said"),
    [
        ("chess 9x6 0.025", "expected 'chessboard 9x6"),
        ("chessboard 9x6", "expected 'chessboard 9x6"),
        ("chessboard 9by6 0.025", "expected 'chessboard 9x6"),
        ("chessboard 9x6 -1", "square is -1, expected"),
        ("chessboard 2x6 0.025", "columns is 2, expected"),
        ("charuco 7x5 0.03 0.04 4x4_50", "tag is 0.04, expected"),
        ("charuco 7x5 0.04 0.03 4x4_5", "the nearest known one is '4x4_50'"),
    ],
)
def test_a_board_that_is_none_is_refused(words, said):
    with pytest.raises(ValueError, match="--board") as error:
        parse_board([words])
    assert said in str(error.value)
