"""Where the markers stand."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import MarkerMap


@dataclass(frozen=True)
class Surveyed:
    """A site that is the same in every run; a MarkerMap itself cannot go to another process."""

    ids: NDArray[np.int32]
    positions: NDArray[np.float64]
    sigmas: NDArray[np.float64]
    labels: NDArray[np.int32]

    @classmethod
    def of(cls, markers: MarkerMap) -> "Surveyed":
        """Take the markers of a map."""
        return cls(markers.ids, markers.positions, markers.sigmas, markers.labels)

    def __call__(self, _: np.random.Generator) -> MarkerMap:
        """Return the map."""
        return MarkerMap(self.ids, self.positions, self.sigmas, self.labels)


def as_they_stand(surveyed: MarkerMap, rng: np.random.Generator) -> MarkerMap:
    """Return where the markers are of which that is the survey: off by its sigma in x and in y."""
    if not surveyed.sigmas.any():
        return surveyed
    positions = surveyed.positions.copy()
    positions[:, :2] += surveyed.sigmas[:, None] * rng.standard_normal((len(surveyed), 2))
    return MarkerMap(surveyed.ids, positions, surveyed.sigmas, surveyed.labels)


def mower_site(rng: np.random.Generator) -> MarkerMap:
    """28 ground markers, six to seven metres apart, like the first paper's."""
    columns, rows = np.meshgrid(np.arange(4) * 6.4 - 9.6, np.arange(7) * 7.0 - 21.0)
    xy = np.column_stack([columns.ravel(), rows.ravel()]) + rng.uniform(-0.6, 0.6, (28, 2))
    return _on_ground(xy)


def four_poles() -> MarkerMap:
    """Four poles on the corners of a field of 5 m by 10 m."""
    return _on_ground(np.array([[-2.5, -5.0], [2.5, -5.0], [2.5, 5.0], [-2.5, 5.0]]))


def hall(rng: np.random.Generator) -> MarkerMap:
    """Ten reflectors at mixed heights along the walls of a hall of 16 m by 10 m."""
    xy = np.array(
        [[-8, -3], [-8, 2], [-4, 5], [1, 5], [6, 5], [8, 1], [8, -4], [3, -5], [-2, -5], [-6, -5]]
    )
    xy = xy + rng.uniform(-0.4, 0.4, xy.shape)
    return MarkerMap(np.arange(10), np.column_stack([xy, rng.uniform(0.3, 2.0, 10)]))


def yard() -> MarkerMap:
    """Ten posts about a yard of 15 m by 13 m, placed so that no two views are alike."""
    xy = np.array(
        [
            [-8, -4],
            [-4, -6],
            [1, -5],
            [5, -5],
            [6, 0],
            [5, 4],
            [0, 7],
            [-5, 7],
            [-9, 3],
            [-1.5, 0.5],
        ]
    )
    return MarkerMap(np.arange(10), np.column_stack([xy, np.full(10, 0.5)]))


def ring(radius_m: float = 2.8) -> MarkerMap:
    """Six markers on the wall of a round arena, at the height of a small robot's camera."""
    angle = np.pi / 9 + np.arange(6) * np.pi / 3
    xy = radius_m * np.column_stack([np.cos(angle), np.sin(angle)])
    return MarkerMap(np.arange(6), np.column_stack([xy, np.full(6, 0.1)]))


def _on_ground(xy: np.ndarray) -> MarkerMap:
    return MarkerMap(np.arange(len(xy)), np.column_stack([xy, np.zeros(len(xy))]))


SITES: dict[str, Callable[[np.random.Generator], MarkerMap]] = {
    "mower": mower_site,
    "four-poles": lambda _: four_poles(),
    "hall": hall,
    "yard": lambda _: yard(),
    "ring": lambda _: ring(),
}
"""By the name that a scenario file calls them."""
