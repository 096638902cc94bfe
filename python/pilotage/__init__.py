"""Pilotage: navigation by fixed landmarks with dead reckoning in between, for ground robots.

The estimator is the C++ core; this package binds it and builds simulation, reading of recordings,
evaluation and figures around it. The generated LCM types are in `pilotage.lcmtypes`.
"""

from typing import Any

from ._core import (
    ArcUnicycle,
    CalibratedArc,
    Config,
    ConfigError,
    DifferentialDrive,
    Ekf3,
    Ekf6,
    Engine,
    GyroDrive,
    Localizer,
    MarkerMap,
    MarkerModel,
    MidpointUnicycle,
    Policy,
    Recording,
    Run,
    UpdateReport,
    __version__,
    load_config,
    read_table,
    replay,
)

__all__ = [
    "ArcUnicycle",
    "CalibratedArc",
    "Config",
    "ConfigError",
    "DifferentialDrive",
    "Ekf3",
    "Ekf6",
    "Engine",
    "GyroDrive",
    "Localizer",
    "MarkerMap",
    "MarkerModel",
    "MidpointUnicycle",
    "Policy",
    "Recording",
    "Run",
    "UpdateReport",
    "__version__",
    "load_config",
    "read_table",
    "replay",
]


def __getattr__(name: str) -> Any:
    # lcm-gen names types by their LCM package, which is `pilotage`: what it generates looks here
    # for nested types, and so may a user who writes `from pilotage import pose_t`.
    if name.endswith("_t"):
        from . import lcmtypes

        return getattr(lcmtypes, name)
    raise AttributeError(f"module 'pilotage' has no attribute {name!r}")
