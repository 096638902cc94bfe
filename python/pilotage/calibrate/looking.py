"""Views of a board from pictures."""

from collections.abc import Callable, Iterable
from itertools import islice

from ..camera.detection import Image
from .boards import Board, View

HINTED = 5
"""Pictures that are asked what else they show, if none shows the board."""


def find_views(
    pictures: Iterable[tuple[str, Image]],
    board: Board,
    told: Callable[[str, bool], None] = lambda name, found: None,
) -> tuple[list[View], tuple[int, int]]:
    """Look for a board in pictures by name, and return its views and the pictures' size (w, h).

    `told` hears of each picture whether the board was found.

    Raises
    ------
    ValueError
        If sizes differ or the board is in no picture; says what is there instead, if that is seen.
    """
    views, size, first = [], None, ""
    missed: list[Image] = []
    for name, picture in pictures:
        height, width = picture.shape
        if size is None:
            size, first = (width, height), name
        elif size != (width, height):
            raise ValueError(
                f"{name} is {width} by {height} pixels, but {first} {size[0]} by {size[1]}: a "
                "calibration is of one size, the one that the camera is used at"
            )
        found = board.find(picture)
        told(name, found is not None)
        if found is not None:
            views.append(View(name, *found))
        elif len(missed) < HINTED:
            missed.append(picture)
    if size is None:
        raise ValueError("there are no pictures")
    if not views:
        hints = (board.hint(picture) for picture in missed)
        hint = next(islice(filter(None, hints), 1), "is all of it in view, sharp and evenly lit")
        raise ValueError(f"the board was found in none of the pictures: {hint}")
    return views, size
