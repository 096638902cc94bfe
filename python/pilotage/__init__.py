"""Pilotage: navigation by fixed landmarks with dead reckoning in between, for ground robots.

The estimator is the C++ core; this package binds it and builds simulation, reading of recordings,
evaluation and figures around it. The generated LCM types are in `pilotage.lcmtypes`.
"""

from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from ._core import (
        ArcUnicycle,
        ArcVelocity,
        CalibratedArc,
        CameraModel,
        Config,
        ConfigError,
        ConstantVelocity,
        DifferentialDrive,
        EchoEnvelope,
        Ekf3,
        Ekf5,
        Ekf6,
        Engine,
        EulerVelocity,
        GyroDrive,
        HeadingFix,
        LinearizedVelocity,
        LinearKalman,
        Localizer,
        MarkerMap,
        MarkerModel,
        MidpointUnicycle,
        MidpointVelocity,
        MoveAndTurn,
        PlanarVelocity,
        Policy,
        PoseFix,
        PositionFix,
        Recording,
        RelativePosition,
        Run,
        SkidSteer,
        Speed,
        Ukf3,
        Ukf4,
        Ukf5,
        Ukf6,
        Unscented,
        UpdateReport,
        WallMap,
        WallRange,
        WheelTravel,
        WorldBearing,
        YawRate,
        __version__,
        associate_pixels,
        load_config,
        read_checkpoint,
        read_table,
        relative_position_noise,
        replay,
        unscented_transform,
    )

__all__ = [
    "ArcUnicycle",
    "ArcVelocity",
    "CalibratedArc",
    "CameraModel",
    "Config",
    "ConfigError",
    "ConstantVelocity",
    "DifferentialDrive",
    "EchoEnvelope",
    "Ekf3",
    "Ekf5",
    "Ekf6",
    "Engine",
    "EulerVelocity",
    "GyroDrive",
    "HeadingFix",
    "LinearKalman",
    "LinearizedVelocity",
    "Localizer",
    "MarkerMap",
    "MarkerModel",
    "MidpointUnicycle",
    "MidpointVelocity",
    "MoveAndTurn",
    "PlanarVelocity",
    "Policy",
    "PoseFix",
    "PositionFix",
    "Recording",
    "RelativePosition",
    "Run",
    "SkidSteer",
    "Speed",
    "Ukf3",
    "Ukf4",
    "Ukf5",
    "Ukf6",
    "Unscented",
    "UpdateReport",
    "WallMap",
    "WallRange",
    "WheelTravel",
    "WorldBearing",
    "YawRate",
    "__version__",
    "associate_pixels",
    "load_config",
    "read_checkpoint",
    "read_table",
    "relative_position_noise",
    "replay",
    "unscented_transform",
]


def __getattr__(name: str) -> Any:
    # The extension is loaded when it is first needed, so that a command starts quickly and can say
    # in a line what is missing where the extension cannot load.
    if name in __all__:
        try:
            from . import _core
        except ImportError as error:
            from ._glib import explain

            raise ImportError(explain(error)) from error
        value = globals()[name] = getattr(_core, name)
        return value
    # lcm-gen names types by their LCM package, which is `pilotage`: what it generates looks here
    # for nested types, and so may a user who writes `from pilotage import pose_t`.
    if name.endswith("_t"):
        from . import lcmtypes

        return getattr(lcmtypes, name)
    raise AttributeError(f"module 'pilotage' has no attribute {name!r}")
