"""A configuration of which no check has anything to say."""

from typing import Any

from pilotage import Config, MarkerMap

SOUND: dict[str, Any] = {
    "encoders.left_m_per_tick": 1.9e-4,
    "encoders.right_m_per_tick": 1.9e-4,
    "encoders.track_width_m": 0.42,
    "calibration.gyro_bias.sigma": 0.002,
    "sensors.camera.x_m": 0.2,
    "sensors.camera.z_m": 0.35,
    "sensors.camera.sigma_bearing_rad": 0.01,
    "initial.x_m": 0,
    "initial.y_m": 0,
    "initial.heading_rad": 0,
}
MARKERS = MarkerMap([1, 2, 5], [[12.4, -3.1, 0.5], [14.1, 2.2, 0.5], [6.0, 4.0, 0.5]])


def sound(markers: MarkerMap | None = MARKERS, without: str = "\n", **changes: Any) -> Config:
    """A sound configuration but for the changes, in whose names two underscores stand for a dot.

    Keys that begin with `without` are left at their defaults.
    """
    config = Config()
    if markers is not None:
        config.map = markers
    for key, value in {**SOUND, **changes}.items():
        if not key.startswith(without):
            config[key.replace("__", ".")] = value
    config.check()
    return config
