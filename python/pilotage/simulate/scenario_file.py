"""Scenario files: a user's own site, drive, sensors and chances, to simulate and to measure.

An example with every key stands in docs/montecarlo.md; what is left out is as in the dataclasses.
"""

from collections.abc import Callable, Iterator, Mapping
from functools import partial
from pathlib import Path
from types import MappingProxyType
from typing import Any

import numpy as np
import yaml

from .. import Config, MarkerMap
from ..fields import call, known_keys, mapping, read_yaml, value_of
from ..sensor_keys import MOUNTING, SIGMAS
from .chances import Kidnap, Outliers, Start
from .drives import DRIVES, Drive
from .measuring import suitable_config
from .scenario import SCENARIOS, Scenario
from .scene import Scene
from .scene_file import parse_scene
from .sensors import Camera, Encoders, Gyro
from .tilt import Tilt
from .waypoints import waypoints
from .worlds import SITES, Surveyed

PARTS: dict[str, Callable[..., Any]] = {
    "encoders": Encoders,
    "gyro": Gyro,
    "start": Start,
    "outliers": Outliers,
    "tilt": Tilt,
    "kidnap": Kidnap,
}
VALUES = {"duration_s": float, "latency_s": float, "jitter_s": float, "ids": bool}
KEYS = ("site", "drive", "sensors", "cameras", "world", "config", *VALUES, *PARTS)
RENDERED = Path(__file__).with_name("rendered.yaml")
"""Scenarios with pictures, as a user's would be written."""


def find_scenario(name: str, others: Mapping[str, Any] = MappingProxyType({})) -> Scenario:
    """Return a scenario by its name, or read it from a file.

    Parameters
    ----------
    others : mapping
        Contents as of files, by further names.

    Raises
    ------
    ValueError
        If there is neither, or the file cannot be used.
    """
    if name in SCENARIOS:
        return SCENARIOS[name]
    rendered = read_yaml(RENDERED)
    others = {**rendered, **others}
    if name in others:
        return parse_scenario(others[name], name)
    if Path(name).is_file():
        return parse_scenario(read_yaml(Path(name)), name)
    raise ValueError(
        f"no scenario '{name}', and no such file; there are {', '.join([*SCENARIOS, *others])}; "
        "docs/montecarlo.md shows a file of your own"
    )


def parse_scenario(content: Any, name: str) -> Scenario:
    """Make a scenario of a file's content; paths in it are relative to the file `name`."""
    content = mapping(content, name)
    known_keys(content, KEYS, name)
    for key in ("site", "drive", "duration_s"):
        if key not in content:
            raise ValueError(f"{name}: '{key}' is missing")
    if "sensors" not in content and "cameras" not in content:
        raise ValueError(f"{name}: 'sensors' is missing")
    parts = {
        key: call(PARTS[key], content[key], f"{name}: {key}") for key in PARTS if key in content
    }
    values = {
        key: value_of(VALUES[key], content[key], f"{name}: {key}")
        for key in VALUES
        if key in content
    }
    scene = _scene(content, name)
    sensors = mapping(content.get("sensors", {}), f"{name}: sensors")
    if not sensors and scene is None:
        raise ValueError(f"{name}: sensors has none, expected one or more")
    given: dict[str, Any] = {
        "site": _site(content["site"], name),
        "drive": _drive(content["drive"], f"{name}: drive"),
        "cameras": (
            *(_camera(s, sensors[s], f"{name}: sensors.{s}") for s in sensors),
            *(() if scene is None else (camera.sensor() for camera in scene.cameras)),
        ),
        "scene": scene,
        "config": dict(_dotted(mapping(content.get("config", {}), f"{name}: config"))),
    }
    try:
        scenario = Scenario(Path(name).name.removesuffix(".yaml"), **given, **parts, **values)
    except ValueError as error:
        raise ValueError(f"{name}: {error}") from error
    _try_out(scenario, name)
    return scenario


def _try_out(scenario: Scenario, name: str) -> None:
    """Refuse what only shows where the site and the configuration are made: now, not in a run."""
    markers = scenario.site(np.random.default_rng(0))
    if scenario.outliers is not None and scenario.outliers.of_ids and len(markers) < 2:
        raise ValueError(
            f"{name}: outliers.kind is {scenario.outliers.kind}, and site has one marker: there is "
            "no other whose id a sighting could have; say kind: bearing"
        )
    if scenario.scene is not None:
        try:
            scenario.scene.markers.detector(markers)
        except ValueError as error:
            raise ValueError(f"{name}: world.markers: {error}") from error
    drive = scenario.drive(1.0)  # names its place itself
    try:
        config = suitable_config(scenario, markers, drive)
        config.check()
    except (KeyError, ValueError) as error:
        words = str(error.args[0]).removeprefix("configuration: ")
        raise ValueError(f"{name}: config: {words}") from error
    unknown = set(config.sensors) - {camera.name for camera in scenario.cameras}
    if unknown:
        raise ValueError(
            f"{name}: config: sensors.{min(unknown)} is none of the scenario's sensors: "
            f"{', '.join(camera.name for camera in scenario.cameras)}"
        )


def _site(content: Any, name: str) -> Callable[[np.random.Generator], MarkerMap]:
    """A named site, the path of a map file, or the markers themselves."""
    if isinstance(content, str):
        if content in SITES:
            return SITES[content]
        file = Path(name).parent / content
        if not file.is_file():
            raise ValueError(
                f"{name}: no site '{content}', and no file {file}; there are {', '.join(SITES)}"
            )
        markers = MarkerMap.load(str(file))
    else:
        try:
            markers = Config.parse(yaml.safe_dump({"map": content})).map
        except ValueError as error:
            raise ValueError(f"{name}: site: {str(error).split(': ', 1)[-1]}") from error
    return Surveyed.of(markers)


def _drive(content: Any, where: str) -> Callable[[float], Drive]:
    """A drive by its name, one with parameters, or waypoints."""
    content = {"name": content} if isinstance(content, str) else dict(mapping(content, where))
    if "waypoints" in content:
        function: Callable[..., Drive] = waypoints
    else:
        named = content.pop("name", None)
        if named not in DRIVES:
            raise ValueError(f"{where} has no 'waypoints', and no name of {', '.join(DRIVES)}")
        function = DRIVES[named]
    make = partial(call, function, content, where)
    return lambda duration_s: make(duration_s=duration_s)


def _camera(name: str, content: Any, where: str) -> Camera:
    """One sensor; where it sits and how well it measures are named as in the configuration."""
    content = dict(mapping(content, where))
    flat = {
        field: tuple(
            value_of(float, content.pop(key, default), f"{where}.{key}")
            for key, default in zip(keys, getattr(Camera(name), field), strict=True)
        )
        for field, keys in (("mounting", MOUNTING), ("sigma", SIGMAS.values()))
    }
    return call(Camera, content, where, name=name, **flat)


def _scene(content: dict[str, Any], name: str) -> Scene | None:
    """What pictures are rendered of, if there are cameras."""
    if "cameras" not in content:
        if "world" in content:
            raise ValueError(f"{name}: there is a world, and 'cameras' is missing: who sees it")
        return None
    scene = parse_scene(content["cameras"], content.get("world", {}), name)
    both = {camera.name for camera in scene.cameras} & set(content.get("sensors") or {})
    if both:
        raise ValueError(f"{name}: {min(both)} is in cameras and in sensors: name one otherwise")
    return scene


def _dotted(content: dict[str, Any], prefix: str = "") -> Iterator[tuple[str, Any]]:
    """Keys of the configuration, whether they stand in sections or with dots."""
    for key, value in content.items():
        if isinstance(value, dict):
            yield from _dotted(value, f"{prefix}{key}.")
        elif isinstance(value, bool):  # what YAML makes of these words
            yield prefix + key, "on" if value else "off"
        else:
            yield prefix + key, value
