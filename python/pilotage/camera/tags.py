"""ArUco and AprilTag markers."""

import math
from dataclasses import dataclass, field, replace

import cv2
import numpy as np

from .. import CameraModel
from ..fields import within
from .detection import Array, Detection, Image, check_size
from .dictionaries import dictionary_of
from .square import refine
from .tag_pose import TagPose, tag_poses

COARSE_PX = 0.4
"""Of a corner that only `cv2.cornerSubPix` has found."""


@dataclass(frozen=True, eq=False)
class TagDetection(Detection):
    """A tag; `outline` are its corners, clockwise from the top left as one reads it."""

    corner_covariance: Array = field(default_factory=lambda: np.full((8, 8), math.nan))
    """(8, 8) px^2 of u0, v0, u1, ..."""
    poses: tuple[TagPose, ...] = ()
    """Those that explain the corners, the better one first; none without the tags' size."""
    pose: TagPose | None = None
    """The better one where the other is out of the question."""


@dataclass(frozen=True)
class TagDetector:
    """Finds the tags of one dictionary."""

    camera: CameraModel
    dictionary: str
    size_m: float | None = None
    """Side of the black square; without it neither range nor pose is told."""
    yaw_rad: dict[int, float] = field(default_factory=dict)
    """By id, for poses in the map: the direction in frame map that the tag looks in."""
    max_ambiguity: float = 0.2
    """A pose is told where its error in the image is at most so much of the other solution's."""
    _modules: int = field(init=False, repr=False)
    _finder: cv2.aruco.ArucoDetector = field(init=False, repr=False)

    def __post_init__(self) -> None:
        if self.size_m is not None:
            within("size_m", self.size_m, 1e-3, 10.0)
        within("max_ambiguity", self.max_ambiguity, 0.0, 1.0)
        dictionary = dictionary_of(self.dictionary)
        parameters = cv2.aruco.DetectorParameters()
        parameters.cornerRefinementMethod = cv2.aruco.CORNER_REFINE_SUBPIX
        object.__setattr__(self, "_modules", dictionary.markerSize + 2)
        object.__setattr__(self, "_finder", cv2.aruco.ArucoDetector(dictionary, parameters))

    def detect(self, image: Image) -> list[TagDetection]:
        """Return the tags of an image (h, w, 3)."""
        check_size(image, self.camera.size)
        grey: Image = cv2.cvtColor(image, cv2.COLOR_BGR2GRAY)
        corners, ids, _ = self._finder.detectMarkers(grey)
        numbers: list[int] = [] if ids is None else np.ravel(ids).tolist()
        found = [
            self._measure(grey, number, np.asarray(four, dtype=np.float64).reshape(4, 2))
            for number, four in zip(numbers, corners, strict=True)
        ]
        return [tag for tag in found if np.isfinite(tag.pixel).all()]

    def sensor_pose(self, tag: TagDetection, position: Array) -> tuple[Array, Array] | None:
        """Return what a `pose_fix_t` says, of a tag surveyed at a position (3,) in frame map [m].

        x, y [m], heading [rad] of the sensor, their covariance (3, 3); None where the pose is in
        doubt or `yaw_rad` does not say where the tag looks.
        """
        if tag.pose is None or tag.id not in self.yaw_rad:
            return None
        return tag.pose.sensor_in_map(position, self.yaw_rad[tag.id])

    def _measure(self, grey: Image, number: int, corners: Array) -> TagDetection:
        refined = refine(grey, corners, self._modules, self.camera)
        corners, covariance = refined or (corners, COARSE_PX**2 * np.eye(8))
        pixel, pixel_covariance = _centre(self.camera, corners, covariance)
        tag = TagDetection(
            pixel, pixel_covariance, id=number, outline=corners, corner_covariance=covariance
        )
        if self.size_m is None:
            return tag
        poses = tuple(tag_poses(self.camera, corners, covariance, self.size_m))
        if not poses:
            return tag
        best = poses[0]
        clear = len(poses) == 1 or best.error_px <= self.max_ambiguity * poses[1].error_px
        return replace(
            tag,
            range_m=best.range_m,
            sigma_range_m=best.sigma_range_m,
            poses=poses,
            pose=best if clear else None,
        )


def _centre(camera: CameraModel, corners: Array, covariance: Array) -> tuple[Array, Array]:
    """Return where the diagonals meet in space, as a pixel (2,), and its covariance (2, 2) px^2."""
    step = 0.1
    flat = corners.ravel()
    every = np.vstack([flat, flat + step * np.eye(8), flat - step * np.eye(8)])
    a, b, c, d = np.moveaxis(camera.rays(every.reshape(-1, 2)).reshape(-1, 4, 3), 1, 0)
    middle = np.cross(np.cross(a, c), np.cross(b, d))
    middle *= np.sign((middle * a).sum(axis=1))[:, None]
    pixels = camera.project(middle)
    jacobian = (pixels[1:9] - pixels[9:]).T / (2 * step)
    return pixels[0], jacobian @ covariance @ jacobian.T
