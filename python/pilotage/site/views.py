"""The sets of markers that are seen at once, and what is peculiar about them."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from .coverage import Coverage
from .layout import Indices, Layout
from .shapes import Circle, circle_through, in_line
from .symmetry import Match, elsewhere

SAMPLE = 500
"""Poses that are looked at, evenly over the ground."""
FEWEST = 3
"""Two markers always look like themselves the other way round."""
NEAR_CIRCLE = 0.1
"""Part of the radius."""


@dataclass(frozen=True)
class View:
    """Markers that are in view from some poses."""

    seen: Indices
    poses: int
    """Of the sample."""
    alike: Match | None
    """Another place from which all of it looks the same."""
    in_line: bool
    circle: Circle | None
    """That all of them stand on."""
    on_circle: int
    """How many of the poses are near it."""


@dataclass(frozen=True)
class Views:
    """All that a sample of poses sees, for what `FEWEST` markers or more are needed."""

    poses: int
    """In the sample."""
    views: list[View]

    @classmethod
    def of(
        cls,
        coverage: Coverage,
        layout: Layout,
        tolerance_m: float,
        mirror: bool,
        progress: Callable[[float], None] | None = None,
    ) -> "Views":
        """Take a sample of the poses, and look at each set of markers once."""
        visible = coverage.visible.reshape(-1, len(layout))
        sample = np.unique(np.linspace(0, len(visible) - 1, SAMPLE).round().astype(int))
        poses = coverage.ground.poses()[sample]
        sets, which = np.unique(visible[sample], axis=0, return_inverse=True)
        views = []
        for row, members in enumerate(sets):
            if progress is not None:
                progress(row / len(sets))
            seen = np.flatnonzero(members)
            if len(seen) < FEWEST:
                continue
            mine = poses[which.ravel() == row]
            circle = circle_through(layout.z[seen], tolerance_m)
            near = [circle.passes(complex(x, y), NEAR_CIRCLE) for x, y, _ in mine] if circle else []
            alike = elsewhere(layout, seen, tolerance_m, mirror)
            line = in_line(layout.z[seen], tolerance_m)
            views.append(View(seen, len(mine), alike, line, circle, sum(near)))
        return cls(len(sample), views)

    @property
    def alike(self) -> list[View]:
        """Those that look alike elsewhere, the most frequent first."""
        return sorted((v for v in self.views if v.alike), key=lambda v: -v.poses)

    @property
    def in_line(self) -> list[View]:
        """Those of markers in a line."""
        return [view for view in self.views if view.in_line]

    @property
    def on_circle(self) -> list[View]:
        """Those that are seen from the circle that they stand on, the most frequent first."""
        return sorted((v for v in self.views if v.on_circle), key=lambda v: -v.on_circle)

    def part(self, views: list[View], on_circle: bool = False) -> float:
        """Return the part of all poses that sees one of these views."""
        return sum(v.on_circle if on_circle else v.poses for v in views) / self.poses
