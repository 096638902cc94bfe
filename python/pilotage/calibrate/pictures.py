"""The pictures that a calibration looks at: files, folders, patterns, a video."""

from collections.abc import Iterator, Sequence
from glob import glob
from pathlib import Path

import cv2

from ..camera.detection import Image
from ..camera.images import ENDINGS

EVERY_S = 1.0
"""Of a video, a frame so often."""


def pictures(inputs: Sequence[str]) -> Iterator[tuple[str, Image]]:
    """Yield name and picture (h, w) grey of all inputs, in order of their names.

    Raises
    ------
    ValueError
        If an input is not there, holds no pictures or cannot be read; names it.
    """
    for given in inputs:
        for file in _files(given):
            if file.suffix.lower() in ENDINGS:
                picture = cv2.imread(str(file), cv2.IMREAD_GRAYSCALE)
                if picture is None:
                    raise ValueError(f"{file} cannot be read as a picture: leave it out")
                yield str(file), picture
            else:
                yield from _frames(file)


def _files(given: str) -> list[Path]:
    path = Path(given)
    if path.is_dir():
        found = sorted(file for file in path.iterdir() if file.suffix.lower() in ENDINGS)
    elif path.exists():
        found = [path]
    else:
        found = sorted(Path(name) for name in glob(given, recursive=True))
    if not found:
        kinds = ", ".join(ending[1:] for ending in ENDINGS)
        raise ValueError(f"{given}: no picture is there ({kinds}), nor a video of that name")
    return found


def _frames(file: Path) -> Iterator[tuple[str, Image]]:
    video = cv2.VideoCapture(str(file))
    rate = video.get(cv2.CAP_PROP_FPS)
    step = max(round(EVERY_S * rate), 1) if rate > 0 else 1
    index = 0
    while True:
        there, frame = video.read()
        if not there:
            break
        if index % step == 0:
            yield f"{file}:{index}", cv2.cvtColor(frame, cv2.COLOR_BGR2GRAY)
        index += 1
    if index == 0:
        raise ValueError(f"{file} cannot be read, neither as a picture nor as a video")
