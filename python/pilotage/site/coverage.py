"""What is in view from each pose on the ground, and how well one frame of it fixes the position."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from .. import MarkerMap
from ..evaluate import ellipse_scale
from .ground import Ground
from .sight import Sight

PROBABILITY = 0.95

Array = NDArray[np.float64]


class Few(NamedTuple):
    """Parts, 0 to 1, of which few markers are in view."""

    poses: float
    """Of all places and headings."""
    worst_heading: float
    """Of the places, with the heading that sees least."""
    best_heading: float
    """Of the places, with the heading that sees most."""


@dataclass(frozen=True)
class Coverage:
    """Of each pose that is tried on the ground.

    Attributes
    ----------
    visible : (ny, nx, h, n) bool
        Whether any sensor has the marker in view.
    radius_m : (ny, nx, h)
        That holds the position with 95 %, after one frame of all sensors and with nothing but
        the heading known before; infinite where the frame does not fix it.
    average_m : (ny, nx)
        The same of a frame that has the mean information of all headings: what counts for a
        robot that drives on and turns.
    """

    ground: Ground
    visible: NDArray[np.bool_]
    radius_m: Array
    average_m: Array

    @classmethod
    def of(
        cls,
        ground: Ground,
        markers: MarkerMap,
        sights: Sequence[Sight],
        sigma_heading_rad: float,
        progress: Callable[[float], None] | None = None,
    ) -> "Coverage":
        """Look at every marker with every sensor from every pose.

        `sigma_heading_rad` is of the heading by dead reckoning, before the frame; 0: exactly known.
        """
        poses = ground.poses()
        visible = np.zeros((len(poses), len(markers)), dtype=bool)
        information = np.zeros((len(poses), 3, 3))
        information[:, 2, 2] = sigma_heading_rad**-2 if sigma_heading_rad > 0.0 else np.inf
        for column, (marker, sigma) in enumerate(
            zip(markers.positions.tolist(), markers.sigmas.tolist(), strict=True)
        ):
            if progress is not None:
                progress(column / len(markers))
            for sight in sights:
                seen = np.flatnonzero(sight.sees(marker, poses))
                visible[seen, column] = True
                information[seen] += sight.information(marker, sigma, poses[seen])
        position = of_position(information).reshape(*ground.shape, 2, 2)
        return cls(
            ground,
            visible.reshape(*ground.shape, len(markers)),
            radius_of(position),
            radius_of(position.mean(axis=2)),
        )

    @property
    def count(self) -> NDArray[np.intp]:
        """(ny, nx, h) markers in view."""
        return np.asarray(self.visible.sum(axis=-1))

    def radius_of_part(self, part: float) -> float:
        """Return what `average_m` is no more than in that part, 0 to 1, of the area."""
        radius = np.sort(self.average_m, axis=None)
        return float(radius[int(part * (radius.size - 1))])

    def fewer(self, than: int) -> "Few":
        """Return how much of it all has fewer markers in view."""
        few = self.count < than
        return Few(float(few.mean()), float(few.any(-1).mean()), float(few.all(-1).mean()))


def of_position(information: Array) -> Array:
    """Return what is left of a pose's information (n, 3, 3) for the position, (n, 2, 2).

    The heading is estimated with it: the Schur complement.
    """
    cross = information[:, :2, 2]
    by_heading = cross[:, :, None] * cross[:, None, :] / information[:, 2, 2, None, None]
    return np.asarray(information[:, :2, :2] - by_heading)


def radius_of(information: Array) -> Array:
    """Return the position's 95 % radius (…), m, from its information (…, 2, 2).

    It is that of the status: the longer half axis of the ellipse.
    """
    values = np.linalg.eigvalsh(information)
    least, most = values[..., 0], values[..., 1]
    fixed = least > 1e-9 * most  # below that is what rounding leaves of nothing
    scale = ellipse_scale(PROBABILITY)
    return np.where(fixed, scale / np.sqrt(np.where(fixed, least, 1.0)), np.inf)
