"""What a camera on a robot would see of a rendered world."""

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import CameraModel
from .appearance import Body, Disc, Tag
from .lens import Box, Lens, mean_of_parts, turned
from .surroundings import PLACES, Surroundings
from .view import LEVEL, sight

PARTS = (4, 32)
"""Into how many parts a pixel's side is divided where a body is: at least, and at most."""
RAYS = 100_000
"""To a body, between these limits."""


@dataclass(frozen=True)
class World:
    """Bodies in their surroundings."""

    bodies: Sequence[Body] = ()
    surroundings: Surroundings = PLACES["lawn"]

    def shows(self, index: int, eye: NDArray[np.float64]) -> bool:
        """Tell whether from an eye (3,) the middle of a body is in sight, a tag's face too."""
        body = self.bodies[index]
        way = body.centre - eye
        if isinstance(body, Tag) and way @ body.rotation[:, 2] >= 0.0:
            return False
        ray = way.astype(np.float32)[None, None]
        near = _order(body, eye)
        return not any(
            _order(other, eye) > near and other.meet(eye, ray)[0].any() for other in self.bodies
        )


class Renderer:
    """Draws a world as one camera of a robot sees it, every part of every pixel by its own ray.

    Parameters
    ----------
    model : CameraModel
        Its size, lens, roll and pitch.
    mounting : (4,) float
        x, y, z [m] and yaw [rad] of the camera in the robot.
    """

    def __init__(
        self, model: CameraModel, mounting: tuple[float, float, float, float], world: World
    ) -> None:
        self.lens, self.mounting, self.world = Lens(model), mounting, world

    def draw(
        self, pose: NDArray[np.float64], tilt: tuple[float, float] = LEVEL
    ) -> NDArray[np.float32]:
        """Draw without blur and noise.

        Parameters
        ----------
        pose : (3,) float
            x, y [m], heading [rad] of the robot in frame map.
        tilt : (2,) float, rad
            Pitch (nose down) and roll (right side down) of the body; the camera stays in its place.

        Returns
        -------
        (h, w, 3) float32
            Blue, green, red, 0 to 255. (0, 0) is the centre of the top left pixel, and a pixel is
            the mean over its area.
        """
        eye, rotation = self.sight(pose, tilt)
        rays = turned(self.lens.central, rotation)
        picture = self.world.surroundings.behind(eye, rays)
        for body in sorted(self.world.bodies, key=lambda body: _order(body, eye)):
            box = self.lens.box((body.outline() - eye) @ rotation)
            if box is not None:
                self._add(picture, body, eye, rotation, self._narrowed(box, body, eye, rotation))
        picture[self.lens.blind] = 0.0
        return picture

    def sight(
        self, pose: NDArray[np.float64], tilt: tuple[float, float] = LEVEL
    ) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
        """Where the camera is (3,) m, and the rotation (3, 3) from its level frame to frame map."""
        return sight(self.mounting, pose, tilt)

    def _add(
        self,
        picture: NDArray[np.float32],
        body: Body,
        eye: NDArray[np.float64],
        rotation: NDArray[np.float64],
        box: Box | None,
    ) -> None:
        if box is None:
            return
        left, top, right, bottom = box
        n = int(np.clip(np.sqrt(RAYS / ((right - left) * (bottom - top))), *PARTS))
        hit, bright = body.meet(eye, turned(self.lens.parts(box, n), rotation))
        share = hit.astype(np.float32)
        light = mean_of_parts(share if bright is None else share * bright, n)
        part = picture[top:bottom, left:right]
        part *= 1.0 - mean_of_parts(share, n)[..., None]
        part += light[..., None] * np.array(body.colour, np.float32)

    def _narrowed(
        self, box: Box, body: Body, eye: NDArray[np.float64], rotation: NDArray[np.float64]
    ) -> Box | None:
        """Return what of a box that is the whole picture has the body, by its pixels' centres."""
        if box != (0, 0, self.lens.width, self.lens.height):
            return box
        hit, _ = body.meet(eye, turned(self.lens.central, rotation))
        rows, columns = np.flatnonzero(hit.any(axis=1)), np.flatnonzero(hit.any(axis=0))
        if len(rows) == 0:
            return None
        return (
            max(int(columns[0]) - 2, 0),
            max(int(rows[0]) - 2, 0),
            min(int(columns[-1]) + 3, self.lens.width),
            min(int(rows[-1]) + 3, self.lens.height),
        )


def _order(body: Body, eye: NDArray[np.float64]) -> tuple[bool, float]:
    """What lies on the ground first, then from far to near."""
    flat = isinstance(body, Disc) and body.position[2] <= 0.0
    return not flat, -float(np.hypot(*(body.centre - eye)[:2]))
