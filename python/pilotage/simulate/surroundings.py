"""What a rendered picture shows where nothing stands: ground, and what is beyond it."""

from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from .paints import Colour

Image = NDArray[np.float32]
SEED = 20020211
"""Of the ground's and the skyline's pattern: a place looks the same in every run."""
TILE = 1024
"""Of the ground's patterns, px a side; they repeat."""
LEVEL = 1e-4
"""Of a ray that falls less, the ground is out of sight."""
AZIMUTHS = 2048
LINE_M = 0.05
LINES: Colour = (225.0, 228.0, 228.0)
BOARDS: Colour = (172.0, 196.0, 208.0)
PANELS, SEAM_M = 16, 0.004


@dataclass(frozen=True)
class Surroundings:
    """Colours and patterns of a place."""

    ground: Colour
    grain: float
    """Standard deviation of the ground's fine pattern, of 255."""
    mottle: float
    """Of its coarse pattern."""
    horizon: Colour
    zenith: Colour
    skyline: Colour
    """Of what stands far away."""
    skyline_rad: float
    """How high above the horizon that rises."""
    ragged: float
    """By which part of that its height varies."""
    grain_m: float = 0.02
    """One pixel of the fine pattern."""
    mottle_m: float = 0.15
    """One pixel of the coarse pattern."""
    haze_m: float = 150.0
    """Over so far, the ground fades into what stands far away."""
    boards: tuple[float, float] | None = None
    """Radius about the origin and height [m] of boards round an arena, drawn from inside."""
    lines: tuple[float, float] | None = None
    """Half the length along x and y [m] of a rectangle of white lines about the origin."""

    @cached_property
    def _patterns(self) -> tuple[Image, Image]:
        rng = np.random.default_rng(SEED)
        return self.grain * _pattern(rng, 0.8, 6.0), self.mottle * _pattern(rng, 2.0, 40.0)

    @cached_property
    def _heights(self) -> Image:
        rough = _pattern(np.random.default_rng(SEED), 1.2, 300.0)[0]
        around = np.resize(rough, AZIMUTHS)
        return np.asarray(self.skyline_rad * (1.0 + self.ragged * around), np.float32)

    def behind(self, eye: NDArray[np.float64], rays: Image) -> Image:
        """(h, w, 3) float32 colours where rays (h, w, 3) from an eye (3,) meet nothing else."""
        import cv2

        x, y, z = (np.asarray(part, np.float32) for part in cv2.split(rays))
        down = z < -LEVEL
        way = np.float32(-eye[2]) / np.where(down, z, np.float32(-LEVEL))
        # What a pixel sees of the ground along its ray, over the ray's own width.
        slant = np.square(way) * np.float32(1.0 / max(eye[2], 1e-3))
        width = slant * np.float32(_pixel_rad(rays))
        place = np.float32(eye[0]) + way * x, np.float32(eye[1]) + way * y
        shade = np.zeros_like(x)
        for pattern, cell in zip(self._patterns, (self.grain_m, self.mottle_m), strict=True):
            seen: Image = cv2.remap(
                pattern,
                _on_tile(place[0], cell),
                _on_tile(place[1], cell),
                cv2.INTER_LINEAR,
            )
            # A pattern finer than a pixel is not seen.
            shade += seen / (1.0 + np.square(width * np.float32(1.0 / cell)))
        near = np.exp(way * np.float32(-1.0 / self.haze_m))[..., None]
        bright = (1.0 + shade * np.float32(1.0 / 255.0))[..., None]
        ground = bright * _row(self.ground)
        if self.lines is not None:
            off = [np.abs(axis) - half for axis, half in zip(place, self.lines, strict=True)]
            inside = LINE_M / 2 - np.abs(np.maximum(*off))
            line = np.clip(inside / width + 0.5, 0.0, np.minimum(1.0, LINE_M / width))[..., None]
            ground += line * (_row(LINES) - ground)
        picture = near * ground + (1.0 - near) * _row(self.skyline)
        self._above(picture, rays, ~down)
        if self.boards is not None:
            _surround(picture, eye, rays, *self.boards)
        return np.asarray(picture, np.float32)

    def _above(self, picture: Image, rays: Image, up: NDArray[np.bool_]) -> None:
        """Draw sky and skyline where a ray does not meet the ground."""
        x, y, z = rays[up].T
        azimuth = (np.arctan2(y, x) / np.float32(2 * np.pi) % 1.0) * (AZIMUTHS - 1)
        top = self._heights[azimuth.astype(np.intp)]
        # Half a pixel to either side, the edge is neither.
        far = np.clip((top - z) / np.float32(_pixel_rad(rays)) + 0.5, 0.0, 1.0)[:, None]
        high = np.sqrt(np.clip(z, 0.0, 1.0))[:, None]
        sky = (1.0 - high) * _row(self.horizon) + high * _row(self.zenith)
        picture[up] = far * _row(self.skyline) + (1.0 - far) * sky


def _surround(
    picture: Image, eye: NDArray[np.float64], rays: Image, radius: float, height: float
) -> None:
    """Draw boards."""
    inside = radius**2 - float(eye[:2] @ eye[:2])
    if inside <= 0.0:
        return
    x, y, z = np.moveaxis(rays, -1, 0)
    flat = np.maximum(x * x + y * y, np.float32(1e-9))
    along = x * np.float32(eye[0]) + y * np.float32(eye[1])
    way = (np.sqrt(along * along + flat * np.float32(inside)) - along) / flat
    up, pixel = np.float32(eye[2]) + way * z, way * np.float32(_pixel_rad(rays))
    share = np.clip(np.minimum(up, height - up) / pixel + 0.5, 0.0, 1.0)
    panels = np.arctan2(eye[1] + way * y, eye[0] + way * x) * np.float32(PANELS / (2 * np.pi))
    seam = np.abs(panels - np.rint(panels)) * np.float32(2 * np.pi * radius / PANELS)
    dark = 1.0 - 0.35 * np.clip((SEAM_M - seam) / pixel + 0.5, 0.0, 1.0) * (up < height)
    picture *= (1.0 - share)[..., None]
    picture += (share * dark * (0.85 + 0.15 * up / np.float32(height)))[..., None] * _row(BOARDS)


def _pixel_rad(rays: Image) -> float:
    """Angle from one pixel to the next, in the picture's middle."""
    row, column = rays.shape[0] // 2, rays.shape[1] // 2
    return float(np.linalg.norm(rays[row, column] - rays[row, column - 1]))


def _pattern(rng: np.random.Generator, fine_px: float, coarse_px: float) -> Image:
    """(TILE + 1, TILE + 1) noise without a seam, of deviation 1, with blotches of these sizes."""
    total = np.zeros((TILE, TILE))
    frequency = np.hypot(*np.meshgrid(np.fft.fftfreq(TILE), np.fft.rfftfreq(TILE), indexing="ij"))
    for size in np.geomspace(fine_px, coarse_px, 4):
        blur = np.exp(-2.0 * np.square(np.pi * size * frequency))
        layer = np.fft.irfft2(np.fft.rfft2(rng.standard_normal((TILE, TILE))) * blur)
        total += layer / layer.std()
    return np.pad(total / total.std(), (0, 1), mode="wrap").astype(np.float32)


def _on_tile(place: NDArray[np.float64] | Image, cell: float) -> Image:
    """Places [m] in pixels of the first of the tiles that repeat."""
    pixel = np.asarray(place, np.float32) * np.float32(1.0 / cell)
    return np.asarray(pixel - np.float32(TILE) * np.floor(pixel * np.float32(1.0 / TILE)))


def _row(colour: Colour) -> Image:
    return np.array(colour, np.float32)


PLACES = {
    "lawn": Surroundings(
        ground=(62.0, 122.0, 84.0),
        grain=38.0,
        mottle=16.0,
        horizon=(236.0, 222.0, 208.0),
        zenith=(205.0, 150.0, 92.0),
        skyline=(58.0, 84.0, 60.0),
        skyline_rad=0.045,
        ragged=0.35,
    ),
    "hall": Surroundings(
        ground=(132.0, 138.0, 142.0),
        grain=10.0,
        mottle=7.0,
        horizon=(190.0, 198.0, 202.0),
        zenith=(150.0, 154.0, 156.0),
        skyline=(158.0, 164.0, 166.0),
        skyline_rad=0.6,
        ragged=0.0,
        grain_m=0.005,
        mottle_m=0.05,
        haze_m=300.0,
        boards=(3.0, 0.45),
    ),
    "field": Surroundings(
        ground=(60.0, 128.0, 46.0),
        grain=14.0,
        mottle=6.0,
        horizon=(190.0, 198.0, 202.0),
        zenith=(140.0, 144.0, 148.0),
        skyline=(150.0, 160.0, 168.0),
        skyline_rad=0.6,
        ragged=0.0,
        grain_m=0.005,
        mottle_m=0.05,
        haze_m=300.0,
        lines=(5.0, 2.5),
    ),
}
"""By the name that a scenario file calls them: outdoors, indoors, a robot soccer field."""


def place(name: str) -> Surroundings:
    """Return surroundings by their name; a ValueError lists the names."""
    if name not in PLACES:
        raise ValueError(f"surroundings is {name!r}, expected one of {', '.join(PLACES)}")
    return PLACES[name]
