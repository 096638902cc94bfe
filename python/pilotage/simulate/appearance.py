"""What stands in a rendered world: discs, poles and tags, each met by rays.

Points and rays are in frame map: x, y on the ground, z up, m. Colours are blue, green, red, 0 to
255, as OpenCV has them.
"""

from dataclasses import dataclass
from functools import cached_property
from typing import Protocol

import cv2
import numpy as np
from numpy.typing import NDArray

from ..camera.dictionaries import dictionary_of
from .lens import turned
from .paints import PAINTS, Colour

Array = NDArray[np.float64]
Rays = NDArray[np.float32]
Met = tuple[NDArray[np.bool_], Rays | None]
"""Whether rays meet it, (...), and how bright its colour is there, (...); None: as it is."""
AROUND = np.linspace(0.0, 2.0 * np.pi, 48, endpoint=False)
CIRCLE = np.column_stack([np.cos(AROUND), np.sin(AROUND)])
LEVELS = np.linspace(0.0, 1.0, 9)
LIT = 0.75
"""Of the middle of a pole, how bright its sides are."""
WHITE: Colour = (255.0, 255.0, 255.0)
BACK = 0.55
"""How bright the back of a tag's plate is."""


class Body(Protocol):
    """What can be drawn."""

    @property
    def centre(self) -> Array:
        """(3,) m."""

    @property
    def colour(self) -> Colour:
        """Where it is brightest."""

    def outline(self) -> Array:
        """(k, 3) points, m, that enclose it densely."""

    def meet(self, eye: Array, rays: Rays) -> Met:
        """Hold rays (..., 3) from an eye (3,) against it."""


@dataclass(frozen=True)
class Disc:
    """A flat, level disc, as a marker on the ground."""

    position: tuple[float, float, float]
    """Of its centre."""
    radius_m: float = 0.2
    colour: Colour = PAINTS["red"]

    @property
    def centre(self) -> Array:
        """(3,) m."""
        return np.array(self.position)

    def outline(self) -> Array:
        """Its edge."""
        return np.column_stack([self.radius_m * CIRCLE, np.zeros(len(CIRCLE))]) + self.centre

    def meet(self, eye: Array, rays: Rays) -> Met:
        """Where the plane is within the radius."""
        dx, dy, dz = (self.centre - eye).tolist()
        x, y, z = cv2.split(rays)
        # Times z: no division that a level ray would break.
        off = np.square(x * dz - dx * z) + np.square(y * dz - dy * z)
        return (off <= np.square(self.radius_m * z)) & (z * dz > 0.0), None


@dataclass(frozen=True)
class Pole:
    """An upright cylinder; the foot is where it stands."""

    foot: tuple[float, float, float]
    height_m: float = 1.0
    radius_m: float = 0.1
    colour: Colour = PAINTS["red"]

    @property
    def centre(self) -> Array:
        """(3,) m."""
        x, y, z = self.foot
        return np.array([x, y, z + self.height_m / 2])

    def outline(self) -> Array:
        """Rings from foot to top."""
        ring = np.column_stack([self.radius_m * CIRCLE, np.zeros(len(CIRCLE))]) + self.foot
        up = np.array([0.0, 0.0, self.height_m])
        return np.asarray(LEVELS[:, None, None] * up + ring).reshape(-1, 3)

    def meet(self, eye: Array, rays: Rays) -> Met:
        """Where the cylinder, or its top from above, is; sides are darker than the middle."""
        dx, dy, dz = (np.array(self.foot) - eye).tolist()
        x, y, z = cv2.split(rays)
        per_level = 1.0 / np.sqrt(np.maximum(x * x + y * y, np.float32(1e-12)))
        aside = (y * dx - x * dy) * per_level
        inside = np.float32(self.radius_m**2) - aside * aside
        half = np.sqrt(np.maximum(inside, 0.0))
        way = (x * dx + y * dy) * per_level - half
        height = way * z * per_level - dz
        hit = (inside >= 0.0) & (way > 0.0) & (height >= 0.0) & (height <= self.height_m)
        light = LIT + np.float32((1.0 - LIT) / self.radius_m) * half
        if dz + self.height_m < 0.0:
            top = Disc((*self.foot[:2], self.foot[2] + self.height_m), self.radius_m)
            above, _ = top.meet(eye, rays)
            light = np.where(above, np.float32(1.0), light)
            hit |= above
        return hit, light


@dataclass(frozen=True)
class Tag:
    """A square fiducial marker on a white plate.

    Its own axes are OpenCV's: x to the right of who looks at it, y up, z out of its face. With all
    angles zero, the face looks along x of frame map, and up is up.
    """

    position: tuple[float, float, float]
    """Of its centre."""
    yaw_rad: float
    """Direction to which its face looks."""
    id: int
    dictionary: str = "4x4_50"
    """Of `cv2.aruco`: 4x4_50, apriltag_36h11, ..."""
    size_m: float = 0.2
    """Edge of the black square."""
    roll_rad: float = 0.0
    pitch_rad: float = 0.0
    """Positive: its face looks down."""
    dark: float = 0.1
    """How bright its black is, of 1."""
    light: float = 0.92
    """How bright its white is."""
    colour: Colour = WHITE

    @property
    def centre(self) -> Array:
        """(3,) m."""
        return np.array(self.position)

    @cached_property
    def cells(self) -> Rays:
        """(m, m) brightness of its cells with one white one around, top left first."""
        dictionary = dictionary_of(self.dictionary)
        count = len(dictionary.bytesList)
        if not 0 <= self.id < count:
            raise ValueError(f"id is {self.id}, expected 0 to {count - 1} in {self.dictionary}")
        side = dictionary.markerSize + 2
        bits = cv2.aruco.generateImageMarker(dictionary, self.id, side)
        plate = np.pad(bits, 1, constant_values=255) / 255.0
        return np.asarray(self.dark + (self.light - self.dark) * plate, np.float32)

    @cached_property
    def rotation(self) -> Array:
        """(3, 3) from OpenCV's axes of a tag to frame map."""
        (cr, sr), (cp, sp), (cy, sy) = (
            (np.cos(angle), np.sin(angle))
            for angle in (self.roll_rad, self.pitch_rad, self.yaw_rad)
        )
        about_x = np.array([[1.0, 0.0, 0.0], [0.0, cr, -sr], [0.0, sr, cr]])
        about_y = np.array([[cp, 0.0, sp], [0.0, 1.0, 0.0], [-sp, 0.0, cp]])
        about_z = np.array([[cy, -sy, 0.0], [sy, cy, 0.0], [0.0, 0.0, 1.0]])
        return np.asarray((about_z @ about_y @ about_x)[:, [1, 2, 0]])

    def corners(self) -> Array:
        """(4, 3) of the black square [m]: top left, top right, bottom right, bottom left."""
        square = np.array([[-1.0, 1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]])
        return self._places(square * self.size_m / 2)

    def outline(self) -> Array:
        """Edges of the plate."""
        ends = np.array([[-1.0, 1.0], [1.0, 1.0], [1.0, -1.0], [-1.0, -1.0]])
        edges = ends[:, None] + LEVELS[None, :, None] * (np.roll(ends, -1, axis=0) - ends)[:, None]
        return self._places(edges.reshape(-1, 2) * self._half_plate)

    def meet(self, eye: Array, rays: Rays) -> Met:
        """Where the plate is; how bright the cell there is, or its back."""
        right, up, out = ((eye - self.centre) @ self.rotation).tolist()
        x, y, z = cv2.split(turned(rays, self.rotation.T))
        towards = z * out < 0.0
        way = -out / np.where(towards, z, np.float32(1.0))
        half, count = self._half_plate, len(self.cells)
        column = (right + half + way * x) * (count / (2 * half))
        row = (half - up - way * y) * (count / (2 * half))
        hit = towards & (column >= 0) & (column < count) & (row >= 0) & (row < count)
        if out <= 0.0:
            return hit, np.full(z.shape, BACK, np.float32)
        across, down = (np.where(hit, index, 0.0).astype(np.intp) for index in (column, row))
        return hit, self.cells[down, across]

    @property
    def _half_plate(self) -> float:
        count = len(self.cells)
        return self.size_m / 2 * count / (count - 2)

    def _places(self, right_up: Array) -> Array:
        flat = np.column_stack([right_up, np.zeros(len(right_up))])
        return np.asarray(flat @ self.rotation.T + self.centre)
