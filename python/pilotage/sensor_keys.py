"""What a marker sensor may measure, and the keys that say how well and from where.

In the core's order, as they stand in the configuration's ``sensors.NAME`` and in scenario files.
"""

from collections.abc import Iterable

SIGMAS = {
    "bearing": "sigma_bearing_rad",
    "elevation": "sigma_elevation_rad",
    "range": "sigma_range_m",
}
"""The key of each component's noise."""
COMPONENTS = tuple(SIGMAS)
MOUNTING = ("x_m", "y_m", "z_m", "yaw_rad")
"""Where it sits in the robot frame."""


def in_order(components: Iterable[str]) -> tuple[str, ...]:
    """Return components in the core's order, each once; none or another one is a ValueError."""
    named = set(components)
    if not named or not named <= set(COMPONENTS):
        raise ValueError(
            f"components are {', '.join(sorted(named)) or 'none'}, "
            f"expected some of {', '.join(COMPONENTS)}"
        )
    return tuple(component for component in COMPONENTS if component in named)
