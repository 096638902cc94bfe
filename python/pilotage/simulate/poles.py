"""Coloured poles at the corners of a robot soccer field, and a camera that sees them every 40 ms.

A. J. Sousa, P. J. Costa, A. P. Moreira and A. S. Carvalho, "Self Localization of an Autonomous
Robot: Using an EKF to merge Odometry and Vision based Landmarks", section 4. Where the poles stand
is not in the text.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import MarkerMap, Recording
from ..evaluate import wrap_angle
from .drives import Drive
from .labels import add_labelled
from .measuring import UNKNOWN_ID
from .sensors import Camera
from .streams import Stream

PERIOD_US = 40_000
"""Of the camera and of the control cycle, µs."""
SENSOR = "camera"
_EYE = Camera(SENSOR, ("bearing", "range"), mounting=(0.0, 0.0, 0.0, 0.0))


def corner_poles() -> MarkerMap:
    """Four poles of a field of 10 m by 5 m, in three colours: those of opposite corners share one.

    Poles 0 and 1 are the two at x = 5 m.
    """
    xy = np.array([[5.0, -2.5], [5.0, 2.5], [-5.0, 2.5], [-5.0, -2.5]])
    return MarkerMap(np.arange(4), np.column_stack([xy, np.zeros(4)]), labels=[0, 1, 2, 1])


def first_poles(poles: MarkerMap, count: int) -> MarkerMap:
    """Return a map of the first poles alone."""
    return MarkerMap(poles.ids[:count], poles.positions[:count], labels=poles.labels[:count])


@dataclass(frozen=True)
class Seen:
    """Sightings in order of time.

    Attributes
    ----------
    step : (k,) int
        Index of the drive's stamp at which it was seen.
    pole : (k,) int
        Which one it truly is.
    bearing, distance : (k,) float, rad and m
    """

    step: NDArray[np.intp]
    pole: NDArray[np.intp]
    bearing: NDArray[np.float64]
    distance: NDArray[np.float64]

    @property
    def relative(self) -> NDArray[np.float64]:
        """(k, 2) forward and leftward [m]: what eq. 8 measures."""
        along = np.stack([np.cos(self.bearing), np.sin(self.bearing)])
        return np.asarray((self.distance * along).T)

    def record(self, drive: Drive, poles: MarkerMap, colours_only: bool) -> Recording:
        """Encode them with the drive's rates, with the poles' ids or with their labels alone."""
        recording = Recording()
        rates = np.stack([drive.v, drive.omega])
        # The first stamp ends no step: its rate is not used.
        recording.add_velocity("VELOCITY", drive.utime, *np.insert(rates, 0, 0.0, axis=1))
        ids = np.full(len(self.pole), UNKNOWN_ID, np.int32)
        none = np.full(len(self.pole), np.nan)
        seen = Stream.sent(
            drive.utime[self.step],
            np.column_stack([self.bearing, none, self.distance]),
            ids if colours_only else poles.ids[self.pole],
        )
        add_labelled(recording, "MARKERS", SENSOR, seen, poles.labels[self.pole])
        recording.sort()
        return recording


@dataclass(frozen=True)
class PoleCamera:
    """A distance whose error grows with the distance, and a bearing: section 4."""

    sigma_per_m: float = 0.1
    """sdv_dist_m."""
    sigma_bearing_rad: float = 0.06
    """sdv_ang."""

    def see(
        self, drive: Drive, poles: MarkerMap, view: NDArray[np.bool_], rng: np.random.Generator
    ) -> Seen:
        """Measure the poles that are in view, (n + 1, m), at the drive's stamps but the first.

        The noise of every pole is drawn, in view or not: other views have the same noise.
        """
        exact = _EYE.look_at_all(drive, poles, drive.utime)
        noise = rng.standard_normal((*exact.shape[:2], 2))
        bearing = wrap_angle(exact[..., 0] + self.sigma_bearing_rad * noise[..., 0])
        distance = exact[..., 2] * (1.0 + self.sigma_per_m * noise[..., 1])
        step, pole = np.nonzero(view[1:])
        step += 1
        return Seen(step, pole, bearing[step, pole], distance[step, pole])


def in_turn(
    drive: Drive, poles: MarkerMap, count: int = 2, change_s: float = 2.0
) -> NDArray[np.bool_]:
    """(n + 1, m) view of one of the first poles at a time, which changes every so often."""
    time_s = (drive.utime - drive.utime[0]) * 1e-6
    return np.asarray((time_s // change_s % count)[:, None] == np.arange(len(poles)))


def at_once(drive: Drive, poles: MarkerMap, count: int = 2) -> NDArray[np.bool_]:
    """(n + 1, m) view of the first poles, all the time."""
    return np.broadcast_to(np.arange(len(poles)) < count, (len(drive.utime), len(poles)))


def ahead(
    drive: Drive, poles: MarkerMap, half_view_rad: float = np.radians(25.0)
) -> NDArray[np.bool_]:
    """(n + 1, m) view of a camera that looks ahead, too narrow for two poles at a time."""
    off = np.abs(_EYE.look_at_all(drive, poles, drive.utime)[..., 0])
    return np.asarray((off <= half_view_rad) & (off == off.min(axis=1, keepdims=True)))
