"""Cameras: whether what is to find their markers can be made."""

from collections.abc import Iterator

from .. import Config
from .finding import Finding


def detector_wrong(config: Config) -> Iterator[Finding]:
    """Find entries of `detectors`, which the node passes over, that pilotage-camera refuses."""
    if not config.detectors:
        return
    try:
        from ..camera.eye import make_eye
    except ImportError:
        yield Finding(
            "detectors",
            "not checked, OpenCV is missing",
            "pip install 'pilotage[camera]'",
            note=True,
        )
        return
    for name in config.detectors:
        if name not in config.sensors:
            yield Finding(
                f"detectors.{name}",
                f"there is no sensor of this name, only {', '.join(config.sensors) or 'none'}",
                f"add sensors.{name} with the camera's mounting and intrinsics, or rename it",
            )
            continue
        try:
            make_eye(config, name)
        except ValueError as error:
            yield Finding(
                f"detectors.{name}", str(error), "mend it; pilotage-camera does not start with it"
            )


CHECKS = (detector_wrong,)
