"""A camera of which pictures are rendered: where it sits, its lens, what its sensor adds."""

from dataclasses import dataclass, field, replace
from functools import cached_property

import numpy as np
from numpy.typing import NDArray

from .. import CameraModel
from ..fields import within
from ..sensor_keys import in_order
from .exposure import Exposure
from .sensors import FASTEST_HZ, Camera

FORMATS = ("png", "jpg")


@dataclass(frozen=True)
class PictureCamera:
    """Pixels and distortion are OpenCV's."""

    name: str
    components: tuple[str, ...] = ("bearing", "elevation")
    """What its detector measures of a marker."""
    mounting: tuple[float, float, float, float] = (0.0, 0.0, 1.0, 0.0)
    """x, y, z [m] and yaw [rad] in the robot frame."""
    roll_rad: float = 0.0
    """Positive: the right side lower."""
    pitch_rad: float = 0.0
    """Positive: it looks down."""
    size: tuple[float, float] = (640.0, 480.0)
    """Width and height, px."""
    focal_px: tuple[float, float] = (600.0, 600.0)
    centre_px: tuple[float, float] | None = None
    """Of the lens; None: the picture's middle."""
    distortion: tuple[float, ...] = ()
    """k1, k2, p1, p2 and so on: none, 4, 5 or 8 numbers."""
    exposure: Exposure = field(default_factory=Exposure)
    rate_hz: float = 2.0
    reach_m: float = 10.0
    """What is farther does not count as in view."""
    sigma_pixel: float = 0.5
    """What the configuration takes a marker's pixel to be wrong by, in u and in v."""
    sigma_range_m: float = 0.1
    """And a range, where that is measured."""
    pictures: str = "png"
    """Or jpg, which is a fifth of that and blurs colours a little."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "components", in_order(self.components))
        within("rate_hz", self.rate_hz, 1e-3, FASTEST_HZ)
        within("reach_m", self.reach_m, 0.0)
        within("sigma_pixel", self.sigma_pixel, 1e-3, 1e3)
        within("sigma_range_m", self.sigma_range_m, 0.0)
        for value in self.size:
            within("size", value, 16, 8192)
            if value != int(value):
                raise ValueError(f"size is {value:g}, expected whole pixels")
        if self.pictures not in FORMATS:
            raise ValueError(f"pictures is {self.pictures!r}, expected {' or '.join(FORMATS)}")
        self.model  # noqa: B018 - refuses a lens that there is not

    @cached_property
    def model(self) -> CameraModel:
        """Its optics."""
        width, height = (int(value) for value in self.size)
        centre = self.centre_px or ((width - 1) / 2, (height - 1) / 2)
        return CameraModel(
            size=(width, height),
            matrix=(*self.focal_px, *centre),
            distortion=list(self.distortion),
            roll_rad=self.roll_rad,
            pitch_rad=self.pitch_rad,
        )

    def __getstate__(self) -> dict[str, object]:
        """Leave out the model, which cannot go to another process."""
        return {key: value for key, value in vars(self).items() if key != "model"}

    def in_picture(self, pixels: NDArray[np.float64]) -> NDArray[np.bool_]:
        """(n,) whether pixels (n, 2) are of the picture."""
        inside = (pixels >= -0.5) & (pixels < np.array(self.size) - 0.5)
        return np.asarray(inside.all(axis=1))  # not a number is not

    def sensor(self) -> Camera:
        """Return what measures as its detector would, without a picture."""
        middle = (self.size[1] - 1) / 2
        sides = self.model.angles(np.array([[0.0, middle], [self.size[0] - 1.0, middle]]))
        return Camera(
            self.name,
            self.components,
            self.mounting,
            (
                self.sigma_pixel / self.focal_px[0],
                self.sigma_pixel / self.focal_px[1],
                self.sigma_range_m,
            ),
            self.rate_hz,
            self.reach_m,
            float(np.abs(sides[:, 0]).min()),
        )

    def with_noise(self, factor: float) -> "PictureCamera":
        """Return the same with its pictures' noise times a factor."""
        return replace(self, exposure=replace(self.exposure, noise=factor * self.exposure.noise))
