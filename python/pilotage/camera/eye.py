"""A camera of the configuration: what finds its markers, and what is said of them."""

from dataclasses import dataclass

from .. import CameraModel, Config
from .detection import Detector
from .kinds import make_detector, mounting_noise, shutter
from .mounting import MountingNoise
from .shutter import Shutter
from .tags import TagDetector

MEASURES = ("markers", "pixels", "pose")


@dataclass(frozen=True, eq=False)
class Eye:
    """All that is configured of one camera."""

    name: str
    """Of the sensor."""
    camera: CameraModel
    detector: Detector
    noise: MountingNoise
    shutter: Shutter
    measures: str
    """markers, pixels or pose."""
    channel: str
    mounting: tuple[float, float, float, float]
    """x, y, z [m] and yaw [rad] in the robot frame."""


def cameras(config: Config) -> list[str]:
    """Return the names of the sensors that are cameras."""
    return [
        name
        for name in config.sensors
        if config.camera(name) is not None or name in config.detectors
    ]


def make_eye(config: Config, name: str) -> Eye:
    """Put together what the configuration says of a camera.

    Raises
    ------
    ValueError
        Naming the key that is missing or wrong, and what to write there.
    """
    measures = config[f"sensors.{name}.measures"]
    if measures not in MEASURES:
        raise ValueError(
            f"sensors.{name}.measures is {measures}, which no camera does: "
            f"expected one of {', '.join(MEASURES)}"
        )
    camera = config.camera(name)
    if camera is None:
        raise ValueError(
            f"sensors.{name}.intrinsics is missing: name the file of the camera's calibration, "
            "as `pilotage camera-calibrate` or OpenCV writes it"
        )
    where = f"detectors.{name}"
    if name not in config.detectors:
        raise ValueError(f"{where} is missing: what is to be found, as in {{kind: tags, ...}}")
    entry = config.detectors[name]
    mounting = tuple(config[f"sensors.{name}.{key}"] for key in ("x_m", "y_m", "z_m", "yaw_rad"))
    detector = make_detector(entry, camera, mounting[2], where)
    if measures == "pose" and not _tells_poses(detector):
        raise ValueError(
            f"sensors.{name}.measures is pose, which needs {where} to be of kind tags with "
            "size_m and yaw_rad; else measure markers"
        )
    return Eye(
        name=name,
        camera=camera,
        detector=detector,
        noise=mounting_noise(entry, where),
        shutter=shutter(entry, where),
        measures=measures,
        channel=config[f"sensors.{name}.channel"],
        mounting=(mounting[0], mounting[1], mounting[2], mounting[3]),
    )


def _tells_poses(detector: Detector) -> bool:
    return (
        isinstance(detector, TagDetector) and detector.size_m is not None and detector.yaw_rad != {}
    )
