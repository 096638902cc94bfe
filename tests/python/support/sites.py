"""Maps to look at, and the sensors that look."""

from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from pilotage import Config, MarkerMap

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
RECTANGLE = [(0, 0), (6, 0), (6, 3), (0, 3)]
LINE = [(0, 0), (3, 0), (7, 0), (12, 0)]
GRID = [(6.4 * i, 7.0 * j) for j in range(7) for i in range(4)]
BOTH = {"sigma_bearing_rad": 0.01, "sigma_range_m": 0.05}
BEARINGS = {"sigma_bearing_rad": 0.01}
RANGES = {"sigma_range_m": 0.05}


def markers(xy: ArrayLike, sigma: float = 0.0, z: float = 0.5) -> MarkerMap:
    xy = np.asarray(xy, dtype=float)
    return MarkerMap(np.arange(len(xy)), np.column_stack([xy, np.full(len(xy), z)]), sigma)


def site(xy: ArrayLike, sensor: dict[str, float] = BOTH, **changes: Any) -> Config:
    """A configuration with a map, and a sensor called eye; two underscores stand for a dot."""
    config = Config()
    config.map = markers(xy)
    for key, value in sensor.items():
        config[f"sensors.eye.{key}"] = value
    for key, value in changes.items():
        config[key.replace("__", ".")] = value
    return config
