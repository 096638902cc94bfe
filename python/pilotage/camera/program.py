"""What `pilotage-camera` does with its options."""

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from .. import Config, load_config
from .annotate import Answer, annotate, projections
from .detection import Array, Image
from .eye import Eye, make_eye
from .frame import Source
from .inputs import by_camera, open_source
from .looking import Seen
from .offline import Found, as_log, find, merged
from .poses import read_poses
from .screen import Screen
from .tally import Tally


@dataclass(frozen=True)
class Options:
    """What both ways of looking share."""

    config: Path
    inputs: Sequence[str]
    begin: int | None
    show: bool
    save_video: Path | None
    save_images: Path | None
    say: Callable[[str], None]


class Watched(NamedTuple):
    """A camera, where its images come from, and what becomes of them."""

    eye: Eye
    source: Source
    tally: Tally


def watched(config: Config, options: Options, begin: int | None = None) -> list[Watched]:
    """Open the inputs; all that can be known to be wrong is an error here.

    A video that does not say when it begins does so at `begin`, µs.
    """
    named = by_camera(config, options.inputs)
    eyes = [make_eye(config, name) for name in named]
    return [
        Watched(eye, open_source(named[eye.name], eye.camera.size, options.begin, begin), tally)
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
        if camera.source.begin is None:
            raise ValueError(f"{camera.eye.name}: -o is for recorded images, and not for a device")
    poses = None
    if poses_log is not None:
        poses, taken = read_poses(poses_log)
        options.say(taken)
    screen = Screen([camera.eye.name for camera in cameras], options.show, options.save_video)
    found: list[Found] = []
    for eye, source, tally in cameras:

        def watch(seen: Seen, eye: Eye = eye, source: Source = source) -> None:
            if screen:
                pose = None if poses is None else poses.at(seen.utime)
                screen.put(eye.name, picture(config, eye, seen, pose), source.rate_hz)

        found += find(config, eye, source, tally, poses, watch)
    if drive is None:
        log = as_log(found)
    else:
        log, replaced = merged(config, drive, found, [camera.eye.name for camera in cameras])
        if replaced > 0:
            options.say(f"{drive}: its {replaced} messages of these cameras are left out")
    log.save(str(output))
    conclude(cameras, screen, options.say)
    options.say(f"{output}: {len(log)} messages")
    return len(found) > 0


def picture(
    config: Config,
    eye: Eye,
    seen: Seen,
    pose: Array | None,
    answers: Mapping[int, Answer] | None = None,
) -> Image:
    """Return an image with all that is known of it drawn in."""
    assert seen.frame.image is not None
    expected = {} if pose is None else projections(eye, config.map, pose)
    words = f"{eye.name}  {seen.utime * 1e-6:.3f} s  {len(seen.detections)} found"
    words += f", {len(expected)} expected" if pose is not None else ", no pose"
    return annotate(seen.frame.image, seen.detections, expected, answers, words)


def conclude(cameras: Sequence[Watched], screen: Screen, say: Callable[[str], None]) -> None:
    """Say where all frames went."""
    for camera in cameras:
        camera.tally.say(camera.tally.summary())
    for file in screen.close():
        say(f"{file} written")
