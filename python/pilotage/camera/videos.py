"""Images of a video file and of a video device."""

import math
from collections.abc import Iterator
from pathlib import Path
from threading import Condition, Thread
from time import sleep, time_ns

import cv2
import numpy as np

from .detection import Image
from .frame import Frame
from .tally import Tally

AGAIN_S = 1.0
"""A device that is gone is looked for again after this."""
MISSES = 3
"""A device that gives no image so many times in a row is gone."""


class VideoFile:
    """A video, its frames dated by the time at which it begins."""

    def __init__(self, path: Path, begin: int):
        """Open it; `begin` is the time of its first frame, µs."""
        self._path, self.begin = path, begin
        self._video = cv2.VideoCapture(str(path))
        if not self._video.isOpened():
            raise ValueError(f"{path}: no video that this OpenCV can read")
        rate = self._video.get(cv2.CAP_PROP_FPS)
        self.rate_hz = rate if 0 < rate < 1e4 else math.nan
        self._expected = round(self._video.get(cv2.CAP_PROP_FRAME_COUNT))
        self._closed = False

    def frames(self, tally: Tally) -> Iterator[Frame]:
        """Read them one after the other."""
        count, first = 0, None
        while not self._closed:
            there, image = self._video.read()
            if not there:
                break
            at_ms = self._video.get(cv2.CAP_PROP_POS_MSEC)
            first = at_ms if first is None else first
            yield Frame(self.begin + round(1e3 * (at_ms - first)), f"frame {count}", image)
            count += 1
        if not self._closed and count < self._expected:
            tally.say(
                f"{self._path} ends after {count} of {self._expected} frames: it is damaged, or "
                "was not closed"
            )
        self._video.release()

    def close(self) -> None:
        """Read no further."""
        self._closed = True


class Device:
    """A video device: its newest image, whatever else it took meanwhile.

    A thread of its own grabs, so that an image is dated when it comes and not when it is wanted.
    """

    begin = None

    def __init__(self, device: int | str, size: tuple[int, int]):
        """Open it; `size` is (width, height) px, which it is asked for."""
        self._device, self._size = device, size
        opened = self._open()
        if opened is None:
            raise ValueError(f"{self.name} cannot be opened: is it there, and not in use?")
        self._video = opened
        rate = self._video.get(cv2.CAP_PROP_FPS)
        self.rate_hz = rate if 0 < rate < 1e4 else math.nan
        self._news = Condition()
        self._newest: tuple[int, int, Image] | None = None
        self._closed = False

    @property
    def name(self) -> str:
        """The device's."""
        return f"/dev/video{self._device}" if isinstance(self._device, int) else self._device

    def frames(self, tally: Tally) -> Iterator[Frame]:
        """Yield the newest image each time, for as long as it is not closed."""
        grabbing = Thread(target=self._grab, args=(tally,), daemon=True)
        grabbing.start()
        while True:
            with self._news:
                self._news.wait_for(lambda: self._newest is not None or self._closed)
                if self._newest is None:
                    break
                (utime, number, image), self._newest = self._newest, None
            yield Frame(utime, f"frame {number}", image)
        grabbing.join()

    def close(self) -> None:
        """Grab no further."""
        with self._news:
            self._closed = True
            self._news.notify()

    def _open(self) -> "cv2.VideoCapture | None":
        video = cv2.VideoCapture(self._device)
        if not video.isOpened():
            return None
        video.set(cv2.CAP_PROP_FRAME_WIDTH, self._size[0])
        video.set(cv2.CAP_PROP_FRAME_HEIGHT, self._size[1])
        return video

    def _grab(self, tally: Tally) -> None:
        number = missed = 0
        while not self._closed:
            grabbed = self._video.grab()
            utime = time_ns() // 1000
            there, taken = self._video.retrieve() if grabbed else (False, None)
            if not there or taken is None:
                missed += 1
                if missed >= MISSES:
                    self._find_again(tally)
                    missed = 0
                continue
            missed = 0
            with self._news:
                if self._newest is not None:
                    tally.frame()
                    tally.drop("busy")
                self._newest = (utime, number, np.asarray(taken, np.uint8))
                number += 1
                self._news.notify()
        self._video.release()

    def _find_again(self, tally: Tally) -> None:
        tally.say(f"{self.name} is gone; looked for every {AGAIN_S:g} s")
        self._video.release()
        while not self._closed:
            sleep(AGAIN_S)
            found = self._open()
            if found is not None:
                self._video = found
                tally.say(f"{self.name} is back")
                return
