"""What `pilotage-camera` does with its options."""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from .. import Config, load_config
from .eye import Eye, make_eye
from .frame import Source
from .inputs import by_camera, open_source
from .offline import Found, as_log, find, merged
from .poses import read_poses
from .tally import Tally


@dataclass(frozen=True)
class Options:
    """What both ways of looking share."""

    config: Path
    inputs: Sequence[str]
    begin: int | None
    show: bool
    save_video: Path | None
    say: Callable[[str], None]


class Watched(NamedTuple):
    """A camera, where its images come from, and what becomes of them."""

    eye: Eye
    source: Source
    tally: Tally


def watched(config: Config, options: Options) -> list[Watched]:
    """Open the inputs; all that can be known to be wrong is an error here."""
    named = by_camera(config, options.inputs)
    eyes = [make_eye(config, name) for name in named]
    return [
        Watched(eye, open_source(named[eye.name], eye.camera.size, options.begin), tally)
        for eye in eyes
        for tally in (Tally(eye.name, options.say),)
    ]


def look_offline(
    options: Options, output: Path, poses_log: Path | None, drive: Path | None
) -> bool:
    """Write what is found in recorded images into a log; whether any image could be used."""
    config = load_config(str(options.config))
    if drive is not None and output.exists() and output.samefile(drive):
        raise ValueError(f"-o {output} is the drive's log itself: give the output another name")
    cameras = watched(config, options)
    for camera in cameras:
        if camera.source.live:
            raise ValueError(f"{camera.eye.name}: -o is for recorded images, and not for a device")
    poses = None
    if poses_log is not None:
        poses, taken = read_poses(poses_log, config)
        options.say(taken)
    found: list[Found] = []
    for eye, source, tally in cameras:
        found += find(config, eye, source, tally, poses)
    if drive is None:
        log = as_log(found)
    else:
        log, replaced = merged(config, drive, found, [camera.eye.name for camera in cameras])
        if replaced > 0:
            options.say(f"{drive}: its {replaced} messages of these cameras are left out")
    log.save(str(output))
    for camera in cameras:
        camera.tally.say(camera.tally.summary())
    options.say(f"{output}: {len(log)} messages")
    return len(found) > 0
