"""Lines and circles that markers stand on."""

from typing import NamedTuple

import numpy as np

from .motion import Places


class Circle(NamedTuple):
    """A circle in frame map, m."""

    centre: complex
    radius: float

    def passes(self, place: complex, within: float) -> bool:
        """Tell whether a place is on it, but for a part of the radius."""
        return bool(abs(abs(place - self.centre) - self.radius) <= within * self.radius)


def in_line(z: Places, tolerance_m: float) -> bool:
    """Tell whether places (k,) stand in one line, each within the tolerance; two always do."""
    arms = z - z.mean()
    along = np.sqrt(np.sum(arms**2))  # the direction of largest spread, as of a double angle
    if along == 0.0:  # as many in one direction as across
        return bool(np.max(np.abs(arms)) <= tolerance_m)
    across = (arms * np.conj(along / abs(along))).imag
    return bool(np.max(np.abs(across)) <= tolerance_m)


def circle_through(z: Places, tolerance_m: float) -> Circle | None:
    """Find the circle that three or more places (k,) stand on, each within the tolerance.

    Least squares in the form x² + y² = 2 ax + 2 by + c (Kåsa 1976), about the places' middle.
    """
    if in_line(z, tolerance_m):
        return None
    arms = z - z.mean()
    rows = np.column_stack([2.0 * arms.real, 2.0 * arms.imag, np.ones(len(arms))])
    (a, b, c), *_ = np.linalg.lstsq(rows, np.abs(arms) ** 2, rcond=None)
    circle = Circle(complex(z.mean() + a + 1j * b), float(np.sqrt(c + a * a + b * b)))
    beside = np.abs(np.abs(z - circle.centre) - circle.radius)
    return circle if np.max(beside) <= tolerance_m else None
