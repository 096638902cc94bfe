"""Rigid motions of the plane, with complex numbers for places."""

import cmath
import math
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

HARDLY_RAD = math.radians(2.0)
"""A smaller turn is about a far point, and better said as a move."""

Places = NDArray[np.complex128]


class Motion(NamedTuple):
    """z to turn · z + shift; with `mirror`, to turn · conj(z) + shift."""

    turn: complex
    """Of length 1."""
    shift: complex
    """m"""
    mirror: bool = False

    @classmethod
    def between(cls, origin: Places, target: Places, mirror: bool = False) -> "Motion":
        """Fit the motion from places (k,) to places (k,), by least squares."""
        origin = origin.conj() if mirror else origin
        arms = target - target.mean()
        product = complex(np.vdot(origin - origin.mean(), arms))
        turn = product / abs(product) if product else 1.0 + 0.0j
        return cls(turn, complex(target.mean() - turn * origin.mean()), mirror)

    def __call__(self, z: Places) -> Places:
        """Move places."""
        return np.asarray(self.turn * (z.conj() if self.mirror else z) + self.shift)

    @property
    def angle_rad(self) -> float:
        """Of the turn, in (-π, π]; of a mirror, twice the direction of its line."""
        return cmath.phase(self.turn)

    def words(self, middle: complex) -> str:
        """Say what it does to a map with its middle there (m), in metres and degrees."""
        if self.mirror:
            return self._mirror_words(middle)
        if abs(self.angle_rad) < HARDLY_RAD:
            return f"moved by {_place(self.turn * middle + self.shift - middle)}"
        centre = self.shift / (1.0 - self.turn)
        return f"turned by {_degrees(self.angle_rad)} about {_place(centre)}"

    def _mirror_words(self, middle: complex) -> str:
        along = cmath.exp(0.5j * self.angle_rad)
        slide = (self.shift * along.conjugate()).real
        # Halfway between a place and its image is on the line.
        image = self.turn * middle.conjugate() + self.shift - slide * along
        text = (
            f"mirrored at the line through {_place((middle + image) / 2)} "
            f"towards {_degrees(0.5 * self.angle_rad)}"
        )
        return text + (f", and moved along it by {slide:.1f} m" if abs(slide) >= 0.05 else "")


def _degrees(angle_rad: float) -> str:
    degrees = round(math.degrees(angle_rad))
    return f"{180 if degrees == -180 else degrees}°"


def _place(z: complex) -> str:
    x, y = (round(v, 1) + 0.0 for v in (z.real, z.imag))  # no -0.0
    return f"({x:.1f}, {y:.1f}) m"
