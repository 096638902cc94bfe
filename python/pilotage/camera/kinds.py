"""The kinds of detectors by the names that a configuration's ``detectors`` section calls them."""

import inspect
import math
from collections.abc import Callable, Mapping
from typing import Any

from .. import CameraModel
from ..fields import call, known_keys, mapping, value_of
from .colour import COLOURS, Colour
from .detection import Detector
from .discs import DiscDetector
from .mounting import MountingNoise
from .poles import PoleDetector
from .shutter import Shutter
from .tags import TagDetector

KINDS: dict[str, type[Detector]] = {
    "discs": DiscDetector,
    "poles": PoleDetector,
    "tags": TagDetector,
}
_FROM_SENSOR = {"discs": ("camera", "height_m"), "poles": ("camera",), "tags": ("camera",)}
_MOUNTING = tuple(inspect.signature(MountingNoise).parameters)
_SHUTTER = tuple(inspect.signature(Shutter).parameters)
_OF_CAMERA = (*_MOUNTING, *_SHUTTER)


def keys(kind: str) -> list[str]:
    """Return the keys of a kind of detector, those of its camera among them."""
    own = [n for n in inspect.signature(KINDS[kind]).parameters if n not in _FROM_SENSOR[kind]]
    return ["kind", *own, *_OF_CAMERA]


def make_detector(content: Any, camera: CameraModel, height_m: float, where: str) -> Detector:
    """Make what an entry of ``detectors`` describes.

    Parameters
    ----------
    content : its keys with values, as read from the configuration
    height_m : of the camera above the ground, the sensor's z_m
    where : the entry's place, for errors

    Raises
    ------
    ValueError
        Naming the key, its value, and what was expected; for an unknown key the nearest known one.
    """
    kind, given = _checked(content, where)
    arguments: dict[str, Any] = {"camera": camera}
    if "height_m" in _FROM_SENSOR[kind]:
        arguments["height_m"] = height_m
    for key, read in _READ.items():
        if key in given:
            arguments[key] = read(given.pop(key), f"{where}.{key}")
    rest = {key: value for key, value in given.items() if key not in _OF_CAMERA}
    if kind == "poles" and "colours" not in arguments:
        raise ValueError(f"{where}: 'colours' is missing: by label, as in {{1: yellow, 2: blue}}")
    return call(KINDS[kind], rest, where, **arguments)


def mounting_noise(content: Any, where: str) -> MountingNoise:
    """Read the keys of a detector's entry that say how well its camera's mounting is known."""
    return call(MountingNoise, _some(content, _MOUNTING, where), where)


def shutter(content: Any, where: str) -> Shutter:
    """Read the keys of a detector's entry that say when its camera's images are taken."""
    return call(Shutter, _some(content, _SHUTTER, where), where)


def _some(content: Any, names: tuple[str, ...], where: str) -> dict[str, Any]:
    _, given = _checked(content, where)
    return {key: value for key, value in given.items() if key in names}


def _checked(content: Any, where: str) -> tuple[str, dict[str, Any]]:
    """Return the kind and the other keys, all of them known."""
    given = dict(mapping(content, where))
    if "kind" not in given:
        raise ValueError(f"{where}: 'kind' is missing, one of {', '.join(KINDS)}")
    kind = given["kind"]
    if not isinstance(kind, str) or kind not in KINDS:
        raise ValueError(f"{where}.kind is {kind!r}, expected one of {', '.join(KINDS)}")
    known_keys(given, keys(kind), where)
    del given["kind"]
    return kind, given


def _colour(value: Any, where: str) -> Colour:
    if isinstance(value, str):
        if value not in COLOURS:
            raise ValueError(
                f"{where} is {value!r}, expected one of {', '.join(COLOURS)}, or hue_deg, "
                "saturation and value"
            )
        return COLOURS[value]
    return call(Colour, value, where)


def _colours(value: Any, where: str) -> Mapping[int, Colour]:
    return {label: _colour(one, f"{where}.{label}") for label, one in _numbered(value, where)}


def _yaws(value: Any, where: str) -> Mapping[int, float]:
    yaws = {
        number: value_of(float, yaw, f"{where}.{number}") for number, yaw in _numbered(value, where)
    }
    for number, yaw in yaws.items():
        if abs(yaw) > 2 * math.pi:
            raise ValueError(f"{where}.{number} is {yaw:g}, expected radians from -2 pi to 2 pi")
    return yaws


def _numbered(value: Any, where: str) -> list[tuple[int, Any]]:
    """Return the pairs of a mapping from numbers, 0 or more."""
    if not isinstance(value, dict) or not value:
        raise ValueError(f"{where} is {value!r}, expected numbers with values, as in {{1: ...}}")
    for key in value:
        if not isinstance(key, int) or isinstance(key, bool) or key < 0:
            raise ValueError(f"{where} has the key {key!r}, expected a number, 0 or more")
    return list(value.items())


_READ: dict[str, Callable[[Any, str], Any]] = {
    "colour": _colour,
    "colours": _colours,
    "yaw_rad": _yaws,
}
"""Keys whose values are more than numbers and words."""
