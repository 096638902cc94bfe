"""Infrared distance sensors: how much of the light comes back (Tamas et al. 2008, section IV A)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

COLOURS = {"white": 0.9, "grey": 0.5, "black": 0.1}
"""Part of the light that a surface throws back."""


@dataclass(frozen=True)
class InfraredPair:
    """An emitter and a receiver side by side, behind a logarithmic amplifier.

    The reading is almost a logarithm of the distance: near by the pair looks past each other, far
    off the ambient light remains.
    """

    gain_v: float = 0.8
    """Of the amplifier, a factor e of light."""
    offset_v: float = 2.0
    """Reading of a white surface at 0.3 m, or nearly so."""
    baseline_m: float = 0.03
    ambient: float = 2e-3
    noise_v: float = 0.02
    reach_m: tuple[float, float] = (0.1, 0.8)
    aligned_rad: float = np.radians(10.0)
    """Furthest from the surface's normal that the receiver sees any of it."""

    def reading(
        self,
        distance: NDArray[np.float64],
        incidence: NDArray[np.float64],
        reflectance: float,
        rng: np.random.Generator,
    ) -> NDArray[np.float64]:
        """(n,) V at distances [m] and angles from the normal [rad]; NaN where nothing returns."""
        overlap = np.exp(-np.square(2.0 * self.baseline_m / distance))
        light = reflectance * overlap * np.square(0.3 / distance) + self.ambient
        volts = self.offset_v + self.gain_v * np.log(light / COLOURS["white"])
        volts = volts + self.noise_v * rng.standard_normal(np.shape(distance))
        low, high = self.reach_m
        seen = (distance >= low) & (distance <= high) & (incidence <= self.aligned_rad)
        return np.where(seen, volts, np.nan)


@dataclass(frozen=True)
class LogCurve:
    """Figure 4 as a curve: reading = at_1_m + slope ln(distance / m)."""

    at_1_m: float
    slope: float
    sigma_v: float
    """Of what the curve leaves: noise, and where the pair is no logarithm."""

    @classmethod
    def fit(cls, distance: NDArray[np.float64], reading: NDArray[np.float64]) -> "LogCurve":
        """Fit by least squares to what returned."""
        seen = np.isfinite(reading)
        by = np.column_stack([np.ones(seen.sum()), np.log(distance[seen])])
        (at_1_m, slope), *_ = np.linalg.lstsq(by, reading[seen], rcond=None)
        left = reading[seen] - by @ [at_1_m, slope]
        return cls(float(at_1_m), float(slope), float(np.sqrt(left @ left / (len(left) - 2))))

    def distance(self, reading: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n,) m of readings [V]."""
        return np.exp((reading - self.at_1_m) / self.slope)

    def sigma(self, distance: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n,) standard deviation of those, m: it grows with the distance."""
        return distance * self.sigma_v / abs(self.slope)
