"""From where a camera on a robot looks, and what is then in its picture."""

from typing import TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from ..sensor_keys import COMPONENTS
from .measuring import Measured
from .picture_camera import PictureCamera
from .streams import Stream

if TYPE_CHECKING:
    from .render import World

Array = NDArray[np.float64]
LEVEL = (0.0, 0.0)


def sight(
    mounting: tuple[float, float, float, float],
    pose: Array,
    tilt: tuple[float, float] = LEVEL,
) -> tuple[Array, Array]:
    """Return where a camera is, (3,) m, and the rotation (3, 3) from its level frame to frame map.

    Parameters
    ----------
    mounting : (4,) x, y, z [m] and yaw [rad] in the robot
    pose : (3,) x, y [m], heading [rad] of the robot
    tilt : (2,) pitch (nose down) and roll (right side down) of the body [rad]; the camera stays in
        its place
    """
    x, y, heading = pose
    ahead, aside, up, yaw = mounting
    body = _about_z(heading)
    eye = np.array([x, y, 0.0]) + body @ (ahead, aside, up)
    return eye, body @ _tilted(*tilt) @ _about_z(yaw)


def stands(measured: Measured, utime: NDArray[np.int64]) -> tuple[Array, Array]:
    """(f, 3) poses and (f, 2) tilts [rad] of the robot at any times of its drive."""
    tilts = np.zeros((len(utime), 2))
    if measured.tilt is not None:
        tilts = measured.tilt[np.searchsorted(measured.drive.utime, utime, side="right") - 1]
    return measured.drive.at(utime), tilts


def in_view(
    camera: PictureCamera, world: "World", measured: Measured, utime: NDArray[np.int64]
) -> Stream:
    """Return bearing, elevation and range without any error of all markers that pictures show.

    Those are the ones within the camera's reach of which the surveyed point is in the picture, with
    nothing before it; a tag besides shows its face.
    """
    markers = measured.true_markers
    frames, ids, values = [], [], []
    for time, pose, tilt in zip(utime, *stands(measured, utime), strict=True):
        eye, rotation = sight(camera.mounting, pose, tuple(tilt))
        points = (markers.positions - eye) @ rotation
        pixels = camera.model.project(points)
        slant = np.linalg.norm(points, axis=1)
        near = np.flatnonzero(camera.in_picture(pixels) & (slant <= camera.reach_m))
        seen = np.array([i for i in near if world.shows(int(i), eye)], dtype=np.intp)
        frames.append(np.full(len(seen), time))
        ids.append(markers.ids[seen])
        values.append(np.column_stack([camera.model.angles(pixels[seen]), slant[seen]]))
    value = np.concatenate(values)
    value[:, [c not in camera.components for c in COMPONENTS]] = np.nan
    return Stream.sent(np.concatenate(frames), value, np.concatenate(ids))


def _about_z(angle: float) -> Array:
    c, s = np.cos(angle), np.sin(angle)
    return np.array([[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]])


def _tilted(pitch: float, roll: float) -> Array:
    (cp, sp), (cr, sr) = ((np.cos(angle), np.sin(angle)) for angle in (pitch, roll))
    about_y = np.array([[cp, 0.0, sp], [0.0, 1.0, 0.0], [-sp, 0.0, cp]])
    about_x = np.array([[1.0, 0.0, 0.0], [0.0, cr, -sr], [0.0, sr, cr]])
    return np.asarray(about_y @ about_x)
