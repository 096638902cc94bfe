"""Many echoes through the threshold and the unscented filter, beside the Cramér-Rao bound."""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from ..evaluate.echo import (
    RISE_S,
    TIME_OF_FLIGHT,
    WHOLE_ECHO_S,
    Calibration,
    Receiver,
    calibrate,
    cramer_rao,
    fit_echo,
    threshold,
)
from ..parallel import in_processes
from ..simulate.echo import SPEED_OF_SOUND_M_S, Ultrasonic
from .study import Request

PAIR = Ultrasonic()
TIMES = PAIR.times(14e-3)
BAND_HZ = 10e3
SPREAD = 0.2
"""Of T and alpha where they are not calibrated, relative."""
SECOND = 0.6
"""Height of the second echo, of the first."""
SNR_DB = (5, 10, 15, 20, 25, 30)
BANDS_HZ = (4e3, 6e3, 10e3, 20e3, 40e3)
DELAYS_S = (0.2e-3, 0.3e-3, 0.4e-3, 0.6e-3, 1.0e-3)
DISTANCES_M = (0.1, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0)
SNR_AT_2_M_DB = 10.0


@dataclass(frozen=True)
class Case:
    """What an echo meets, and how it is looked at.

    Attributes
    ----------
    snr_db : float
        Its envelope's peak over the noise's standard deviation, both of the samples.
    spread : float
        Relative standard deviation of what is known of T and alpha; 0: calibrated.
    delay_s : float
        Of a second echo; 0: there is none.
    after_s : float
        See `fit_echo`.
    distance_m : float
        0: any.
    """

    snr_db: float
    band_hz: float = BAND_HZ
    spread: float = 0.0
    delay_s: float = 0.0
    after_s: float = WHOLE_ECHO_S
    distance_m: float = 0.0

    @property
    def sigma(self) -> float:
        """Noise of the samples; the peak is 1."""
        return float(10.0 ** (-self.snr_db / 20.0))

    def bound(self, spread: float) -> float:
        """Return the least standard deviation of the time of flight, s."""
        state = PAIR.state(1.0, 5e-3)
        known = np.array([np.inf, np.inf, spread * PAIR.time_s, spread * PAIR.shape])
        return cramer_rao(TIMES, state, self.sigma, known)


@dataclass(frozen=True)
class Errors:
    """Root mean square errors of the time of flight over many echoes, s.

    Attributes
    ----------
    threshold : float
        Its mean error taken away.
    ukf : float
        As it is.
    bias : float
        Part of `ukf` that is the same in all.
    """

    threshold: float
    ukf: float
    bias: float

    @property
    def ratio(self) -> float:
        """Of the two."""
        return self.ukf / self.threshold


def at_distance(distance_m: float) -> Case:
    """Return the case of a wall so far away: 10 dB at 2 m."""
    lost = PAIR.peak_at(distance_m, 1.0) / PAIR.peak_at(2.0, 1.0)
    return Case(SNR_AT_2_M_DB + 20.0 * float(np.log10(lost)), distance_m=distance_m)


CASES: Mapping[str, Sequence[Case]] = {
    "calibrated": [Case(snr) for snr in SNR_DB],
    "all four": [Case(snr, spread=SPREAD) for snr in SNR_DB],
    "bands": [Case(10.0, band) for band in BANDS_HZ],
    "whole": [Case(20.0, delay_s=delay) for delay in DELAYS_S],
    "rise": [Case(20.0, delay_s=delay, after_s=RISE_S) for delay in DELAYS_S],
    "distances": [at_distance(distance) for distance in DISTANCES_M],
}


@lru_cache
def receiver(band_hz: float) -> tuple[Receiver, Calibration]:
    """Return a receiver, and what a clean echo looks like behind it."""
    made = Receiver(PAIR.carrier_hz, PAIR.sample_hz, band_hz)
    state = PAIR.state(1.0, 5e-3)
    samples = PAIR.echo(TIMES, state, np.random.default_rng(0))
    return made, calibrate(made, TIMES, samples, state)


def record(case: Case, rng: np.random.Generator) -> tuple[float, NDArray[np.float64]]:
    """Draw a time of flight [s] and the samples (n,)."""
    flight = 2.0 * case.distance_m / SPEED_OF_SOUND_M_S or rng.uniform(2e-3, 9e-3)
    samples = PAIR.echo(TIMES, PAIR.state(1.0, flight), rng)
    if case.delay_s:
        samples += PAIR.echo(TIMES, PAIR.state(SECOND, flight + case.delay_s), rng)
    return flight, samples + case.sigma * rng.standard_normal(len(samples))


def estimate(
    case: Case, samples: NDArray[np.float64], rng: np.random.Generator
) -> tuple[float, NDArray[np.float64]]:
    """Return the threshold's crossing [s] and the fitted state (4,) in the envelope's own terms."""
    front, start = receiver(case.band_hz)
    if case.spread:
        time, shape = np.exp(case.spread * rng.standard_normal(2))
        start = replace(start, time_s=start.time_s * time, shape=start.shape * shape)
    envelope = front.envelope(samples)
    state, _ = fit_echo(front, TIMES, envelope, case.sigma, start, case.spread, case.after_s)
    return threshold(TIMES, envelope)[0], state


def one_run(seed: int, run: int) -> NDArray[np.float64]:
    """(cases, 2) errors of the threshold and of the filter for one echo of each case, s."""
    errors = []
    for case in (case for group in CASES.values() for case in group):
        rng = np.random.default_rng((seed, run))
        flight, samples = record(case, rng)
        crossing, state = estimate(case, samples, rng)
        begin = state[TIME_OF_FLIGHT] - receiver(case.band_hz)[1].lead_s
        errors.append((crossing - flight, begin - flight))
    return np.array(errors)


def run_echoes(request: Request, runs: int) -> dict[str, list[Errors]]:
    """Return the errors of each group of cases, in their order."""
    calls = [(request.seed, k) for k in range(runs)]
    done = in_processes(
        one_run, calls, request.jobs, lambda k: f"the process of echo {k} died", request.progress
    )
    crossing, fitted = np.moveaxis(np.array(list(done)), 2, 0)
    found = [
        Errors(float(c.std()), float(np.sqrt(np.mean(f**2))), float(f.mean()))
        for c, f in zip(crossing.T, fitted.T, strict=True)
    ]
    return {name: [found.pop(0) for _ in group] for name, group in CASES.items()}
