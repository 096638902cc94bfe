"""Markers in a camera's pictures during a drive: of a log, or of the pictures themselves."""

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from .. import CameraModel, Config, Recording
from ..camera import images
from ..camera.detection import Array, Detection
from ..camera.eye import make_eye
from ..camera.looking import look
from ..camera.tally import Tally
from ..lcmtypes import marker_frame_t, pixel_frame_t

pixel_message: Any = pixel_frame_t  # generated without types
marker_message: Any = marker_frame_t


@dataclass(frozen=True, eq=False)
class Sightings:
    """Rows are markers in pictures.

    Attributes
    ----------
    utime : (n,) int, µs
        Rows of the same time are of the same picture.
    id, label : (n,) int
        -1 unknown, -1 none.
    pixel, sigma : (n, 2) px
    """

    utime: NDArray[np.int64]
    id: NDArray[np.int32]
    label: NDArray[np.int32]
    pixel: Array
    sigma: Array

    @classmethod
    def of(cls, rows: Sequence[tuple[float, ...]]) -> "Sightings":
        """Make it of utime, id, label, u, v and their sigmas a row."""
        utime, number, label, *values = np.array(rows, dtype=np.float64).reshape(-1, 7).T
        u, v, sigma_u, sigma_v = values
        return cls(
            utime.astype(np.int64),
            number.astype(np.int32),
            label.astype(np.int32),
            np.column_stack([u, v]),
            np.column_stack([sigma_u, sigma_v]),
        )

    def __len__(self) -> int:
        return len(self.utime)

    def rows(self, index: NDArray[Any]) -> "Sightings":
        """Return the rows of a mask or of indices."""
        return Sightings(*(getattr(self, name)[index] for name in self.__annotations__))


def of_log(recording: Recording, config: Config, sensor: str) -> Sightings:
    """Take a sensor's `pixel_frame_t`, or its `marker_frame_t` with bearing and elevation.

    Bearings and elevations become pixels by the configuration that they were made with.

    Raises
    ------
    ValueError
        If there are none; names the sensors that there are.
    """
    camera = _camera(config, sensor)
    pixels, markers = (kind().encode()[:8] for kind in (pixel_message, marker_message))
    rows: list[Any] = []
    others = set()
    for index in range(len(recording)):
        data = recording[index][2]
        if data[:8] not in (pixels, markers):
            continue
        frame = (pixel_message if data[:8] == pixels else marker_message).decode(data)
        if frame.sensor != sensor:
            others.add(frame.sensor)
        elif data[:8] == pixels:
            rows += [(frame.utime, o.id, o.label, o.u, o.v, o.sigma_u, o.sigma_v)
                     for o in frame.observations]  # fmt: skip
        else:
            rows += _as_pixels(camera, frame)
    if not rows:
        there = f"; it has those of {', '.join(sorted(others))}" if others else ""
        raise ValueError(
            f"the log has no pixels, nor bearings with elevations, of '{sensor}'{there}. Name the "
            "camera's pictures with --pictures, or record what pilotage-camera sends"
        )
    return _with_sigmas(Sightings.of(rows), config, sensor)


def of_pictures(folder: Path, config: Config, sensor: str, tally: Tally) -> Sightings:
    """Detect markers in pictures with stamps, as the configuration's detector does.

    Raises
    ------
    ValueError
        If there are no such pictures, or the detector finds nothing in any; the tally has said why.
    """
    _camera(config, sensor)
    eye = make_eye(config, sensor)
    rows = [
        _row(seen.utime, one)
        for seen in look(eye, images.folder(folder), tally)
        for one in seen.detections
        if one.has_elevation
    ]
    if not rows:
        raise ValueError(
            f"detectors.{sensor} found nothing with a pixel of its own in the pictures of "
            f"{folder}: {tally.summary()}"
        )
    return Sightings.of(rows)


def _row(utime: int, one: Detection) -> tuple[float, ...]:
    return (utime, one.id, one.label, *one.pixel, *np.sqrt(one.covariance.diagonal()))


def _camera(config: Config, sensor: str) -> CameraModel:
    if sensor not in config.sensors:
        raise ValueError(f"no sensor is called '{sensor}'; there are {', '.join(config.sensors)}")
    camera = config.camera(sensor)
    if camera is None:
        raise ValueError(
            f"sensors.{sensor}.intrinsics is missing: calibrate the lens first, "
            "pilotage camera-calibrate intrinsics"
        )
    return camera


def _as_pixels(camera: CameraModel, frame: Any) -> list[tuple[float, ...]]:
    """Return rows of a `marker_frame_t`; their sigmas are left to the configuration."""
    seen = [s for s in frame.sightings if np.isfinite([s.bearing, s.elevation]).all()]
    if not seen:
        return []
    bearing, elevation = np.array([(s.bearing, s.elevation) for s in seen]).T
    flat = np.cos(elevation)
    rays = np.column_stack([flat * np.cos(bearing), flat * np.sin(bearing), np.sin(elevation)])
    return [
        (frame.utime, s.id, s.label, u, v, np.nan, np.nan)
        for s, (u, v) in zip(seen, camera.project(rays), strict=True)
        if np.isfinite([u, v]).all()
    ]


def _with_sigmas(seen: Sightings, config: Config, sensor: str) -> Sightings:
    usual = float(config[f"sensors.{sensor}.sigma_pixel"])
    sigma = np.where(seen.sigma > 0, seen.sigma, usual)
    return Sightings(seen.utime, seen.id, seen.label, seen.pixel, sigma)
