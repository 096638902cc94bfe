"""What evaluation and figures need of a run and of a map, whoever made them."""

from collections.abc import Mapping, Sequence
from typing import Any, Protocol

import numpy as np
from numpy.typing import NDArray


class HasPoses(Protocol):
    """What figures of the estimate alone need."""

    @property
    def poses(self) -> NDArray[Any]:
        """(n,) structured: utime µs, x, y m, heading rad, covariance (3, 3) of those three."""


class RunLike(HasPoses, Protocol):
    """The outcome of a replay: ``pilotage.Run``, or anything with these attributes."""

    @property
    def reports(self) -> NDArray[Any]:
        """(m,) structured, a row a sighting.

        utime µs, sensor (index into `sensors`), frame_seq, nis, dof, accepted, reason (index into
        `reasons`).
        """

    @property
    def sensors(self) -> Sequence[str]:
        """Names of the sensors."""

    @property
    def reasons(self) -> Sequence[str]:
        """Reasons for which a sighting was rejected."""

    @property
    def counts(self) -> Mapping[str, Any]:
        """``messages``, ``samples``, ``accepted``, and ``rejected``, a count by reason."""

    @property
    def wall_s(self) -> float:
        """Time that the run took, s."""


class MapLike(Protocol):
    """Surveyed markers: ``pilotage.MarkerMap``, or anything with these attributes."""

    @property
    def ids(self) -> NDArray[np.int32]:
        """(n,) numbers of the markers."""

    @property
    def positions(self) -> NDArray[np.float64]:
        """(n, 3) x, y, z in frame map, m."""
