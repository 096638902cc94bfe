"""The files of a robot with cameras: configuration, map, intrinsics."""

from pathlib import Path
from typing import Any

import numpy as np
import yaml

from ..camera.intrinsics_file import write_intrinsics
from .measuring import Measured, suitable_config
from .scenario import Scenario
from .scene import Scene

MAP, ROBOT = "markers.yaml", "robot.yaml"
BOOLEAN = "tag:yaml.org,2002:bool"


def write_robot(scenario: Scenario, scene: Scene, measured: Measured, folder: Path) -> None:
    """Write ``robot.yaml``, ``markers.yaml`` and each camera's intrinsics into a folder."""
    measured.markers.save(str(folder / MAP))
    for camera in scene.cameras:
        optics = camera.model
        write_intrinsics(
            folder / f"{camera.name}.yaml", optics.size, optics.matrix, np.array(camera.distortion)
        )
    (folder / ROBOT).write_text(_configuration(scenario, scene, measured), encoding="utf-8")


def _configuration(scenario: Scenario, scene: Scene, measured: Measured) -> str:
    """Return the node's configuration; what is known of the cameras refers to their files."""
    text = suitable_config(scenario, measured.markers, measured.drive).to_yaml()
    content: dict[str, Any] = yaml.load(text, _Loader)
    for camera in scene.cameras:
        content["sensors"][camera.name] |= {
            "roll_rad": camera.roll_rad,
            "pitch_rad": camera.pitch_rad,
            "intrinsics": f"{camera.name}.yaml",
            "sigma_pixel": camera.sigma_pixel,
        }
    content["map"] = MAP
    found_by = scene.markers.detector(measured.markers)
    content["detectors"] = {camera.name: dict(found_by) for camera in scene.cameras}
    return str(yaml.dump(content, Dumper=_Dumper, sort_keys=False))


class _Loader(yaml.SafeLoader):  # type: ignore[misc]
    """Leaves `off` a word, as the configuration has it."""


class _Dumper(yaml.SafeDumper):  # type: ignore[misc]
    """Writes that word without quotes, and everything where it belongs, without references."""

    def ignore_aliases(self, data: Any) -> bool:
        return True


for _kind in (_Loader, _Dumper):
    _kind.yaml_implicit_resolvers = {
        first: [(tag, pattern) for tag, pattern in resolvers if tag != BOOLEAN]
        for first, resolvers in _kind.yaml_implicit_resolvers.items()
    }
