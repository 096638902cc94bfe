"""All that is found out about a map."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass

import numpy as np

from .. import Config
from .coverage import Coverage
from .ground import Area, Ground, around
from .layout import Layout
from .shapes import in_line
from .sight import Sight
from .symmetry import Match, symmetries
from .views import Views

HEADING = "initial.sigma_heading_rad"
"""How well the heading is known before a frame."""


@dataclass(frozen=True)
class Survey:
    """A map as the sensors of a configuration see it, one frame at a time."""

    config: Config
    layout: Layout
    sights: list[Sight]
    tolerance_m: float
    """Two places nearer than this are one, to one sighting."""
    symmetries: list[Match]
    in_line: bool
    coverage: Coverage
    views: Views

    @classmethod
    def of(
        cls,
        config: Config,
        reach_m: float = np.inf,
        view_rad: float = 2.0 * np.pi,
        area: Area | None = None,
        components: Sequence[str] = (),
        progress: Callable[[float], None] | None = None,
    ) -> "Survey":
        """Look at the configuration's map with its sensors.

        Parameters
        ----------
        config : Config
            With a map and a sensor.
        reach_m, view_rad : float
            Of every sensor; the view is the whole angle.
        area : Area or None
            Where the robot drives; by default the markers' box and a little around it.
        components : sequence of str
            That every sensor measures; without any they are guessed by the configured noise.
        progress : callable or None
            Takes the part that is done, 0 to 1.
        """
        report = progress or (lambda done: None)
        sights = [Sight.of(config, n, reach_m, view_rad, components) for n in config.marker_sensors]
        layout = Layout.of(config.map, sights)
        tolerance_m = layout.tolerance_m(sights)
        mirror = not gives_bearings(sights)
        found = symmetries(layout, tolerance_m, mirror)
        report(0.1)
        ground = Ground.of(
            area or around(layout), len(layout), len(sights), view_rad >= 2.0 * np.pi
        )
        coverage = Coverage.of(
            ground,
            config.map,
            sights,
            float(config[HEADING]),
            lambda done: report(0.1 + 0.5 * done),
        )
        views = Views.of(
            coverage, layout, tolerance_m, mirror, lambda done: report(0.6 + 0.4 * done)
        )
        line = len(layout) > 2 and in_line(layout.z, tolerance_m)
        return cls(config, layout, sights, tolerance_m, found, line, coverage, views)

    @property
    def mirror(self) -> bool:
        """Whether a place and its mirror image look the same: no sensor tells left from right."""
        return not gives_bearings(self.sights)

    @property
    def alert_limit_m(self) -> float:
        """The 95 % radius above which a position is not OK."""
        return float(self.config["status.alert_limit_m"])

    @property
    def sigma_heading_rad(self) -> float:
        """Of the heading by dead reckoning, before a frame."""
        return float(self.config[HEADING])

    @property
    def bearings_only(self) -> bool:
        """Whether nothing tells a distance."""
        return all(sight.components == ("bearing",) for sight in self.sights)


def gives_bearings(sights: list[Sight]) -> bool:
    """Tell whether any of the sensors measures a bearing."""
    return any("bearing" in sight.components for sight in sights)
