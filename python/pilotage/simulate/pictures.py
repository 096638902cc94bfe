"""A drive as pictures in folders, with what is needed to find the robot by them."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import cv2
import numpy as np
from numpy.typing import NDArray

from ..parallel import in_processes
from .measuring import measure
from .picture_camera import PictureCamera
from .render import Renderer, World
from .robot_files import write_robot
from .scenario import Scenario
from .sensors import frame_times
from .streams import Stream
from .view import in_view, stands

CHUNK = 25
"""Frames that are drawn at a time."""
OPTIONS = {"png": (cv2.IMWRITE_PNG_COMPRESSION, 1), "jpg": (cv2.IMWRITE_JPEG_QUALITY, 95)}
"""Of each format."""
SMEARED = 5
"""Moments of an exposure of which the mean is taken."""
DRIVE, IDEAL = "drive.lcmlog", "ideal.lcmlog"


@dataclass(frozen=True)
class Taken:
    """The pictures of a camera.

    Attributes
    ----------
    utime : (f,) int, µs
    ideal : Stream
        Bearing, elevation and range, without any error, of the markers that they show.
    """

    camera: PictureCamera
    utime: NDArray[np.int64]
    ideal: Stream


def take_pictures(
    scenario: Scenario,
    rng: np.random.Generator,
    folder: Path,
    jobs: int = 1,
    progress: Callable[[float], None] | None = None,
) -> list[Taken]:
    """Drive, and write what the cameras see, the drive's log and the robot's configuration.

    Parameters
    ----------
    rng : Generator
        Of all chance; a picture's does not depend on how many processes draw.
    folder : Path
        Where to: ``<camera>/<utime>.png``, ``<camera>.yaml``, ``markers.yaml``, ``robot.yaml``,
        ``drive.lcmlog`` and ``ideal.lcmlog``.
    jobs : int
        Processes; -1 for one a core.

    Raises
    ------
    ValueError
        If the scenario has no cameras, or the folder has pictures already.
    """
    scene = scenario.scene
    if scene is None:
        raise ValueError(
            f"{scenario.name} has no cameras of which pictures could be drawn; add the parts "
            "'cameras' and 'world' as in docs/camera-rendered.md"
        )
    for camera in scene.cameras:
        if any((folder / camera.name).glob("*")):
            raise ValueError(f"{folder / camera.name} is not empty: name another folder")
    measured = measure(scenario, rng)
    world = scene.world(measured.true_markers)
    seed = int(rng.integers(2**63))
    taken, calls = [], []
    for index, camera in enumerate(scene.cameras):
        (folder / camera.name).mkdir(parents=True, exist_ok=True)
        utime = frame_times(measured.drive, camera.rate_hz, rng)
        taken.append(Taken(camera, utime, in_view(camera, world, measured, utime)))
        instants = utime[:, None] + _instants(camera.exposure.exposure_s)
        last = measured.drive.utime[-1]
        for some in np.array_split(np.arange(len(utime)), -(-len(utime) // CHUNK)):
            moments = np.clip(instants[some], measured.drive.utime[0], last)
            poses, tilts = stands(measured, moments.ravel())
            shape = (*moments.shape, -1)
            way = poses.reshape(shape), tilts.reshape(shape)
            calls.append((camera, world, utime[some], *way, (seed, index), folder / camera.name))
    write_robot(scenario, scene, measured, folder)
    replace(measured, sightings={}).record().save(str(folder / DRIVE))
    ideal = {one.camera.name: one.ideal for one in taken}
    replace(measured, sightings=ideal, ids=True).record().save(str(folder / IDEAL))
    for _ in in_processes(_draw, calls, jobs, _died, progress):
        pass
    return taken


def _instants(exposure_s: float) -> NDArray[np.int64]:
    """(k,) µs from the middle of an exposure, which its stamp is, to the moments it is drawn at."""
    if exposure_s == 0.0:
        return np.zeros(1, np.int64)
    share = (np.arange(SMEARED) + 0.5) / SMEARED - 0.5
    return np.rint(share * exposure_s * 1e6).astype(np.int64)


def _draw(
    camera: PictureCamera,
    world: World,
    utime: NDArray[np.int64],
    poses: NDArray[np.float64],
    tilts: NDArray[np.float64],
    seed: tuple[int, int],
    folder: Path,
) -> None:
    """Draw frames (f,) of which the robot stands in poses (f, k, 3) with tilts (f, k, 2)."""
    renderer = Renderer(camera.model, camera.mounting, world)
    for time, some, lean in zip(utime.tolist(), poses, tilts, strict=True):
        light: NDArray[np.float32] = np.mean(
            [renderer.draw(p, tuple(t)) for p, t in zip(some, lean, strict=True)],
            axis=0,
            dtype=np.float32,
        )
        picture = camera.exposure.develop(light, np.random.default_rng((*seed, time)))
        file = folder / f"{time}.{camera.pictures}"
        if not cv2.imwrite(str(file), picture, OPTIONS[camera.pictures]):
            raise OSError(f"{file} cannot be written: is the disk full")


def _died(_: int) -> str:
    return "a process that drew pictures died, perhaps for want of memory: name fewer --jobs"
