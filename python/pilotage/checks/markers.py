"""Where the markers stand, and to whom that is too close."""

import math
from collections.abc import Iterable, Iterator
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import Config, MarkerMap
from ..site import APART, Layout, Sight
from .finding import Finding


class Pair(NamedTuple):
    """Two markers by their ids."""

    one: int
    other: int
    apart_m: float


def closest(markers: MarkerMap) -> Pair | None:
    """Find the closest pair; None where there are fewer than two markers."""
    from scipy.spatial import KDTree

    if len(markers) < 2:
        return None
    distances, places = KDTree(markers.positions).query(markers.positions, k=2)
    least: NDArray[np.float64] = distances[:, 1]
    at = int(np.argmin(least))
    one, other = sorted(int(markers.ids[place]) for place in places[at])
    return Pair(one, other, float(least[at]))


def markers_too_close(config: Config) -> Iterator[Finding]:
    """Find markers that a sensor cannot tell apart where it sees their neighbours."""
    return too_close(config.map, [Sight.of(config, name) for name in config.marker_sensors])


def too_close(markers: MarkerMap, sights: Iterable[Sight]) -> Iterator[Finding]:
    """Find markers that one of these sensors cannot tell apart where it sees their neighbours."""
    if len(markers) < 2:
        return
    for sight in sights:
        layout = Layout.of(markers, [sight])
        blur = APART * math.hypot(sight.blur(layout.usual_m), layout.sigma_m)
        if twins := layout.twins(blur):
            one, other, apart = twins[0]
            others = f", {len(twins) - 1} more too close as well" if len(twins) > 1 else ""
            yield Finding(
                "map",
                f"markers {layout.ids[one]} and {layout.ids[other]} are {apart:.3g} m apart"
                f"{others}; seen from {layout.usual_m:.3g} m, {sight.name} tells apart "
                f"{blur:.2g} m ({APART:g} σ)",
                "set them further apart, or be sure that their ids are never confused",
            )


CHECKS = (markers_too_close,)
