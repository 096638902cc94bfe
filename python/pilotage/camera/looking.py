"""A camera's images, one after the other, to what is found in each."""

from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

import cv2
import numpy as np

from .detection import Detection, check_size
from .eye import Eye
from .frame import Frame, Source
from .tally import Tally


class Seen(NamedTuple):
    """An image with what was found in it."""

    frame: Frame
    utime: int
    """µs, of the capture."""
    detections: Sequence[Detection]


def look(
    eye: Eye, source: Source, tally: Tally, pace: Callable[[int], bool] = lambda _: True
) -> Iterator[Seen]:
    """Yield what is found in each image that can be used; the tally counts the others.

    Parameters
    ----------
    pace : is called with each image's stamp [µs], and returns when it is time for it; False ends
    """
    before: int | None = None
    for frame in source.frames(tally):
        tally.frame()
        if frame.image is None:
            tally.drop(frame.reason, frame.words)
            continue
        # After a clock that was set back all goes on from there: one image is lost by it.
        before, last = frame.utime, before
        if last is not None and frame.utime <= last:
            _refuse_stamp(tally, frame, last)
            continue
        if not pace(frame.utime):
            tally.drop("ended")
            return
        seen = _detect(eye, frame, tally)
        if seen is not None:
            yield seen


def _refuse_stamp(tally: Tally, frame: Frame, last: int) -> None:
    if frame.utime == last:
        tally.drop("repeated_stamp", f"{frame.name} has the time of the image before it, {last}")
    else:
        back_s = (last - frame.utime) * 1e-6
        tally.drop("clock_back", f"{frame.name} is {back_s:.6g} s before the image before it")


def _detect(eye: Eye, frame: Frame, tally: Tally) -> Seen | None:
    assert frame.image is not None
    try:
        check_size(frame.image, eye.camera.size)
    except ValueError as error:
        tally.drop("wrong_size", f"{frame.name}: {error}")
        return None
    try:
        found = eye.detector.detect(frame.image)
    except (cv2.error, ValueError, ArithmeticError, np.linalg.LinAlgError) as error:
        tally.drop("not_detected", f"{frame.name}: the detector failed: {error}")
        return None
    pixels = np.array([one.pixel for one in found]).reshape(-1, 2)
    utime = eye.shutter.capture(frame.utime, pixels, len(frame.image))
    return Seen(frame, utime, found)
