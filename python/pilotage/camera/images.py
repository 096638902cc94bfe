"""Images in files, with the time of capture as their names or in a list beside them."""

import csv
import math
from collections.abc import Iterable, Iterator
from pathlib import Path
from typing import NamedTuple

import cv2
import numpy as np

from .frame import Frame
from .tally import Tally

ENDINGS = (".png", ".jpg", ".jpeg", ".bmp", ".tif", ".tiff", ".pgm", ".ppm", ".webp")
STAMPS = "stamps.csv"
NO_STAMP = (
    "has no time of capture: name images by it in microseconds, as 1000417.png, or list them in "
    f"{STAMPS} beside them, with the columns file and utime"
)


class Stamped(NamedTuple):
    """An image file; without a stamp it is of no use."""

    utime: int | None
    path: Path


class ImageFiles:
    """The images of a folder or of a pattern, in order of time."""

    def __init__(self, paths: Iterable[Path], what: str):
        """Find the stamps of files; `what` is how the user calls them all."""
        files = _stamped(sorted(path for path in paths if path.suffix.lower() in ENDINGS))
        if not files:
            raise ValueError(f"{what}: no images there ({', '.join(ENDINGS)})")
        known = [file for file in files if file.utime is not None]
        if not known:
            raise ValueError(f"{what}: {files[0].path.name} {NO_STAMP}")
        self._files = sorted(known, key=lambda file: file.utime or 0)
        self._files += [file for file in files if file.utime is None]
        stamps = sorted(file.utime or 0 for file in known)
        self.begin = stamps[0]
        steps = np.diff(stamps)
        self.rate_hz = 1e6 / float(np.median(steps)) if steps.size and steps.any() else math.nan
        self._closed = False

    def frames(self, _: Tally) -> Iterator[Frame]:
        """Read them one after the other."""
        for utime, path in self._files:
            if self._closed:
                return
            yield _frame(utime, path)

    def close(self) -> None:
        """Read no further."""
        self._closed = True


def folder(path: Path) -> ImageFiles:
    """Return the images of a folder."""
    return ImageFiles(path.iterdir(), str(path))


def _stamped(paths: list[Path]) -> list[Stamped]:
    """Find the stamp of each by the list beside it, else by its name.

    What is listed and is not there is among them, to be counted.
    """
    lists = {parent: _listed(parent / STAMPS) for parent in {path.parent for path in paths}}
    files = []
    for path in paths:
        listed = lists[path.parent]
        if listed is not None:
            files.append(Stamped(listed.pop(path.name, None), path))
        else:
            files.append(Stamped(int(path.stem) if path.stem.isdecimal() else None, path))
    for parent, listed in lists.items():
        files += [Stamped(utime, parent / name) for name, utime in (listed or {}).items()]
    return files


def _listed(path: Path) -> dict[str, int] | None:
    """Read the stamps by file name, None where there is no such list."""
    if not path.exists():
        return None
    with path.open(newline="", encoding="utf-8") as file:
        rows = csv.DictReader(file, skipinitialspace=True)
        if not {"file", "utime"} <= set(rows.fieldnames or ()):
            found = ", ".join(rows.fieldnames or ()) or "nothing"
            raise ValueError(f"{path}: its first line has {found}, expected file,utime")
        stamps = {}
        for row in rows:
            try:
                stamps[row["file"]] = int(row["utime"])
            except (TypeError, ValueError):
                raise ValueError(
                    f"{path}:{rows.line_num}: utime is {row['utime']!r}, expected whole µs"
                ) from None
    return stamps


def _frame(utime: int | None, path: Path) -> Frame:
    if utime is None:
        return Frame(0, path.name, reason="no_stamp", words=f"{path.name} {NO_STAMP}")
    try:
        image = cv2.imdecode(np.fromfile(path, np.uint8), cv2.IMREAD_COLOR)
    except OSError as error:
        words = f"{path.name} cannot be read: {error.strerror}"
        return Frame(utime, path.name, reason="unreadable", words=words)
    except cv2.error:
        image = None
    if image is None:
        words = f"{path.name} is no image, or a damaged one"
        return Frame(utime, path.name, reason="unreadable", words=words)
    return Frame(utime, path.name, image)
