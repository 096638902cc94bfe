"""Recorded images to a log of what was found in them."""

import struct
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np

from .. import Config, Recording, lcmtypes
from ..logs import read
from .association import associated, radius_pixel
from .eye import Eye
from .frame import Source
from .looking import Seen, look
from .messages import message
from .poses import Poses
from .tally import Tally

STAMP = struct.Struct(">8xq")
"""Every message begins with its type's fingerprint and its utime."""
KINDS: tuple[Any, ...] = (lcmtypes.marker_frame_t, lcmtypes.pixel_frame_t, lcmtypes.pose_fix_t)
FRAMES = {kind().encode()[:8]: kind for kind in KINDS}


class Found(NamedTuple):
    """One message of a camera."""

    utime: int
    channel: str
    data: bytes


def find(
    config: Config,
    eye: Eye,
    source: Source,
    tally: Tally,
    poses: Poses | None,
    watch: Callable[[Seen], None] = lambda _: None,
) -> Iterator[Found]:
    """Yield the messages of a camera; with poses, what has no id is associated.

    Parameters
    ----------
    watch : is called with each image that was used, ids and all
    """
    radius = radius_pixel(config, eye)
    unplaced = 0
    for seen in look(eye, source, tally):
        pose = None if poses is None else poses.at(seen.utime)
        unplaced += pose is None
        if pose is not None:
            named = associated(eye, seen.detections, pose, config.map, radius)
            seen = seen._replace(detections=named)
        watch(seen)
        sent = message(eye, seen.utime, tally.published, seen.detections, config.map)
        if sent is None:
            tally.drop("no_fix")
            continue
        tally.publish(len(seen.detections))
        yield Found(seen.utime, eye.channel, sent.encode())
    if poses is not None and unplaced > 0:
        tally.say(f"of {unplaced} images no pose is known: what is found in them has no new ids")


def as_log(found: list[Found]) -> Recording:
    """Return the messages in order of time, each arriving at its capture."""
    recording = Recording()
    for one in sorted(found, key=lambda one: one.utime):
        recording.add(one.utime, one.channel, one.data)
    return recording


def merged(
    config: Config, drive: Path, found: list[Found], names: list[str]
) -> tuple[Recording, int]:
    """Return a drive's log with the messages in it, and how many of these cameras' it had.

    Those are left out. A message arrives as if it had been sent at its capture: as long after that
    as the motion sample does that comes next.
    """
    recording = read(drive).recording
    motion = config[f"{config['motion.source']}.channel"]
    received = recording.arrivals(motion)
    if received.size == 0:
        raise ValueError(f"{drive}: no {motion} in it, by which the images could be put in order")
    utime = np.array([STAMP.unpack_from(data)[0] for data in recording.messages(motion)])
    order = np.argsort(utime, kind="stable")
    together, replaced = Recording(), 0
    for i in range(len(recording)):
        at, channel, data = recording[i]
        if _sensor(data) in names:
            replaced += 1
        else:
            together.add(at, channel, data)
    for one in found:
        after = int(np.searchsorted(utime, one.utime, sorter=order))
        row = order[min(after, utime.size - 1)]
        together.add(one.utime + int(received[row] - utime[row]), one.channel, one.data)
    together.sort()
    return together, replaced


def _sensor(data: bytes) -> str | None:
    """Return the sensor's name if a message is of a kind that cameras send."""
    kind = FRAMES.get(data[:8])
    try:
        return None if kind is None else str(kind.decode(data).sensor)
    except (ValueError, struct.error):
        return None
