"""Square fiducial markers on walls, found in images and solved for by perspective-n-point (PnP)."""

from dataclasses import dataclass, field, replace

import numpy as np
from numpy.typing import NDArray

from .. import MarkerMap, WorldBearing
from ..evaluate import wrap_angle
from .drives import Drive
from .sensors import Camera


@dataclass(frozen=True)
class Detections:
    """Markers found in frames, k in all, frame by frame.

    Attributes
    ----------
    frame : (k,) int
        Index of the frame.
    marker : (k,) int
        Index in the map.
    bearing, range : (k,) float, rad and m
        From the camera.
    direction : (k,) float, rad
        From the marker to the robot in frame map, in (−π, π]: what the marker's attitude in the
        image tells.
    """

    frame: NDArray[np.intp]
    marker: NDArray[np.intp]
    bearing: NDArray[np.float64]
    range: NDArray[np.float64]
    direction: NDArray[np.float64]

    def rows(self, index: NDArray[np.bool_] | NDArray[np.intp]) -> "Detections":
        """Return those of a mask or of indices."""
        return Detections(*(column[index] for column in vars(self).values()))

    def within(self, limit_m: float) -> "Detections":
        """Return those whose estimated range is no more than a limit."""
        return self.rows(self.range <= limit_m)

    def numbered(self, step: int) -> "Detections":
        """Return the same where frames came with every `step`-th sample, numbered by samples."""
        return replace(self, frame=self.frame * step)

    def nearest(self) -> "Detections":
        """Return of every frame the nearest marker alone."""
        by_range = np.lexsort((self.range, self.frame))
        return self.rows(by_range[np.unique(self.frame[by_range], return_index=True)[1]])


@dataclass(frozen=True)
class FiducialCamera:
    """A camera and the errors of PnP, which has two solutions for a small square far away.

    The centre of a marker is sure in the image, and so is the bearing; the range is less so, and
    the direction from the marker, which its distorted outline tells, is worst. Beyond some distance
    a share of the solutions is the wrong one: the marker is turned about the line of sight, to the
    other side.
    """

    camera: Camera = field(
        default_factory=lambda: Camera(
            "camera",
            components=("bearing", "range"),
            mounting=(0.07, 0.0, 0.1, 0.0),
            rate_hz=30.0,
            reach_m=6.0,
            half_view_rad=0.54,
        )
    )
    sigma_bearing_rad: float = 0.005
    sigma_range_per_m: float = 0.02
    sigma_direction_rad_per_m: float = 0.02
    wild_share: float = 0.05
    wild_beyond_m: float = 3.0
    wild_sigma_range: float = 0.1
    """Of the range of a wild solution, as a part of it."""

    def sigma(self, name: str, slant: NDArray[np.float64]) -> NDArray[np.float64]:
        """(k,) standard deviation of bearing, range or direction at ranges (k,), unless wild."""
        if name == "bearing":
            return np.full_like(slant, self.sigma_bearing_rad)
        per_m = {"range": self.sigma_range_per_m, "direction": self.sigma_direction_rad_per_m}
        return per_m[name] * slant

    def detect(
        self,
        drive: Drive,
        markers: MarkerMap,
        utime: NDArray[np.int64],
        rng: np.random.Generator,
    ) -> Detections:
        """Take a frame at each of the times (f,) µs; the markers face the origin."""
        exact = self.camera.look_at_all(drive, markers, utime)
        poses = drive.at(utime)
        direction = np.column_stack(
            [WorldBearing(marker[:2]).predict(poses)[:, 0] for marker in markers.positions]
        )
        facing = np.arctan2(-markers.positions[:, 1], -markers.positions[:, 0])
        slant = exact[..., 2]
        noise = rng.standard_normal((3, *slant.shape))
        wild = (rng.random(slant.shape) < self.wild_share) & (slant > self.wild_beyond_m)
        bearing = exact[..., 0] + self.sigma_bearing_rad * noise[0]
        spread = np.where(wild, self.wild_sigma_range, self.sigma_range_per_m)
        aspect = np.where(wild, -1.0, 1.0) * wrap_angle(direction - facing)
        aspect += self.sigma_direction_rad_per_m * slant * noise[2]
        frame, marker = np.nonzero(self.camera.in_view(exact))
        return Detections(
            frame,
            marker,
            wrap_angle(bearing)[frame, marker],
            (slant * (1.0 + spread * noise[1]))[frame, marker],
            wrap_angle(facing + aspect)[frame, marker],
        )
