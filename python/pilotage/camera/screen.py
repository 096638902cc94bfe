"""Pictures in windows and in video files."""

import math
import os
import sys
from collections.abc import Sequence
from pathlib import Path
from typing import Any

import cv2

from .detection import Image

CODECS = {".mp4": "mp4v", ".avi": "MJPG"}
USUAL_HZ = 10.0
"""Of a video whose rate is not known."""
NO_WINDOWS = (
    "--show needs an OpenCV with windows and a screen to show them on: install opencv-python "
    "instead of opencv-python-headless, or look at what --save-video writes"
)


class Screen:
    """Where annotated pictures go: a window a camera, a file a camera, or nowhere."""

    def __init__(self, names: Sequence[str], show: bool, save_video: Path | None):
        """Refuse what cannot be done."""
        if show and not _has_windows():
            raise ValueError(NO_WINDOWS)
        if save_video is not None and save_video.suffix not in CODECS:
            raise ValueError(f"--save-video {save_video}: expected {' or '.join(CODECS)}")
        self._show = show
        self._files = {}
        if save_video is not None:
            for name in names:
                alone = save_video.with_stem(f"{save_video.stem}-{name}")
                self._files[name] = save_video if len(names) == 1 else alone
        self._videos: dict[str, Any] = {}

    def __bool__(self) -> bool:
        """Whether anybody looks."""
        return self._show or bool(self._files)

    def put(self, name: str, picture: Image, rate_hz: float) -> None:
        """Show or write a camera's next picture."""
        if self._show:
            cv2.imshow(name, picture)
            cv2.waitKey(1)
        if name in self._files:
            if name not in self._videos:
                self._videos[name] = _writer(self._files[name], picture, rate_hz)
            self._videos[name].write(picture)

    def close(self) -> list[Path]:
        """Finish the files; return those that were written."""
        for video in self._videos.values():
            video.release()
        if self._show:
            cv2.destroyAllWindows()
        return [self._files[name] for name in self._videos]


def save_image(folder: Path, utime: int, image: Image) -> bool:
    """Write an image as it came, named by its stamp as `images.folder` reads it; whether it is."""
    options = cv2.IMWRITE_PNG_COMPRESSION, 1
    return bool(cv2.imwrite(str(folder / f"{utime}.png"), image, options))


def _writer(file: Path, picture: Image, rate_hz: float) -> Any:
    rate = rate_hz if math.isfinite(rate_hz) else USUAL_HZ
    codec = cv2.VideoWriter.fourcc(*CODECS[file.suffix])
    writer = cv2.VideoWriter(str(file), codec, rate, picture.shape[1::-1])
    if not writer.isOpened():
        raise OSError(f"{file} cannot be written: is its folder there, and the disk not full?")
    return writer


def _has_windows() -> bool:
    # Some builds end the process if there is no screen.
    if sys.platform == "linux" and not {"DISPLAY", "WAYLAND_DISPLAY"} & set(os.environ):
        return False
    try:
        cv2.namedWindow("pilotage-camera")
        cv2.destroyWindow("pilotage-camera")
    except cv2.error:
        return False
    return True
