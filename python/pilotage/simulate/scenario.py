"""Named drives with their sites and sensors."""

from collections.abc import Callable
from dataclasses import dataclass, field, replace
from typing import Any

import numpy as np

from .. import Config, MarkerMap
from ..fields import within
from . import drives, worlds
from .chances import Kidnap, Outliers, Start
from .drives import Drive
from .scene import Scene
from .sensors import Camera, Encoders, Gyro
from .tilt import Tilt

EXACT_M_PER_TICK = 1e-12
"""Ticks so fine that they quantise nothing, in a simulation without noise."""
SMALL_ROBOT_M_PER_TICK = np.pi * 0.1 / 2048
"""2048 ticks a turn of a wheel of 0.1 m."""


@dataclass(frozen=True)
class Scenario:
    """A drive over a site, with the robot's sensors."""

    name: str
    site: Callable[[np.random.Generator], MarkerMap]
    drive: Callable[[float], Drive]
    duration_s: float
    encoders: Encoders = field(default_factory=Encoders)
    gyro: Gyro = field(default_factory=Gyro)
    cameras: tuple[Camera, ...] = ()
    latency_s: float = 0.0
    """From a frame's capture to its arrival; its stamp tells the capture."""
    jitter_s: float = 0.0
    """Mean of what every message's way takes besides, exponentially distributed."""
    start: Start = field(default_factory=Start)
    outliers: Outliers | None = None
    tilt: Tilt | None = None
    kidnap: Kidnap | None = None
    ids: bool = True
    """Whether sightings say which marker they are of."""
    scene: Scene | None = None
    """Of which pictures are rendered."""
    config: dict[str, Any] = field(default_factory=dict)
    """Keys of the configuration, dotted, that differ from those of a suitable one."""

    def __post_init__(self) -> None:
        within("duration_s", self.duration_s, 1.0, 1e5)
        within("latency_s", self.latency_s, 0.0, 60.0)
        within("jitter_s", self.jitter_s, 0.0, 60.0)
        if self.kidnap is not None and self.kidnap.at_s[1] >= self.duration_s:
            raise ValueError(
                f"kidnap.at_s ends at {self.kidnap.at_s[1]:g}, expected before the drive does: "
                f"duration_s is {self.duration_s:g}"
            )
        if self.outliers is not None:
            self._check_outliers(self.outliers)

    def _check_outliers(self, outliers: Outliers) -> None:
        """Refuse outliers of what no sensor says."""
        if outliers.of_ids and not self.ids:
            raise ValueError(
                f"outliers.kind is {outliers.kind}, and ids is false: no sighting has an id that "
                "could be wrong; say kind: bearing"
            )
        for camera in self.cameras:
            if outliers.of_bearings and "bearing" not in camera.components:
                raise ValueError(
                    f"outliers.kind is {outliers.kind}, and sensors.{camera.name}.components has "
                    "no bearing that could be wrong; say kind: id"
                )

    def prior(self) -> tuple[float, float]:
        """Return the stated sigmas of the start: of x and of y [m], and of heading [rad]."""
        config, start = Config(), self.start
        position, heading = start.sigma_position_m, start.sigma_heading_rad
        return (
            config["initial.sigma_position_m"] if position is None else position,
            config["initial.sigma_heading_rad"] if heading is None else heading,
        )

    def drawn(self, rng: np.random.Generator) -> "Scenario":
        """Return one robot of those that it may be: start, bias and scale differ as known before.

        Without this the robot is told its true start, and its calibration is the nominal one.
        """
        position, heading = self.prior()
        sigma = self.start.error_factor * np.array([position, position, heading])
        x, y, turn = (float(error) for error in sigma * rng.standard_normal(3))
        encoders, gyro = self.encoders, self.gyro
        bias = gyro.bias_rad_s + gyro.bias_sigma_rad_s * float(rng.standard_normal())
        left, right = (1.0 + encoders.scale_sigma * rng.standard_normal()) * np.array(
            encoders.scale
        )
        return replace(
            self,
            start=replace(self.start, error=(x, y, turn)),
            gyro=replace(gyro, bias_rad_s=bias),
            encoders=replace(encoders, scale=(float(left), float(right))),
        )

    def with_noise(self, factor: float) -> "Scenario":
        """Return the same with every noise times a factor; 0 also ends the ticks' quantisation."""
        encoders, gyro = self.encoders, self.gyro
        return replace(
            self,
            encoders=replace(
                encoders,
                noise_m_per_sqrt_m=factor * encoders.noise_m_per_sqrt_m,
                m_per_tick=encoders.m_per_tick if factor > 0 else EXACT_M_PER_TICK,
            ),
            gyro=replace(
                gyro,
                noise_rad_per_sqrt_s=factor * gyro.noise_rad_per_sqrt_s,
                walk_rad_s_per_sqrt_s=factor * gyro.walk_rad_s_per_sqrt_s,
            ),
            cameras=tuple(replace(c, sigma=_scaled(c.sigma, factor)) for c in self.cameras),
            jitter_s=factor * self.jitter_s,
            scene=None if self.scene is None else self.scene.with_noise(factor),
        )


SCENARIOS = {
    scenario.name: scenario
    for scenario in (
        Scenario(
            "mower-spiral",
            worlds.mower_site,
            drives.spiral,
            duration_s=549.0,
            cameras=tuple(
                Camera(
                    name,
                    components=("bearing", "elevation"),
                    mounting=(x, 0.0, 0.226, yaw),
                    rate_hz=0.5,
                    reach_m=9.0,
                    half_view_rad=0.5,
                )
                for name, x, yaw in (("front", 0.5, 0.0), ("rear", -0.3, np.pi))
            ),
        ),
        Scenario(
            "circle-four-poles",
            lambda _: worlds.four_poles(),
            drives.circle,
            duration_s=60.0,
            encoders=Encoders(track_width_m=0.4, m_per_tick=SMALL_ROBOT_M_PER_TICK),
            cameras=(
                Camera(
                    "camera",
                    components=("bearing", "range"),
                    mounting=(0.1, 0.0, 0.3, 0.0),
                    sigma=(0.06, 0.0, 0.3),
                    rate_hz=25.0,
                    half_view_rad=0.6,
                ),
            ),
        ),
        Scenario(
            "figure-eight",
            worlds.hall,
            drives.figure_eight,
            duration_s=120.0,
            encoders=Encoders(track_width_m=0.5, m_per_tick=SMALL_ROBOT_M_PER_TICK),
            cameras=(
                Camera(
                    "scanner",
                    mounting=(0.2, 0.05, 0.4, 0.1),
                    sigma=(0.005, 0.01, 0.03),
                    rate_hz=10.0,
                    half_view_rad=2.4,
                ),
            ),
        ),
        Scenario(
            "yard",
            lambda _: worlds.yard(),
            drives.rounds,
            duration_s=90.0,
            encoders=Encoders(track_width_m=0.5, m_per_tick=SMALL_ROBOT_M_PER_TICK),
            gyro=Gyro(noise_rad_per_sqrt_s=5e-4, walk_rad_s_per_sqrt_s=2e-5),
            cameras=(
                Camera(
                    "scanner",
                    components=("bearing", "range"),
                    mounting=(0.2, 0.0, 0.4, 0.0),
                    sigma=(0.01, 0.0, 0.05),
                    rate_hz=10.0,
                    reach_m=8.0,
                    half_view_rad=1.5,
                ),
            ),
            latency_s=0.03,
            jitter_s=0.001,
        ),
    )
}


def _scaled(sigma: tuple[float, float, float], factor: float) -> tuple[float, float, float]:
    bearing, elevation, slant = sigma
    return factor * bearing, factor * elevation, factor * slant
