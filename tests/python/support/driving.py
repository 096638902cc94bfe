"""A robot that drives a circle among four markers, and what its sensors send."""

import math
from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

from pilotage.lcmtypes import encoders_t, gyro_t

from .bus import frame

RADIUS_M, SPEED_M_S, TRACK_M = 2.0, 1.0, 0.5
RATE_RAD_S = SPEED_M_S / RADIUS_M
PERIOD_US = 10_000
MARKERS = {1: (5.0, 1.0), 2: (-1.0, 6.0), 3: (-5.0, 2.0), 4: (1.0, -4.0)}

CONFIG = f"""
map: [{", ".join(f"{{id: {i}, x: {x}, y: {y}, z: 0.5}}" for i, (x, y) in MARKERS.items())}]
encoders: {{left_m_per_tick: 0.001, right_m_per_tick: 0.001, track_width_m: {TRACK_M}}}
sensors: {{camera: {{z_m: 0.5}}}}
initial: {{x_m: 0, y_m: 0, heading_rad: 0}}
"""


@dataclass
class Robot:
    """Where it is after `step` steps of `period_us`.

    Attributes
    ----------
    aside : (x, y) [m]
        Where the circle's start has been carried to.
    ticks_from : int
        The step at which the counters started from zero; -1 if they have counted all along.
    """

    step: int = 0
    aside: tuple[float, float] = (0.0, 0.0)
    ticks_from: int = -1
    first_us: int = 1_000_000
    period_us: int = PERIOD_US
    frames: int = 0

    @property
    def utime(self) -> int:
        return self.first_us + self.period_us * self.step

    def pose(self, utime: int) -> tuple[float, float, float]:
        """x, y [m] and heading [rad] at a time [us] since it was last carried."""
        angle = RATE_RAD_S * (utime - self.first_us) * 1e-6
        x, y = RADIUS_M * math.sin(angle), RADIUS_M * (1.0 - math.cos(angle))
        return x + self.aside[0], y + self.aside[1], math.remainder(angle, 2.0 * math.pi)

    def distance(self, pose: Any) -> float:
        """How far a pose_t is from the truth [m]."""
        x, y, _ = self.pose(pose.utime)
        return math.hypot(pose.x - x, pose.y - y)

    def messages(self, sightings: bool = True) -> Iterator[tuple[str, Any]]:
        """What is sent at this step; the step is over then."""
        gyro = gyro_t()
        gyro.utime, gyro.seq, gyro.rate = self.utime, self.step, RATE_RAD_S
        yield "GYRO", gyro
        encoders = encoders_t()
        encoders.utime, encoders.seq = self.utime, self.step
        encoders.left, encoders.right = self.ticks
        yield "ENCODERS", encoders
        if sightings:
            marker = 1 + self.frames % len(MARKERS)
            yield "MARKERS", frame(self.utime, self.frames, self.sees(marker))
            self.frames += 1
        self.step += 1

    @property
    def ticks(self) -> tuple[int, int]:
        """Counts of the wheels."""
        way_mm = 1e-3 * self.period_us * (self.step - max(self.ticks_from, 0))
        half = TRACK_M / 2.0 / RADIUS_M
        offset = 1000 if self.ticks_from < 0 else 0
        return offset + round(way_mm * (1 - half)), offset + round(way_mm * (1 + half))

    def sees(self, marker: int) -> tuple[int, float, float]:
        """Id, bearing [rad] and range [m] of a marker from where it is."""
        x, y, heading = self.pose(self.utime)
        dx, dy = MARKERS[marker][0] - x, MARKERS[marker][1] - y
        bearing = math.remainder(math.atan2(dy, dx) - heading, 2.0 * math.pi)
        return marker, bearing, math.hypot(dx, dy)
