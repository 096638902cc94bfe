"""The part of a scenario that pictures are rendered of."""

from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from .. import MarkerMap
from .looks import Looks
from .picture_camera import PictureCamera
from .surroundings import place

if TYPE_CHECKING:
    from .render import World


@dataclass(frozen=True)
class Scene:
    """Cameras, and what the site of the scenario looks like to them."""

    cameras: tuple[PictureCamera, ...]
    markers: Looks
    surroundings: str = "lawn"

    def __post_init__(self) -> None:
        place(self.surroundings)

    def world(self, markers: MarkerMap) -> "World":
        """Return what there is to see, the markers first and in the map's order."""
        from .render import World

        return World(self.markers.bodies(markers), place(self.surroundings))

    def with_noise(self, factor: float) -> "Scene":
        """Return the same with the pictures' noise times a factor."""
        return replace(self, cameras=tuple(camera.with_noise(factor) for camera in self.cameras))
