"""Problem files: a world, a start, how noisy the robot is, and what it is told to do.

One keyword a line, then its numbers, with blanks or commas between them; # begins a comment::

    boundary  0,0  4,0  4,3  0,3      # corners, m
    obstacle  1,1  2,1  2,2           # as many as there are
    start     0.5 0.5 90              # x, y [m], heading [degrees, counter-clockwise from +x]
    commandDstSigmaRatio 0.03         # σ of the distance driven, of the distance commanded
    commandAngSigmaRatio 0.05         # σ of the angle turned, of the angle commanded
    rangeSigmaRatio      0.01         # σ of a range, of the range
    move   1.75  90                   # forward [m], then turn on the spot [degrees, left positive]
    sense  90                         # the range along a beam [degrees from forward, left positive]

The ratios have the names of the assignment "Localization and the extended Kalman filter".
"""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from difflib import get_close_matches
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from .polygon_world import PolygonWorld, polygon_fault

NUMBERS = {
    "boundary": "x,y x,y x,y ... (m)",
    "obstacle": "x,y x,y x,y ... (m)",
    "start": "x y heading (m, m, degrees)",
    "commandDstSigmaRatio": "ratio",
    "commandAngSigmaRatio": "ratio",
    "rangeSigmaRatio": "ratio",
    "move": "distance turn (m, degrees)",
    "sense": "angle (degrees)",
}
"""Every keyword with what follows it."""
REPEATED = ("obstacle", "move", "sense")
RATIOS = tuple(keyword for keyword in NUMBERS if keyword.endswith("Ratio"))


@dataclass(frozen=True)
class Move:
    """Straight forward, then a turn on the spot."""

    distance_m: float
    turn_rad: float


@dataclass(frozen=True)
class Sense:
    """The distance to the wall in a direction from forward, left positive."""

    angle_rad: float


@dataclass(frozen=True)
class Problem:
    """What a problem file says.

    Attributes
    ----------
    name, title : str
        The file's name, and its first comment.
    start : (3,) float
        x, y [m], heading [rad].
    distance_ratio, turn_ratio, range_ratio : float
        Standard deviation as a part of what is driven, turned or measured.
    """

    name: str
    title: str
    world: PolygonWorld
    start: NDArray[np.float64]
    distance_ratio: float
    turn_ratio: float
    range_ratio: float
    commands: tuple[Move | Sense, ...]


@dataclass(frozen=True)
class _Line:
    place: str
    keyword: str
    numbers: NDArray[np.float64]

    def refused(self, why: str) -> ValueError:
        return ValueError(f"{self.place}: {self.keyword}: {why}")

    @property
    def polygon(self) -> NDArray[np.float64]:
        corners = self.numbers.reshape(-1, 2)
        if fault := polygon_fault(corners):
            raise self.refused(f"{fault}; give the corners in order, each once")
        return corners


def read_problem(path: Path) -> Problem:
    """Read a file; a ValueError names file, line, value, and what was expected."""
    return parse_problem(path.read_text(encoding="utf-8", errors="replace"), str(path))


def parse_problem(text: str, name: str) -> Problem:
    """Make a problem of a file's text."""
    lines = list(_lines(text, name))
    single: dict[str, _Line] = {}
    for line in lines:
        if line.keyword in REPEATED:
            continue
        first = single.setdefault(line.keyword, line)
        if first is not line:
            raise line.refused(f"stands there twice, first in {first.place}: keep one of them")
    for keyword, what in NUMBERS.items():
        if keyword not in single and keyword not in REPEATED:
            raise ValueError(f"{name}: '{keyword}' is missing: add a line '{keyword} {what}'")
    distance, turn, range_ = (_ratio(single[keyword]) for keyword in RATIOS)
    obstacles = tuple(line.polygon for line in lines if line.keyword == "obstacle")
    world = PolygonWorld(single["boundary"].polygon, obstacles)
    x, y, heading = single["start"].numbers
    if not world.is_free((x, y)):
        raise single["start"].refused(
            f"({x:g}, {y:g}) is on a wall, in an obstacle or outside of the boundary: "
            "start in the open"
        )
    title = next((line[1:].strip() for line in text.splitlines() if line.startswith("#")), "")
    start = np.array([x, y, math.radians(heading)])
    commands = tuple(_command(line) for line in lines if line.keyword in ("move", "sense"))
    return Problem(Path(name).stem, title, world, start, distance, turn, range_, commands)


def _lines(text: str, name: str) -> Iterator[_Line]:
    for number, line in enumerate(text.splitlines(), 1):
        keyword, *words = line.split("#")[0].replace(",", " ").split() or [""]
        place = f"{name}:{number}"
        if not keyword:
            continue
        if keyword not in NUMBERS:
            (near,) = get_close_matches(keyword, NUMBERS, n=1, cutoff=0.0)
            raise ValueError(
                f"{place}: unknown keyword '{keyword}'; the nearest known keyword is '{near}'; "
                f"there are {', '.join(NUMBERS)}"
            )
        found = _Line(place, keyword, np.array([_number(w, place, keyword) for w in words]))
        what = NUMBERS[keyword]
        polygon = what.startswith("x,y")
        fits = len(words) % 2 == 0 if polygon else len(words) == len(what.split(" (")[0].split())
        if not fits:
            plural = "" if len(words) == 1 else "s"
            raise found.refused(f"{len(words)} number{plural}, expected {keyword} {what}")
        yield found


def _number(word: str, place: str, keyword: str) -> float:
    try:
        number = float(word)
    except ValueError:
        number = math.nan
    if not math.isfinite(number):
        raise ValueError(f"{place}: {keyword}: '{word}' is no number, expected {NUMBERS[keyword]}")
    return number


def _ratio(line: _Line) -> float:
    if not 0.0 <= line.numbers[0] <= 1.0:
        raise line.refused(f"is {line.numbers[0]:g}, expected 0 to 1: 0.02 is 2 % of the size")
    return float(line.numbers[0])


def _command(line: _Line) -> Move | Sense:
    if line.keyword == "move":
        return Move(float(line.numbers[0]), math.radians(line.numbers[1]))
    return Sense(math.radians(line.numbers[0]))
