"""Boards whose corners are known, and where a picture shows them."""

from collections.abc import Sequence
from dataclasses import dataclass, replace
from typing import Protocol

import cv2
import numpy as np
from numpy.typing import NDArray

from ..camera.detection import Array, Image
from ..camera.dictionaries import dictionary_of
from ..fields import within

FEWEST = 6
"""Corners of a view: fewer say too little of where the board is."""


WINDOW = 0.4
"""Of the shortest side of a square in the picture: about a corner so much to each side is seen."""


@dataclass(frozen=True, eq=False)
class View:
    """The corners that one picture shows.

    Attributes
    ----------
    points : (n, 3) m
        On the board, z is 0.
    pixels : (n, 2) px
    """

    name: str
    points: Array
    pixels: Array


class Board(Protocol):
    """A flat pattern of known corners."""

    def find(self, grey: Image) -> tuple[Array, Array] | None:
        """Return points (n, 3) m and pixels (n, 2) of the corners in a picture (h, w), or None."""
        ...

    def hint(self, grey: Image) -> str:
        """Tell what board a picture (h, w) shows instead; empty if none."""
        ...


@dataclass(frozen=True)
class Chessboard:
    """Counted by its inner corners, where four squares meet."""

    columns: int
    rows: int
    square_m: float

    def __post_init__(self) -> None:
        within("columns", self.columns, 3, 100)
        within("rows", self.rows, 3, 100)
        within("square", self.square_m, 1e-4, 10.0)

    def find(self, grey: Image) -> tuple[Array, Array] | None:
        """Return all corners or none: the pattern has to be whole."""
        size = (self.columns, self.rows)
        there, corners = cv2.findChessboardCornersSB(grey, size, flags=cv2.CALIB_CB_ACCURACY)
        if not there:
            return None
        v, u = np.divmod(np.arange(self.columns * self.rows), self.columns)
        points = self.square_m * np.column_stack([u, v, np.zeros_like(u)])
        return points, _refined(grey, np.asarray(corners).reshape(self.rows, self.columns, 2))

    def hint(self, grey: Image) -> str:
        """Try the sizes next to this one: squares counted instead of corners."""
        for less in (1, -1):
            other = replace(self, columns=self.columns - less, rows=self.rows - less)
            if min(other.columns, other.rows) > 2 and other.find(grey) is not None:
                return (
                    f"there is one of {other.columns}x{other.rows}: inner corners are counted, "
                    "where four squares meet"
                )
        return ""


def _refined(grey: Image, corners: NDArray[np.float32]) -> Array:
    """Return corners (rows, columns, 2) px as (n, 2), found once more where edges cross.

    Those of the sector-based finder are off by up to 0.2 px where the board is tilted.
    """
    steps = (np.linalg.norm(np.diff(corners, axis=axis), axis=2).min() for axis in (0, 1))
    reach = max(2, int(WINDOW * min(steps)))
    ends = (cv2.TERM_CRITERIA_EPS + cv2.TERM_CRITERIA_COUNT, 50, 1e-4)
    start = corners.reshape(-1, 1, 2).astype(np.float32)
    found = cv2.cornerSubPix(grey, start, (reach, reach), (-1, -1), ends)
    return np.asarray(found, dtype=np.float64).reshape(-1, 2)


@dataclass(frozen=True)
class Charuco:
    """A chessboard with tags in its white squares: parts of it are enough. Squares are counted."""

    columns: int
    rows: int
    square_m: float
    tag_m: float
    dictionary: str

    def __post_init__(self) -> None:
        within("columns", self.columns, 2, 100)
        within("rows", self.rows, 2, 100)
        within("square", self.square_m, 1e-4, 10.0)
        within("tag", self.tag_m, 1e-4, 0.999 * self.square_m)
        dictionary_of(self.dictionary)

    def find(self, grey: Image) -> tuple[Array, Array] | None:
        """Return the corners in view, which the tags about them tell apart."""
        board = cv2.aruco.CharucoBoard(
            (self.columns, self.rows), self.square_m, self.tag_m, dictionary_of(self.dictionary)
        )
        corners, ids, *_ = cv2.aruco.CharucoDetector(board).detectBoard(grey)
        if ids is None or len(ids) < FEWEST:
            return None
        which: NDArray[np.int64] = np.ravel(ids)
        points = np.asarray(board.getChessboardCorners(), dtype=np.float64)[which]
        if np.linalg.matrix_rank(points[:, :2] - points[0, :2]) < 2:
            return None  # all in a line
        return points, np.asarray(corners, dtype=np.float64).reshape(-1, 2)

    def hint(self, grey: Image) -> str:
        """Tell whether the tags are there, of this dictionary."""
        found = cv2.aruco.ArucoDetector(dictionary_of(self.dictionary)).detectMarkers(grey)[1]
        if found is None:
            return f"there is no tag of {self.dictionary} either: another dictionary, perhaps"
        return (
            f"there are {len(found)} tags of {self.dictionary}: are there {self.columns}x"
            f"{self.rows} squares"
        )


def parse_board(words: Sequence[str]) -> Board:
    """Make the board of words such as ``chessboard 9x6 0.025``.

    Or ``charuco 7x5 0.04 0.03 4x4_50``: the square's side and the tag's in metres, and the
    dictionary.
    """
    text = " ".join(words).split()
    usage = (
        f"--board is '{' '.join(text)}', expected 'chessboard 9x6 0.025' (inner corners, side of a "
        "square in m) or 'charuco 7x5 0.04 0.03 4x4_50' (squares, side of a square and of a tag in "
        "m, dictionary)"
    )
    kinds = {"chessboard": 3, "charuco": 5}
    if not text or len(text) != kinds.get(text[0]):
        raise ValueError(usage)
    try:
        columns, rows = (int(n) for n in text[1].lower().split("x"))
        sides = [float(word) for word in text[2:4]]
    except ValueError as error:
        raise ValueError(usage) from error
    try:
        if text[0] == "chessboard":
            return Chessboard(columns, rows, *sides)
        return Charuco(columns, rows, sides[0], sides[1], text[4])
    except ValueError as error:
        raise ValueError(f"--board: {error}") from error
