"""The first paper's experiment: 549 s inwards over 28 markers, 155 to 187 sightings, at 99 Hz.

Kiriy and Buehler 2002, sections 1 to 4. The noise of wheels and gyro is that of the recording
`mower-listing`, found by holding its columns against its truth; the angles' is eq. 30.
"""

import numpy as np

from ..logs.mower import Triple
from .drives import Drive, inward_spiral
from .measuring import measure
from .poselog import at_most_one, poselog, slow_clock
from .scenario import Scenario
from .sensors import Camera, Encoders, Gyro
from .worlds import mower_site

DURATION_S = 549.0
BEHIND_S = 5.0
"""Of a clock that counts rows of 10 ms."""
BLIND_S = (285.0, 300.0)
"""No marker in view, or one."""
SIGMA = (0.048, 0.006, 0.0)
"""Of azimuth and elevation, rad."""
FRAME_HZ = 0.25
"""Of each of the two cameras."""
SCALE_SIGMA = 0.02
"""Of each wheel's scale, from mower to mower."""
WANDER, WANDER_S = 0.0165, 20.0
"""Of each wheel's slip that comes and goes, and for how long."""
TICK_M = 5e-4
GYRO = 2e-4, 1e-4, 1.4e-5
"""White noise [rad/√s], bias at the start [rad/s] and its walk [rad/s/√s]."""


def mower_log(
    rng: np.random.Generator, marker_noise: float = 1.0, frame_rate: float = 1.0
) -> Triple:
    """Drive once; all chance comes from `rng`, first that of markers, wheels and gyro.

    Parameters
    ----------
    marker_noise : float
        Over the paper's; 0: ideal angles, of the same markers at the same times.
    frame_rate : float
        Over the paper's.
    """
    cameras = tuple(
        Camera(
            name,
            components=("bearing", "elevation"),
            mounting=(0.0, 0.0, 0.226, yaw),  # the paper's angles are of the mid-axis point
            sigma=(marker_noise * SIGMA[0], marker_noise * SIGMA[1], 0.0),
            rate_hz=frame_rate * FRAME_HZ,
            reach_m=11.0,
            half_view_rad=0.38,
            dropout=0.2,
        )
        for name, yaw in (("front", 0.0), ("rear", np.pi))
    )
    left, right = 1.0 + SCALE_SIGMA * rng.standard_normal(2)
    white, bias, walk = GYRO
    scenario = Scenario(
        "mower",
        mower_site,
        _way,
        DURATION_S,
        Encoders(
            m_per_tick=TICK_M,
            noise_m_per_sqrt_m=0.0,
            scale=(left, right),
            wander=WANDER,
            wander_s=WANDER_S,
        ),
        Gyro(white, bias * rng.standard_normal(), walk),
        cameras,
    )
    return at_most_one(poselog(measure(scenario, rng), cameras, TICK_M, rng), BLIND_S)


def _way(duration_s: float) -> Drive:
    return slow_clock(inward_spiral(duration_s - BEHIND_S), BEHIND_S)
