"""Ultrasonic echoes as a receiver samples them (Tamas et al. 2008, section IV B)."""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray

from .. import EchoEnvelope

SPEED_OF_SOUND_M_S = 343.2
"""At 20 °C."""


@dataclass(frozen=True)
class Ultrasonic:
    """An emitter and receiver: echoes have eq. 38's envelope, their carrier has any phase.

    T and alpha belong to the pair; these make an echo that rises within twelve periods.
    """

    carrier_hz: float = 40e3
    sample_hz: float = 200e3
    time_s: float = 150e-6
    """T."""
    shape: float = 2.0
    """Alpha."""
    absorption_db_m: float = 1.3
    """Of air, along the way of the sound."""

    def times(self, duration_s: float) -> NDArray[np.float64]:
        """(n,) times of the samples, s."""
        return np.arange(round(duration_s * self.sample_hz)) / self.sample_hz

    def state(self, peak: float, time_of_flight_s: float) -> NDArray[np.float64]:
        """(4,) A0, tau [s], T [s], alpha of the echo whose envelope is so high at its highest."""
        unit = np.array([1.0, 0.0, self.time_s, self.shape])
        highest = EchoEnvelope.at_times(unit, [self.shape * self.time_s])[0]
        return np.array([peak / highest, time_of_flight_s, self.time_s, self.shape])

    def echo(
        self, times: NDArray[np.float64], state: NDArray[np.float64], rng: np.random.Generator
    ) -> NDArray[np.float64]:
        """(n,) samples without noise; the phase of the carrier comes from `rng`."""
        cycles = self.carrier_hz * times + rng.uniform()
        return EchoEnvelope.at_times(state, times) * np.cos(2.0 * np.pi * cycles)

    def peak_at(self, distance_m: float, peak_at_1_m: float) -> float:
        """Of a wall's echo: as from a mirror, the sound spreads over the way there and back."""
        return peak_at_1_m / distance_m * 10 ** (-self.absorption_db_m * (distance_m - 1.0) / 10.0)
