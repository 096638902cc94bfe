"""What is found in an image as the message that a sensor of its kind sends."""

from collections.abc import Sequence
from typing import Any

import numpy as np

from .. import MarkerMap, lcmtypes
from ..evaluate import wrap_angle
from .detection import Array, Detection
from .eye import Eye
from .mounting import angles
from .tags import TagDetection, TagDetector

TYPES: Any = lcmtypes  # generated, without hints


def message(
    eye: Eye, utime: int, seq: int, detections: Sequence[Detection], markers: MarkerMap
) -> Any | None:
    """Return marker_frame_t, pixel_frame_t or pose_fix_t, by what the sensor measures.

    An image without markers gives an empty frame, and no pose.

    Parameters
    ----------
    utime : µs, of the capture
    seq : counts the camera's messages
    """
    if eye.measures == "pose":
        return _fix(eye, utime, seq, detections, markers)
    frame = TYPES.marker_frame_t() if eye.measures == "markers" else TYPES.pixel_frame_t()
    frame.utime, frame.seq, frame.sensor, frame.n = utime, seq, eye.name, len(detections)
    if eye.measures == "markers":
        frame.sightings = _sightings(eye, detections)
    else:
        frame.observations = _observations(eye, detections)
    return frame


def _sightings(eye: Eye, detections: Sequence[Detection]) -> list[Any]:
    value, covariance = angles(eye.camera, detections, eye.noise)
    sigma = np.sqrt(np.diagonal(covariance, axis1=1, axis2=2))
    sightings = []
    for one, (bearing, elevation), sigmas in zip(
        detections, value.tolist(), sigma.tolist(), strict=True
    ):
        sighting = TYPES.marker_sighting_t()
        sighting.id, sighting.label = one.id, one.label
        sighting.bearing, sighting.elevation, sighting.range = bearing, elevation, one.range_m
        sighting.sigma_bearing, sighting.sigma_elevation = sigmas
        sighting.sigma_range = one.sigma_range_m
        sightings.append(sighting)
    return sightings


def _observations(eye: Eye, detections: Sequence[Detection]) -> list[Any]:
    pixels = np.array([one.pixel for one in detections]).reshape(-1, 2)
    covariance = np.array([one.covariance for one in detections]).reshape(-1, 2, 2)
    covariance = covariance + eye.noise.pixel_covariance(eye.camera, pixels)
    sigma = np.sqrt(np.diagonal(covariance, axis1=1, axis2=2))
    observations = []
    for one, pixel, sigmas in zip(detections, pixels.tolist(), sigma.tolist(), strict=True):
        observation = TYPES.pixel_observation_t()
        observation.id, observation.label = one.id, one.label
        observation.u, observation.v = pixel
        observation.sigma_u, observation.sigma_v = sigmas
        observations.append(observation)
    return observations


def _fix(
    eye: Eye, utime: int, seq: int, detections: Sequence[Detection], markers: MarkerMap
) -> Any | None:
    """Return the pose by all tags that tell one, each weighted by its information."""
    by_tag = [_by_tag(eye, one, markers) for one in detections]
    fixes = [fix for fix in by_tag if fix is not None]
    if not fixes:
        return None
    pose, covariance = _mean(fixes)
    covariance[2, 2] += eye.noise.heading_variance(eye.camera)
    told = TYPES.pose_fix_t()
    told.utime, told.seq, told.sensor = utime, seq, eye.name
    told.x, told.y, told.heading = pose.tolist()
    told.covariance = covariance.ravel().tolist()
    return told


def _by_tag(eye: Eye, one: Detection, markers: MarkerMap) -> tuple[Array, Array] | None:
    row = np.flatnonzero(markers.ids == one.id)
    if not (row.size and isinstance(one, TagDetection) and isinstance(eye.detector, TagDetector)):
        return None
    return eye.detector.sensor_pose(one, markers.positions[row[0]])


def _mean(fixes: Sequence[tuple[Array, Array]]) -> tuple[Array, Array]:
    """Return the likeliest pose (3,) and its covariance (3, 3), the fixes being independent."""
    start = fixes[0][0]
    information: Array = np.zeros((3, 3))
    weighted: Array = np.zeros(3)
    for pose, covariance in fixes:
        inverse = np.linalg.inv(covariance)
        step = pose - start
        step[2] = wrap_angle(step[2])
        information += inverse
        weighted += inverse @ step
    spread = np.asarray(np.linalg.inv(information), dtype=np.float64)
    pose = start + spread @ weighted
    pose[2] = wrap_angle(pose[2])
    return pose, spread
