"""Where the markers stand, and to whom that is too close."""

from collections.abc import Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import Config, MarkerMap
from .finding import Finding

APART = 3.0
"""So many sigmas between two markers, and one is not taken for the other."""


class Spacing(NamedTuple):
    """Distances from marker to nearest marker, m."""

    closest: tuple[int, int]
    """Ids of the closest pair."""
    least: float
    usual: float
    """The median."""


def spacing(markers: MarkerMap) -> Spacing | None:
    """Measure a map; None where there are fewer than two markers."""
    from scipy.spatial import KDTree

    if len(markers) < 2:
        return None
    distances, places = KDTree(markers.positions).query(markers.positions, k=2)
    least: NDArray[np.float64] = distances[:, 1]
    at = int(np.argmin(least))
    one, other = sorted(int(markers.ids[place]) for place in places[at])
    return Spacing((one, other), float(least[at]), float(np.median(least)))


def markers_too_close(config: Config) -> Iterator[Finding]:
    """Find markers that a sensor cannot tell apart where it sees their neighbours."""
    found = spacing(config.map)
    if found is None:
        return
    for name in config.sensors:
        blur = APART * _blur(config, name, found.usual)
        if found.least < blur:
            yield Finding(
                "map",
                f"markers {found.closest[0]} and {found.closest[1]} are {found.least:.3g} m apart; "
                f"seen from {found.usual:.3g} m, {name} tells apart {blur:.2g} m ({APART:g} σ)",
                "set them further apart, or be sure that their ids are never confused",
            )


def _blur(config: Config, sensor: str, distance: float) -> float:
    """Return the standard deviation of a marker's place as seen from a distance, m."""
    key = f"sensors.{sensor}."
    across = config[key + "sigma_bearing_rad"] * distance
    along = np.hypot(config[key + "sigma_range_m"], config[key + "sigma_range_per_m"] * distance)
    return float(max(across, along))


CHECKS = (markers_too_close,)
