"""What the sensors make of a true drive: encoders, gyro, cameras."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import MarkerMap, MarkerModel
from ..evaluate import wrap_angle
from ..fields import within
from ..sensor_keys import COMPONENTS, SIGMAS, in_order
from .drives import Drive
from .tilt import tilted
from .wander import gauss_markov

FASTEST_HZ = 1e4
"""More frames a second than any sensor gives, and than microseconds tell apart well."""


@dataclass(frozen=True)
class Encoders:
    """Two wheels; noise grows with the root of the distance, slip and scale with the distance."""

    track_width_m: float = 1.41
    m_per_tick: float = 5e-4
    noise_m_per_sqrt_m: float = 0.01
    slip: float = 0.0
    """Part of the measured travel that moves nothing, both wheels."""
    scale: tuple[float, float] = (1.0, 1.0)
    """Measured over true travel of the left and the right wheel, as by a tyre's wear."""
    scale_sigma: float = 0.01
    """How well the scale of both is known beforehand; 0: exactly."""
    wander: float = 0.0
    """Part of its travel by which each wheel's comes out wrong, as by slip that comes and goes."""
    wander_s: float = 20.0
    """For how long: its correlation time."""

    def __post_init__(self) -> None:
        within("track_width_m", self.track_width_m, 1e-3, 1e3)
        within("m_per_tick", self.m_per_tick, 1e-12, 1.0)
        within("noise_m_per_sqrt_m", self.noise_m_per_sqrt_m, 0.0)
        within("slip", self.slip, -0.9, 0.9)
        within("scale_sigma", self.scale_sigma, 0.0, 1.0)

    def travel(self, drive: Drive) -> NDArray[np.float64]:
        """(n, 2) travel of the left and the right wheel over each step as without noise, m."""
        middle, half = (drive.increments * (1.0, self.track_width_m / 2)).T
        return np.column_stack([middle - half, middle + half]) * self.scale / (1.0 - self.slip)

    def variance(self, travel: NDArray[np.float64]) -> NDArray[np.float64]:
        """Of the noise of each travel [m²]."""
        return np.asarray(self.noise_m_per_sqrt_m**2 * np.abs(travel))

    def ticks(self, drive: Drive, rng: np.random.Generator) -> NDArray[np.int64]:
        """(n + 1, 2) absolute ticks, left and right, at the drive's stamps."""
        travel = self.travel(drive)
        if self.wander > 0.0:
            step_s = float(drive.utime[1] - drive.utime[0]) * 1e-6
            travel *= 1.0 + gauss_markov(self.wander, self.wander_s, step_s, travel.shape, rng)
        travel += np.sqrt(self.variance(travel)) * rng.standard_normal(travel.shape)
        total = np.vstack([np.zeros((1, 2)), np.cumsum(travel, axis=0)])
        return np.rint(total / self.m_per_tick).astype(np.int64)


@dataclass(frozen=True)
class Gyro:
    """A yaw rate sensor with white noise, and a bias that it keeps or that wanders."""

    noise_rad_per_sqrt_s: float = 2e-4
    bias_rad_s: float = 0.0
    """At the start."""
    walk_rad_s_per_sqrt_s: float = 0.0
    """Random walk of the bias."""
    bias_sigma_rad_s: float = 1e-3
    """How well the bias at the start is known beforehand; 0: exactly."""

    def __post_init__(self) -> None:
        within("noise_rad_per_sqrt_s", self.noise_rad_per_sqrt_s, 0.0)
        within("bias_rad_s", self.bias_rad_s, -10.0, 10.0)
        within("walk_rad_s_per_sqrt_s", self.walk_rad_s_per_sqrt_s, 0.0)
        within("bias_sigma_rad_s", self.bias_sigma_rad_s, 0.0, 1.0)

    def rates(self, drive: Drive, rng: np.random.Generator) -> NDArray[np.float64]:
        """(n + 1,) mean rate over the interval that ends at each stamp, rad/s."""
        dt = np.diff(drive.utime) * 1e-6
        noise = self.noise_rad_per_sqrt_s / np.sqrt(dt) * rng.standard_normal(len(dt))
        walk = self.walk_rad_s_per_sqrt_s * np.sqrt(dt) * rng.standard_normal(len(dt))
        bias = self.bias_rad_s + np.append(0.0, np.cumsum(walk))
        return np.append(drive.omega[0], drive.omega + noise) + bias


@dataclass(frozen=True)
class Camera:
    """Anything that sees markers: where it sits, what it measures, how often, how far, how well."""

    name: str
    components: tuple[str, ...] = COMPONENTS
    mounting: tuple[float, float, float, float] = (0.0, 0.0, 0.226, 0.0)
    """x, y, z [m] and yaw [rad] in the robot frame."""
    sigma: tuple[float, float, float] = (0.048, 0.006, 0.1)
    """Of bearing, elevation [rad], range [m]."""
    rate_hz: float = 2.0
    reach_m: float = 12.0
    half_view_rad: float = np.pi
    dropout: float = 0.0
    """Part of what is in view that it misses."""

    def __post_init__(self) -> None:
        object.__setattr__(self, "components", in_order(self.components))
        for key, sigma in zip(SIGMAS.values(), self.sigma, strict=True):
            within(key, sigma, 0.0)
        within("rate_hz", self.rate_hz, 1e-3, FASTEST_HZ)
        within("reach_m", self.reach_m, 0.0)
        within("half_view_rad", self.half_view_rad, 0.0, 2.0 * np.pi)
        within("dropout", self.dropout, 0.0, 1.0)

    def sightings(
        self,
        drive: Drive,
        markers: MarkerMap,
        rng: np.random.Generator,
        tilt: NDArray[np.float64] | None = None,
    ) -> tuple[NDArray[np.int64], NDArray[np.int32], NDArray[np.float64]]:
        """Look at every frame's own time.

        Parameters
        ----------
        tilt : (n + 1, 2) float, rad
            Pitch and roll of the body at the drive's stamps; None: it stands level.

        Returns
        -------
        utime : (k,) int, µs
        id : (k,) int
        value : (k, 3) float, NaN for what it does not measure
        """
        utime = frame_times(drive, self.rate_hz, rng)
        exact = self.look_at_all(drive, markers, utime)
        seen = self.in_view(exact) & (rng.random(exact.shape[:2]) >= self.dropout)
        if tilt is not None:
            newest = np.searchsorted(drive.utime, utime, side="right") - 1
            exact = tilted(exact, tilt[newest], self.mounting[3])
        frame, marker = np.nonzero(seen)
        value = exact[frame, marker]
        value += np.array(self.sigma) * rng.standard_normal(value.shape)
        value[:, 0] = wrap_angle(value[:, 0])
        value[:, [c not in self.components for c in COMPONENTS]] = np.nan
        return utime[frame], markers.ids[marker], value

    def in_view(self, exact: NDArray[np.float64]) -> NDArray[np.bool_]:
        """(f, m) whether what would be measured, (f, m, 3), is near enough and not behind."""
        near, before = exact[..., 2] <= self.reach_m, np.abs(exact[..., 0]) <= self.half_view_rad
        return np.asarray(near & before)

    def look_at_all(
        self, drive: Drive, markers: MarkerMap, utime: NDArray[np.int64]
    ) -> NDArray[np.float64]:
        """Exact bearing, elevation and range (f, m, 3) of all markers, at times (f,) µs."""
        poses = drive.at(utime)
        return np.stack([self._look(p, poses) for p in markers.positions], axis=1)

    def look(
        self, drive: Drive, marker: NDArray[np.float64], utime: NDArray[np.int64]
    ) -> NDArray[np.float64]:
        """Exact bearing, elevation and range (n, 3) of a marker at x, y, z, at times (n,)."""
        return self._look(marker, drive.at(utime))

    def _look(self, marker: NDArray[np.float64], poses: NDArray[np.float64]) -> NDArray[np.float64]:
        exact = MarkerModel(marker, list(COMPONENTS), self.mounting).predict(poses)
        exact[:, 0] = wrap_angle(exact[:, 0])  # a model's bearings differ from these by turns
        return exact


def frame_times(drive: Drive, rate_hz: float, rng: np.random.Generator) -> NDArray[np.int64]:
    """(f,) µs at which a camera that runs by itself takes frames during a drive."""
    period = round(1e6 / rate_hz)
    first = int(drive.utime[0]) + int(rng.integers(1, period))
    return np.arange(first, int(drive.utime[-1]), period, dtype=np.int64)
