"""Which marker each detection is of, from a pose that is known: section 2 of the first paper."""

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from .. import Config, MarkerMap, associate_pixels
from .detection import Array, Detection
from .eye import Eye

RADIUS_PIXEL = 64.0
"""Kiriy and Buehler's, where the configuration has none."""


def radius_pixel(config: Config, eye: Eye) -> float:
    """Return within how many pixels a projection is near; only sensors of pixels may say it."""
    if eye.measures != "pixels":
        return RADIUS_PIXEL
    return float(config[f"sensors.{eye.name}.association_radius_pixel"]) or RADIUS_PIXEL


def associated(
    eye: Eye, detections: Sequence[Detection], pose: Array, markers: MarkerMap, radius: float
) -> list[Detection]:
    """Give an id to those that have none and lie near a marker's projection from a pose (3,)."""
    open_ones = [i for i, one in enumerate(detections) if one.id < 0]
    named = list(detections)
    if open_ones:
        pixels = np.array([detections[i].pixel for i in open_ones]).reshape(-1, 2)
        labels = np.array([detections[i].label for i in open_ones], dtype=np.int32)
        ids = associate_pixels(eye.camera, eye.mounting, pose, markers, pixels, radius, labels)
        for i, marker in zip(open_ones, ids.tolist(), strict=True):
            named[i] = replace(detections[i], id=marker)
    return named
