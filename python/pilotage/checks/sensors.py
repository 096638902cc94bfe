"""Sensors: their mounting, their noise, and whether there is anything to see."""

from collections.abc import Iterator

import numpy as np

from .. import Config
from ..sensor_keys import MOUNTING, SIGMAS
from ..site import guessed
from .finding import Finding

SMALLEST = dict(zip(SIGMAS.values(), (1e-4, 1e-4, 1e-3), strict=True))
"""What a surveyor's total station reaches, rad and m: no sensor on a robot sees better."""


def nothing_to_see(config: Config) -> Iterator[Finding]:
    """Find a missing map or missing sensors."""
    if (config.marker_sensors or config.pixel_sensors) and len(config.map) == 0:
        yield Finding(
            "map",
            "missing: there is nothing to see, and pilotage-node does not start",
            "name a file of markers with map: here, or with --map",
        )
    ranging = [n for n in config.sensors if config[f"sensors.{n}.measures"] == "walls"]
    if ranging and len(config.walls) == 0:
        yield Finding(
            "walls",
            f"missing: there is nothing for {ranging[0]} to see, and pilotage-node does not start",
            "name a file of walls with walls: here, or list them",
        )
    for name in config.pixel_sensors:
        if config.camera(name) is None:
            yield Finding(
                f"sensors.{name}.intrinsics",
                "missing: no pixel tells anything, and pilotage-node does not start",
                "name the file of the camera's calibration, as OpenCV or ROS writes it",
            )
    if not config.sensors:
        yield Finding(
            "sensors",
            "missing: nothing corrects the pose, and pilotage-node does not start",
            "name at least one, for instance sensors: {camera: {z_m: 0.35}}",
        )


def never_mounted(config: Config) -> Iterator[Finding]:
    """Find sensors in the robot's origin, where there is none."""
    for name in config.marker_sensors + config.pixel_sensors:
        if all(config[f"sensors.{name}.{part}"] == 0.0 for part in MOUNTING):
            yield Finding(
                f"sensors.{name}",
                "mounted in the robot's origin, on the ground between the wheels",
                f"measure {', '.join(MOUNTING)}",
            )


def noise_by_default(config: Config) -> Iterator[Finding]:
    """Find sensors of which nobody said how well they see."""
    for name in config.marker_sensors:
        if not guessed(config, name):
            yield Finding(
                f"sensors.{name}",
                "the default noise in every component",
                f"measure it, and set {', '.join(SIGMAS.values())}, those that it gives",
            )


def noise_too_small(config: Config) -> Iterator[Finding]:
    """Find a noise that no sensor reaches, which makes an estimate confidently wrong."""
    for name in config.marker_sensors:
        for sigma, smallest in SMALLEST.items():
            value = config[f"sensors.{name}.{sigma}"]
            if value < smallest:
                yield Finding(
                    f"sensors.{name}.{sigma}",
                    f"{value:g}, smaller than a surveyor's instrument reaches ({smallest:g})",
                    "include the errors of mounting and detection; a replay's NIS tells how much",
                )


def elevation_says_nothing(config: Config) -> Iterator[Finding]:
    """Find elevations of markers that are all as high as the sensor."""
    heights = config.map.positions[:, 2]
    for name in config.marker_sensors:
        z = f"sensors.{name}.z_m"
        elevations = "elevation" in guessed(config, name)
        if elevations and heights.size and np.all(heights == config[z]):
            yield Finding(
                z,
                f"{config[z]:g}, and every marker is as high: elevations tell no distance",
                "measure the sensor's and the markers' height (z) above the ground",
            )


CHECKS = (
    nothing_to_see,
    never_mounted,
    noise_by_default,
    noise_too_small,
    elevation_says_nothing,
)
