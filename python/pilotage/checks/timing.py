"""Times, the history and the channels."""

from collections.abc import Iterator

from .. import Config, multicast
from .finding import Finding

MOTION_HZ = 200.0
"""The fastest that encoders and a gyro are meant to be sent."""


def window_shorter_than_a_latency(config: Config) -> Iterator[Finding]:
    """Find inputs whose samples are all late."""
    window = config["history.window_s"]
    motion = config[f"{config['motion.source']}.latency_s"]
    gyro = [] if config["motion.heading"] == "wheels" else ["gyro"]
    for name in (*gyro, *(f"sensors.{sensor}" for sensor in config.sensors)):
        behind = config[f"{name}.latency_s"] - motion
        if behind >= window:
            yield Finding(
                f"{name}.latency_s",
                f"{behind:g} s behind the motion, but history.window_s is {window:g}: "
                f"every sample is late",
                f"set history.window_s to {2.0 * behind:g}, or is the latency in milliseconds?",
            )


def history_too_small(config: Config) -> Iterator[Finding]:
    """Find a history that is full before its window is."""
    window, capacity = config["history.window_s"], config["history.capacity"]
    streams = 1 if config["motion.heading"] == "wheels" else 2
    needed = round(window * MOTION_HZ * streams)
    if capacity < needed:
        yield Finding(
            "history.capacity",
            f"{capacity} samples are {capacity / MOTION_HZ / streams:.2g} s of motion at "
            f"{MOTION_HZ:g} Hz, but history.window_s is {window:g}",
            f"set it to {2 * needed}, which leaves room for sightings",
        )


def outputs_on_one_channel(config: Config) -> Iterator[Finding]:
    """Find outputs that a receiver cannot tell apart."""
    seen: dict[str, str] = {}
    for key in ("output.pose", "output.odometry", "output.jump", "output.report", "output.status"):
        other = seen.setdefault(config[key], key)
        if other != key:
            yield Finding(
                key, f"{config[key]}, as {other}: who listens gets both", "rename one of them"
            )


def no_multicast() -> Iterator[Finding]:
    """Find a machine on which LCM cannot work."""
    if not multicast.available():
        problem, remedy = multicast.ADVICE.split("; ", 1)
        yield Finding("LCM", problem, remedy)


CHECKS = (window_shorter_than_a_latency, history_too_small, outputs_on_one_channel)
