"""What a robot's wheels and its camera reported on a drive, sample by sample."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import MarkerMap
from .drives import Drive
from .fiducials import Detections, FiducialCamera
from .wheel_speeds import WheelSpeeds


@dataclass(frozen=True)
class WheelsAndCamera:
    """n samples of the wheels, with the detections at their ends.

    Attributes
    ----------
    utime : (n + 1,) int, µs
        The start, and the ends of the samples.
    truth : (n + 1, 3) float
        x, y [m] and heading [rad].
    speeds : (n, 2) float, m/s
        Of the left and the right wheel.
    seen : Detections
        Their frames are indices of `utime`.
    """

    wheels: WheelSpeeds
    camera: FiducialCamera
    markers: MarkerMap
    utime: NDArray[np.int64]
    truth: NDArray[np.float64]
    speeds: NDArray[np.float64]
    seen: Detections

    @classmethod
    def on(
        cls,
        drive: Drive,
        markers: MarkerMap,
        wheels: WheelSpeeds,
        rng: np.random.Generator,
        every: int = 1,
    ) -> "WheelsAndCamera":
        """Drive and look; a frame comes with every so many-th sample of the wheels."""
        camera, utime = FiducialCamera(), wheels.stamps(drive)
        seen = camera.detect(drive, markers, utime[::every], rng).numbered(every)
        speeds = wheels.report(drive, rng)
        return cls(wheels, camera, markers, utime, drive.at(utime), speeds, seen)

    @property
    def rates(self) -> NDArray[np.float64]:
        """(n, 2) forward speed [m/s] and yaw rate [rad/s] by the wheels."""
        return np.asarray(self.speeds @ self.wheels.mixing.T)

    def ticks(self, m_per_tick: float) -> NDArray[np.float64]:
        """(n + 1, 2) absolute ticks of an encoder on each wheel."""
        travel = self.speeds * (np.diff(self.utime) * 1e-6)[:, None]
        return np.rint(np.vstack([np.zeros(2), np.cumsum(travel, axis=0)]) / m_per_tick)
