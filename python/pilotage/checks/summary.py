"""A configuration in words."""

import math

import numpy as np

from .. import Config, MarkerMap
from .markers import closest

CLOCK = {
    "utime": "the sender's stamp",
    "receive": "arrival",
    "mapped": "the sender's stamp, mapped to our clock",
}


def summarize(config: Config, map_name: str = "") -> dict[str, list[str]]:
    """Return lines by section: motion, inputs, sensors, map, start, outputs."""
    return {
        "motion": _motion(config),
        "inputs": _inputs(config),
        "sensors": [line for name in config.sensors for line in _sensor(config, name)] or ["none"],
        "map": _map(config.map, map_name) + _walls(config),
        "start": [_start(config)],
        "outputs": [
            f"pose_t on {config['output.pose']}, odometry_t on {config['output.odometry']}, "
            f"pose_jump_t on {config['output.jump']}",
            f"marker_report_t on {config['output.report']}, status_t on {config['output.status']}",
        ],
    }


def _motion(config: Config) -> list[str]:
    source, heading = config["motion.source"], config["motion.heading"]
    own = "the wheels" if source == "encoders" else "its omega"
    turn = {"gyro": "the gyro", "wheels": own, "both": f"the gyro and {own}"}[heading]
    states = ("gyro_bias", "distance_scale", "rotation_scale")
    moving = [
        state
        for state in states
        if config[f"calibration.{state}.sigma"] > 0 or config[f"calibration.{state}.walk"] > 0
    ]
    estimated = f"estimated on the way: {', '.join(moving) or 'pose only'}"
    unscented = ["unscented Kalman filter"] if config["filter"] == "ukf" else []
    return [f"{source}, heading from {turn}", estimated, *unscented]


def _inputs(config: Config) -> list[str]:
    gyro = [] if config["motion.heading"] == "wheels" else ["gyro"]
    sensors = [f"sensors.{name}" for name in config.sensors]
    names = [config["motion.source"], *gyro, *sensors, "pose_reset"]
    channels = [str(config[f"{name}.channel"]) for name in names]
    shown = [name.removeprefix("sensors.") for name in names]
    width, wide = max(map(len, shown)), max(map(len, channels))
    lines = []
    for name, label, channel in zip(names, shown, channels, strict=True):
        latency = 1e3 * config[f"{name}.latency_s"]
        less = f", less {latency:g} ms" if latency else ""
        time = CLOCK[config[f"{name}.time"]]
        lines.append(f"{label:<{width}}  {channel:<{wide}}  dated by {time}{less}")
    return lines


def _sensor(config: Config, name: str) -> list[str]:
    def of(key: str) -> float:
        return float(config[f"sensors.{name}.{key}"])

    measures = config[f"sensors.{name}.measures"]
    height = f"z {of('z_m'):g} m, " if measures in ("markers", "pixels") else ""
    noise = []
    if measures == "markers":
        noise.append(f"bearing {math.degrees(of('sigma_bearing_rad')):.3g}°")
        noise.append(f"elevation {math.degrees(of('sigma_elevation_rad')):.3g}°")
    if measures == "pose":
        noise.append(f"position {of('sigma_position_m'):g} m")
        noise.append(f"heading {math.degrees(of('sigma_heading_rad')):.3g}°")
    elif measures == "pixels":
        noise.append(f"u and v {of('sigma_pixel'):g} px")
    else:
        per_m = f" + {of('sigma_range_per_m'):g} of it" if of("sigma_range_per_m") else ""
        noise.append(f"range {of('sigma_range_m'):g} m{per_m}")
    kind = {
        "markers": "",
        "pose": ", fixes of the pose",
        "walls": ", ranges to walls",
        "pixels": ", pixels of markers",
    }[measures]
    return [
        f"{name} at x {of('x_m'):g} m, y {of('y_m'):g} m, {height}"
        f"yaw {math.degrees(of('yaw_rad')):.3g}°{kind}",
        f"  σ of {', '.join(noise)}; fusion {config[f'sensors.{name}.fusion']}",
        *_camera(config, name),
    ]


def _camera(config: Config, name: str) -> list[str]:
    camera = config.camera(name)
    if camera is None:
        return []
    width, height = camera.size
    left, right = camera.rays(np.array([[x, (height - 1) / 2] for x in (-0.5, width - 0.5)]))
    across = math.degrees(math.acos(left @ right))
    entry = config.detectors.get(name)
    kind = entry.get("kind") if isinstance(entry, dict) else None
    return [
        f"  camera of {width} by {height} px, {across:.0f}° across, pitched "
        f"{math.degrees(camera.pitch_rad):.3g}° down, rolled {math.degrees(camera.roll_rad):.3g}°"
        + (f"; finds {kind}" if kind else "")
    ]


def _map(markers: MarkerMap, name: str) -> list[str]:
    if len(markers) == 0:
        return ["none"]
    low, high = markers.positions.min(axis=0), markers.positions.max(axis=0)
    height = f"{low[2]:.3g} m" if low[2] == high[2] else f"{low[2]:.3g} m to {high[2]:.3g} m"
    lines = [
        f"{len(markers)} markers" + (f" from {name}" if name else ""),
        f"over {high[0] - low[0]:.1f} m × {high[1] - low[1]:.1f} m, at a height of {height}",
        f"ids {markers.ids[0]} to {markers.ids[-1]}, {_gaps(markers)}",
    ]
    if pair := closest(markers):
        lines.append(f"closest: {pair.one} and {pair.other}, {pair.apart_m:.3g} m")
    return lines


def _walls(config: Config) -> list[str]:
    if len(config.walls) == 0:
        return []
    ends = config.walls.segments.reshape(-1, 2)
    wide, high = np.ptp(ends, axis=0)
    from_file = f" from {config['walls']}" if config["walls"] else ""
    return [f"{len(config.walls)} walls{from_file} over {wide:.1f} m × {high:.1f} m"]


def _gaps(markers: MarkerMap) -> str:
    """Count the ids that are missing in between, and name the first."""
    ids = markers.ids.astype(np.int64)
    missing = int(ids[-1] - ids[0]) + 1 - ids.size
    if missing == 0:
        return "none missing"
    before = int(np.flatnonzero(np.diff(ids) > 1)[0])
    return f"{missing} missing in between, the first {ids[before] + 1}"


def _start(config: Config) -> str:
    if math.isnan(config["initial.x_m"]):
        reset = config["pose_reset.channel"]
        return f"anywhere: found from sightings, or set by a pose_reset_t on {reset}"
    return (
        f"x {config['initial.x_m']:g} m, y {config['initial.y_m']:g} m, "
        f"σ {config['initial.sigma_position_m']:g} m; "
        f"heading {math.degrees(config['initial.heading_rad']):.3g}°, "
        f"σ {math.degrees(config['initial.sigma_heading_rad']):.3g}°"
    )
