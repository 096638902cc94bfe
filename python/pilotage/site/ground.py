"""The ground a robot drives on, cut into cells."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .layout import Layout

TRIALS = 6e6
"""Markers times robot poses that are tried, of all sensors together."""
CELLS = (400, 3600)
"""The fewest and the most."""
HEADINGS = 48
HEADINGS_ALL_ROUND = 4
"""Of a sensor that sees all round, which the heading only carries about the robot."""

Array = NDArray[np.float64]
Area = tuple[float, float, float, float]
"""Lowest x, lowest y, highest x, highest y in frame map, m."""


def around(layout: Layout) -> Area:
    """Take the markers' box, and around it room of half the usual distance between neighbours."""
    low = layout.z.real.min(), layout.z.imag.min()
    high = layout.z.real.max(), layout.z.imag.max()
    usual = layout.usual_m if np.isfinite(layout.usual_m) else 0.0
    room = usual / 2.0 or 1.0
    return low[0] - room, low[1] - room, high[0] + room, high[1] + room


@dataclass(frozen=True)
class Ground:
    """Cells by their centres, and the headings that are tried in each.

    Attributes
    ----------
    x : (nx,), m
    y : (ny,), m
    headings : (h,), rad
    """

    area: Area
    x: Array
    y: Array
    headings: Array

    @classmethod
    def of(cls, area: Area, markers: int, sensors: int, all_round: bool) -> "Ground":
        """Cut as finely as that many markers and sensors allow."""
        count = HEADINGS_ALL_ROUND if all_round else HEADINGS
        wide, high = area[2] - area[0], area[3] - area[1]
        cells = np.clip(TRIALS / (markers * sensors * count), *CELLS)
        side = np.sqrt(wide * high / cells)
        # Of a long and thin area two rows, and as many columns as make no more cells.
        nx, ny = (int(np.clip(np.ceil(n / side), 2, cells // 2)) for n in (wide, high))
        return cls(
            area,
            area[0] + (np.arange(nx) + 0.5) * wide / nx,
            area[1] + (np.arange(ny) + 0.5) * high / ny,
            np.arange(count) * 2.0 * np.pi / count,
        )

    @property
    def shape(self) -> tuple[int, int, int]:
        """(ny, nx, h) of anything that is known of each pose."""
        return len(self.y), len(self.x), len(self.headings)

    def poses(self) -> Array:
        """Return all x, y, heading: (ny · nx · h, 3)."""
        y, x, heading = np.meshgrid(self.y, self.x, self.headings, indexing="ij")
        return np.column_stack([x.ravel(), y.ravel(), heading.ravel()])
