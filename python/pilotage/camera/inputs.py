"""What the user names, as sources of images by camera."""

import re
from collections.abc import Sequence
from difflib import get_close_matches
from glob import glob, has_magic
from pathlib import Path

from .. import Config
from .eye import cameras
from .frame import Source
from .images import ImageFiles, folder
from .videos import Device, VideoFile

DEVICE = re.compile(r"\d+|/dev/video\w+")


def by_camera(config: Config, inputs: Sequence[str]) -> dict[str, str]:
    """Return the inputs, each NAME=INPUT, by the name of the camera.

    Raises
    ------
    ValueError
        If a name is unknown, comes twice, or is missing where there are several cameras.
    """
    known = cameras(config)
    if not known:
        raise ValueError(
            "the configuration has no camera: a sensor with intrinsics, and its entry in detectors"
        )
    named: dict[str, str] = {}
    for text in inputs:
        name, sign, what = text.partition("=")
        if name not in known and sign and not Path(text).exists():
            (near,) = get_close_matches(name, known, n=1, cutoff=0.0)
            raise ValueError(
                f"{text}: no camera '{name}' in the configuration; the nearest is '{near}' "
                f"of {', '.join(known)}"
            )
        if not sign or name not in known:
            if len(known) > 1 or len(inputs) > 1:
                raise ValueError(f"{text}: say of which camera, as in {known[0]}={text}")
            name, what = known[0], text
        if name in named:
            raise ValueError(f"{text}: camera '{name}' has {named[name]} already")
        named[name] = what
    return named


def is_device(what: str) -> bool:
    """Whether an input is a video device, by its number or its file."""
    return DEVICE.fullmatch(what) is not None and not Path(what).is_dir()


def open_source(
    what: str, size: tuple[int, int], begin: int | None, otherwise: int | None = None
) -> Source:
    """Open a video device, a folder of images, a pattern of image files, or a video file.

    Parameters
    ----------
    size : (width, height) px, which a device is asked for
    begin : µs, time of a video's first frame; None: its name is that time
    otherwise : the same where its name is none

    Raises
    ------
    ValueError
        If there is nothing, or nothing that can be used; says what there should be.
    """
    if is_device(what):
        return Device(int(what) if what.isdecimal() else what, size)
    path = Path(what)
    if path.is_dir():
        return folder(path)
    if has_magic(what):
        return ImageFiles(map(Path, glob(what)), what)
    if not path.exists():
        raise ValueError(
            f"{what}: no such file or folder; an input is a video device (0, /dev/video0), a video "
            "file, a folder of images or a pattern of them ('front/*.png')"
        )
    if begin is None:
        begin = int(path.stem) if path.stem.isdecimal() else otherwise
        if begin is None:
            raise ValueError(
                f"{what} does not say when it begins: give --begin in microseconds on the robot's "
                "clock, or name the file by it, as 1000417.mp4"
            )
    return VideoFile(path, begin)
