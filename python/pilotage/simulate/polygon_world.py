"""A world of polygons: a boundary around it and obstacles in it; shapely knows their geometry."""

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from .. import WallMap


@dataclass(frozen=True)
class PolygonWorld:
    """What a robot drives in, and its range finder sees.

    Attributes
    ----------
    boundary : (n, 2) float
        Corners in frame map [m], in order; the last joins the first.
    obstacles : sequence of (k, 2) float
        They may touch and overlap each other and the boundary.
    """

    boundary: NDArray[np.float64]
    obstacles: Sequence[NDArray[np.float64]] = ()

    @property
    def segments(self) -> NDArray[np.float64]:
        """Every wall, (m, 4): from x, y to x, y [m]."""
        rings = (self.boundary, *self.obstacles)
        return np.concatenate([np.hstack([ring, np.roll(ring, -1, axis=0)]) for ring in rings])

    def walls(self) -> WallMap:
        """Make the map that beams are cast in; it cannot go to another process, a world can."""
        return WallMap(self.segments)

    @property
    def box(self) -> NDArray[np.float64]:
        """The least box around it, [[x, y] low, [x, y] high]."""
        points = np.concatenate([self.boundary, *self.obstacles])
        return np.stack([points.min(axis=0), points.max(axis=0)])

    @cached_property
    def _free(self) -> Any:
        shapely = _shapely()
        obstacles = shapely.union_all([shapely.Polygon(ring) for ring in self.obstacles])
        return shapely.Polygon(self.boundary).difference(obstacles)

    def is_free(self, *points: ArrayLike) -> bool:
        """Tell whether a point, or the way from point to point, meets no wall."""
        shapely = _shapely()
        way = shapely.Point(points[0]) if len(points) == 1 else shapely.LineString(points)
        return bool(self._free.contains_properly(way))


def polygon_fault(corners: NDArray[np.float64]) -> str:
    """Say what makes corners (n, 2) no polygon: '' if nothing does."""
    if len(corners) < 3:
        return f"a polygon of {len(corners)} corners, expected 3 or more"
    shapely = _shapely()
    reason = shapely.is_valid_reason(shapely.Polygon(corners))
    return "" if reason == "Valid Geometry" else f"no simple polygon: {reason}"


def _shapely() -> ModuleType:
    try:
        import shapely
    except ImportError:
        raise ImportError(
            "worlds of polygons need shapely: pip install 'pilotage[studies]', or shapely itself"
        ) from None
    return shapely  # type: ignore[no-any-return]
