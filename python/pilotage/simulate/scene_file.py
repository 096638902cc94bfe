"""The parts `cameras` and `world` of a scenario file; docs/camera-rendered.md shows every key."""

import inspect
from collections.abc import Callable
from typing import Any

from ..fields import call, known_keys, mapping, value_of
from ..sensor_keys import MOUNTING
from .exposure import Exposure
from .looks import KINDS, Looks
from .picture_camera import PictureCamera
from .scene import Scene

WORLD = ("surroundings", "markers")
BY_NUMBER = {"colours": str, "yaw_rad": float}
"""Keys of markers whose values are by label or by id."""
EXPOSURE = tuple(inspect.signature(Exposure).parameters)


def parse_scene(cameras: Any, world: Any, where: str) -> Scene:
    """Make a scene of both parts' contents; a ValueError names the place of what is wrong."""
    cameras = mapping(cameras, f"{where}: cameras")
    if not cameras:
        raise ValueError(f"{where}: cameras has none, expected one or more")
    world = mapping(world, f"{where}: world")
    known_keys(world, WORLD, f"{where}: world")
    if "markers" not in world:
        raise ValueError(
            f"{where}: world: 'markers' is missing: what they look like, as in {{kind: discs}}"
        )
    rest = {key: value for key, value in world.items() if key != "markers"}
    return call(
        Scene,
        rest,
        f"{where}: world",
        cameras=tuple(_camera(name, cameras[name], f"{where}: cameras.{name}") for name in cameras),
        markers=_looks(world["markers"], f"{where}: world.markers"),
    )


def _camera(name: str, content: Any, where: str) -> PictureCamera:
    """One camera; where it sits is named as in the configuration."""
    content = dict(mapping(content, where))
    known = [key for key in inspect.signature(PictureCamera).parameters if key not in NOT_KEYS]
    known_keys(content, [*known, *MOUNTING, *EXPOSURE], where)
    mounting = tuple(
        value_of(float, content.pop(key, default), f"{where}.{key}")
        for key, default in zip(MOUNTING, PictureCamera.mounting, strict=True)
    )
    light = {key: content.pop(key) for key in EXPOSURE if key in content}
    exposure = call(Exposure, light, where)
    return call(PictureCamera, content, where, name=name, mounting=mounting, exposure=exposure)


NOT_KEYS = ("name", "mounting", "exposure")


def _looks(content: Any, where: str) -> Looks:
    content = dict(mapping(content, where))
    kind = content.pop("kind", None)
    if kind not in KINDS:
        raise ValueError(f"{where}.kind is {kind!r}, expected one of {', '.join(KINDS)}")
    known_keys(content, ["kind", *inspect.signature(KINDS[kind]).parameters], where)
    by_number = {
        key: _by_number(of, content.pop(key), f"{where}.{key}")
        for key, of in BY_NUMBER.items()
        if key in content
    }
    make: Callable[..., Looks] = KINDS[kind]
    return call(make, content, where, **by_number)


def _by_number(kind: type, content: Any, where: str) -> dict[int, Any]:
    if not isinstance(content, dict) or not all(type(key) is int for key in content):
        raise ValueError(f"{where} is {content!r}, expected numbers with values, as in {{1: ...}}")
    return {key: value_of(kind, value, f"{where}.{key}") for key, value in content.items()}
