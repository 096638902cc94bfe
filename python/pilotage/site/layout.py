"""Where the markers stand, and which of them could be taken for each other."""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from .. import MarkerMap
from .sight import Sight

APART = 3.0
"""So many sigmas between two places, and a sighting tells one from the other."""
CROWDED = 1.0 / 3.0
"""Of the usual distance between neighbours: with more tolerance any layout resembles any other."""

Indices = NDArray[np.intp]


@dataclass(frozen=True)
class Layout:
    """The markers in the plane, as complex numbers: x + iy in frame map, m.

    Attributes
    ----------
    z : (n,) complex, m
    height : (n,) float, m; 0 where the sensors do not measure it
    label : (n,) int; -1 none; markers of different label are never taken for each other
    """

    ids: NDArray[np.int32]
    z: NDArray[np.complex128]
    height: NDArray[np.float64]
    label: NDArray[np.int32]
    labelled: bool
    """Whether the map has labels: then sensors tell these, not ids."""
    sigma_m: float
    """Of the survey, of most markers."""

    @classmethod
    def of(cls, markers: MarkerMap, sights: Iterable[Sight] = ()) -> "Layout":
        """Read a map; sensors that measure elevations see how high a marker is."""
        x, y, z = markers.positions.T
        heights = any("elevation" in sight.components for sight in sights)
        return cls(
            ids=markers.ids,
            z=x + 1j * y,
            height=z if heights else np.zeros(len(markers)),
            label=markers.labels,
            labelled=bool(np.any(markers.labels >= 0)),
            sigma_m=float(np.median(markers.sigmas)) if len(markers) else 0.0,
        )

    def __len__(self) -> int:
        return len(self.z)

    @property
    def names(self) -> list[str]:
        """The ids, with the labels that sensors tell them by: "7", or "7 (2)"."""
        if not self.labelled:
            return [str(marker) for marker in self.ids]
        return [f"{i} ({label})" for i, label in zip(self.ids, self.label, strict=True)]

    @cached_property
    def tree(self):  # type: ignore[no-untyped-def]  # scipy has no types
        """A KD-tree of all markers, those of each label far from those of another."""
        from scipy.spatial import KDTree

        return KDTree(self.points(self.z, np.arange(len(self))))

    def points(self, at: NDArray[np.complex128], of: Indices) -> NDArray[np.float64]:
        """Make the points (…, 4) that the tree holds: markers `of` (m,), were they `at` (…, m)."""
        span = 1e3 * (1.0 + float(np.ptp(self.z.real) + np.ptp(self.z.imag)))
        apart = np.broadcast_to(span * self._label_rank[of], at.shape)
        height = np.broadcast_to(self.height[of], at.shape)
        return np.stack([at.real, at.imag, height, apart], axis=-1)

    @cached_property
    def _label_rank(self) -> Indices:
        """0, 1, 2, … for the labels in use: they may be large."""
        return np.unique(self.label, return_inverse=True)[1]

    @cached_property
    def usual_m(self) -> float:
        """The median distance from a marker to its nearest; infinite for a single one."""
        from scipy.spatial import KDTree

        xy = np.column_stack([self.z.real, self.z.imag])
        return float(np.median(KDTree(xy).query(xy, k=2)[0][:, 1]))

    def tolerance_m(self, sights: Sequence[Sight]) -> float:
        """Return how far apart two places are that the best of the sensors tells apart."""
        usual = self.usual_m if np.isfinite(self.usual_m) else 1.0
        blur = min(sight.blur(usual) for sight in sights)
        return min(APART * float(np.hypot(blur, self.sigma_m)), CROWDED * usual)

    def twins(self, within_m: float) -> list[tuple[int, int, float]]:
        """Find pairs nearer than that: two indices and their distance, the nearest first."""
        pairs = self.tree.query_pairs(within_m)
        apart = ((i, j, self.tree.data[i] - self.tree.data[j]) for i, j in pairs)
        return sorted(
            ((i, j, float(np.linalg.norm(arm))) for i, j, arm in apart), key=lambda t: t[2]
        )

    def like(self, one: int, other: int, tolerance_m: float) -> tuple[Indices, Indices]:
        """Find the pairs that could be taken for a pair: as far apart, with its labels."""
        distance, first, second = self._pairs
        d = abs(self.z[other] - self.z[one])
        low, high = np.searchsorted(distance, [d - tolerance_m, d + tolerance_m])
        first, second = first[low:high], second[low:high]
        same = (self.label[first] == self.label[one]) & (self.label[second] == self.label[other])
        return first[same], second[same]

    @cached_property
    def _pairs(self) -> tuple[NDArray[np.float64], Indices, Indices]:
        """Distances between any two markers in order, and the two."""
        first, second = np.nonzero(~np.eye(len(self), dtype=bool))
        distance = np.abs(self.z[second] - self.z[first])
        order = np.argsort(distance, kind="stable")
        return distance[order], first[order], second[order]
