"""Motion and its noise."""

import math
from collections.abc import Iterator

from .. import Config
from .finding import Finding


def wheels_by_default(config: Config) -> Iterator[Finding]:
    """Find wheels of which nobody said how large they are."""
    if config["motion.source"] != "encoders":
        return
    default = Config()
    ticks = ("encoders.left_m_per_tick", "encoders.right_m_per_tick")
    if all(config[key] == default[key] for key in ticks):
        yield Finding(
            "encoders",
            f"left_m_per_tick and right_m_per_tick are the default of {default[ticks[0]]:g}",
            "drive 10 m straight on, and divide 10 by the ticks counted",
        )
    width = "encoders.track_width_m"
    if config["motion.heading"] != "gyro" and config[width] == default[width]:
        yield Finding(
            width,
            f"the default of {default[width]:g} m",
            "measure it between the wheels' contact points",
        )


def frozen_gyro_bias(config: Config) -> Iterator[Finding]:
    """Find a gyro without bias, which there is not."""
    bias = [config[f"calibration.gyro_bias.{name}"] for name in ("initial", "sigma", "walk")]
    if config["motion.heading"] != "wheels" and bias == [0.0, 0.0, 0.0]:
        yield Finding(
            "calibration.gyro_bias",
            "frozen at 0, so a bias of 0.1 °/s turns the pose by 6° a minute",
            "let it be estimated: gyro_bias: {sigma: 0.002, walk: 1.0e-5}",
        )


def motion_without_noise(config: Config) -> Iterator[Finding]:
    """Find a motion without noise, which no marker corrects."""
    keys = [key for key, _, _ in config.describe() if key.startswith("noise.") and "_per_" in key]
    if all(config[key] == 0.0 for key in keys):
        yield Finding(
            "noise",
            "0 throughout: the motion is taken for exact, and markers correct nothing",
            "leave it out for the defaults, and tune it by the NIS of a replay",
        )


def degrees_for_radians(config: Config) -> Iterator[Finding]:
    """Find angles of more than a turn."""
    for key, value, _ in config.describe():
        if key.endswith("_rad") and value and abs(float(value)) > 2.0 * math.pi:
            yield Finding(
                key,
                f"{float(value):g} rad, more than a turn",
                f"if it was meant in degrees: {math.radians(float(value)):.4g}",
            )


CHECKS = (wheels_by_default, frozen_gyro_bias, motion_without_noise, degrees_for_radians)
