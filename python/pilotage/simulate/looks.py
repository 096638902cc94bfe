"""What the markers of a map look like: discs, poles or tags."""

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, Protocol

import numpy as np

from .. import MarkerMap
from ..fields import within
from .paints import paint

if TYPE_CHECKING:
    from .appearance import Body


class Looks(Protocol):
    """Of all markers of a map."""

    def bodies(self, markers: MarkerMap) -> "list[Body]":
        """Return what stands at each marker, in the map's order."""

    def detector(self, markers: MarkerMap) -> dict[str, Any]:
        """Return the entry of a configuration's `detectors` that finds them."""


@dataclass(frozen=True)
class Discs:
    """Flat on the ground; a marker's position is the centre."""

    radius_m: float = 0.2
    colour: str = "red"

    def __post_init__(self) -> None:
        within("radius_m", self.radius_m, 1e-3, 10.0)
        paint(self.colour)

    def bodies(self, markers: MarkerMap) -> "list[Body]":
        """A disc a marker."""
        from .appearance import Disc

        places = markers.positions.tolist()
        return [Disc((x, y, z), self.radius_m, paint(self.colour)) for x, y, z in places]

    def detector(self, markers: MarkerMap) -> dict[str, Any]:
        """Discs of this colour."""
        return {"kind": "discs", "radius_m": self.radius_m, "colour": self.colour}


@dataclass(frozen=True)
class Poles:
    """Upright; a marker's position is the foot, and its label tells the colour."""

    height_m: float = 1.0
    radius_m: float = 0.1
    colours: Mapping[int, str] = field(default_factory=dict)
    """By label."""

    def __post_init__(self) -> None:
        within("height_m", self.height_m, 1e-3, 100.0)
        within("radius_m", self.radius_m, 1e-3, 10.0)
        for name in self.colours.values():
            paint(name)

    def bodies(self, markers: MarkerMap) -> "list[Body]":
        """A pole a marker."""
        from .appearance import Pole

        places = zip(markers.positions.tolist(), markers.labels.tolist(), strict=True)
        return [
            Pole((x, y, z), self.height_m, self.radius_m, paint(self._colour(label)))
            for (x, y, z), label in places
        ]

    def detector(self, markers: MarkerMap) -> dict[str, Any]:
        """Poles of the colours that the map has."""
        labels = sorted(set(markers.labels.tolist()))
        return {
            "kind": "poles",
            "height_m": self.height_m,
            "radius_m": self.radius_m,
            "colours": {label: self._colour(label) for label in labels},
        }

    def _colour(self, label: int) -> str:
        if label not in self.colours:
            raise ValueError(f"colours has none for the label {label} of the site's markers")
        return self.colours[label]


@dataclass(frozen=True)
class Tags:
    """Upright square tags; a marker's position is the centre, its id is the tag's."""

    dictionary: str = "4x4_50"
    """Of `cv2.aruco`: 4x4_50, apriltag_36h11, ..."""
    size_m: float = 0.15
    """Side of the black square."""
    yaw_rad: Mapping[int, float] = field(default_factory=dict)
    """By id, the direction to which a tag looks; one that is not named looks to the origin."""

    def __post_init__(self) -> None:
        within("size_m", self.size_m, 1e-3, 10.0)

    def bodies(self, markers: MarkerMap) -> "list[Body]":
        """A tag a marker."""
        from .appearance import Tag

        yaws = self._yaws(markers)
        places = zip(markers.ids.tolist(), markers.positions.tolist(), strict=True)
        return [
            Tag((x, y, z), yaws[number], number, self.dictionary, self.size_m)
            for number, (x, y, z) in places
        ]

    def detector(self, markers: MarkerMap) -> dict[str, Any]:
        """Tags of this dictionary and size."""
        return {
            "kind": "tags",
            "dictionary": self.dictionary,
            "size_m": self.size_m,
            "yaw_rad": self._yaws(markers),
        }

    def _yaws(self, markers: MarkerMap) -> dict[int, float]:
        inwards = np.arctan2(-markers.positions[:, 1], -markers.positions[:, 0])
        return dict(zip(markers.ids.tolist(), inwards.tolist(), strict=True)) | dict(self.yaw_rad)


KINDS: dict[str, type[Discs] | type[Poles] | type[Tags]] = {
    "discs": Discs,
    "poles": Poles,
    "tags": Tags,
}
"""By the name that scenario and configuration call them."""
