"""Pictures with what was found in them, and where the map says that it should be."""

from collections.abc import Mapping, Sequence
from typing import NamedTuple

import cv2
import numpy as np

from .. import MarkerMap
from ..simulate.view import sight
from .detection import Array, Detection, Image
from .eye import Eye

Colour = tuple[int, int, int]
FOUND: Colour = (90, 230, 60)
"""Blue, green, red: of detections."""
EXPECTED: Colour = (0, 200, 255)
"""Of the map's markers, where they are projected from the pose."""
REFUSED: Colour = (60, 60, 255)
"""Of what the localizer has rejected."""
SHADE: Colour = (0, 0, 0)
FONT = cv2.FONT_HERSHEY_SIMPLEX
ABOVE, BELOW = np.array([13.0, -10.0]), np.array([13.0, 20.0])
"""From a mark to its text, px."""
ARMS = np.array([[5.0, 0.0], [0.0, 5.0]])
"""Of a cross, px."""
AROUND = ((-1, 0), (1, 0), (0, -1), (0, 1))
"""A text's shade, px: bold it would be wider than the text."""
RADIUS_PX = 13
"""Of the circle about an expected marker, in which the marker is left to be seen."""
SUBPIXEL = 4
"""Lines are drawn to a sixteenth of a pixel."""


class Answer(NamedTuple):
    """What the localizer made of a detection."""

    id: int
    """Of the marker it was held against, -1 none."""
    reason: str
    """Why it was rejected, empty if it was not."""


def projections(eye: Eye, markers: MarkerMap, pose: Array) -> dict[int, Array]:
    """Return the pixels (2,) at which the map's markers show from a pose (3,), those in the image.

    The body is taken for level.
    """
    place, rotation = sight(eye.mounting, pose)
    pixels = eye.camera.project((markers.positions - place) @ rotation)
    inside = ((pixels >= -0.5) & (pixels < np.array(eye.camera.size) - 0.5)).all(axis=1)
    return {int(markers.ids[row]): pixels[row] for row in np.flatnonzero(inside)}


def annotate(
    image: Image,
    detections: Sequence[Detection],
    expected: Mapping[int, Array],
    answers: Mapping[int, Answer] | None = None,
    words: str = "",
) -> Image:
    """Draw detections, expected markers, and a line from each to the one that it is of.

    Parameters
    ----------
    expected : by id, the pixel (2,) at which a marker should show
    answers : by index of the detection; without one, its own id is believed
    words : for the lower border
    """
    picture = image.copy()
    for number, at in expected.items():
        _mark(picture, at, EXPECTED)
        _write(picture, at + ABOVE, str(number), EXPECTED)
    for index, one in enumerate(detections):
        answer = (answers or {}).get(index, Answer(one.id, ""))
        colour = REFUSED if answer.reason else FOUND
        _outline(picture, one.outline, colour)
        _mark(picture, one.pixel, colour, cross=True)
        if answer.id in expected:
            _line(picture, one.pixel, expected[answer.id], colour)
        _write(picture, one.pixel + BELOW, _name(one, answer), colour)
    if words:
        _write(picture, np.array([8.0, len(picture) - 10.0]), words, (255, 255, 255))
    return picture


def _name(one: Detection, answer: Answer) -> str:
    label = f" of {one.label}" if one.label >= 0 and answer.id < 0 else ""
    name = (str(answer.id) if answer.id >= 0 else "?") + label
    return f"{name} {answer.reason}" if answer.reason else name


def _mark(picture: Image, at: Array, colour: Colour, cross: bool = False) -> None:
    if not np.isfinite(at).all():
        return
    if not cross:
        cv2.circle(picture, _fine(at), RADIUS_PX << SUBPIXEL, colour, 1, cv2.LINE_AA, SUBPIXEL)
        return
    for arm in ARMS:
        _line(picture, at - arm, at + arm, colour)


def _line(picture: Image, start: Array, end: Array, colour: Colour) -> None:
    if np.isfinite(start).all() and np.isfinite(end).all():
        cv2.line(picture, _fine(start), _fine(end), colour, 1, cv2.LINE_AA, SUBPIXEL)


def _outline(picture: Image, outline: Array, colour: Colour) -> None:
    if len(outline) > 0 and np.isfinite(outline).all():
        corners = np.array([_fine(corner) for corner in outline], dtype=np.int32)
        cv2.polylines(picture, [corners], True, colour, 1, cv2.LINE_AA, SUBPIXEL)


def _write(picture: Image, at: Array, text: str, colour: Colour) -> None:
    if not np.isfinite(at).all():
        return
    (width, height), _ = cv2.getTextSize(text, FONT, 0.45, 1)
    left = int(np.clip(at[0], 2, max(picture.shape[1] - width - 2, 2)))
    base = int(np.clip(at[1], height + 2, len(picture) - 4))
    for shade, right, down in (*((SHADE, *step) for step in AROUND), (colour, 0, 0)):
        place = left + right, base + down
        cv2.putText(picture, text, place, FONT, 0.45, shade, 1, cv2.LINE_AA)


def _fine(at: Array) -> tuple[int, int]:
    """Return a pixel as OpenCV takes it with `SUBPIXEL`."""
    u, v = np.rint(np.clip(at, -1e5, 1e5) * (1 << SUBPIXEL)).astype(int).tolist()
    return u, v
