"""The time of flight of an ultrasonic echo: by a threshold, by the unscented filter, at best.

Tamas et al. 2008, section IV B: Hilbert transformation, modulus, and the parameters of eq. 38 by
the unscented filter. Before the modulus a band-pass takes away the noise far from the carrier.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import NDArray
from scipy.optimize import least_squares
from scipy.signal import hilbert

from .. import EchoEnvelope, Ukf4

TIME_OF_FLIGHT = 1
"""Its place in the state A0, tau, T, alpha."""
_SAMPLES_A_BAND = 2
"""Samples that are fused within 1/band, in which the noise's correlation falls to 4 %."""
_PASSES = 4
_PEAK, _CROSSING_S = 0.3, 80e-6
"""Standard deviations at the start, of what the threshold finds: more than it is ever wrong."""
_BEFORE_S = 400e-6
"""What is fused before the threshold's crossing: a little more than the rise."""
WHOLE_ECHO_S, RISE_S = 600e-6, 150e-6
"""What is fused after it: the peak and half the fall, or as good as nothing of a second echo."""


@dataclass(frozen=True)
class Receiver:
    """What turns samples into an envelope, and the pair's echo as it comes out of it.

    Attributes
    ----------
    carrier_hz, sample_hz : float
    band_hz : float
        Noise bandwidth of the band-pass, a Gaussian about the carrier.
    """

    carrier_hz: float
    sample_hz: float
    band_hz: float

    def envelope(self, samples: NDArray[np.float64]) -> NDArray[np.float64]:
        """(n,) modulus of the analytic signal within the band."""
        offset = np.fft.fftfreq(len(samples), 1.0 / self.sample_hz) - self.carrier_hz
        gain = np.exp(-0.5 * np.pi * np.square(offset / self.band_hz))
        return np.abs(np.fft.ifft(np.fft.fft(hilbert(samples)) * gain))

    def noise(self, sigma: float) -> float:
        """Of the envelope well above it, from that of the samples: the part within the band."""
        return sigma * float(np.sqrt(self.band_hz / (self.sample_hz / 2.0)))

    def clean(self, envelope: NDArray[np.float64], sigma: float) -> NDArray[np.float64]:
        """Take the noise's power away, which lifts a modulus."""
        return np.sqrt(np.maximum(np.square(envelope) - 2.0 * self.noise(sigma) ** 2, 0.0))


@dataclass(frozen=True)
class Calibration:
    """An echo of known time of flight without noise, as it comes out of a receiver.

    Attributes
    ----------
    time_s, shape : float
        T and alpha that fit it best: the band-pass makes it a little wider.
    lead_s : float
        Beginning of the envelope that fits, less that of the echo.
    """

    time_s: float
    shape: float
    lead_s: float


def calibrate(
    receiver: Receiver,
    times: NDArray[np.float64],
    samples: NDArray[np.float64],
    state: NDArray[np.float64],
) -> Calibration:
    """Fit eq. 38 to the envelope of a clean echo of that state by least squares."""
    envelope = receiver.envelope(samples)
    lasting = np.abs(times - state[TIME_OF_FLIGHT] - 5 * state[2]) < 10 * state[2]
    fit = least_squares(
        lambda x: EchoEnvelope.at_times(x * state, times[lasting]) - envelope[lasting],
        np.ones(4), x_scale=[1.0, 0.01, 1.0, 1.0],
    ).x * state  # fmt: skip
    return Calibration(fit[2], fit[3], fit[TIME_OF_FLIGHT] - state[TIME_OF_FLIGHT])


def threshold(
    times: NDArray[np.float64], envelope: NDArray[np.float64], part: float = 0.5
) -> tuple[float, float]:
    """Return when the envelope last rose through a part of its highest value, and that value."""
    highest = int(np.argmax(envelope))
    limit = part * envelope[highest]
    low = np.flatnonzero(envelope[:highest] < limit)
    i = int(low[-1]) if len(low) else 0
    crossing = np.interp(limit, envelope[i : i + 2], times[i : i + 2])
    return float(crossing), float(envelope[highest])


def fit_echo(
    receiver: Receiver,
    times: NDArray[np.float64],
    envelope: NDArray[np.float64],
    sigma: float,
    start: Calibration,
    spread: float = 0.0,
    after_s: float = WHOLE_ECHO_S,
) -> tuple[NDArray[np.float64], NDArray[np.float64]]:
    """Estimate A0, tau, T and alpha by the unscented filter, started from the threshold.

    All of `_PASSES` passes over the samples have so many times their noise: the same information,
    but the later sigma points lie closer together, where the envelope is nearly linear. Samples
    closer than 1/band share their noise, so theirs is raised by their number in it.

    Parameters
    ----------
    sigma : float
        Noise of the receiver's samples.
    start : Calibration
    spread : float
        Relative standard deviation of T and alpha about those; 0 if the pair is calibrated.
    after_s : float
        How far beyond the threshold's crossing samples are fused.

    Returns
    -------
    state : (4,) float
    covariance : (4, 4) float
    """
    crossing, peak = threshold(times, envelope)
    x = _state_of(peak, crossing, start.time_s, start.shape)
    sd = [_PEAK * x[0], _CROSSING_S, spread * start.time_s, spread * start.shape]
    step = max(1, round(receiver.sample_hz / receiver.band_hz / _SAMPLES_A_BAND))
    shared = receiver.sample_hz / receiver.band_hz / step
    r = [[_PASSES * max(shared, 1.0) * receiver.noise(sigma) ** 2]]
    used = (times >= crossing - _BEFORE_S) & (times <= crossing + after_s)
    z = receiver.clean(envelope, sigma)
    samples = [
        (EchoEnvelope(t), [a]) for t, a in zip(times[used][::step], z[used][::step], strict=True)
    ]
    ukf = Ukf4(x, np.diag(np.square(sd)))
    for _ in range(_PASSES):
        for model, value in samples:
            ukf.update(model, value, r)
    return ukf.state, ukf.covariance


def _state_of(peak: float, crossing: float, time_s: float, shape: float) -> NDArray[np.float64]:
    """(4,) state of the echo that has such a peak and rises through half of it then."""
    rise = np.linspace(0.0, shape * time_s, 200)
    delay, height = threshold(rise, EchoEnvelope.at_times([1.0, 0.0, time_s, shape], rise))
    return np.array([peak / height, crossing - delay, time_s, shape])


def cramer_rao(
    times: NDArray[np.float64], state: NDArray[np.float64], sigma: float, known: NDArray[np.float64]
) -> float:
    """Return the least standard deviation of tau [s] that any estimate from the samples can have.

    The phase of the carrier is unknown and tells nothing of tau.

    Parameters
    ----------
    known : (4,) float
        Standard deviation of what is known of each parameter beforehand; inf: nothing, 0: all.
    """
    free = np.flatnonzero(known)
    by = np.vstack([EchoEnvelope(t).linearize(state)[1] for t in times])[:, free]
    # Half the carrier's power is in the samples, whatever its phase.
    information = by.T @ by / (2.0 * sigma**2) + np.diag(1.0 / np.square(known[free]))
    unit = np.abs(state[free])
    bound = np.linalg.inv(information * np.outer(unit, unit)) * np.outer(unit, unit)
    return float(np.sqrt(bound[free == TIME_OF_FLIGHT, free == TIME_OF_FLIGHT][0]))
