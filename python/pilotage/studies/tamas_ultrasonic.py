"""Section IV B of Tamas et al. 2008: an echo's time of flight, in tables and figures."""

from typing import TYPE_CHECKING

import numpy as np

from .. import EchoEnvelope
from ..evaluate.echo import TIME_OF_FLIGHT
from ..simulate.echo import SPEED_OF_SOUND_M_S
from . import tamas_echo as echo
from .study import Findings, Request, Table

if TYPE_CHECKING:
    from matplotlib.figure import Figure

ECHOES = 800
US = 1e6
MM_PER_S = SPEED_OF_SOUND_M_S / 2.0 * 1e3


def ultrasonic(request: Request) -> Findings:
    """Section IV B and figures 5 and 6: the time of flight by the UKF and by a threshold."""
    found = echo.run_echoes(request, request.runs(ECHOES))
    known, unknown = found["calibrated"], found["all four"]
    bounds = {
        spread: [case.bound(spread) for case in echo.CASES["calibrated"]]
        for spread in (0.0, echo.SPREAD, np.inf)
    }
    at_noise = Table(
        "Time of flight over peak SNR, RMSE (µs; 1 µs is 0.17 mm)",
        ["SNR", "threshold", "UKF", "ratio", "bound", "all four", "bound ± 20 %", "bound free"],
        [
            (f"{snr} dB", *_us(a.threshold, a.ukf), f"{a.ratio:.2f}", *_us(b0, b.ukf, b1, b2))
            for snr, a, b, b0, b1, b2 in zip(
                echo.SNR_DB, known, unknown, *bounds.values(), strict=True
            )
        ],
        "Threshold: half the peak, its mean error taken away. UKF: T and α calibrated. All four: "
        "T and α known to 20 %, with the Cramér-Rao bound for that, and for neither known at all.",
    )
    bands = Table(
        "The same at 10 dB behind other band-passes (µs)",
        ["noise bandwidth", "threshold", "UKF", "ratio", "bound"],
        [
            (
                f"{case.band_hz / 1e3:g} kHz",
                *_us(e.threshold, e.ukf),
                f"{e.ratio:.2f}",
                *_us(case.bound(0.0)),
            )
            for case, e in zip(echo.CASES["bands"], found["bands"], strict=True)
        ],
        "No unbiased estimate from these samples is better than the bound.",
    )
    second = Table(
        f"With a second echo, {echo.SECOND:g} times as high, at 20 dB (µs)",
        ["second echo after", "threshold", "UKF, whole echo", "UKF, its rise"],
        [
            (f"{case.delay_s * 1e3:.1f} ms", *_us(whole.threshold, whole.ukf, rise.ukf))
            for case, whole, rise in zip(
                echo.CASES["whole"], found["whole"], found["rise"], strict=True
            )
        ],
    )
    far = np.array(echo.DISTANCES_M)
    by_ukf = np.array([e.ukf for e in found["distances"]]) * MM_PER_S
    by_threshold = np.array([e.threshold for e in found["distances"]]) * MM_PER_S
    best = np.array([case.bound(0.0) for case in echo.CASES["distances"]]) * MM_PER_S
    distance = Table(
        "Figure 6: error of the range, 10 dB at 2 m (mm)",
        ["distance (m)", *(f"{d:g}" for d in far)],
        [
            ("threshold", *(f"{e:.2f}" for e in by_threshold)),
            ("UKF", *(f"{e:.2f}" for e in by_ukf)),
            ("bound", *(f"{e:.2f}" for e in best)),
        ],
    )
    case = echo.Case(10.0, delay_s=0.8e-3)
    rng = np.random.default_rng((request.seed, 0))
    flight, samples = echo.record(case, rng)
    crossing, state = echo.estimate(case, samples, rng)

    def heard() -> "Figure":
        from ..plot.echo import echo_figure

        front, clean = echo.receiver(case.band_hz)
        near = (flight - 0.5e-3 < echo.TIMES) & (flight + 2.2e-3 > echo.TIMES)
        fitted = EchoEnvelope.at_times(state, echo.TIMES)
        begin = float(state[TIME_OF_FLIGHT] - clean.lead_s)
        marks = {"true time of flight": flight, "by the UKF": begin, "threshold": crossing}
        envelope = front.envelope(samples)
        return echo_figure(echo.TIMES[near], samples[near], envelope[near], fitted[near], marks)

    def noise() -> "Figure":
        from ..plot.echo import against_noise_figure

        errors = {
            "threshold": [e.threshold * US for e in known],
            "UKF, calibrated": [e.ukf * US for e in known],
            "UKF, all four": [e.ukf * US for e in unknown],
        }
        lines = {
            "bound, calibrated": bounds[0.0],
            "bound, T and α ± 20 %": bounds[echo.SPREAD],
            "bound, all free": bounds[np.inf],
        }
        return against_noise_figure(
            {name: (echo.SNR_DB, y) for name, y in errors.items()},
            {name: (echo.SNR_DB, [s * US for s in y]) for name, y in lines.items()},
        )

    def over_distance() -> "Figure":
        from ..plot.echo import against_distance_figure

        points = {"threshold at half the peak": (far, by_threshold), "UKF": (far, by_ukf)}
        return against_distance_figure(points, (far, best))

    results = {
        "time_of_flight_s": {name: [vars(e) for e in errors] for name, errors in found.items()},
        "bound_s": {f"{spread:g}": bound for spread, bound in bounds.items()},
        "ratio_at_10_db": known[echo.SNR_DB.index(10)].ratio,
    }
    figures = {"figure-5": heard, "time-of-flight": noise, "figure-6": over_distance}
    return Findings(results, [at_noise, bands, second, distance], figures)


def _us(*seconds: float) -> tuple[str, ...]:
    return tuple(f"{s * US:.1f}" for s in seconds)
